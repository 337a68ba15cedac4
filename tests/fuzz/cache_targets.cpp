// SPDX-License-Identifier: GPL-2.0-or-later
// Cache files: any bytes as a file, and any bytes inside a right seal.
#include "bench/reference.h"
#include "common/sealed.h"
#include "target.h"

#include <algorithm>

namespace vigil::fuzz {

void fuzz_cache(Input bytes) {
    constexpr std::string_view kind = "vigil reference 2\nkey";
    const auto content = std::as_bytes(bytes);
    if (const auto right = unseal("another kind", content)) {
        const std::string again = seal("another kind", *right);
        require(std::ranges::equal(std::as_bytes(std::span(again)), content),
                "a seal that nobody wrote was accepted");
    }

    const std::string sealed = seal(kind, content);
    const auto opened = unseal(kind, std::as_bytes(std::span(sealed)));
    require(opened && opened->size() == content.size(), "a seal does not open");

    for (const auto file : {content, std::as_bytes(std::span(sealed))}) {
        bench::Reference reference(6);
        if (reference.parse(file, "key"))
            require(reference.values() == 6 && reference.batches() > 0, "a reference of no size");
        else
            require(reference.batches() == 0, "a refused file left something behind");
    }
}

} // namespace vigil::fuzz
