// SPDX-License-Identifier: GPL-2.0-or-later
// Entity text parser and the getters of Entity. The token rules are those of Quake's engine
// (quotes, comments, bare words); it does not interpret keys.
#include "formats/entity.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/printable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>

namespace vigil {

namespace {

/// More keys than any level has; bounds the linear search of Entity::set on hostile text.
constexpr size_t max_pairs = 1024;

bool is_space(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

/// The numbers that `text` (nullptr: none) starts with; nothing where it does not, or one of them
/// is beyond `largest`. from_chars, because a decimal point must not depend on the locale.
template <size_t Count>
std::optional<std::array<double, Count>> parse_numbers(const std::string* text, double largest) {
    if (!text) return std::nullopt;
    std::string_view rest = *text;
    std::array<double, Count> numbers{};
    for (double& value : numbers) {
        while (!rest.empty() && is_space(rest.front()))
            rest.remove_prefix(1);
        if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
        if (error != std::errc() || !(std::abs(value) <= largest)) return std::nullopt;
        rest.remove_prefix(static_cast<size_t>(end - rest.data()));
    }
    return numbers;
}

constexpr double largest_float = std::numeric_limits<float>::max();

struct Token {
    std::string text;
    bool quoted = false;
    bool is(char c) const { return !quoted && text.size() == 1 && text[0] == c; }
};

class Tokenizer {
public:
    Tokenizer(std::string_view name, std::string_view text)
        : name_(name), text_(text.substr(0, text.find('\0'))) {}

    /// The next token, or nothing at the end of the text.
    std::optional<Token> next() {
        skip_space_and_comments();
        if (text_.empty()) return std::nullopt;
        if (text_.front() == '"') return quoted();
        if (text_.front() == '{' || text_.front() == '}') return Token{std::string(take(1)), false};
        size_t size = 0;
        while (size < text_.size() && !is_space(text_[size]) && text_[size] != '"' &&
               text_[size] != '{' && text_[size] != '}')
            ++size;
        return Token{std::string(take(size)), false};
    }

    template <typename... Args>
    [[noreturn]] void fail_here(fmt::format_string<Args...> text, Args&&... args) const {
        fail("{}: entities lump: line {}: {}", name_, line_,
             fmt::format(text, std::forward<Args>(args)...));
    }

private:
    Token quoted() {
        take(1);
        const size_t end = text_.find('"');
        if (end == std::string_view::npos) fail_here("a string has no closing quote");
        Token token{{}, true};
        const std::string_view raw = take(end);
        for (size_t i = 0; i < raw.size(); ++i) {
            const bool line_feed = raw[i] == '\\' && i + 1 < raw.size() && raw[i + 1] == 'n';
            token.text += line_feed ? '\n' : raw[i];
            if (line_feed) ++i;
        }
        take(1);
        return token;
    }

    void skip_space_and_comments() {
        while (!text_.empty()) {
            if (is_space(text_.front()))
                take(1);
            else if (text_.starts_with("//"))
                take(std::min(text_.find('\n'), text_.size()));
            else
                return;
        }
    }

    std::string_view take(size_t size) {
        const std::string_view taken = text_.substr(0, size);
        line_ += static_cast<size_t>(std::count(taken.begin(), taken.end(), '\n'));
        text_.remove_prefix(size);
        return taken;
    }

    std::string_view name_;
    std::string_view text_;
    size_t line_ = 1;
};

} // namespace

const std::string* Entity::find(std::string_view key) const {
    for (const auto& [known, value] : pairs)
        if (equal_nocase(known, key)) return &value;
    return nullptr;
}

void Entity::set(std::string_view key, std::string_view value) {
    for (auto& [known, old] : pairs) {
        if (!equal_nocase(known, key)) continue;
        old = value;
        return;
    }
    pairs.emplace_back(key, value);
}

std::string Entity::get_string(std::string_view key, std::string_view fallback) const {
    const std::string* value = find(key);
    return value ? *value : std::string(fallback);
}

float Entity::get_float(std::string_view key, float fallback) const {
    const auto number = parse_numbers<1>(find(key), largest_float);
    return number ? static_cast<float>((*number)[0]) : fallback;
}

int Entity::get_int(std::string_view key, int fallback) const {
    using Limits = std::numeric_limits<int>;
    const auto number = parse_numbers<1>(find(key), std::numeric_limits<double>::max());
    return number ? static_cast<int>(std::clamp<double>((*number)[0], Limits::min(), Limits::max()))
                  : fallback;
}

std::optional<glm::vec2> Entity::get_vec2(std::string_view key) const {
    const auto numbers = parse_numbers<2>(find(key), largest_float);
    if (!numbers) return std::nullopt;
    return glm::vec2((*numbers)[0], (*numbers)[1]);
}

glm::vec3 Entity::get_vec3(std::string_view key, glm::vec3 fallback) const {
    const auto numbers = parse_numbers<3>(find(key), largest_float);
    return numbers ? glm::vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]) : fallback;
}

glm::vec3 Entity::get_angles() const {
    return has("angles") ? get_vec3("angles") : glm::vec3(0.0f, get_float("angle"), 0.0f);
}

glm::vec3 Entity::get_model_angles() const {
    if (has("angles")) return get_vec3("angles");
    const float angle = get_float("angle");
    if (angle == -1.0f) return {-90.0f, 0.0f, 0.0f};
    if (angle == -2.0f) return {90.0f, 0.0f, 0.0f};
    return {0.0f, angle, 0.0f};
}

std::vector<Entity> parse_entities(std::string_view name, std::string_view text) {
    std::vector<Entity> entities;
    Tokenizer tokens(name, text);
    while (const auto open = tokens.next()) {
        if (!open->is('{'))
            tokens.fail_here("found '{}' where '{{' begins an entity", printable(open->text, 40));
        Entity entity;
        while (true) {
            const auto key = tokens.next();
            if (!key) tokens.fail_here("entity {} has no closing brace", entities.size());
            if (key->is('}')) break;
            if (key->is('{')) tokens.fail_here("entity {} holds another '{{'", entities.size());
            const auto value = tokens.next();
            if (!value || value->is('}') || value->is('{'))
                tokens.fail_here("key '{}' has no value", printable(key->text, 40));
            entity.set(key->text, value->text);
            if (entity.pairs.size() > max_pairs)
                tokens.fail_here("entity {} has more than {} keys", entities.size(), max_pairs);
        }
        entities.push_back(std::move(entity));
    }
    return entities;
}

} // namespace vigil
