// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/alias_buffer.h"

#include "refresh/vkpt/light/alias_table.h"

#include <cstring>

namespace vigil::vkpt {

bool AliasBuffer::set(std::span<const float> weights) {
    const std::vector<shader::AliasEntry> entries = build_alias_table(weights);
    // The count stands in front of the entries.
    const auto count = static_cast<uint32_t>(entries.size());
    std::vector<std::byte> bytes(sizeof(count) + entries.size() * sizeof(shader::AliasEntry));
    std::memcpy(bytes.data(), &count, sizeof(count));
    if (count > 0)
        std::memcpy(bytes.data() + sizeof(count), entries.data(), bytes.size() - sizeof(count));
    return table_.set(bytes);
}

} // namespace vigil::vkpt
