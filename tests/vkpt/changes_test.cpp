// SPDX-License-Identifier: GPL-2.0-or-later
// The picture's size or the level changes while light caches and quadtrees are warm: means stay
// those of a technique that learns nothing, they begin anew, and nothing is used that was learned
// in another size or level.
#include "render_test.h"

#include <gtest/gtest.h>

namespace vigil::test {
namespace {

class Changes : public RenderTest {
protected:
    static constexpr int batch_count = 12, frames = 8, block = 4;

    void SetUp() override {
        RenderTest::SetUp();
        rooms_.view = {{290, 20, 96}, {5, 55, 0}, 90};
        hall_.view = {{-192, 0, 64}, {50, 0, 0}, 60};
        set("pt_nee", "vlc");
        set("pt_guide", "cdq");
        set("pt_accumulate", "1");
    }
    static void render(const Shot& shot, int count) {
        for (int i = 0; i < count; ++i)
            renderer().render(shot.frame());
    }
    /// The mean of the frames since the change, which is now.
    static std::vector<float> mean_since(const Shot& shot) {
        render(shot, frames);
        const refresh::RadiancePicture seen = renderer().read_radiance();
        EXPECT_EQ(seen.frames, frames) << "the mean did not begin anew";
        return seen.rgb;
    }
    PictureBatches reference(std::string_view level, const Shot& shot) {
        set("pt_nee", "lh");
        set("pt_guide", "brdf");
        load(level);
        return batches(shot, 12, 64, 1000, block);
    }

    Shot rooms_, hall_;
};

TEST_F(Changes, MeansStayWhenTheSizeChanges) {
    const PictureBatches expected = reference("rooms", rooms_);
    set("pt_nee", "vlc");
    set("pt_guide", "cdq");
    set("pt_spp", "6");
    PictureBatches seen(48, 32, block);
    for (int batch = 0; batch < batch_count; ++batch) {
        set("pt_seed", std::to_string(5000 + batch));
        set_size(72, 48);
        render(rooms_, 6);
        set_size(48, 32);
        seen.add(mean_since(rooms_));
    }
    judge("after a change of size", seen, expected, {0.015});
}

TEST_F(Changes, MeansStayWhenTheLevelChangesAndComesBack) {
    const PictureBatches expected_rooms = reference("rooms", rooms_),
                         expected_hall = reference("lamp", hall_);
    set("pt_nee", "vlc");
    set("pt_guide", "cdq");
    set("pt_spp", "6");
    PictureBatches rooms(48, 32, block), hall(48, 32, block);
    for (int batch = 0; batch < batch_count; ++batch) {
        set("pt_seed", std::to_string(5000 + batch));
        load("rooms");
        rooms.add(mean_since(rooms_));
        load("lamp");
        hall.add(mean_since(hall_));
    }
    judge("rooms, after the hall", rooms, expected_rooms, {0.015});
    judge("hall, after the rooms", hall, expected_hall, {0.015});
}

// With the same random numbers, the first picture after a change is to the last bit the one that
// nothing learned gives.
TEST_F(Changes, NothingIsUsedThatWasLearnedBefore) {
    const auto first_of_rooms = [&](std::string_view before, const Shot& shot) {
        load(before);
        render(shot, 6);
        load("rooms");
        const refresh::RadiancePicture seen = radiance(rooms_);
        EXPECT_EQ(seen.frames, 1) << "the mean did not begin anew";
        return seen.rgb;
    };
    set("pt_nee", "sll");
    set("pt_guide", "brdf");
    load("rooms");
    render(rooms_, 1);
    set("pt_nee", "vlc");
    set("pt_guide", "cdq");
    load("rooms");
    const std::vector<float> fresh = radiance(rooms_).rgb;
    EXPECT_EQ(first_of_rooms("lamp", hall_), fresh);
    EXPECT_EQ(first_of_rooms("rooms", rooms_), fresh);

    // The sixth frame of a level, the first of its size.
    set("pt_accumulate", "0");
    const auto sixth = [&](bool resized) {
        if (resized) set_size(72, 48);
        load("rooms");
        render(rooms_, 5);
        set_size(48, 32);
        if (!resized) renderer().reset_guiding();
        return radiance(rooms_).rgb;
    };
    const std::vector<float> forgotten = sixth(false), resized = sixth(true);
    load("rooms");
    render(rooms_, 5);
    const std::vector<float> learned = radiance(rooms_).rgb;
    EXPECT_EQ(resized, forgotten);
    EXPECT_NE(resized, learned) << "what was learned must make a difference";
}

} // namespace
} // namespace vigil::test
