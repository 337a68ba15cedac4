// SPDX-License-Identifier: GPL-2.0-or-later
// What every light-sampling technique has to keep, on every scene of light_scenes.h; a technique is
// tested by its row in shared/techniques.h. Where it tells probabilities, they add up to 1 (or to
// the share of draws that can find a light), lights are drawn as often as they say, and a draw
// brings along the very probability that is computed for it afterwards. No light is drawn that has
// none. And the mean of next event estimation is that of brute force: of all lights, one after the
// other, without a choice. Each judgement is made once more with a planted error, which must be
// found.
#include "light_answers.h"
#include "light_scenes.h"
#include "numerics/record.h"
#include "technique_settings.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <map>
#include <numeric>
#include <optional>

namespace vigil::test {
namespace {

constexpr uint32_t usual_draws_per_pixel = 2048;
constexpr uint32_t batch_count = 16, draws_per_batch = 128;
constexpr int block = 4;
/// Relative error that is planted into probabilities: half of the lights get it, half lose it, two
/// and two (of neighbours, one may be black).
constexpr double planted = 0.03;

/// Draws of all pixels together, by groups of lights: sums of different multinomials have a little
/// less variance than one of the mean probability, so that the score is on the safe side.
double pooled_score(const LightAnswers& answers, double error, uint32_t draws_per_pixel) {
    constexpr size_t groups = 32;
    std::vector<double> shares(groups + 1, 0.0);
    std::vector<uint64_t> counts(groups + 1, 0);
    double pixels = 0.0;
    for (size_t pixel = 0; pixel < answers.hits.size(); ++pixel) {
        if (!answers.has_surface(pixel)) continue;
        pixels += 1.0;
        const std::span<const LightAnswer> row = answers.row(pixel);
        double sum = 0.0;
        for (size_t light = 0; light < answers.lights; ++light) {
            const double share = static_cast<double>(row[light].probability) / answers.draws;
            shares[light % groups] += share * (light / 2 % 2 == 0 ? 1.0 + error : 1.0 - error);
            counts[light % groups] += row[light].draws;
            sum += share;
        }
        shares[groups] += std::max(1.0 - sum, 0.0);
        counts[groups] += row[answers.lights].draws;
    }
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    SelectionBins bins(pixels * draws_per_pixel);
    for (size_t group = 0; group <= groups; ++group)
        bins.add(shares[group] / total, counts[group]);
    return bins.score().value_or(0.0);
}

class LightTechniqueTest : public RenderTest,
                           public testing::WithParamInterface<TechniqueSettings> {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        // One set of shaders for all scenes, but caches are among the features.
        set("pt_features", GetParam().caches ? "all" : "auto");
        if (!GetParam().caches) set("pt_vlc_enough", "1e-6");
        GetParam().set();
    }

    /// Loads the scene and lets the technique learn it.
    void bring(LightScene& scene) {
        set_size(scene.size.x, scene.size.y);
        load(scene.level, scene.edit);
        if (scene.sky_turns)
            renderer().set_sky("court", scene.sky_turns->x,
                               {scene.sky_turns->y, scene.sky_turns->z, scene.sky_turns->w});
        if (scene.door) scene.shot.entities[0].model = renderer().register_model("*1");
        learn(scene.shot, frames_to_learn);
        // The same primary hits for all: a ray may or may not stop at a window.
        vkpt::FrameDescription frame = params(scene.shot);
        frame.frame = 1;
        trace(frame, 1);
        if (!pass_)
            pass_.emplace(
                light_technique_pass(renderer(), GetParam().technique, GetParam().caches));
    }

    static size_t pixels() {
        const glm::uvec2 size = renderer().buffers().size();
        return size_t{size.x} * size.y;
    }

    static size_t light_count() { return renderer().scene()->lights().lights().size(); }

    /// Independent pictures of the light that arrives at primary hits, by draws.
    PictureBatches sampled(uint32_t effort) {
        add_light_buffers(*pass_, renderer(), batch_count * effort);
        run_at_pixels(*pass_, renderer(), batch_count * effort, {2, draws_per_batch});
        return add_up(batch_count, effort, 1);
    }

