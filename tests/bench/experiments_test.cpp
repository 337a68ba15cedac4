// SPDX-License-Identifier: GPL-2.0-or-later
// Every experiment from the command line to its report, in its --quick form, and an interruption in
// the midst of one.
#include "common/process.h"
#include "common/scratch_folder.h"
#include "shared/features.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace vigil::bench {

namespace {

using nlohmann::json;

class Experiments : public testing::Test {
protected:
    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

    /// Starts vigil_bench; what it prints goes to NAME.txt.
    std::unique_ptr<test::Process> start(const std::string& name,
                                         const std::vector<std::string>& more) const {
        std::vector<std::string> words = {VIGIL_BENCH, name,
                                          "--quick",   "--set",
                                          "outdir",    folder_.path().string(),
                                          "--seeds",   "1",
                                          "--json",    file(name + ".json").string()};
        words.insert(words.end(), more.begin(), more.end());
        return std::make_unique<test::Process>(words, file(name + ".txt").string());
    }

    int run(const std::string& name, const std::vector<std::string>& more = {}) const {
        return start(name, more)->wait();
    }

    std::string text_of(const std::string& name) const {
        std::ifstream stream(file(name));
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    json report_of(const std::string& name) const {
        const json report = json::parse(text_of(name + ".json"), nullptr, false);
        return report.is_object() ? report : json::object(); // nothing is there yet
    }

    /// Runs an experiment and checks what all reports have in common.
    json measure(const std::string& name, const std::vector<std::string>& more = {}) const {
        EXPECT_EQ(run(name, more), 0) << text_of(name + ".txt");
        const json report = report_of(name);
        EXPECT_TRUE(report.is_object()) << name;
        EXPECT_EQ(report.value("measured", ""), name);
        EXPECT_TRUE(report.value("finished", false));
        EXPECT_FALSE(report.value("parts", json::array()).empty());
        for (const json& part : report.value("parts", json::array())) {
            EXPECT_FALSE(part["rows"].empty());
            EXPECT_EQ(part.value("nonfinite", 0), 0);
        }
        EXPECT_GT(std::ranges::count(text_of(name + ".csv"), '\n'), 1) << name;
        return report;
    }

    static void expect_errors_and_times(const json& quality) {
        for (const json& row : quality["parts"][0]["rows"]) {
            EXPECT_GT(row["mse"]["value"], 0.0) << row["label"];
            EXPECT_GT(row["efficiency"]["value"], 0.0) << row["label"];
            EXPECT_GT(row["frame_ms"]["value"], 0.0) << row["label"];
        }
    }

    /// Runs Python; what it prints goes to python.txt.
    int python(std::vector<std::string> words) const {
        words.insert(words.begin(), "python3");
        return test::Process(words, file("python.txt").string()).wait();
    }

    test::ScratchFolder folder_;
};

} // namespace

TEST_F(Experiments, QualityComparesAllTechniques) {
    const json report = measure("quality");
    EXPECT_GE(report["parts"][0]["rows"].size(), 6u);
    expect_errors_and_times(report);
}

TEST_F(Experiments, ScaleVariesLightsPixelsAndTriangles) {
    const json report = measure("scale");
    std::map<std::string, std::vector<double>> axes;
    for (const json& part : report["parts"])
        for (const char* axis : {"lights", "resolution", "triangles"})
            if (part["part"].get<std::string>().starts_with(axis))
                axes[axis].push_back(axis == std::string("resolution")
                                         ? part["height"].get<double>()
                                         : part[axis].get<double>());
    ASSERT_EQ(axes.size(), 3u);
    for (const auto& [axis, values] : axes) {
        ASSERT_GE(values.size(), 2u) << axis;
        EXPECT_LT(values.front(), values.back()) << axis;
    }
}

TEST_F(Experiments, RingTurnsTheLamp) {
    const json report = measure("ring");
    EXPECT_EQ(report["parts"][0]["degrees"], 36);
}

TEST_F(Experiments, EconomyAddsFeatures) {
    const json report = measure("economy", {"--technique", "uniform", "--set", "vk_cache", "1"});
    const json& part = report["parts"][0];
    // A row for each feature that the level lacks, and none for those that it has.
    EXPECT_EQ(part["rows"].size() + part["same_as_auto"].size(),
              2 + vkpt::scene_feature_rows.size());
    // Caches are of `vlc` alone.
    EXPECT_EQ(part["features"].size() + 1, part["same_as_auto"].size());
    ASSERT_GE(part["rows"].size(), 3u);
    const json& own = part["rows"][0];
    EXPECT_EQ(own["features"], part["features"]);
    for (const json& row : part["rows"]) {
        EXPECT_EQ(row["variables"]["pt_features"].get<std::string>() + " uniform", row["label"]);
        EXPECT_GT(row["path_ms"]["ratio"]["value"], 0.0) << row["label"];
        EXPECT_GT(row["compile_s"]["value"], 0.0) << row["label"];
        EXPECT_GT(row["memory_bytes"]["by"]["triangles"], 0.0) << row["label"];
        // The camera moves: its parameters are copied, if nothing else.
        EXPECT_GT(row["upload_bytes"]["value"], 0.0) << row["label"];
        // All have the same passes. Shaders have the same source, and more is left of it.
        ASSERT_EQ(row["shaders"].size(), own["shaders"].size()) << row["label"];
        EXPECT_EQ(row["spirv_bytes"], own["spirv_bytes"]) << row["label"];
        if (!row["code_bytes"]["value"].is_number()) continue; // without SPIRV-Tools
        EXPECT_LT(row["code_bytes"]["value"], row["spirv_bytes"]["value"]) << row["label"];
        if (row["label"] != own["label"]) {
            EXPECT_GT(row["code_bytes"]["value"], own["code_bytes"]["value"]) << row["label"];
        }
    }
}

TEST_F(Experiments, PictureComparesFiltersInEverySituation) {
    const json report = measure(
        "picture", {"--size", "48x27", "--warmup", "4", "--pictures", file("pictures").string()});
    std::map<std::string, std::map<std::string, json>> rows; // [situation][row]
    for (const json& part : report["parts"])
        for (const json& row : part["rows"])
            rows[part["part"].get<std::string>().substr(10)][row["label"]] = row; // warehouse
    ASSERT_EQ(rows.size(), 6u);
    const auto typical = [&](const char* situation, const char* row, const char* measure) {
        return rows[situation][row][measure]["median"]["value"].get<double>();
    };
    for (const char* row : {"raw", "temporal", "full", "svgf-like"}) {
        EXPECT_GT(typical("route", row, "mse"), 0.0) << row;
        EXPECT_GT(typical("route", row, "flip"), 0.0) << row;
        EXPECT_GT(typical("cut", row, "mse_8"), 0.0) << row;
        EXPECT_NEAR(typical("strobe", row, "brighter_4"), 1.0, 0.5) << row;
    }
    EXPECT_EQ(typical("route", "raw", "filter_ms"), 0.0);
    EXPECT_GT(typical("route", "full", "filter_ms"), 0.0);
    EXPECT_LT(typical("route", "full", "mse"), typical("route", "raw", "mse"));
    EXPECT_LT(typical("still", "full", "flicker"), 0.1 * typical("still", "raw", "flicker"));
    EXPECT_LT(typical("still", "full", "moving_flicker"),
              typical("still", "raw", "moving_flicker"));
    // What nothing remembers shows lamps at once.
    EXPECT_NEAR(typical("lamp", "raw", "brighter_1"), 1.0, 0.5);
    EXPECT_NEAR(typical("lamp", "raw", "darker_1"), 1.0, 0.5);
    EXPECT_GE(typical("lamp", "full", "lag_darker"), 1.0);
    EXPECT_LE(typical("lamp", "full", "lag_darker"), 17.0); // 16 frames, or later
    for (const char* name : {"reference", "raw_1", "svgf-like_1", "albedo", "normal"})
        EXPECT_TRUE(std::filesystem::exists(file("pictures") / "warehouse" / "view1" /
                                            (std::string(name) + ".exr")))
            << name;
}

TEST_F(Experiments, TradeGoesOnAfterAnInterruption) {
    const std::vector<std::string> some = {"--part", "warehouse pt_vlc"};
    const auto program = start("trade", some);
    while (report_of("trade").value("parts", json::array()).empty() && program->running())
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    program->send(SIGINT);
    program->wait();
    json left = report_of("trade");
    ASSERT_FALSE(left.value("parts", json::array()).empty());
    // How far it came is chance, and on a slow day the signal comes after the end. This is what one
    // after the first part leaves.
    const json first = left["parts"][0];
    left["parts"] = {first};
    left["finished"] = false;
    std::ofstream(file("trade.json")) << left;

    const json report = measure("trade", some);
    EXPECT_NE(text_of("trade.txt").find("measured before, kept"), std::string::npos);
    EXPECT_EQ(report["parts"].size(), report["planned"].size());
    EXPECT_EQ(report["parts"][0], first);
    // Finished: --keep leaves it as it is.
    EXPECT_EQ(run("trade", {"--keep", some[0], some[1]}), 0);
    EXPECT_EQ(report_of("trade"), report);
}

TEST_F(Experiments, QualityAdaptTimingAndTradeMakeAPage) {
    const std::string page = VIGIL_SOURCE_DIR "/tools/report/page.py";
    expect_errors_and_times(measure("quality", {"--pictures", file("pictures").string(),
                                                "--technique", "sll", "--technique", "vlc"}));
    // A lamp that nobody expects is noisy at first where only the table of all lights may draw it,
    // and then it is known. Cuts would know it at once.
    const json lamp = measure("adapt", {"--frames", "12", "--change", "lamp", "--technique", "vlc",
                                        "--variant", "table:pt_nee=vlc,pt_explore_local=0"});
    std::vector<double> errors;
    for (const json& frame : lamp["parts"][0]["rows"][1]["mse"]["frames"])
        errors.push_back(frame["value"]);
    ASSERT_EQ(errors.size(), 12u);
    const double first = errors[0];
    std::ranges::nth_element(errors, errors.begin() + 6);
    EXPECT_GT(first, 2.0 * errors[6]);
    const json adapt = measure("adapt", {"--frames", "12"});
    for (const json& row : adapt["parts"][0]["rows"])
        EXPECT_EQ(row["mse"]["frames"].size(), 12u);
    const json timing = measure("timing");
    for (const json& row : timing["parts"][0]["rows"]) {
        const bool prepares = row["label"] != "sll" && row["label"] != "lh";
        EXPECT_EQ(!row["pass_frames_ms"].empty(), prepares) << row["label"];
        EXPECT_EQ(row["path_ms"]["frames"].size(), 21u);
    }
    measure("trade", {"--part", "warehouse pt_vlc_bucket"});

    if (python({"-c", "import flip_evaluator, matplotlib, numpy, OpenEXR, PIL"}) != 0)
        GTEST_SKIP() << "the packages of tools/report/requirements.txt are missing";
    EXPECT_EQ(python({page, folder_.path().string()}), 0) << text_of("python.txt");
    EXPECT_GT(std::filesystem::file_size(file("report.html")), 100000u);
    EXPECT_EQ(python({page, folder_.path().string(), "--summary", file("summary").string()}), 0)
        << text_of("python.txt");
    // Every picture that the text shows is there.
    const std::string text = text_of("summary/README.md");
    int pictures = 0;
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
        const std::string name = text.substr(at + 2, text.find(')', at) - at - 2);
        if (!name.ends_with(".png")) continue;
        EXPECT_TRUE(std::filesystem::exists(file("summary") / name)) << name;
        ++pictures;
    }
    EXPECT_GE(pictures, 5); // the plots of each, and the pictures of quality
    EXPECT_NE(text.find("Mean FLIP"), std::string::npos);
}

