// SPDX-License-Identifier: GPL-2.0-or-later
// Demos with the path tracer: a demo that was recorded along a route renders the same pictures each
// time, and beams and particles are in them.
#include "formats/dm2_parser.h"
#include "formats/dm2_protocol.h"
#include "formats/dm2_writer.h"
#include "formats/image.h"
#include "program_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace vigil::client {
namespace {

class DemoGpuTest : public ProgramRun {
protected:
    /// Small pictures of the project's own levels.
    int run(const std::string& text) {
        return run_program_on(VIGIL_SOURCE_DIR, "+set vid_width 96 +set vid_height 54 " + text,
                              [](FileSystem& files, refresh::SurfaceProvider* surface,
                                 const refresh::Settings& settings) {
                                  return refresh::make_vkpt_renderer(files, surface, settings);
                              });
    }

    void TearDown() override {
        for (const std::string& log : {output_, errors_})
            EXPECT_EQ(log.find("Vulkan validation"), std::string::npos) << log;
    }

    /// Writes the first frames of a recorded demo as another.
    void shorten(const std::string& from, const std::string& to, int frames) const {
        const std::string text = game_.read("out/demos/" + from + ".dm2");
        dm2::File file(from, {text.begin(), text.end()});
        dm2::Parser parser(from);
        dm2::Writer writer;
        while (frames > 0) {
            std::vector<dm2::Message> messages;
            parser.parse(file.next().value(), messages);
            for (const dm2::Message& message : messages) {
                writer.add(message);
                frames -= std::holds_alternative<dm2::Frame>(message) ? 1 : 0;
            }
            writer.end_block();
        }
        const std::vector<uint8_t> bytes = writer.finish();
        game_.write("out/demos/" + to + ".dm2",
                    {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }

    Image picture(const std::string& name) const {
        const std::string bytes = game_.read("out/" + name);
        return decode_image(name, {reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
    }
    /// Mean absolute difference of the channels, 0..255.
    static double difference(const Image& a, const Image& b) {
        double sum = 0.0;
        for (size_t i = 0; i < a.rgba.size(); ++i)
            sum += std::abs(double{a.rgba[i] * 1.0} - b.rgba[i]);
        return sum / static_cast<double>(a.rgba.size());
    }
};

TEST_F(DemoGpuTest, TheFirstPictureOfAFlightIsCalm) {
    // The camera hardly moves from picture to picture: what they differ by is noise.
    for (const char* first : {"0", "12"})
        ASSERT_EQ(run(fmt::format(
                      "+set flt_enable 1 +set flt_first {0} +map ring +fly ring 4 f{0} 1", first)),
                  0)
            << errors_;
    const auto noise = [&](const std::string& name) {
        return difference(picture(name + "_000.png"), picture(name + "_001.png"));
    };
    std::cout << fmt::format("first two pictures differ by {:.2f}, calm ones by {:.2f}\n",
                             noise("f0"), noise("f12"));
    EXPECT_LT(noise("f12"), 0.6 * noise("f0"));
}

TEST_F(DemoGpuTest, ADemoPlayedTwiceGivesTheSamePictures) {
    ASSERT_EQ(run("+map ring +record ring ring"), 0) << errors_;
    shorten("ring", "short", 20);
    // Two runs of the program, and two repetitions in one.
    const std::string plain = "+set flt_enable 0 +set pt_nee sll +set pt_guide brdf +set timedemo ";
    ASSERT_EQ(run(plain + "1 +demomap short a 5"), 0) << errors_;
    ASSERT_EQ(run(plain + "2 +demomap short b 5"), 0) << errors_;
    EXPECT_NE(output_.find("all 2 together: 40 frames"), std::string::npos) << output_;
    for (int i = 0; i < 4; ++i) {
        const Image a = picture(fmt::format("a_{:03}.png", i));
        EXPECT_EQ(a.rgba, picture(fmt::format("b_{:03}.png", i)).rgba) << i;
        EXPECT_EQ(a.rgba, picture(fmt::format("b_{:03}.png", i + 4)).rgba) << i;
    }
    // What guiding learns depends on the order in which threads store samples:
    // docs/play/demos.md.
    const std::string guided =
        "+set flt_enable 0 +set vk_validation 2 +set pt_nee vlc +set pt_guide cdq +set timedemo 2 ";
    ASSERT_EQ(run(guided + "+demomap short c 5"), 0) << errors_;
    for (int i = 0; i < 4; ++i) {
        const Image first = picture(fmt::format("c_{:03}.png", i));
        EXPECT_LT(difference(first, picture(fmt::format("c_{:03}.png", i + 4))), 2.0) << i;
    }
}

TEST_F(DemoGpuTest, BeamsAndParticlesAreSeen) {
    // Looks into the gallery, once as it is, once with a beam, once with particles.
    const auto demo = [this](const std::string& name, bool beam, bool particles) {
        dm2::Writer writer;
        writer.add(dm2::ServerData{});
        writer.add(dm2::ConfigString{dm2::CS_MODELS + 1, "maps/gallery.bsp"});
        writer.end_block();
        dm2::Frame frame;
        frame.player.fov = 90;
        frame.player.origin = {-110, 0, 56};
        if (beam) {
            dm2::EntityState state;
            state.number = 2;
            state.origin = {-70, -20, 56};
            state.old_origin = {-70, 20, 56};
            state.render_flags = dm2::RF_BEAM;
            state.frame = 8;
            state.skin = 0xd0d1d2d3;
            frame.entities.push_back(state);
        }
        for (frame.number = 1; frame.number < 4; ++frame.number) {
            writer.add(frame);
            dm2::TempEntity splash;
            splash.type = dm2::TE_LASER_SPARKS;
            splash.count = 200;
            splash.place = {-70, 0, 56};
            splash.color = 0xd0;
            if (particles) writer.add(splash);
            writer.end_block();
        }
        const std::vector<uint8_t> bytes = writer.finish();
        game_.write("out/demos/" + name + ".dm2",
                    {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        EXPECT_EQ(run("+set vk_validation 2 +set timedemo 1 +set pt_exposure 0.05 +demomap " +
                      name + " " + name + " 1"),
                  0)
            << errors_;
        return picture(name + "_002.png");
    };
    /// Pixels that are clearly green.
    const auto greens = [](const Image& image) {
        int count = 0;
        for (size_t i = 0; i < image.rgba.size(); i += 4)
            count += image.rgba[i + 1] > 100 && image.rgba[i + 1] > 2 * image.rgba[i + 2] ? 1 : 0;
        return count;
    };
    const int none = greens(demo("plain", false, false));
    EXPECT_GT(greens(demo("beam", true, false)), none + 100);
    EXPECT_GT(greens(demo("sparks", false, true)), none + 20);
}

} // namespace
} // namespace vigil::client
