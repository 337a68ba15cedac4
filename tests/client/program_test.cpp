// SPDX-License-Identifier: GPL-2.0-or-later
// The whole program without a display and without a GPU: command line in, calls of the renderer,
// files and the exit status out.
#include "client/client.h"
#include "client/driver_advice.h"
#include "common/archive_builder.h"
#include "common/full_disk.h"
#include "fake_renderer.h"
#include "program_run.h"
#include "shared/views.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace vigil::client {
namespace {

class ProgramTest : public ProgramRun {
protected:
    int run(const std::string& text) {
        return run_program_on(
            game_.basedir(), text,
            [this](FileSystem&, refresh::SurfaceProvider* surface, const refresh::Settings&) {
                EXPECT_EQ(surface, nullptr);
                return std::make_unique<FakeRenderer>(render_);
            });
    }

    RenderLog render_;
};

TEST_F(ProgramTest, RendersWaitsAndTakesAPicture) {
    EXPECT_EQ(run("+map tiny +wait 4 +screenshot a +quit"), 0);
    EXPECT_EQ(errors_, "");
    EXPECT_EQ(render_.calls, (std::vector<std::string>{"map tiny", "render", "render", "render",
                                                       "render", "picture"}));
    EXPECT_TRUE(game_.exists("out/a.png"));
    // The eye is 22 units over the start; each frame lasts 1/60 s.
    EXPECT_EQ(render_.views[0].origin, glm::vec3(32, 32, 46));
    EXPECT_EQ(render_.views[0].angles, glm::vec3(0, 90, 0));
    EXPECT_NEAR(render_.times[3] - render_.times[2], 1.0 / 60.0, 1e-9);
}

TEST_F(ProgramTest, EndsByItselfWhenNoCommandWaits) {
    EXPECT_EQ(run("+map tiny +wait 2"), 0);
    EXPECT_EQ(render_.count("render"), 2u);
    EXPECT_EQ(run(""), 0);
    EXPECT_NE(output_.find("nothing to do"), std::string::npos);
}

TEST_F(ProgramTest, APictureShowsWhatTheCommandsBeforeItChanged) {
    EXPECT_EQ(run("+map tiny +screenshot +setviewpos 1 2 3 10 20 30 +screenshot +screenshot"), 0);
    EXPECT_EQ(render_.calls, (std::vector<std::string>{"map tiny", "render", "picture", "render",
                                                       "picture", "picture"}));
    EXPECT_EQ(render_.views[1].origin, glm::vec3(1, 2, 3));
    EXPECT_EQ(render_.views[1].angles, glm::vec3(10, 20, 30));
    EXPECT_TRUE(game_.exists("out/vigil0000.png"));
    EXPECT_TRUE(game_.exists("out/vigil0002.png"));
    EXPECT_NE(output_.find("vigil0002.png"), std::string::npos);
}

TEST_F(ProgramTest, SettingsThatNoPictureShowsDoNotRenderAgain) {
    EXPECT_EQ(run("+map tiny +wait 1 +set sensitivity 5 +screenshot a +set pt_spp 2 +screenshot b"),
              0);
    EXPECT_EQ(render_.count("render"), 2u);
}

TEST_F(ProgramTest, FailedCommandsOfTheCommandLineSetTheExitStatus) {
    EXPECT_EQ(run("+map nowhere +map tiny +wait 1"), 1);
    EXPECT_NE(errors_.find("maps/nowhere.bsp"), std::string::npos);
    EXPECT_EQ(render_.count("render"), 1u); // what follows still runs
    EXPECT_EQ(run("+screenshot"), 1);       // no level
    EXPECT_EQ(run("+map tiny +screenshot ../../escape"), 1);
    EXPECT_EQ(run("+map tiny +screenshot_hdr"), 1);
    EXPECT_EQ(run("+no_such_command"), 1);
}

TEST_F(ProgramTest, ABrokenLevelKeepsTheOneBefore) {
    game_.write("data/baseq2/maps/broken.bsp", "IBSP, but no more");
    EXPECT_EQ(run("+map tiny +map broken +wait 1 +screenshot a"), 1);
    EXPECT_NE(errors_.find("broken.bsp"), std::string::npos);
    EXPECT_EQ(render_.calls, (std::vector<std::string>{"map tiny", "render", "picture"}));
}

TEST_F(ProgramTest, CommandsRunInTheOrderGiven) {
    EXPECT_EQ(run("+set pt_spp 2 +map tiny +set pt_spp 3 +wait 1 +echo spp $pt_spp +reset pt_spp "
                  "+echo now $pt_spp"),
              0);
    EXPECT_LT(output_.find("spp 3"), output_.find("now 1"));
}

TEST_F(ProgramTest, WhatPlayersOfQuakeTypeWorks) {
    game_.write("data/baseq2/next.cfg", "gamemap \"*tiny$there\"\n");
    EXPECT_EQ(run("+map tiny +setviewpos 1 2 3 40 50 0 +centerview +viewpos +echo dumped +condump "
                  "+condump notes/a.txt +exec next.cfg +wait 1"),
              0);
    EXPECT_NE(output_.find("setviewpos 1.00 2.00 3.00 0.00 50.00 0.00"), std::string::npos);
    EXPECT_NE(game_.read("out/condump.txt").find("\ndumped\n"), std::string::npos);
    EXPECT_NE(game_.read("out/notes/a.txt").find("wrote "), std::string::npos);
    EXPECT_EQ(render_.count("map tiny"), 2u);
    EXPECT_NE(output_.find("its own start, not at there"), std::string::npos);
    EXPECT_EQ(run("+map tiny +condump ../out"), 1);
    EXPECT_EQ(run("+gamemap nowhere"), 1);
    EXPECT_EQ(run("+kill"), 1);           // no level
    EXPECT_EQ(run("+map tiny +kill"), 1); // nobody walks
    EXPECT_NE(errors_.find("kill: nobody walks"), std::string::npos);
    EXPECT_EQ(run("+map tiny +noclip +noclip +kill"), 1); // flies
    output_.clear();
    EXPECT_EQ(run("+map tiny +noclip +wait 2 +kill +wait 2 +viewpos"), 0);
    EXPECT_NE(output_.find("Back to the start"), std::string::npos);
}

TEST_F(ProgramTest, VidRestartMakesTheRendererAnew) {
    int made = 0;
    std::vector<std::string> devices;
    const auto start = [&](const std::string& text, int failing) {
        made = 0;
        devices.clear();
        return run_program_on(
            game_.basedir(), text,
            [&](FileSystem&, refresh::SurfaceProvider*,
                const refresh::Settings& settings) -> std::unique_ptr<refresh::Renderer> {
                devices.push_back(settings.vk_device);
                if (++made == failing) fail("no such device");
                return std::make_unique<FakeRenderer>(render_);
            });
    };
    EXPECT_EQ(start("+map tiny +lightstyle 0 0.5 +wait 2 +setviewpos 1 2 3 +vid_restart "
                    "+screenshot a +wait 1 +vid_restart +vid_restart +echo end",
                    0),
              0)
        << errors_;
    EXPECT_EQ(made, 4);
    EXPECT_EQ(render_.count("map tiny"), 4u); // the level goes on in it
    EXPECT_EQ(render_.models.size(), 2u * 3 + 1);
    EXPECT_EQ(render_.views.back().origin, glm::vec3(1, 2, 3));
    EXPECT_EQ(render_.style_0.back(), 0.5f);
    EXPECT_EQ(render_.entities.at(0).model, static_cast<int>(render_.models.size()) - 1);
    EXPECT_LT(output_.find("are new: a fake device"), output_.find("a.png"));
    EXPECT_NE(output_.find("end\n"), std::string::npos);
    // Before a level, and in the midst of a flight, which ends.
    EXPECT_EQ(start("+vid_restart +map tiny +wait 1", 0), 0);
    EXPECT_EQ(made, 2);
    // A device that is not there: as it was.
    game_.write("data/baseq2/other.cfg", "set vk_device two\n");
    EXPECT_EQ(start("+set vk_device one +map tiny +wait 1 +exec other.cfg +vid_restart +wait 1 "
                    "+screenshot b +echo on $vk_device",
                    2),
              0);
    EXPECT_EQ(devices, (std::vector<std::string>{"one", "two", "one"}));
    EXPECT_NE(output_.find("on one"), std::string::npos);
    EXPECT_NE(output_.find("vk_device takes effect with vid_restart"), std::string::npos);
    EXPECT_NE(errors_.find("vid_restart: no such device"), std::string::npos);
    EXPECT_TRUE(game_.exists("out/b.png"));
}

TEST_F(ProgramTest, NamesOfQuakeIIRtxWork) {
    EXPECT_EQ(run("+set pt_num_bounce_rays 0.5 +set tm_exposure_bias -1 +map tiny "
                  "+sun_brightness 20 +seta profiler 1 +set tm_debug 1 +tm_knee_start 0.5 "
                  "+screenshotpng x +echo got $pt_bounces $pt_exposure_bias $pt_sun_scale "
                  "$scr_stats"),
              0)
        << errors_;
    EXPECT_NE(output_.find("got 1 -1 2 passes"), std::string::npos) << output_;
    EXPECT_NE(output_.find("tm_debug of Quake II RTX has no counterpart here."), std::string::npos);
    EXPECT_TRUE(game_.exists("out/x.png"));
    EXPECT_EQ(run("+set sun_brightness bright"), 1);
}

TEST_F(ProgramTest, ThePresetIsAVariableLikeOthers) {
    EXPECT_EQ(run("+set pt_preset fast +map tiny +echo a $pt_guide $pt_light_points "
                  "+pt_preset accurate +echo b $pt_spp $pt_preset +pt_spp 3 +echo c $pt_preset "
                  "+toggle pt_preset +echo d $pt_preset +toggle pt_preset paper fast "
                  "+pt_preset custom +echo e $pt_preset +reset pt_preset +echo f $pt_spp +presets"),
              0);
    for (const std::string_view text :
         {"a brdf 4\n", "b 4 accurate\n", "c custom\n", "d paper\n", "e fast\n", "f 1\n",
          "stays \"fast\"", "* balanced", "  accurate"})
        EXPECT_NE(output_.find(text), std::string::npos) << text;
    // Of two +set the last one wins, whatever it is about.
    EXPECT_EQ(run("+set pt_preset accurate +set pt_spp 2 +echo g $pt_preset $pt_light_points"), 0);
    EXPECT_NE(output_.find("g custom 16\n"), std::string::npos);
    EXPECT_EQ(run("+set pt_spp 2 +set pt_preset accurate +echo h $pt_preset $pt_spp"), 0);
    EXPECT_NE(output_.find("h accurate 4\n"), std::string::npos);
    EXPECT_EQ(run("+pt_preset theirs"), 1);
    EXPECT_NE(errors_.find("pt_preset: \"theirs\" is none of paper|fast"), std::string::npos);
}

TEST_F(ProgramTest, TheGamesAutoexecRunsBeforeTheCommandLine) {
    game_.write("data/baseq2/autoexec.cfg", "set pt_spp 7\nset pt_bounces 0\nno_such_thing\n");
    EXPECT_EQ(run("+set pt_bounces 1 +echo $pt_spp $pt_bounces"), 0); // its faults are not ours
    EXPECT_NE(output_.find("7 1"), std::string::npos);
}

TEST_F(ProgramTest, AnAutoexecInsideAnArchiveCannotSayWhereFilesGo) {
    const std::string script = "set outdir " + game_.path("stolen").string() +
                               "\nset vid_width 32\nset pt_spp 7\n"
                               "alias shot \"outdir /; screenshot b\"\n";
    const auto pak = test::build_pak({{"autoexec.cfg", script}});
    game_.write("data/baseq2/pak0.pak", {reinterpret_cast<const char*>(pak.data()), pak.size()});
    EXPECT_EQ(run("+map tiny +wait 1 +screenshot a +echo spp $pt_spp width $vid_width"), 0);
    EXPECT_NE(output_.find("spp 7 width 640"), std::string::npos);
    EXPECT_NE(errors_.find("outdir: not set"), std::string::npos);
    EXPECT_NE(errors_.find("vid_width: not set"), std::string::npos);
    EXPECT_TRUE(game_.exists("out/a.png"));
    EXPECT_FALSE(game_.exists("stolen"));
    EXPECT_EQ(run("+map tiny +wait 1 +shot"), 1);
    EXPECT_TRUE(game_.exists("out/b.png"));
}

TEST_F(ProgramTest, AnAutoexecThatIsNoTextIsSaidSoAndPassedOver) {
    game_.write("data/baseq2/autoexec.cfg", std::string_view("set pt_spp 7\0", 13));
    EXPECT_EQ(run("+map tiny +wait 1 +screenshot a"), 0);
    EXPECT_NE(errors_.find("autoexec.cfg: is not a text file"), std::string::npos);
    EXPECT_TRUE(game_.exists("out/a.png"));
}

TEST_F(ProgramTest, AFullDiskFailsByNameAndKeepsTheLastResult) {
    struct Job {
        std::string command, file;
    };
    const Job jobs[] = {{"+map tiny +wait 1 +screenshot a", "a.png"},
                        {"+map tiny +wait 1 +screenshot_hdr a", "a.exr"},
                        {"+map tiny +fly line 10 flight 1", "flight_000.png"},
                        {"+set timedemo_json a.json +map tiny +fly line 10", "a.json"}};
    for (const Job& job : jobs) {
        ASSERT_EQ(run(job.command), 0) << errors_;
        const std::string before = game_.read("out/" + job.file);
        ASSERT_FALSE(before.empty()) << job.file;
        {
            const test::FullDisk disk(16);
            EXPECT_EQ(run(job.command), 1) << job.command;
        }
        EXPECT_NE(errors_.find(job.file + ": cannot write: File too large"), std::string::npos)
            << errors_;
        EXPECT_EQ(game_.read("out/" + job.file), before);
        errors_.clear();
        cvars().reset("timedemo_json");
    }
    for (const auto& entry : std::filesystem::directory_iterator(game_.path("out")))
        EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(ProgramTest, PresetsOfLightListsGoThereAndBack) {
    for (const char* name : {"q2rtx_lists.cfg", "default_lists.cfg"}) {
        std::ifstream file(std::string(VIGIL_SOURCE_DIR "/baseq2/") + name);
        game_.write(std::string("data/baseq2/") + name,
                    std::string(std::istreambuf_iterator<char>(file), {}));
    }
    const std::string values =
        "+echo lists $pt_nee $pt_guide $pt_sll_max $pt_sll_mass $pt_sll_stats "
        "$pt_light_points $pt_light_density ";
    EXPECT_EQ(run("+set pt_nee sll " + values + "+exec q2rtx_lists.cfg " + values +
                  "+exec default_lists.cfg " + values),
              0);
    const size_t before = output_.find("lists"), shipped = output_.find("lists", before + 1),
                 after = output_.find("lists", shipped + 1);
    ASSERT_NE(after, std::string::npos);
    EXPECT_EQ(output_.substr(shipped, output_.find('\n', shipped) - shipped),
              "lists sll brdf 8 solid_angle 1 1 solid_angle");
    EXPECT_EQ(output_.substr(before, output_.find('\n', before) - before),
              output_.substr(after, output_.find('\n', after) - after));
}

TEST_F(ProgramTest, HeadlessNeitherReadsNorWritesThePlayersConfiguration) {
    game_.write("config/vigil/config.cfg", "set fov 120\n");
    EXPECT_EQ(run("+set fov 91 +echo $fov"), 0);
    EXPECT_NE(output_.find("91"), std::string::npos);
    EXPECT_EQ(game_.read("config/vigil/config.cfg"), "set fov 120\n");
    EXPECT_EQ(run("+reset fov +echo fov $fov"), 0);
    EXPECT_NE(output_.find("fov 90"), std::string::npos);
}

TEST_F(ProgramTest, ALostDeviceEndsWithAMessage) {
    render_.fail_at_frame = 2;
    EXPECT_EQ(run("+map tiny +wait 10 +screenshot a"), 1);
    EXPECT_NE(errors_.find("the device was lost"), std::string::npos);
    EXPECT_FALSE(game_.exists("out/a.png"));
}

TEST_F(ProgramTest, AMissingRendererEndsWithItsMessage) {
    const std::string basedir = game_.basedir();
    const std::vector<const char*> words{"+set", "basedir",    basedir.c_str(),
                                         "+set", "vid_driver", "headless"};
    const MakeRenderer none = [](FileSystem&, refresh::SurfaceProvider*,
                                 const refresh::Settings&) -> std::unique_ptr<refresh::Renderer> {
        fail("install a driver");
    };
    EXPECT_EQ(run_program(words, none), 1);
    EXPECT_EQ(errors_, "install a driver\n");
}

TEST_F(ProgramTest, WrongCommandLinesAreRefused) {
    EXPECT_EQ(run("+set pt_spp"), 1);
    const std::vector<const char*> words{"warehouse"};
    EXPECT_EQ(run_program(words, {}), 1);
    EXPECT_NE(errors_.find("warehouse"), std::string::npos);
    const std::vector<const char*> help{"--help"};
    EXPECT_EQ(run_program(help, {}), 0);
}

TEST_F(ProgramTest, FliesARouteAndReports) {
    EXPECT_EQ(run("+set timedemo_json fly.json +map tiny +fly line 10 shot 2 +echo landed +quit"),
              0);
    EXPECT_EQ(errors_, "");
    EXPECT_EQ(render_.count("render"), 7u); // 0.5 s at 10 fps, both ends; and before, for calm
    EXPECT_EQ(render_.count("picture"), 3u);
    EXPECT_TRUE(game_.exists("out/shot_000.png"));
    EXPECT_TRUE(game_.exists("out/shot_002.png"));
    EXPECT_FALSE(game_.exists("out/shot_003.png"));
    EXPECT_EQ(render_.views.front().origin, glm::vec3(0, 0, 10));
    EXPECT_EQ(render_.views.back().origin, glm::vec3(100, 0, 10));
    EXPECT_NEAR(render_.times[2] - render_.times[1], 0.1, 1e-9);
    EXPECT_LT(output_.find("6 frames, "), output_.find("landed"));
    EXPECT_NE(output_.find(" fps\n"), std::string::npos);

    const auto report = nlohmann::json::parse(game_.read("out/fly.json"));
    EXPECT_EQ(report["frames"].size(), 6u);
    EXPECT_EQ(report["frames"][5]["passes_ms"]["shade"], 3.0);
    // Frames 1 to 6 of the renderer counted as many leaves as their number; what came before the
    // flight is in no report.
    EXPECT_DOUBLE_EQ(report["guiding"]["leaves"], 3.5);
    EXPECT_EQ(report["device"], "a fake device");
    EXPECT_EQ(report["level"], "tiny");
    EXPECT_EQ(report["variables"]["timedemo_json"], "fly.json");
    EXPECT_FALSE(report["variables"].contains("pt_nee"));
}

TEST_F(ProgramTest, AFlightThatCannotWriteStopsAndFails) {
    game_.write("out/shot_001.png/occupied", "a folder where a picture should go");
    EXPECT_EQ(run("+map tiny +fly line 10 shot 2 +echo after"), 1);
    EXPECT_NE(errors_.find("shot_001.png"), std::string::npos);
    EXPECT_NE(output_.find("after"), std::string::npos);
    EXPECT_EQ(run("+map tiny +fly line 10 shot 2"), 1); // also when nothing follows
    EXPECT_EQ(run("+map tiny +fly nowhere"), 1);
    EXPECT_NE(errors_.find("line"), std::string::npos); // the routes there are
}

TEST_F(ProgramTest, NamesThatCannotBeWrittenAreRefusedBeforeTheWork) {
    game_.write("out/taken.json/occupied", "a folder where a report should go");
    game_.write("out/taken_000.png/occupied", "a folder where a picture should go");
    game_.write("out/taken.png/occupied", "a folder where a picture should go");
    game_.write("out/taken.exr/occupied", "a folder where a picture should go");
    game_.write("out/taken.gltf/occupied", "a folder where a scene should go");
    game_.write("out/walks/taken.walk/occupied", "a folder where a walk should go");
    game_.write("out/demos/taken.dm2/occupied", "a folder where a demo should go");
    game_.write("out/file", "a file where a folder should be");
    const struct {
        std::string words, message;
    } cases[] = {
        {"+set timedemo_json /tmp/fly.json +map tiny +fly line 10", "the name is absolute"},
        {"+set timedemo_json ../fly.json +map tiny +fly line 10", "the name goes up"},
        {"+set timedemo_json taken.json +map tiny +fly line 10", "taken.json: cannot write"},
        {"+set timedemo_json file/fly.json +map tiny +fly line 10", "out/file"},
        {"+map tiny +fly line 10 /tmp/shot 1", "the name is absolute"},
        {"+map tiny +fly line 10 taken 1", "taken_000.png: cannot write"},
        {"+map tiny +screenshot /tmp/shot", "the name is absolute"},
        {"+map tiny +screenshot taken", "taken.png: cannot write"},
        {"+map tiny +screenshot_hdr ../shot", "the name goes up"},
        {"+map tiny +screenshot_hdr taken", "taken.exr: cannot write"},
        {"+map tiny +exportscene /tmp/scene", "the name is absolute"},
        {"+map tiny +exportscene taken", "taken.gltf: cannot write"},
        {"+map tiny +record /tmp/x", "demos//tmp/x.dm2"},
        {"+map tiny +record taken", "taken.dm2: cannot write"},
        {"+map tiny +walkrecord ../x", "the name goes up"},
        {"+map tiny +walkrecord taken", "taken.walk: cannot write"},
    };
    for (const auto& [words, message] : cases) {
        errors_.clear();
        render_.calls.clear();
        EXPECT_EQ(run(words), 1) << words;
        EXPECT_NE(errors_.find(message), std::string::npos) << words << ": " << errors_;
        EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1) << errors_;
        EXPECT_LE(render_.count("render"), 1u) << words; // the last wait of every command line
        EXPECT_EQ(render_.count("picture") + render_.count("radiance"), 0u) << words;
        cvars().reset("timedemo_json");
    }
}

TEST_F(ProgramTest, WhatADriverCompilesIsNoneOfAFlightsTime) {
    render_.reports = 4;
    render_.compile_s = 0.5;
    EXPECT_EQ(run("+set timedemo_json fly.json +map tiny +fly line 10"), 0) << errors_;
    EXPECT_EQ(render_.count("render"), 6u);
    EXPECT_EQ(render_.drawn, std::vector<bool>(4, false)); // there is no window
    const auto report = nlohmann::json::parse(game_.read("out/fly.json"));
    EXPECT_LT(report["frames"][0]["ms"].get<double>(), 400.0);
    EXPECT_GT(report["frames"][0]["ms"].get<double>(), 0.0);
}

TEST_F(ProgramTest, SlowSoftwareDriversAreToldOf) {
    const std::string old = "llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6 (LLVM 15.0.6), Vulkan 1";
    const auto fetched = game_.path("mesa/lvp_icd.json");
    EXPECT_NE(driver_advice(old, fetched).find("Mesa 22.3.6 is slow"), std::string::npos);
    EXPECT_NE(driver_advice(old, fetched).find("`./run` fetches"), std::string::npos);
    game_.write("mesa/lvp_icd.json", "{}");
    EXPECT_NE(driver_advice(old, fetched).find("VK_DRIVER_FILES=" + fetched.string()),
              std::string::npos);
    for (const char* device :
         {"llvmpipe (LLVM 15.0.6, 256 bits), Mesa 25.0.7-2~bpo12+1 (LLVM 15.0.6), Vulkan 1.4.305",
          "AMD Radeon RX 6600 (RADV NAVI23), Mesa 22.3.6, Vulkan 1.3.230", "a fake device", ""})
        EXPECT_EQ(driver_advice(device, fetched), "") << device;
    // A run of the program says it.
    render_.device = old;
    EXPECT_EQ(run("+map tiny +wait 1"), 0);
    EXPECT_NE(output_.find("Mesa 22.3.6 is slow"), std::string::npos) << output_;
    render_.device = "a fake device";
    output_.clear();
    EXPECT_EQ(run("+map tiny +wait 1"), 0);
    EXPECT_EQ(output_.find("is slow"), std::string::npos) << output_;
}

TEST_F(ProgramTest, ChangesTheLevelsLightsAndModels) {
    EXPECT_EQ(run("+map tiny +turn lamp 30 5 +lightstyle 0 0.5 +lightstyle 1 am "
                  "+dlight 3 1 2 3 4 9 9 9 +dlight 3 1 2 3 5 9 9 9 +wait 1 "
                  "+dlight_clear +screenshot b"),
              0);
    EXPECT_EQ(errors_, "");
    EXPECT_EQ(render_.style_0[0], 0.5f);
    EXPECT_EQ(render_.style_1[0], 0.0f);
    ASSERT_EQ(render_.entities.size(), 1u);
    EXPECT_EQ(render_.entities[0].number, 2);
    EXPECT_EQ(render_.entities[0].origin, glm::vec3(1, 2, 3));
    EXPECT_EQ(render_.entities[0].angles, glm::vec3(5, 30, 0));
    EXPECT_EQ(render_.dynamic_lights, 0u);
    EXPECT_EQ(render_.count("render"), 2u); // dlight_clear made the picture stale
    EXPECT_EQ(run("+map tiny +turn nobody 30"), 1);
    EXPECT_EQ(run("+map tiny +dlight 1 0 0 0 -1 1 1 1"), 1);
}

TEST_F(ProgramTest, SteadyLightsOnRequest) {
    EXPECT_EQ(run("+set pt_light_styles 0 +map tiny +lightstyle 0 0.5 +wait 1"), 0);
    EXPECT_EQ(render_.style_0[0], 1.0f);
}

TEST_F(ProgramTest, TimeStandsStillWhileFramesAreAveraged) {
    EXPECT_EQ(run("+set pt_accumulate 1 +map tiny +wait 3 +screenshot_hdr sum"), 0);
    EXPECT_EQ(render_.times, (std::vector<double>{0.0, 0.0, 0.0}));
    EXPECT_TRUE(game_.exists("out/sum.exr"));
}

TEST_F(ProgramTest, PrintsWhatIsAskedFor) {
    EXPECT_EQ(run("+maps +map tiny +scene +device +wait 2 +passes +viewpos +noclip +bindlist "
                  "+exportscene tiny"),
              0);
    for (const std::string_view text :
         {"tiny\n", "1 levels", "a fake scene", "a fake device", "over 2 frames", "shade",
          "setviewpos 32.00 32.00 46.00 0.00 90.00 0.00", "bind w \"+forward\""}) {
        EXPECT_NE(output_.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(render_.calls.back(), "export " + game_.outdir() + "/tiny.gltf");
}

TEST_F(ProgramTest, WalksThroughTheViews) {
    const int count = choice_count(view_choices);
    std::string walk = "+map tiny +view zero +viewnext +echo at $pt_view +viewprev +viewprev";
    EXPECT_EQ(run(walk + " +echo at $pt_view +view none +viewprev +echo at $pt_view"), 0);
    EXPECT_NE(output_.find("view zero: Light samples that contributed nothing."),
              std::string::npos);
    EXPECT_NE(output_.find("at nonfinite\n"), std::string::npos);
    EXPECT_NE(output_.find("at technique\n"), std::string::npos);
    EXPECT_NE(output_.find("at light\n"), std::string::npos); // the last: round and round
    std::string around = "+map tiny +view none";
    for (int i = 0; i < count; ++i)
        around += " +viewnext";
    output_.clear();
    EXPECT_EQ(run(around + " +echo at $pt_view +view"), 0);
    EXPECT_NE(output_.find("at none\n"), std::string::npos);
    for (const ViewInfo& info : view_infos)
        EXPECT_NE(output_.find(info.help), std::string::npos) << info.name;
    EXPECT_EQ(run("+view nowhere"), 1);
}

TEST_F(ProgramTest, TellsWhatGuidingKnows) {
    EXPECT_EQ(run("+map tiny +wait 3 +vlcinfo +guiding +setviewpos 1 2 3 +vlcinfo +cdqinfo"), 0);
    EXPECT_NE(output_.find("1 light in 1 bucket\n"), std::string::npos);
    EXPECT_NE(output_.find("32 bits, 25 leaves"), std::string::npos);
    EXPECT_NE(output_.find("guiding memory, bytes\n"), std::string::npos);
    EXPECT_NE(output_.find("mean of 3 frames"), std::string::npos);
    EXPECT_EQ(render_.count("render"), 4u); // the second leaf is that of the new view
    // What was learned before counts no more, and the last picture is stale.
    render_.calls.clear();
    EXPECT_EQ(run("+map tiny +wait 3 +guidingreset +screenshot a"), 0);
    EXPECT_EQ(render_.calls, (std::vector<std::string>{"map tiny", "render", "render", "render",
                                                       "reset guiding", "render", "picture"}));
    EXPECT_EQ(run("+vlcinfo"), 1); // no level
    EXPECT_EQ(run("+cdqinfo"), 1);
    EXPECT_EQ(run("+guiding"), 1);
    EXPECT_EQ(run("+guidingreset"), 1);
}

TEST_F(ProgramTest, ModelsThatCannotBeLoadedAreLeftOut) {
    render_.broken_models.insert("*1");
    EXPECT_EQ(run("+map tiny +wait 1"), 0);
    EXPECT_TRUE(render_.entities.empty());
    EXPECT_NE(output_.find("left out"), std::string::npos);
}

TEST_F(ProgramTest, QuitDropsWhatFollows) {
    EXPECT_EQ(run("+map tiny +wait 1 +quit +wait 5 +echo never"), 0);
    EXPECT_EQ(output_.find("never"), std::string::npos);
    EXPECT_EQ(render_.count("render"), 1u);
}

} // namespace
} // namespace vigil::client
