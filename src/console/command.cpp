// SPDX-License-Identifier: GPL-2.0-or-later
// Running scripts: takes commands one by one, expands `$name`, dispatches to commands, aliases and
// variables, and catches what they throw. Completion is in completion.cpp.
#include "console/command.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "common/printable.h"
#include "console/preset.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <sstream>
#include <utility>

namespace vigil {

namespace {

// Scripts and aliases may call each other this deep between two pauses.
constexpr int max_depth = 32;
// Commands may run text inside each other this deep: each level costs C++ stack.
constexpr int max_nesting = 16;
// One script may run this many commands between two pauses: an alias that calls itself twice per
// level stays within max_depth but would never end.
constexpr int max_commands = 100'000;
// Aliases and files that run in one script between two pauses: each is split into commands before
// one of them runs.
constexpr std::size_t max_inserted_bytes = std::size_t{32} << 20;
// A command with its variables filled in; a variable's text may be repeated in it.
constexpr std::size_t max_line_bytes = 65536;
// Aliases stay until the program ends.
constexpr std::size_t max_aliases = 1024;

bool is_name_character(char c) {
    return c == '_' || (c >= '0' && c <= '9') || (ascii_lower(c) >= 'a' && ascii_lower(c) <= 'z');
}

/// Whether ARGUMENTS of a command's help (command.h) can be so many words.
bool takes_words(std::string_view help, std::size_t count) {
    const std::size_t colon = help.find(':');
    if (colon == std::string_view::npos) return true;
    std::istringstream words{std::string(help.substr(0, colon))};
    std::size_t before = 0;
    for (std::string word; words >> word; ++before) {
        if (word.starts_with('[') && before == count) return true;
        if (word.find("...") != std::string::npos) return count > before;
    }
    return before == count;
}

} // namespace

CommandRegistry::CommandRegistry(CvarRegistry& variables) : variables_(variables) {}

void CommandRegistry::add(std::string name, std::string help, CommandFunction function,
                          CommandCompletion complete) {
    name = ascii_lower(name);
    if (find_cvar(name)) fail("command {}: a variable has this name", name);
    if (aliases_.contains(name)) aliases_.erase(name);
    const auto [place, added] = commands_.try_emplace(
        name, Command{std::move(help), std::move(function), std::move(complete)});
    if (!added) fail("command {}: exists already", place->first);
}

void CommandRegistry::remove(std::string_view name) {
    if (const auto found = commands_.find(ascii_lower(name)); found != commands_.end())
        commands_.erase(found);
}

void CommandRegistry::set_alias(std::string_view name, std::string_view text) {
    const std::string lower = ascii_lower(name);
    if (lower.empty()) fail("an alias needs a name");
    if (find_cvar(lower)) fail("{}: a variable has this name", name);
    if (commands_.contains(lower)) fail("{}: a command has this name", name);
    if (aliases_.size() >= max_aliases && !aliases_.contains(lower))
        fail("{}: there are {} aliases already, which is the limit", name, max_aliases);
    aliases_[lower] = {std::string(text), trust_};
}

void CommandRegistry::remove_alias(std::string_view name) {
    const auto found = aliases_.find(ascii_lower(name));
    if (found == aliases_.end()) fail("{}: no such alias", name);
    aliases_.erase(found);
}

Trust CommandRegistry::lowered(Trust trust) const {
    return std::min(trust, trust_);
}

void CommandRegistry::execute_text(std::string_view text, std::string_view origin, Trust trust) {
    Script script;
    for (CommandText& command : split_commands(text))
        script.pending.push_back({std::move(command), std::string(origin), lowered(trust), 0});
    start(std::move(script));
}

void CommandRegistry::execute_words(std::span<const std::vector<std::string>> commands) {
    Script script;
    for (const std::vector<std::string>& words : commands) {
        if (words.empty()) continue;
        Pending pending;
        for (const std::string& word : words)
            pending.command.words.push_back({word, false});
        script.pending.push_back(std::move(pending));
    }
    start(std::move(script));
}

void CommandRegistry::start(Script script) {
    if (script.pending.empty()) return;
    if (nesting_ >= max_nesting) {
        report(script.pending.front().command.words.front().text,
               "commands run each other too deeply", script.pending.front());
        return;
    }
    run(script);
    if (!script.pending.empty()) scripts_.push_back(std::move(script));
}

void CommandRegistry::run_frame() {
    const std::uint64_t clears = clears_;
    std::vector<Script> due = std::exchange(scripts_, {});
    for (Script& script : due) {
        // A pause ends what counts as one run: an alias may call itself after a wait for ever.
        if (pause_ended(script)) {
            script.ran = 0;
            script.inserted_bytes = 0;
            for (Pending& pending : script.pending)
                pending.depth = 0;
            run(script);
        }
        if (clears != clears_) return;
        if (!script.pending.empty()) scripts_.push_back(std::move(script));
    }
}

// Counts one frame; true when the script may go on.
bool CommandRegistry::pause_ended(Script& script) {
    if (script.wait_frames > 0) --script.wait_frames;
    if (script.wait_frames > 0) return false;
    if (!script.wait_until) return true;
    try {
        if (!script.wait_until()) return false;
    } catch (const std::exception& exception) {
        report("wait", exception.what(), {});
    }
    script.wait_until = {};
    return true;
}

void CommandRegistry::run(Script& script) {
    Script* outer = std::exchange(running_, &script);
    ++nesting_;
    const std::uint64_t clears = clears_;
    while (!script.pending.empty() && script.wait_frames == 0 && !script.wait_until) {
        const bool go_on = run_one(script);
        if (!go_on || clears != clears_) script.pending.clear();
    }
    --nesting_;
    running_ = outer;
}

// Runs the script's next command. False when the script must end.
bool CommandRegistry::run_one(Script& script) {
    const Pending pending = std::move(script.pending.front());
    script.pending.pop_front();
    script.depth = pending.depth;

    const std::string& name = pending.command.words.front().text;
    if (++script.ran > max_commands) {
        report(name,
               fmt::format("the script ran {} commands without a wait; stopped", max_commands),
               pending);
        return false;
    }
    if (pending.depth > max_depth) {
        report(name, "scripts or aliases call each other without end; stopped", pending);
        return false;
    }

    const Trust outer = std::exchange(trust_, lowered(pending.trust));
    try {
        if (pending.command.open_quote) fail("a double quote is missing");
        dispatch(expand(pending.command));
    } catch (const std::exception& exception) {
        report(name, exception.what(), pending);
    }
    trust_ = outer;
    return true;
}

void CommandRegistry::report(std::string_view name, std::string_view text, const Pending& pending) {
    ++failures_;
    // Errors of variables begin with the variable's name already.
    std::string message(text);
    if (!text.starts_with(fmt::format("{}: ", name)))
        message = fmt::format("{}: {}", printable(name), text);
    if (!pending.origin.empty())
        message += fmt::format(" ({}, line {})", pending.origin, pending.command.line);
    log_text(Severity::Error, message);
}

// The words with `$name` replaced by the variable's value outside quotes.
std::vector<std::string> CommandRegistry::expand(const CommandText& command) const {
    std::vector<std::string> words;
    std::size_t finished_bytes = 0;
    const auto check_length = [&](std::size_t bytes) {
        if (finished_bytes + bytes > max_line_bytes)
            fail("the command is longer than {} bytes", max_line_bytes);
    };
    for (const CommandWord& word : command.words) {
        if (!words.empty()) finished_bytes += words.back().size() + 1;
        check_length(word.text.size());
        if (word.quoted) {
            words.push_back(word.text);
            continue;
        }
        std::string expanded;
        for (std::size_t i = 0; i < word.text.size();) {
            std::size_t end = i + 1;
            while (end < word.text.size() && is_name_character(word.text[end]))
                ++end;
            if (word.text[i] == '$' && end > i + 1) {
                expanded += variables_.get_text(ascii_lower(word.text.substr(i + 1, end - i - 1)));
                i = end;
            } else {
                expanded += word.text[i++];
            }
            check_length(expanded.size());
        }
        words.push_back(std::move(expanded));
    }
    return words;
}

void CommandRegistry::dispatch(const std::vector<std::string>& words) {
    const std::string name = ascii_lower(words.front());
    const CommandArguments arguments = std::span(words).subspan(1);

    if (const auto command = commands_.find(name); command != commands_.end()) {
        if (!takes_words(command->second.help, arguments.size()))
            fail("usage: {} {}", name, command->second.help);
        const CommandFunction function = command->second.function; // it may remove itself
        function(arguments);
    } else if (const auto alias = aliases_.find(name); alias != aliases_.end()) {
        const ScriptText script = alias->second; // it may redefine itself
        insert_text(script.text, {}, script.trust);
    } else if (const CvarInfo* info = find_cvar(name)) {
        if (arguments.size() > 1) fail("takes one value. Put text with spaces in double quotes.");
        if (arguments.empty())
            log_info("{}", describe_cvar(*info, variables_.values()));
        else
            set_variable(name, arguments[0]);
    } else if (const ForeignName* foreign = find_foreign_name(name)) {
        run_foreign(*foreign, arguments);
    } else {
        fail("unknown command. cmdlist and cvarlist list what there is.");
    }
}

void CommandRegistry::run_foreign(const ForeignName& foreign, CommandArguments arguments) {
    if (!foreign.target.empty() && find_cvar(foreign.target) == nullptr) {
        std::vector<std::string> words{std::string(foreign.target)};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return dispatch(words);
    }
    if (arguments.size() > 1) fail("takes one value");
    if (arguments.size() == 1) return set_foreign(foreign, arguments[0]);
    log_info("{}", describe_foreign_name(foreign));
    if (const CvarInfo* info = find_cvar(foreign.target))
        log_info("{}", describe_cvar(*info, variables_.values()));
}

void CommandRegistry::set_foreign(const ForeignName& foreign, std::string_view text) {
    if (find_cvar(foreign.target) == nullptr) {
        log_warning("{}", describe_foreign_name(foreign));
        return;
    }
    const std::string value = converted_value(foreign, text);
    set_variable(foreign.target, value);
    log_info("{} {} is {} {} here", foreign.name, text, foreign.target,
             variables_.get_text(foreign.target));
}

void CommandRegistry::check_may_set(const CvarInfo& info) const {
    if (info.guarded && trust_ == Trust::Archive)
        fail("{}: not set. A cfg inside a game archive must not set it.", info.name);
}

void CommandRegistry::set_variable(std::string_view name, std::string_view text) {
    if (const CvarInfo* info = find_cvar(name)) check_may_set(*info);
    if (trust_ == Trust::Person)
        variables_.set(name, text);
    else
        variables_.set_for_this_run(name, text);
    if (name == "pt_preset" && equal_nocase(text, custom_preset) &&
        present_preset(variables_) != nullptr)
        log_info("pt_preset stays \"{}\". It becomes custom when a setting is changed.",
                 variables_.get_text(name));
    if (find_cvar(name)->life != CvarLife::Start) return;
    if (name.starts_with("vid_") || name.starts_with("vk_"))
        log_info("{} takes effect with vid_restart.", name);
    else
        log_info("{} is read when the program starts. Put +set {} {} on the command line.", name,
                 name, quote_word(text));
}

void CommandRegistry::reset_variable(std::string_view name) {
    const CvarInfo* info = find_cvar(name);
    if (info) check_may_set(*info);
    if (info && trust_ == Trust::Archive)
        variables_.set_for_this_run(name, cvar_default_text(*info));
    else
        variables_.reset(name);
}

void CommandRegistry::insert_text(std::string_view text, std::string_view origin, Trust trust) {
    if (!running_) {
        execute_text(text, origin, trust);
        return;
    }
    const auto stop = [this](std::string_view fault) {
        running_->pending.clear();
        fail("{}; stopped", fault);
    };
    running_->inserted_bytes += text.size();
    if (running_->inserted_bytes > max_inserted_bytes)
        stop("scripts or aliases call each other without end");
    std::vector<Pending> inserted;
    for (CommandText& command : split_commands(text))
        inserted.push_back(
            {std::move(command), std::string(origin), lowered(trust), running_->depth + 1});
    if (running_->pending.size() + inserted.size() > std::size_t{max_commands})
        stop(fmt::format("more than {} commands wait to run", max_commands));
    running_->pending.insert(running_->pending.begin(), std::make_move_iterator(inserted.begin()),
                             std::make_move_iterator(inserted.end()));
}

void CommandRegistry::pause_script(int frames) {
    if (running_) running_->wait_frames = std::max(frames, 0);
}

void CommandRegistry::pause_script_until(std::function<bool()> done) {
    if (running_) running_->wait_until = std::move(done);
}

void CommandRegistry::clear() {
    ++clears_;
    scripts_.clear();
}

} // namespace vigil