TEST_F(Experiments, WhatTradeTakesForBetterIsMeasuredAgain) {
    const std::string tools = VIGIL_SOURCE_DIR "/tools/report/";
    json report = measure("trade", {"--part", "warehouse pt_cdq_margin"});
    // One value is made to look better, the other to tell nothing.
    for (json& row : report["parts"][0]["rows"])
        for (const char* error : {"mse", "trimmed_mse"}) {
            json& ratio = row[error]["ratio_at_equal_time"]["value"];
            ratio = row["label"] == "pt_cdq_margin=0.5" ? json(0.5) : json(nullptr);
        }
    std::ofstream(file("trade.json")) << report;
    const json again =
        measure("confirm", {"--trade", file("trade.json").string(), "--first-seed", "1001"});
    ASSERT_EQ(again["parts"].size(), 1u);
    ASSERT_EQ(again["parts"][0]["rows"].size(), 2u);
    EXPECT_EQ(again["parts"][0]["rows"][1]["label"], "pt_cdq_margin=0.5");
    EXPECT_EQ(again["trade"]["key"], report["key"]);

    EXPECT_EQ(
        python({tools + "defaults.py", file("trade.json").string(), file("confirm.json").string()}),
        0)
        << text_of("python.txt");
    EXPECT_NE(text_of("python.txt").find(" = ? |"), std::string::npos);
    EXPECT_NE(text_of("python.txt").find("| `0.5` again |"), std::string::npos);
    EXPECT_NE(text_of("python.txt").find("that is not confirmed"), std::string::npos);
    // Without what was measured again, the page has a fault.
    EXPECT_EQ(python({tools + "defaults.py", file("trade.json").string()}), 1);

    // Where no error tells anything there is no picture.
    if (python({"-c", "import matplotlib"}) != 0) GTEST_SKIP() << "matplotlib is missing";
    for (json& row : report["parts"][0]["rows"])
        row["trimmed_mse"]["ratio"]["value"] = nullptr;
    std::ofstream(file("trade.json")) << report;
    EXPECT_EQ(python({tools + "trade.py", file("trade.json").string()}), 0)
        << text_of("python.txt");
    EXPECT_FALSE(std::filesystem::exists(file("trade_warehouse.png")));
}

} // namespace vigil::bench
