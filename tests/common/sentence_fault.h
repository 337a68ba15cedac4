// SPDX-License-Identifier: GPL-2.0-or-later
// What a person cannot read aloud in one breath: help texts are held to it.
#pragma once

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <string_view>

namespace vigil::test {

/// Most words of a sentence.
inline constexpr int most_words = 25;

/// "" where `text` is sentences that end in a full stop and have no more than most_words words;
/// else what is wrong. A choice or a number may begin one ("0: none.").
inline std::string sentence_fault(std::string_view text) {
    if (text.empty()) return "there is no text";
    if (!text.ends_with('.')) return "the last sentence does not end";
    if (std::islower(static_cast<unsigned char>(text.front())) != 0 &&
        text.find(':') > text.find(' ') && text.find('_') > text.find(' '))
        return "it begins with a small letter";
    if (text.find(';') != std::string_view::npos) return "a semicolon: two sentences";
    while (!text.empty()) {
        const std::string_view sentence = text.substr(0, text.find(". "));
        std::istringstream words{std::string(sentence)};
        int count = 0;
        for (std::string word; words >> word;)
            ++count;
        if (count > most_words) return "too long: " + std::string(sentence);
        text.remove_prefix(std::min(sentence.size() + 2, text.size()));
    }
    return "";
}

} // namespace vigil::test
