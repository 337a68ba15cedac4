// SPDX-License-Identifier: GPL-2.0-or-later
// What the techniques say about their own probabilities, exhaustively: at every primary hit of a
// picture the probabilities of all lights add up to 1 (or to the share of draws that can find a
// light), lights are drawn as often as they say, and a draw brings along the very probability that
// is computed for it afterwards.
#include "light/statistics.h"
#include "light_answers.h"
#include "render_test.h"
#include "technique_variations.h"

#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iostream>

namespace vigil::test {
namespace {

constexpr uint32_t draws_per_pixel = 2048;

class LightProbability : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        set_size(24, 16);
    }

    static LightAnswers ask(const Shot& shot, std::string_view technique) {
        set("pt_nee", technique);
        learn(shot, frames_to_learn);
        return ask_lights(renderer(), technique, draws_per_pixel);
    }

    /// How many draws find no light, per draw: `part` of them is a whole multiple of one of 1 / 1
    /// .. 1 / starts.
    struct Blanks {
        double part = 1.0;
        uint32_t starts = 1;
        bool any = false; // true: only the draws themselves tell how many
    };

    /// Distance of a sum of probabilities from the nearest that is possible.
    static double impossible(double sum, const Blanks& blanks) {
        double nearest = 1.0;
        for (uint32_t i = 1; i <= blanks.starts; ++i) {
            const double found = (1.0 - sum) / blanks.part * i;
            nearest = std::min(nearest, std::abs(found - std::round(found)));
        }
        return nearest;
    }

    static void judge(const LightAnswers& answers, const Blanks& blanks) {
        size_t lit = 0, worst_pixel = 0;
        double scores = 0.0, worst = 0.0;
        for (size_t pixel = 0; pixel < answers.hits.size(); ++pixel) {
            if (answers.hits[pixel].primitive == shader::NONE) continue;
            const std::span<const float> claimed =
                std::span(answers.probabilities).subspan(pixel * answers.row, answers.row);
            const std::span<const uint32_t> seen =
                std::span(answers.draws).subspan(pixel * answers.row, answers.row);
            double sum = 0.0;
            for (size_t light = 0; light + 1 < answers.row; ++light) {
                ASSERT_GE(claimed[light], 0.0f) << "pixel " << pixel << " light " << light;
                ASSERT_TRUE(std::isfinite(claimed[light]));
                sum += static_cast<double>(claimed[light]);
                // Never drawn where it says never.
                const bool never = claimed[light] == 0.0f;
                ASSERT_TRUE(!never || seen[light] == 0) << "pixel " << pixel << " light " << light;
            }
            if (!blanks.any) {
                EXPECT_LT(impossible(sum, blanks), 2e-5)
                    << "pixel " << pixel << ": probabilities add up to " << sum;
            }
            EXPECT_LT(sum, 1.0 + 2e-5);
            // The walk adds up weights in the same order; a stretched random number costs some
            // digits.
            EXPECT_LT(answers.errors[pixel], 1e-4f) << "pixel " << pixel;

            std::vector<double> expected(claimed.begin(), claimed.end());
            expected.back() = std::max(1.0 - sum, 0.0);
            const std::optional<double> found = selection_score(expected, seen);
            if (!found) continue;
            const double score = *found;
            ++lit;
            scores += score;
            if (std::abs(score) > std::abs(worst)) {
                worst = score;
                worst_pixel = pixel;
            }
        }
        const double together = scores / std::sqrt(static_cast<double>(lit));
        std::cout << fmt::format("{} pixels: chi-square {:+.2f} together, {:+.2f} at the worst\n",
                                 lit, together, worst);
        EXPECT_GT(lit, 300u);
        EXPECT_LT(std::abs(together), score_limit);
        EXPECT_LT(std::abs(worst), score_limit) << "pixel " << worst_pixel;
    }

    /// With half of the search for new lights in the cluster's list, and then with none of it
    /// there.
    void judge_all(const Shot& shot) {
        set("pt_explore_local", "0.5");
        judge_techniques(shot, [](std::string_view) { return true; });
        set("pt_explore_local", "0");
        judge_techniques(shot, [](std::string_view name) { return name == "vlc"; });
    }

    void judge_techniques(const Shot& shot, const std::function<bool(std::string_view)>& wanted) {
        for (const TechniqueInfo& info : technique_infos) {
            if (info.name == "brute" || !wanted(info.name)) continue; // the first draws nothing
            for (const TechniqueVariation& variation : variations_of(info.name)) {
                SCOPED_TRACE(fmt::format("{} {}", info.name, variation.label));
                for (const auto& [name, value] : variation.variables)
                    set(name, value);
                const LightAnswers answers = ask(shot, info.name);
                if (info.name == "vlc") {
                    const shader::GuidingWork learned = renderer().guiding().statistics(0);
                    EXPECT_GT(learned.cached_lights, 2 * learned.cached_leaves);
                    EXPECT_TRUE(cvars()->pt_vlc_bucket == 32 ||
                                learned.cached_buckets > learned.cached_leaves + 20);
                }
                judge(answers, blanks_of(info.name, static_cast<uint32_t>(answers.row - 1)));
            }
        }
    }

    static Blanks blanks_of(std::string_view technique, uint32_t lights) {
        if (technique == "uniform" || technique == "power") return {};
        // Some starts of a walk with a stride may hold only lights that face away.
        if (technique == "sll") {
            const auto limit = static_cast<uint32_t>(cvars()->pt_sll_max);
            return {1.0, (lights + limit - 1) / limit};
        }
        // Some buckets, too. A walk through the cluster's list throws away what the cache has.
        if (technique == "vlc")
            return {1.0 - static_cast<double>(cvars()->pt_vlc_explore), 16,
                    cvars()->pt_explore_local > 0.0f};
        Blanks unknown;
        unknown.any = true;
        return unknown;
    }
};

TEST_F(LightProbability, OfStaticLights) {
    load("rooms");
    Shot shot;
    shot.view = {{290, 20, 96}, {5, 55, 0}, 90};
    judge_all(shot);
}

TEST_F(LightProbability, OfMovingAndDynamicLights) {
    load("rooms");
    Shot shot;
    shot.view = {{40, 40, 60}, {0, 35, 0}, 90};
    refresh::Entity door;
    door.number = 1;
    door.model = renderer().register_model("*1");
    door.origin = {-40, -20, 20};
    shot.entities = {door};
    shot.dynamic_lights = {{7, {120, 120, 40}, 16.0f, {20, 10, 5}},
                           {8, {200, 60, 100}, 2.0f, {5, 20, 40}}};
    judge_all(shot);
}

} // namespace
} // namespace vigil::test
