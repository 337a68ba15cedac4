// SPDX-License-Identifier: GPL-2.0-or-later
// Previews of models: where they are in the picture, which texels they show, what hides what, and
// what comes of wrong files and sizes.
#include "refresh/preview/preview.h"

#include "common/file_system.h"
#include "common/log.h"
#include "common/memory_source.h"
#include "formats/picture_bytes.h"
#include "formats/small_models.h"

#include <array>
#include <gtest/gtest.h>

namespace vigil::refresh {
namespace {

class PreviewTest : public testing::Test {
protected:
    PreviewTest() {
        // Left half red, right half green.
        const Image halves{2, 1, {255, 0, 0, 255, 0, 255, 0, 255}};
        files_.mount(std::make_unique<test::MemorySource>(
            test::MemorySource::Files{{"models/square.md2", small_md2()},
                                      {"models/broken.md2", {1, 2, 3}},
                                      {"skins/halves.tga", write_tga(halves, {2, 32, 0x28})}}));
        token_ = add_log_sink([this](Severity severity, std::string_view) {
            if (severity == Severity::Warning) ++warnings_;
        });
        square_.model = "models/square.md2";
        square_.skin = "skins/halves.tga";
    }
    ~PreviewTest() override { remove_log_sink(token_); }

    /// From 40 units above the square, whose side of 10 is an eighth of what is seen there.
    Picture draw(std::span<const PreviewModel> models, glm::ivec2 size = {80, 80},
                 float pitch = 90.0f, float height = 41.0f) {
        Preview preview;
        preview.view = {{5, 5, height}, {pitch, 0, 0}, 90, 90};
        preview.size = size;
        preview.models = models;
        return painter_.draw(preview);
    }
    Picture draw(const PreviewModel& model) { return draw(std::span(&model, 1)); }
    static std::array<int, 4> at(const Picture& picture, int x, int y) {
        const auto* rgba = &picture.rgba[4 * static_cast<size_t>(y * picture.width + x)];
        return {rgba[0], rgba[1], rgba[2], rgba[3]};
    }
    static int covered(const Picture& picture) {
        int count = 0;
        for (size_t i = 3; i < picture.rgba.size(); i += 4)
            count += picture.rgba[i] > 0 ? 1 : 0;
        return count;
    }

    FileSystem files_;
    PreviewPainter painter_{files_};
    PreviewModel square_;
    int warnings_ = 0;

private:
    int token_ = 0;
};

TEST_F(PreviewTest, ModelIsWhereTheCameraSeesIt) {
    const Picture picture = draw(square_);
    ASSERT_EQ(picture.width, 80);
    ASSERT_EQ(picture.height, 80);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
            const bool inside = x >= 35 && x < 45 && y >= 35 && y < 45;
            ASSERT_EQ(at(picture, x, y)[3], inside ? 255 : 0) << x << ' ' << y;
        }
    // Pixels half as wide: the same part of the width.
    EXPECT_EQ(covered(draw(std::span(&square_, 1), {160, 80})), 20 * 10);
}

TEST_F(PreviewTest, ShowsItsSkin) {
    // The skin's left edge is at x = 0 of the square, y from 0 (the upper edge is along +y), and
    // the camera that looks down with its head to +x sees +y on the left.
    const Picture picture = draw(square_);
    int red = 0, green = 0;
    for (int y = 35; y < 45; ++y)
        for (int x = 35; x < 45; ++x) {
            const auto [r, g, b, a] = at(picture, x, y);
            EXPECT_EQ(b, 0);
            (r > g ? red : green) += 1;
            EXPECT_GT(std::max(r, g), 150) << "lit";
        }
    EXPECT_GE(red, 25);
    EXPECT_GE(green, 25);
}

TEST_F(PreviewTest, TurnsMovesAndInterpolates) {
    PreviewModel lifted = square_; // frame "jump": 4 units higher, so nearer
    lifted.frame = 1;
    EXPECT_GT(covered(draw(lifted)), covered(draw(square_)));
    lifted.old_frame = 0;
    lifted.backlerp = 1.0f;
    EXPECT_EQ(draw(lifted).rgba, draw(square_).rgba);
    PreviewModel moved = square_;
    moved.origin = {0, -10, 0};
    EXPECT_EQ(at(draw(moved), 50, 40)[3], 255) << "-y is on the right";
    PreviewModel turned = square_;
    turned.angles = {0, 90, 0}; // +x becomes +y: the square lies at x -10..0
    EXPECT_EQ(at(draw(turned), 40, 50)[3], 255) << "-x is below";
}

TEST_F(PreviewTest, NearerThingsHideOthersAndBacksAreNotSeen) {
    PreviewModel nearer = square_;
    nearer.origin.z = 10;
    nearer.skin.clear(); // its own cannot be read: a checker
    const PreviewModel both[] = {square_, nearer}, turned[] = {nearer, square_};
    EXPECT_EQ(draw(both).rgba, draw(turned).rgba);
    EXPECT_EQ(draw(both).rgba, draw(nearer).rgba);
    EXPECT_EQ(covered(draw(std::span(&square_, 1), {80, 80}, -90.0f, -41.0f)), 0) << "from below";
    EXPECT_EQ(covered(draw(std::span(&square_, 1), {80, 80}, 90.0f, 1.5f)), 0) << "too near";
}

TEST_F(PreviewTest, AlphaIsCoverage) {
    PreviewModel faint = square_;
    faint.alpha = 0.5f;
    const Picture picture = draw(faint);
    EXPECT_EQ(at(picture, 40, 40)[3], 128);
    EXPECT_EQ(at(picture, 40, 40)[0], at(draw(square_), 40, 40)[0]);
    faint.alpha = 0.0f;
    EXPECT_EQ(covered(draw(faint)), 0);
}

TEST_F(PreviewTest, WrongFilesAreToldOnce) {
    PreviewModel missing = square_, broken = square_, without_skin = square_;
    missing.model = "models/none.md2";
    broken.model = "models/broken.md2";
    without_skin.skin = "skins/none.pcx";
    const PreviewModel models[] = {missing, broken, without_skin};
    EXPECT_EQ(covered(draw(models)), 100) << "as a checker";
    EXPECT_EQ(warnings_, 3);
    draw(models);
    EXPECT_EQ(warnings_, 3);
    painter_.clear();
    draw(models);
    EXPECT_EQ(warnings_, 6);
}

TEST_F(PreviewTest, SizesThatAreNoPicture) {
    for (const glm::ivec2 size : {glm::ivec2(0, 5), {5, 0}, {-3, 4}, {5000, 5}})
        EXPECT_TRUE(draw(std::span(&square_, 1), size).rgba.empty());
    PreviewModel far_away = square_;
    far_away.origin = glm::vec3(1e30f);
    far_away.angles = glm::vec3(1e30f);
    far_away.frame = -7;
    draw(far_away); // no more than not failing
}

} // namespace
} // namespace vigil::refresh