    /// The same from all lights. They are looked at one by one, so few points on each do.
    PictureBatches reference(uint32_t effort) {
        constexpr uint32_t batches = 6, lights_at_once = 512;
        const auto parts = static_cast<uint32_t>(
            std::max<size_t>((light_count() + lights_at_once - 1) / lights_at_once, 1));
        const auto repeats = effort * static_cast<uint32_t>(std::clamp<size_t>(
                                          600 / std::max<size_t>(light_count(), 1), 1, 40));
        add_light_buffers(*pass_, renderer(), batches * repeats * parts);
        run_at_pixels(*pass_, renderer(), batches * repeats * parts, {3, lights_at_once});
        return add_up(batches, repeats, parts);
    }

    /// Batches of what the shader wrote: means of `repeats` sums of `parts` pictures.
    PictureBatches add_up(uint32_t batches, uint32_t repeats, uint32_t parts) {
        const size_t size = 3 * pixels();
        const std::vector<float> values = pass_->read<float>(1, size * batches * repeats * parts);
        PictureBatches result(cvars()->vid_width, cvars()->vid_height, block);
        std::vector<float> mean(size);
        for (uint32_t batch = 0; batch < batches; ++batch) {
            std::ranges::fill(mean, 0.0f);
            const size_t first = size_t{batch} * repeats * parts * size;
            for (size_t i = 0; i < size * repeats * parts; ++i)
                mean[i % size] += values[first + i] / static_cast<float>(repeats);
            result.add(mean);
        }
        return result;
    }

    /// Asks for all promises on each of these scenes.
    void judge_scenes(std::vector<LightScene> scenes);

