// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of a demo's frames, from the engine with our module and from vigil, have the same means:
// raw radiance, one picture for each seed. demo.sh makes them; VIGIL_DEMO_PICTURES names their
// folder, with demo.dm2, engine_TECHNIQUE_SEED_NUMBER.exr and vigil_TECHNIQUE_SEED_NUMBER.exr. A
// NUMBER is that of a frame divided by VIGIL_DEMO_EVERY. Frames with shots and what is left of them
// are told, but not judged: sparks fly at random in both, and each has its own.
#include "formats/dm2_parser.h"
#include "formats/dm2_protocol.h"
#include "vkpt/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <tinyexr.h>

namespace vigil::test {
namespace {

constexpr int block = 10; // pixels

struct Radiance {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

Radiance load(const std::filesystem::path& path) {
    float* rgba = nullptr;
    Radiance picture;
    const char* reason = nullptr;
    const int result =
        LoadEXR(&rgba, &picture.width, &picture.height, path.string().c_str(), &reason);
    EXPECT_EQ(result, TINYEXR_SUCCESS) << path;
    const std::unique_ptr<float, decltype(&std::free)> owner(rgba, std::free);
    if (result != TINYEXR_SUCCESS) return picture;
    const size_t pixels = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);
    for (size_t i = 0; i < 4 * pixels; ++i)
        if (i % 4 != 3) picture.rgb.push_back(rgba[i]);
    return picture;
}

/// All pictures of one frame that one program made with one technique.
using Files = std::vector<std::filesystem::path>;

PictureBatches batches_of(const Files& files) {
    const Radiance first = load(files.at(0));
    PictureBatches batches(first.width, first.height, block);
    for (const auto& file : files)
        batches.add(load(file).rgb);
    return batches;
}

/// By frame of the demo: whether a shot or what it left behind may be seen.
std::vector<bool> frames_with_effects(const std::filesystem::path& path) {
    constexpr int longest = 16; // frames that an effect lasts
    constexpr uint32_t flying =
        dm2::EF_ROCKET | dm2::EF_BLASTER | dm2::EF_HYPERBLASTER | dm2::EF_GRENADE | dm2::EF_GIB;
    std::ifstream stream(path, std::ios::binary);
    dm2::File file(path.filename().string(),
                   std::vector<uint8_t>(std::istreambuf_iterator<char>(stream), {}));
    dm2::Parser parser(file.name());
    std::vector<bool> found;
    int left = 0;
    while (const auto part = file.next()) {
        std::vector<dm2::Message> messages;
        parser.parse(*part, messages);
        for (const dm2::Message& message : messages) {
            if (std::holds_alternative<dm2::TempEntity>(message) ||
                std::holds_alternative<dm2::MuzzleFlash>(message))
                left = longest;
            const auto* const frame = std::get_if<dm2::Frame>(&message);
            if (frame == nullptr) continue;
            if (std::ranges::any_of(frame->entities, [](const dm2::EntityState& entity) {
                    return (entity.effects & flying) != 0;
                }))
                left = longest;
            found.push_back(left > 0);
            left = std::max(left - 1, 0);
        }
    }
    return found;
}

/// For tools/report/kept.py.
void record(const std::string& row, const char* field, double value) {
    testing::Test::RecordProperty(fmt::format("measured/{}/{}", row, field),
                                  fmt::format("{}", value));
}

TEST(DemoPictures, OfEngineAndProgramAgree) {
    const char* const folder = std::getenv("VIGIL_DEMO_PICTURES");
    if (folder == nullptr) GTEST_SKIP() << "demo.sh has an engine play a demo, and calls this";
    std::map<std::string, std::map<std::string, Files>> by_frame; // "vlc 003", program
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".exr") continue;
        std::stringstream words(entry.path().stem().string());
        std::string program, technique, seed, frame;
        for (std::string* word : {&program, &technique, &seed, &frame})
            std::getline(words, *word, '_');
        by_frame[technique + " " + frame][program].push_back(entry.path());
    }
    ASSERT_FALSE(by_frame.empty());
    const char* const every_text = std::getenv("VIGIL_DEMO_EVERY");
    const int every = every_text != nullptr ? std::atoi(every_text) : 1;
    const std::vector<bool> effects =
        frames_with_effects(std::filesystem::path(folder) / "demo.dm2");
    size_t unequal = 0, judged = 0;
    std::map<std::string, std::vector<double>> biases;
    for (const auto& [label, programs] : by_frame) {
        ASSERT_EQ(programs.size(), 2) << label << ": of one program alone";
        const PictureBatches engine = batches_of(programs.at("engine"));
        const PictureBatches own = batches_of(programs.at("vigil"));
        EXPECT_EQ(engine.batches(), own.batches()) << label;
        const auto frame = static_cast<size_t>(std::stoi(label.substr(label.find(' '))) * every);
        ASSERT_LT(frame, effects.size()) << label << ": the demo is shorter";
        const bool with_effects = effects[frame];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const Comparison result = compare(engine, own, channel);
            std::cout << fmt::format("{}{} {}: {}\n", label, with_effects ? " (shots)" : "",
                                     "RGB"[channel], result.text());
            if (with_effects) continue;
            EXPECT_TRUE(result.agrees(score_limit)) << label << ' ' << "RGB"[channel];
            unequal += result.agrees(score_limit) ? 0 : 1;
            ++judged;
            biases[label.substr(0, label.find(' '))].push_back(result.bias);
        }
    }
    for (const auto& [technique, values] : biases) {
        double sum = 0.0, squares = 0.0;
        for (const double value : values) {
            sum += value;
            squares += value * value;
        }
        const auto count = static_cast<double>(values.size());
        std::cout << fmt::format(
            "{}: {} comparisons, mean bias {:.3f}%, root mean square {:.3f}%\n", technique,
            values.size(), 100.0 * sum / count, 100.0 * std::sqrt(squares / count));
        record(technique, "bias", sum / count);
    }
    record("all", "comparisons", static_cast<double>(judged));
    record("all", "unequal", static_cast<double>(unequal));
    std::cout << fmt::format("{} of {} comparisons without shots differ\n", unequal, judged);
    EXPECT_GE(judged, 3);
}

} // namespace
} // namespace vigil::test
