// SPDX-License-Identifier: GPL-2.0-or-later
// Starting and ending the program.
#include "client/program.h"

#include "client/client.h"
#include "client/driver_advice.h"
#include "common/binary_file.h"
#include "common/error.h"
#include "common/log.h"
#include "common/output.h"
#include "common/terminal_log.h"
#include "console/builtin_commands.h"
#include "console/command_line.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <vector>

namespace vigil::client {

namespace {

constexpr std::string_view version = "Vigil 0.1";
constexpr std::string_view config_name = "config.cfg";
constexpr std::string_view autoexec_name = "autoexec.cfg";
constexpr std::string_view history_name = "console_history";

/// Listens to the log while it lives.
class TerminalLog {
public:
    TerminalLog() : sink_(add_log_sink(terminal_log_sink())) {}
    ~TerminalLog() { remove_log_sink(sink_); }
    TerminalLog(const TerminalLog&) = delete;
    TerminalLog& operator=(const TerminalLog&) = delete;

private:
    int sink_;
};

std::string file_text(const std::filesystem::path& path) {
    const BinaryFile file(path);
    const std::vector<std::uint8_t> bytes = file.read(0, file.size());
    return {bytes.begin(), bytes.end()};
}

/// A cfg file of the game; loose files count as the person's own.
ScriptText game_script(const FileSystem& files, std::string_view name) {
    const auto place = files.find(name);
    const bool packed = place && place->in_archive;
    return {files.read_text(name), packed ? Trust::Archive : Trust::Person};
}

/// `exec NAME`: a file of the user's configuration folder, else of the game.
ScriptReader script_reader(const FileSystem& files) {
    return [&files](std::string_view name) -> ScriptText {
        const std::filesystem::path own = config_dir() / std::filesystem::path(name).filename();
        std::error_code none;
        if (name.find('/') == std::string_view::npos &&
            std::filesystem::is_regular_file(own, none)) {
            return {file_text(own), Trust::Person};
        }
        return game_script(files, name);
    };
}

/// For what the program can do without: a failure is said and passed over.
void if_possible(std::string_view failure, const std::function<void()>& part) {
    try {
        part();
    } catch (const std::exception& error) {
        log_error("{}: {}", failure, error.what());
    }
}

/// What the game brings to run at the start.
void run_autoexec(CommandRegistry& commands, const FileSystem& files) {
    if (!files.exists(autoexec_name)) return;
    if_possible("the game's start script is not run", [&] {
        const ScriptText script = game_script(files, autoexec_name);
        commands.execute_text(script.text, autoexec_name, script.trust);
    });
}

void load_configuration(CommandRegistry& commands, CommandHistory& history) {
    if_possible("the configuration is not read", [&] {
        history.load(cache_dir() / history_name);
        const std::filesystem::path path = config_dir() / config_name;
        if (std::filesystem::exists(path)) commands.execute_text(file_text(path), path.string());
    });
}

/// Keeps what the player changed for the next time, however the game ends.
class KeptConfiguration {
public:
    KeptConfiguration(const CvarRegistry& variables, const KeyBindings& bindings,
                      const CommandHistory& history)
        : variables_(variables), bindings_(bindings), history_(history) {}
    ~KeptConfiguration() {
        if_possible("the configuration is not kept", [this] {
            write_file(config_dir() / config_name, "// Written by Vigil when it ends.\n" +
                                                       variables_.archive_text() +
                                                       bindings_.archive_text());
            history_.save(cache_dir() / history_name);
        });
    }
    KeptConfiguration(const KeptConfiguration&) = delete;
    KeptConfiguration& operator=(const KeptConfiguration&) = delete;

private:
    const CvarRegistry& variables_;
    const KeyBindings& bindings_;
    const CommandHistory& history_;
};

std::unique_ptr<platform::Window> make_window(const CvarRegistry& variables) {
    platform::WindowOptions options;
    options.width = variables->vid_width;
    options.height = variables->vid_height;
    options.fullscreen = variables->vid_fullscreen != 0;
    return platform::open_window(variables.get_text("vid_driver"), options);
}

/// The window, if there is one, and the renderer in it, as the variables want them.
class Screen {
public:
    Screen(FileSystem& files, CvarRegistry& variables, const MakeRenderer& make_renderer)
        : files_(files), variables_(variables), make_renderer_(make_renderer) {}

    /// Throws Error.
    void open(bool with_window) {
        if (with_window) window_ = make_window(variables_);
        renderer_ = make_renderer_(files_, window_.get(), variables_.values());
        for (const std::string_view name : read_once)
            opened_with_.insert_or_assign(name, variables_.get_text(name));
    }

