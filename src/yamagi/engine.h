// SPDX-License-Identifier: GPL-2.0-or-later
// The engine as the module uses it: its console, its variables and its files. It keeps the
// functions that the engine gave, and no state beside them.
#pragma once

#include "common/file_source.h"
#include "yamagi/interface.h"

#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace vigil::yamagi {

class Engine {
public:
    explicit Engine(const EngineFunctions& functions) : functions_(functions) {}

    const EngineFunctions& functions() const { return functions_; }

    /// A line at the engine's console.
    void print(std::string_view line) const;

    /// The variable's text, "" where it has none. It is made where it is missing, archived or not.
    std::string text(const char* name, const char* default_text, int flags = 0) const;
    float value(const char* name, const char* default_text, int flags = 0) const;
    void set(const char* name, const std::string& text) const;

private:
    EngineFunctions functions_;
};

/// The engine's file system. It cannot tell what files there are. One thread at a time asks the
/// engine.
class EngineFiles : public FileSource {
public:
    explicit EngineFiles(const Engine& engine) : FileSource("engine", true), engine_(engine) {}

    std::optional<File> find(std::string_view path) const override;
    std::optional<std::vector<uint8_t>> read(std::string_view path) const override;

private:
    const Engine& engine_;
    mutable std::mutex mutex_;
};

/// The engine's API version as the text of its variable `version` tells ("8.20 x86_64 ..."), or 0
/// where it is none that is known.
int api_of(std::string_view version_text);

} // namespace vigil::yamagi
