// SPDX-License-Identifier: GPL-2.0-or-later
// Fixture of tests that run the whole program without a display: words of a command line in, log
// and files out. Every test starts with all variables at their defaults.
#pragma once

#include "client/program.h"
#include "common/log.h"
#include "console/cvar.h"
#include "test_game.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace vigil::client {

class ProgramRun : public testing::Test {
protected:
    ProgramRun() {
        for (const CvarInfo& info : cvar_infos)
            cvars().reset(info.name);
        sink_ = add_log_sink([this](Severity severity, std::string_view line) {
            (severity == Severity::Error ? errors_ : output_) += std::string(line) + "\n";
        });
    }
    ~ProgramRun() override { remove_log_sink(sink_); }

    /// Runs headless on the game data in `basedir` with the words of `text`, split at spaces.
    /// Returns the exit status.
    int run_program_on(const std::string& basedir, const std::string& text,
                       const MakeRenderer& make_renderer,
                       const std::function<void(Client&)>& add_commands = {}) {
        std::istringstream stream("+set basedir " + basedir + " +set outdir " + game_.outdir() +
                                  " +set vid_driver headless " + text);
        std::vector<std::string> words;
        for (std::string word; stream >> word;)
            words.push_back(word);
        std::vector<const char*> pointers;
        for (const std::string& word : words)
            pointers.push_back(word.c_str());
        return run_program(pointers, make_renderer, add_commands);
    }

    TestGame game_;
    std::string output_; // what is logged, but for
    std::string errors_;

private:
    int sink_ = 0;
};

} // namespace vigil::client
