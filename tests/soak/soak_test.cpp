// SPDX-License-Identifier: GPL-2.0-or-later
// The command soak: what it types, where it writes that down, and whose words they are.
#include "soak/soak_command.h"

#include "client/fake_renderer.h"
#include "client/program_run.h"
#include "common/archive_builder.h"

#include <filesystem>

namespace vigil::client {
namespace {

class SoakTest : public ProgramRun {
protected:
    int run(const std::string& text) {
        return run_program_on(
            game_.basedir(), text,
            [this](FileSystem&, refresh::SurfaceProvider*, const refresh::Settings&) {
                return std::make_unique<FakeRenderer>(render_);
            },
            add_soak_command);
    }

    RenderLog render_;
};

TEST_F(SoakTest, TypesWhatTheConsoleTakes) {
    EXPECT_EQ(run("+soak 0.01 5"), 0) << errors_;
    EXPECT_NE(output_.find("0 values that were not finite"), std::string::npos) << output_;
    // What is clamped is told: values must be in their ranges.
    EXPECT_EQ(output_.find("out of range"), std::string::npos) << output_;
    EXPECT_EQ(run("+soak soon"), 1);
}

TEST_F(SoakTest, CountsWhatEachRendererSaw) {
    render_.health.nonfinite = 3;
    EXPECT_EQ(run("+soak 0.01 10"), 1); // types it in frame 13
    EXPECT_NE(errors_.find(" 3 values that were not finite"), std::string::npos) << errors_;
    EXPECT_NE(game_.read("out/soak.cfg").find("\nvid_restart\n"), std::string::npos);
}

TEST_F(SoakTest, WritesDownWhatItTypes) {
    EXPECT_EQ(run("+soak 0.01 5"), 0) << errors_;
    const std::string typed = game_.read("out/soak.cfg");
    EXPECT_TRUE(typed.starts_with("// Typed by `soak 0.01 5`.\nmap \"")) << typed.substr(0, 80);
    EXPECT_NE(typed.find("\nwait "), std::string::npos);
    game_.write("data/baseq2/again.cfg", typed);
    output_.clear();
    EXPECT_EQ(run("+exec again.cfg +echo to the end"), 0) << errors_;
    EXPECT_NE(output_.find("to the end"), std::string::npos);
    // Without a place to write there is no play.
    std::filesystem::remove(game_.path("out/soak.cfg"));
    game_.write("out/soak.cfg/occupied", "a folder where the words should go");
    EXPECT_EQ(run("+soak 0.01 5"), 1);
    EXPECT_NE(errors_.find("soak.cfg: cannot write"), std::string::npos) << errors_;
}

TEST_F(SoakTest, ThatAnArchiveStartsCannotChangeVideoSettings) {
    const auto pak = test::build_pak({{"packed.cfg", "soak 0.01 5\n"}});
    game_.write("data/baseq2/pak0.pak", {reinterpret_cast<const char*>(pak.data()), pak.size()});
    EXPECT_EQ(run("+exec packed.cfg +echo size $vid_width $vid_height"), 1);
    EXPECT_NE(game_.read("out/soak.cfg").find("set vid_width"), std::string::npos);
    EXPECT_NE(errors_.find("vid_width: not set"), std::string::npos) << errors_;
    EXPECT_NE(output_.find("size 640 360"), std::string::npos) << output_;
}

} // namespace
} // namespace vigil::client
