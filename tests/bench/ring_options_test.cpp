// SPDX-License-Identifier: GPL-2.0-or-later
// The ring experiment's command line, and what its rows set.
#include "bench/plan.h"

#include "common/error.h"
#include "console/cvar.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vigil::bench {

namespace {

QualityOptions parse(const std::vector<std::string>& words) {
    return ring_plan(words).options;
}

} // namespace

TEST(RingOptions, OneRowPerSizeAndTheBrdf) {
    const std::vector<QualityRow> rows = ring_rows(parse({}).bits);
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows.front().label, "cdq32");
    EXPECT_EQ(rows.back().label, "brdf");
    for (const QualityRow& row : rows)
        for (const Setting& setting : row.settings)
            EXPECT_TRUE(find_cvar(setting.name)) << setting.name;
}

TEST(RingOptions, NumbersAreCheckedAndOptionsKnown) {
    const QualityOptions options =
        parse({"--seeds", "3", "--size", "64x32", "--set", "pt_cdq_rays", "0", "--fresh"});
    EXPECT_EQ(options.seeds, 3);
    EXPECT_EQ(options.size, glm::ivec2(64, 32));
    ASSERT_EQ(options.settings.size(), 1u);
    EXPECT_EQ(options.settings[0].name, "pt_cdq_rays");
    EXPECT_TRUE(options.fresh);
    EXPECT_EQ(options.turns, (std::vector<int>{9, 36}));
    const QualityOptions one = parse({"--turn", "20", "--bits", "128"});
    EXPECT_EQ(one.turns, std::vector<int>{20});
    EXPECT_EQ(one.bits, std::vector<int>{128});
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"--seeds"},
                                               {"--seeds", "0"},
                                               {"--seeds", "many"},
                                               {"--frames", "39"}, // the tail is 20
                                               {"--size", "64"},
                                               {"--turn", "0"},
                                               {"--bits", "100"},
                                               {"--set", "pt_nothing", "1"},
                                               {"--views", "2"}})
        EXPECT_THROW(parse(words), Error) << words[0];
}

TEST(QualityOptions, AnyRowRendersReferences) {
    const std::vector<std::string> words{
        "--technique", "sll", "--variant", "g:pt_nee=vlc,pt_guide=cdq", "--reference", "g"};
    const QualityOptions options = quality_plan(words).options;
    EXPECT_EQ(options.reference.label, "g");
    ASSERT_EQ(options.reference.settings.size(), 2u);
    EXPECT_EQ(options.reference.settings[1].value, "cdq");
}

} // namespace vigil::bench
