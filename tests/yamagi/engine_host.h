// SPDX-License-Identifier: GPL-2.0-or-later
// An engine of ours that speaks the interface of Yamagi Quake II: it loads the module, gives it
// files, variables and a console, and calls it as the engine does. It has no window and no game:
// tests say what is seen.
#pragma once

#include "common/file_system.h"
#include "common/memory_source.h"
#include "yamagi/interface.h"

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::test {

struct HostPicture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;
    std::array<int, 3> at(int x, int y) const {
        const uint8_t* const texel = &rgb[3 * static_cast<size_t>(y * width + x)];
        return {texel[0], texel[1], texel[2]};
    }
};

/// One at a time: the interface has no place for a pointer to it.
class EngineHost {
public:
    /// Loads the module; `version` is the text of the engine's variable. Its files are those of
    /// tests/data, and `files` over them.
    explicit EngineHost(std::string version, MemorySource::Files files = {});
    ~EngineHost();

    /// Asks for the module's functions. Fails the test where it wrote more than there is room for.
    void get_functions(int api);
    const yamagi::ModuleFunctions& module() const { return functions_; }

    void set(const std::string& name, const std::string& text);
    std::string text(const std::string& name) const;
    /// A line at the console.
    void run(const std::vector<std::string>& words);
    bool has_command(const std::string& name) const { return commands_.contains(name); }

    /// A frame with whatever `draw` calls.
    template <typename Calls> void frame(const Calls& draw) {
        functions_.begin_frame(0.0f);
        draw(functions_);
        functions_.end_frame();
    }
    /// What the module shows, by its command.
    HostPicture screenshot();

    std::vector<std::string> lines; // told at the console
    size_t count(std::string_view part) const;

    static constexpr int width = 48, height = 32;
    std::string folder = "/nowhere"; // of the game's files that are written
    int windows = 0;                 // opened
    int menus = 0;                   // made

private:
    struct Variable {
        yamagi::EngineVariable shown{};
        std::string name, text, default_text;
    };
    static yamagi::EngineFunctions offered();
    void update(Variable& variable);
    Variable& variable(const char* name, const char* default_text);

    static EngineHost* running;
    FileSystem files_;
    void* library_ = nullptr;
    void* get_ = nullptr;
    yamagi::ModuleFunctions functions_{};
    std::map<std::string, Variable> variables_;
    std::map<std::string, void (*)()> commands_;
    std::vector<std::string> words_; // of the command that runs
    HostPicture shot_;
};

} // namespace vigil::test
