// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands: names with functions, and scripts (typed lines, cfg files, the command line)
// that run them in order and can pause for frames. This is the one boundary that catches errors: a
// command that throws is reported as `name: text` and the program goes on. Used by the main thread
// only.
#pragma once

#include "console/command_text.h"
#include "console/cvar.h"
#include "console/foreign_names.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

/// Who wrote a script. What somebody else packed into a game archive may change how the game plays,
/// but not the guarded variables (settings_table.h): where files go and what the screen does.
/// Aliases and key bindings remember who made them, and a script runs with the trust of the least
/// trusted one that led to it.
enum class Trust { Archive, Person };

/// A script and who wrote it.
struct ScriptText {
    std::string text;
    Trust trust = Trust::Person;
};

/// The words after the command's name.
using CommandArguments = std::span<const std::string>;
using CommandFunction = std::function<void(CommandArguments)>;

/// Candidates for the last word of an unfinished command. `arguments` are the finished words before
/// it; the registry itself drops candidates that do not begin with what was typed.
using CommandCompletion = std::function<std::vector<std::string>(CommandArguments arguments)>;

struct Completion {
    std::size_t word_begin = 0;          ///< where the word under completion starts in the line
    std::vector<std::string> candidates; ///< sorted, each a whole word
    std::string common;                  ///< longest common prefix of all candidates
};

class CommandRegistry {
public:
    struct Command {
        /// "ARGUMENTS: what it does", one line. It is called with as many words as ARGUMENTS has,
        /// or only those before a "["; "..." at the end stands for any number more. Without
        /// a colon it takes any words.
        std::string help;
        CommandFunction function;
        CommandCompletion complete;
    };
    using CommandMap = std::map<std::string, Command, std::less<>>;
    using AliasMap = std::map<std::string, ScriptText, std::less<>>;

    explicit CommandRegistry(CvarRegistry& variables = cvars());

    /// Adds a command. Throws Error when the name is taken by a command or a variable.
    void add(std::string name, std::string help, CommandFunction function,
             CommandCompletion complete = {});
    void remove(std::string_view name);

    /// Runs `text` now, as a script of its own: commands run in order until one pauses it;
    /// run_frame() resumes it. Never throws for what a command does wrong. `origin` (a file's name)
    /// stands in messages.
    void execute_text(std::string_view text, std::string_view origin = {},
                      Trust trust = Trust::Person);

    /// The same for commands that are split into words already (the command line).
    void execute_words(std::span<const std::vector<std::string>> commands);

    /// Tells that one more frame has been shown, and resumes the scripts whose pause ends with it.
    /// Call it once after each frame: N frames are then shown between `wait N` and the command that
    /// follows.
    void run_frame();

    /// For commands: pauses the script that runs this command for `frames` frames, or until `done`
    /// returns true (asked after each frame).
    void pause_script(int frames);
    void pause_script_until(std::function<bool()> done);

    /// For commands: runs `text` in the script that runs this command, before what follows in it.
    /// Throws Error, and ends the script, when it runs or holds more than a script may. Outside a
    /// script it runs it at once.
    void insert_text(std::string_view text, std::string_view origin = {},
                     Trust trust = Trust::Person);

    /// Who wrote the command that runs now; a person where none does.
    Trust trust() const { return trust_; }

    /// Drops everything that waits to run, the rest of the running script included (for `quit`).
    void clear();

    /// True when no script waits for a later frame.
    bool idle() const { return scripts_.empty(); }

    /// Commands that failed so far; a headless run ends with a non-zero exit status when there are
    /// any.
    int failures() const { return failures_; }

    /// Candidates for the last word of `line`, as the console's completion key wants them.
    Completion complete(std::string_view line) const;

    CvarRegistry& variables() const { return variables_; }

    /// Sets a variable for the command that runs now: as CvarRegistry::set, and tells when a new
    /// value shows only at the next start (life Start). What an archive's script sets is not kept
    /// in the configuration file, and a guarded variable throws Error.
    void set_variable(std::string_view name, std::string_view text);
    /// The same for the default value.
    void reset_variable(std::string_view name);
    /// Sets what `foreign` stands for, and says what that is; says so where that is nothing.
    void set_foreign(const ForeignName& foreign, std::string_view text);

    const CommandMap& commands() const { return commands_; }

    /// Scripts that a name stands for (`alias`). Names are not those of commands or variables.
    const AliasMap& aliases() const { return aliases_; }
    void set_alias(std::string_view name, std::string_view text);
    void remove_alias(std::string_view name);

private:
    struct Pending {
        CommandText command;
        std::string origin;
        Trust trust = Trust::Person;
        int depth = 0; ///< how many scripts and aliases led here since the last pause
    };
    struct Script {
        std::deque<Pending> pending;
        int wait_frames = 0;
        std::function<bool()> wait_until;
        int ran = 0;                    ///< commands since the last pause, to stop endless aliases
        std::size_t inserted_bytes = 0; ///< text of aliases and files since then
        int depth = 0;
    };

    Trust lowered(Trust trust) const;
    void check_may_set(const CvarInfo& info) const;
    void start(Script script);
    bool pause_ended(Script& script);
    void run(Script& script);
    bool run_one(Script& script);
    void dispatch(const std::vector<std::string>& words);
    void run_foreign(const ForeignName& foreign, CommandArguments arguments);
    std::vector<std::string> expand(const CommandText& command) const;
    void report(std::string_view name, std::string_view text, const Pending& pending);
    std::vector<std::string> argument_candidates(const std::vector<std::string>& words) const;

    CvarRegistry& variables_;
    CommandMap commands_;
    AliasMap aliases_;
    std::vector<Script> scripts_;
    Script* running_ = nullptr;
    Trust trust_ = Trust::Person; ///< of the running command
    int nesting_ = 0;
    std::uint64_t clears_ = 0;
    int failures_ = 0;
};

} // namespace vigil
