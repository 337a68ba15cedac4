// SPDX-License-Identifier: GPL-2.0-or-later
// A seal opens to what was sealed, and to nothing after any change.
#include "common/sealed.h"

#include <gtest/gtest.h>

namespace vigil {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(Sealed, OpensToWhatWasSealed) {
    for (const std::string& content : {std::string(), std::string("x"), std::string(5000, '\0')}) {
        const std::string file = seal("kind 1", bytes_of(content));
        const auto opened = unseal("kind 1", bytes_of(file));
        ASSERT_TRUE(opened);
        EXPECT_EQ(std::string(reinterpret_cast<const char*>(opened->data()), opened->size()),
                  content);
    }
}

TEST(Sealed, AnyOtherByteAnyOtherLengthAndAnyOtherKindAreRefused) {
    const std::string file = seal("kind 1", bytes_of("content of a cache"));
    EXPECT_FALSE(unseal("kind 2", bytes_of(file)));
    EXPECT_FALSE(unseal("kind 1 ", bytes_of(file)));
    EXPECT_FALSE(unseal("kind 1", bytes_of(file + "x")));
    for (std::size_t size = 0; size < file.size(); ++size)
        EXPECT_FALSE(unseal("kind 1", bytes_of(std::string_view(file).substr(0, size)))) << size;
    for (std::size_t at = 0; at < file.size(); ++at)
        for (const int bit : {0, 3, 7}) {
            std::string damaged = file;
            damaged[at] = static_cast<char>(damaged[at] ^ 1 << bit);
            EXPECT_FALSE(unseal("kind 1", bytes_of(damaged))) << at;
        }
}

} // namespace
} // namespace vigil