    std::optional<vkpt::SidePass> pass_;
};

/// Distance of a sum of probabilities from the nearest that is possible.
double impossible(double sum, const Blanks& blanks, size_t lights) {
    const size_t walk = std::min<size_t>(blanks.walk, std::max<size_t>(lights, 1));
    const auto parts = static_cast<uint32_t>(
        blanks.parts > 1 ? blanks.parts : (std::max<size_t>(lights, 1) + walk - 1) / walk);
    double nearest = std::abs(sum); // where nothing can shine, there is nothing to draw
    for (uint32_t i = 1; i <= parts; ++i) {
        const double found = (1.0 - sum) / blanks.share * i;
        nearest = std::min(nearest, std::abs(found - std::round(found)));
    }
    if (blanks.sun_apart) {
        Blanks others = blanks;
        others.sun_apart = false;
        nearest = std::min(nearest, impossible(2.0 * sum - 1.0, others, lights));
    }
    return nearest;
}

void judge_support(const LightAnswers& answers) {
    for (size_t pixel = 0; pixel < answers.hits.size(); ++pixel) {
        if (!answers.has_surface(pixel)) continue;
        for (size_t light = 0; light < answers.lights; ++light) {
            const LightAnswer& answer = answers.row(pixel)[light];
            ASSERT_TRUE(std::isfinite(answer.probability) && answer.probability >= 0.0f)
                << "pixel " << pixel << " light " << light;
            ASSERT_TRUE(answer.probability > 0.0f || answer.draws == 0)
                << "pixel " << pixel << " light " << light;
        }
    }
}

void judge_probabilities(const LightAnswers& answers, const Blanks& blanks, bool spread,
                         uint32_t draws_per_pixel) {
    size_t scored = 0, worst_pixel = 0;
    double scores = 0.0, worst = 0.0, worst_error = 0.0;
    for (size_t pixel = 0; pixel < answers.hits.size(); ++pixel) {
        if (!answers.has_surface(pixel)) continue;
        const double sum = answers.sum(pixel);
        ASSERT_LT(sum, answers.draws + 2e-5) << "pixel " << pixel;
        if (blanks.walk > 0) {
            EXPECT_LT(impossible(sum, blanks, answers.lights), 2e-5)
                << "pixel " << pixel << ": probabilities add up to " << sum;
        }
        // The walk adds up weights in the same order; a stretched random number costs some digits.
        EXPECT_LT(answers.errors[pixel], 1e-4f) << "pixel " << pixel;
        worst_error = std::max(worst_error, static_cast<double>(answers.errors[pixel]));

        SelectionBins bins(draws_per_pixel);
        for (const LightAnswer& answer : answers.row(pixel).first(answers.lights))
            bins.add(static_cast<double>(answer.probability) / answers.draws, answer.draws);
        bins.add(std::max(1.0 - sum / answers.draws, 0.0),
                 answers.row(pixel)[answers.lights].draws);
        const std::optional<double> score = bins.score();
        if (!score) continue;
        ++scored;
        scores += *score;
        if (std::abs(*score) > std::abs(worst)) {
            worst = *score;
            worst_pixel = pixel;
        }
    }
    const double together = scores / std::sqrt(static_cast<double>(std::max<size_t>(scored, 1)));
    const double pooled = pooled_score(answers, 0.0, draws_per_pixel),
                 found = pooled_score(answers, planted, draws_per_pixel);
    std::cout << fmt::format(
        "  {} pixels: chi-square {:+.2f} together, {:+.2f} at the worst, {:+.2f} "
        "pooled ({:+.1f} with {:.0f}% planted)\n",
        scored, together, worst, pooled, found, 100.0 * planted);
    EXPECT_LT(std::abs(together), score_limit);
    EXPECT_LT(std::abs(worst), score_limit) << "pixel " << worst_pixel;
    // Fewer draws than pixels' may differ: only too much difference counts.
    EXPECT_LT(pooled, score_limit);
    // The test can fail: the same draws against probabilities that are a little off, where as many
    // found a light as it takes to see that.
    if (scored > 100 && answers.lights >= 8 && spread &&
        planted * std::sqrt(answers.found()) > 2.0 * score_limit) {
        EXPECT_GT(found, score_limit);
    }
}

void judge_means(const PictureBatches& sampled, const PictureBatches& reference,
                 const LightScene& scene) {
    if (scene.dark) {
        for (size_t batch = 0; batch < sampled.batches(); ++batch)
            for (size_t i = 0; i < 3 * sampled.blocks(); ++i)
                ASSERT_EQ(sampled.value(batch, i % 3, i / 3), 0.0);
        return;
    }
    judge("  mean", sampled, reference, scene.bounds);
}

void LightTechniqueTest::judge_scenes(std::vector<LightScene> scenes) {
    for (LightScene& scene : scenes) {
        SCOPED_TRACE(scene.name);
        bring(scene);
        if (!GetParam().caches && renderer().technique()->uses_guiding()) continue;
        std::cout << fmt::format("{}, {} lights\n", scene.name, light_count());
        const uint32_t draws_per_pixel = usual_draws_per_pixel * scene.effort;
        const LightAnswers answers = ask_lights(*pass_, renderer(), draws_per_pixel);
        const bool any = std::ranges::any_of(
            answers.answers, [&](const LightAnswer& answer) { return answer.probability > 0.0f; });
        if (!renderer().technique()->samples_lights()) {
            EXPECT_FALSE(any) << "rays find the lights, and draws do not";
            continue;
        }
        judge_support(answers);
        Blanks blanks = GetParam().blanks;
        blanks.sun_apart &= renderer().scene()->lights().sun() != shader::NONE;
        if (answers.draws > 0) judge_probabilities(answers, blanks, scene.spread, draws_per_pixel);
        EXPECT_TRUE(any || scene.dark);
        // The first technique's shader makes the reference of all.
        static std::map<std::string, PictureBatches> references;
        if (!references.contains(scene.name))
            references.emplace(scene.name, reference(scene.effort));
        judge_means(sampled(scene.effort), references.at(scene.name), scene);
        if (!scene.extreme.empty())
            record("scenes", scene.extreme,
                   scene.dark
                       ? "every technique: nothing is drawn that cannot be, and all is black"
                       : "every technique: drawn as often as told, mean that of brute force");
    }
}

TEST_P(LightTechniqueTest, KeepsItsPromises) {
    judge_scenes(light_scenes());
}

/// Extremes take ten seconds for each: the defaults do.
class ExtremeLights : public LightTechniqueTest {};

TEST_P(ExtremeLights, KeepThem) {
    judge_scenes(extreme_light_scenes());
}

std::vector<TechniqueSettings> default_settings() {
    std::vector<TechniqueSettings> all = technique_settings();
    std::erase_if(all, [](const auto& settings) { return settings.label != "Default"; });
    return all;
}

std::string name_of(const testing::TestParamInfo<TechniqueSettings>& given) {
    return fmt::format("{}_{}", given.param.technique, given.param.label);
}

INSTANTIATE_TEST_SUITE_P(AllTechniques, LightTechniqueTest, testing::ValuesIn(technique_settings()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(AllTechniques, ExtremeLights, testing::ValuesIn(default_settings()),
                         name_of);

} // namespace
} // namespace vigil::test