    /// Closes both and opens them anew; where that fails, as they were.
    Video restart() {
        const bool with_window = window_ != nullptr;
        close();
        try {
            open_again(with_window);
        } catch (const Error& error) {
            log_error("vid_restart: {}", error.what());
            close();
            for (const auto& [name, text] : opened_with_)
                variables_.set_for_this_run(name, text);
            open_again(with_window);
        }
        return {*renderer_, window_.get()};
    }

    platform::Window* window() const { return window_.get(); }
    refresh::Renderer& renderer() const { return *renderer_; }

private:
    /// By window and renderer, when they are made.
    static constexpr std::string_view read_once[] = {"vid_driver", "vk_device", "vk_validation",
                                                     "vk_debug_names", "vk_cache"};

    void close() {
        renderer_.reset();
        window_.reset();
    }
    void open_again(bool with_window) {
        open(with_window);
        if (with_window && window_ == nullptr) fail("no window opens");
    }

    FileSystem& files_;
    CvarRegistry& variables_;
    const MakeRenderer& make_renderer_;
    std::map<std::string_view, std::string> opened_with_;
    std::unique_ptr<platform::Window> window_;
    std::unique_ptr<refresh::Renderer> renderer_; // ends before the window does
};

int run_commands(const CommandLine& line, const MakeRenderer& make_renderer,
                 const std::function<void(Client&)>& add_commands) {
    CvarRegistry& variables = cvars();
    apply_early_sets(line, variables);
    FileSystem files;
    files.mount_game(find_basedir(variables->basedir), variables->game);

    CommandRegistry commands(variables);
    KeyBindings bindings;
    add_builtin_commands(commands, script_reader(files));
    add_binding_commands(commands, bindings);

    Console console(commands);

    // The overlay outlives the renderer; the window opens once the configuration is known.
    std::unique_ptr<Overlay> overlay;
    Screen screen(files, variables, make_renderer);
    const bool may_open_window = platform::wants_window(variables.get_text("vid_driver"));
    if (may_open_window) {
        load_configuration(commands, console.history());
        apply_early_sets(line, variables);
    }
    overlay = std::make_unique<Overlay>(Clipboard{
        [&screen] { return screen.window() != nullptr ? screen.window()->clipboard() : ""; },
        [&screen](const std::string& text) {
            if (screen.window() != nullptr) screen.window()->set_clipboard(text);
        }});
    screen.open(may_open_window);

    const std::string advice =
        driver_advice(screen.renderer().device_name(), cache_dir() / "mesa/lvp_icd.json");
    if (!advice.empty()) log_info("{}", advice);

    Client client({files, commands, bindings, console, *overlay, screen.renderer(), screen.window(),
                   [&screen] { return screen.restart(); }});
    if (add_commands) add_commands(client);
    run_autoexec(commands, files);
    apply_early_sets(line, variables);
    const int failures_before = commands.failures();
    // A last wait, so that the frames of one before it are shown although nothing follows it.
    std::vector<std::vector<std::string>> words = line.commands;
    words.push_back({"wait"});
    commands.execute_words(words);
    if (client.headless() && line.commands.empty()) {
        log_info("There is no window, and there is nothing to do. Give commands, for example +map "
                 "warehouse +wait 4 +screenshot");
    }
    {
        std::optional<KeptConfiguration> kept;
        if (!client.headless()) kept.emplace(variables, bindings, console.history());
        client.run();
    }
    if (!client.headless()) {
        const int status = client.cut_short() ? 1 : 0;
        client.end_play(); // keeps what is recorded
        // A driver's compiler cannot be broken off, and who closed the window waits for nothing.
        if (screen.renderer().compiling()) {
            std::fflush(nullptr);
            std::_Exit(status);
        }
        return status;
    }
    return commands.failures() > failures_before || client.failures() > 0 ? 1 : 0;
}

} // namespace

int run_program(std::span<const char* const> words, const MakeRenderer& make_renderer,
                const std::function<void(Client&)>& add_commands) {
    const TerminalLog terminal;
    try {
        const CommandLine line = parse_command_line(words);
        if (line.help) {
            fmt::print("{}", command_line_help());
            return 0;
        }
        if (line.version) {
            fmt::print("{}\n", version);
            return 0;
        }
        return run_commands(line, make_renderer, add_commands);
    } catch (const std::exception& error) { // the outermost boundary; common/error.h has them all
        log_error("{}", error.what());
        return 1;
    }
}

} // namespace vigil::client
