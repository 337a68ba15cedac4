// SPDX-License-Identifier: GPL-2.0-or-later
// The quality benchmark's command line: rows as data, and messages for what makes no sense.
#include "bench/plan.h"

#include "bench/quality_estimate.h"
#include "common/error.h"
#include "shared/techniques.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string>
#include <vector>

namespace vigil::bench {

namespace {

QualityOptions parse(const std::vector<std::string>& words) {
    return quality_plan(words).options;
}

std::vector<std::string> labels(const QualityOptions& options) {
    std::vector<std::string> result;
    for (const QualityRow& row : options.rows)
        result.push_back(row.label);
    return result;
}

} // namespace

TEST(QualityOptions, EveryTechniqueButBruteIsARow) {
    const std::vector<QualityRow> rows = technique_rows();
    EXPECT_EQ(rows.size(), std::size(technique_infos) - 1);
    for (const QualityRow& row : rows) {
        EXPECT_NE(row.label, "brute");
        ASSERT_EQ(row.settings.size(), 2u);
        EXPECT_EQ(row.settings[0].name, "pt_nee");
        EXPECT_EQ(row.settings[0].value, row.label);
        EXPECT_EQ(row.settings[1].value, "brdf");
    }
    const QualityRow guided = technique_row("vlc+cdq");
    ASSERT_EQ(guided.settings.size(), 2u);
    EXPECT_EQ(guided.settings[0].value, "vlc");
    EXPECT_EQ(guided.settings[1].name, "pt_guide");
    EXPECT_EQ(guided.settings[1].value, "cdq");
    EXPECT_THROW(technique_row("magic+cdq"), Error);
    const QualityOptions options = parse({});
    EXPECT_GT(options.rows.size(), rows.size());
    EXPECT_EQ(options.reference.label, "vlc+cdq");
    EXPECT_EQ(options.baseline, "sll");
    EXPECT_EQ(options.levels,
              (std::vector<std::string>{"warehouse", "mine", "gallery", "yard", "room", "quay"}));
}

TEST(QualityOptions, VariantsAreRowsWithOtherVariables) {
    const QualityRow row = parse_variant("small:pt_nee=sll,pt_sll_max=8");
    EXPECT_EQ(row.label, "small");
    ASSERT_EQ(row.settings.size(), 2u);
    EXPECT_EQ(row.settings[1].name, "pt_sll_max");
    EXPECT_EQ(row.settings[1].value, "8");
    const QualityOptions options =
        parse({"--technique", "sll", "--variant", "small:pt_nee=sll,pt_sll_max=8"});
    EXPECT_EQ(labels(options), (std::vector<std::string>{"sll", "small"}));
}

TEST(QualityOptions, BadVariantsAreNamed) {
    for (const char* text : {"label", ":pt_spp=1", "label:", "label:pt_spp", "label:pt_nothing=1"})
        EXPECT_THROW(parse_variant(text), Error) << text;
}

TEST(QualityOptions, NumbersAreCheckedAndOptionsKnown) {
    EXPECT_EQ(parse({"--size", "64x32"}).size, glm::ivec2(64, 32));
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--size", "64"},
                                               {"--size", "64x"},
                                               {"--views", "0"},
                                               {"--views", "many"},
                                               {"--views"},
                                               {"--technique", "magic"},
                                               {"--reference", "magic"},
                                               {"--baseline", "magic"},
                                               {"--set", "pt_nothing", "1"},
                                               {"--technique", "sll", "--technique", "sll"},
                                               {"--what"}})
        EXPECT_THROW(parse(words), Error) << words[0];
}

TEST(QualityOptions, QuickOnlyChangesWhatIsNotSaid) {
    EXPECT_EQ(parse({"--seeds", "5", "--quick"}).seeds, 5);
    EXPECT_LT(parse({"--quick"}).seeds, parse({}).seeds);
    EXPECT_EQ(parse({"--quick", "--level", "mine"}).levels, (std::vector<std::string>{"mine"}));
}

TEST(QualityOptions, FloorIsAboutDirectLightUnlessSaidOtherwise) {
    const QualityOptions options = parse({"--set", "pt_bounces", "1", "--floor"});
    EXPECT_TRUE(options.floor);
    // Later settings win.
    ASSERT_EQ(options.settings.size(), 3u);
    EXPECT_EQ(options.settings.front().name, "pt_bounces");
    EXPECT_EQ(options.settings.front().value, "0");
    EXPECT_EQ(options.settings.back().value, "1");
    EXPECT_TRUE(parse({}).settings.empty());
}

TEST(QualityOptions, TheCurveHasNeitherFloorNorPictures) {
    const auto adapt = [](const std::vector<std::string>& words) {
        return adapt_plan(words).options;
    };
    EXPECT_EQ(parse({"--pictures", "out/p"}).pictures, "out/p");
    EXPECT_EQ(adapt({}).measured, Measured::Curve);
    EXPECT_THROW(adapt({"--floor"}), Error);
    EXPECT_THROW(adapt({"--pictures", "out/p"}), Error);
    EXPECT_THROW(adapt({"--frames", std::to_string(settled_tail)}), Error);
}

TEST(QualityOptions, TheCurveCountsFromAChange) {
    const auto changing = [](const std::vector<std::string>& words) {
        return adapt_plan(words).options.changing;
    };
    EXPECT_EQ(changing({}), Changing::Nothing);
    EXPECT_EQ(changing({"--change", "lamp"}), Changing::Lamp);
    EXPECT_EQ(changing({"--change", "door"}), Changing::Door);
    EXPECT_EQ(changing({"--change", "strobe"}), Changing::Strobe);
    EXPECT_THROW(changing({"--change", "weather"}), Error);
    EXPECT_THROW(parse({"--change", "lamp"}), Error);
    // References and what was measured of the level at rest are others.
    const std::vector<std::string> door = {"--level", "warehouse", "--change", "door"};
    EXPECT_EQ(adapt_plan(door).parts.front().name, "warehouse door");
    EXPECT_EQ(adapt_plan(door).parts.front().level, "warehouse");
}

} // namespace vigil::bench
