// SPDX-License-Identifier: GPL-2.0-or-later
// The glossy lobe's transformed cosines: the committed table is what the fit gives, its albedos are
// the BRDF's, and its importance follows the light that GGX really reflects.
#include "ltc_fit/ltc_fit.h"
#include "refresh/vkpt/light/ltc_table.h"
#include "shared/random.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace vigil {
namespace {

using namespace shader;
using test::Sample;

const vec3 up(0, 0, 1);

vec3 view_at(float cosine) {
    return {std::sqrt(1.0f - cosine * cosine), 0.0f, cosine};
}

Brdf make_brdf(float albedo, float f0, float alpha) {
    Brdf brdf = brdf_lambert(vec3(albedo));
    brdf.f0 = f0;
    brdf.alpha = alpha;
    return brdf;
}

LtcSurface prepare(vec3 normal, vec3 view, const Brdf& brdf) {
    return ltc_prepare_glossy(vec3(0.0f), normal, view, brdf,
                              ltc_lookup(brdf.alpha, brdf_cosine(normal, brdf_view(normal, view))));
}

TEST(LtcTable, IsWhatTheFitGives) {
    ASSERT_EQ(ltc_table().size(), size_t{LTC_TABLE_SIZE} * LTC_TABLE_SIZE);
    for (uint row = 0; row < LTC_TABLE_SIZE; row += 6) {
        for (uint column = 3; column < LTC_TABLE_SIZE; column += 7) {
            const LtcEntry& entry = ltc_table()[row * LTC_TABLE_SIZE + column];
            const LtcFit fit = fit_ltc(ltc_table_alpha(column), ltc_table_view_cosine(row));
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(entry.matrix[i], fit.entry.matrix[i],
                            1e-3f + 1e-3f * std::abs(entry.matrix[i]))
                    << row << ' ' << column;
            EXPECT_NEAR(entry.albedo.x, fit.entry.albedo.x, 1e-4f);
            EXPECT_NEAR(entry.albedo.y, fit.entry.albedo.y, 1e-4f);
            EXPECT_LT(fit.excess, ltc_table_view_cosine(row) > 0.1 ? 0.2 : 10.0)
                << row << ' ' << column;
        }
    }
}

TEST(LtcTable, LookUpReachesEveryEntryAndInterpolates) {
    for (uint row = 0; row < LTC_TABLE_SIZE; ++row) {
        for (uint column = 1; column < LTC_TABLE_SIZE; ++column) {
            const float alpha = static_cast<float>(ltc_table_alpha(column));
            const float cosine = static_cast<float>(ltc_table_view_cosine(row));
            const LtcEntry& entry = ltc_table()[row * LTC_TABLE_SIZE + column];
            const LtcEntry found = ltc_lookup(alpha, cosine);
            EXPECT_NEAR(found.matrix.x, entry.matrix.x, 2e-2f) << row << ' ' << column;
            EXPECT_NEAR(found.albedo.x, entry.albedo.x, 2e-2f) << row << ' ' << column;
        }
    }
    for (const float bad : {-1.0f, 2.0f}) {
        const LtcEntry found = ltc_lookup(bad, bad);
        EXPECT_TRUE(std::isfinite(found.matrix.x) && std::isfinite(found.albedo.y));
    }
}

TEST(LtcTable, MatricesKeepOrientation) {
    for (const LtcEntry& entry : ltc_table())
        EXPECT_GT(entry.matrix.x * entry.matrix.w - entry.matrix.y * entry.matrix.z, 0.0f);
}

TEST(LtcTable, AlbedosAreTheBrdfs) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (const float alpha : {0.05f, 0.2f, 0.5f, 1.0f}) {
        for (const float cosine : {0.2f, 0.6f, 0.95f}) {
            for (const float f0 : {0.04f, 0.5f}) {
                const Brdf brdf = make_brdf(0.0f, f0, alpha);
                Sample energy;
                for (int i = 0; i < 20000; ++i) {
                    const BrdfSample drawn =
                        brdf_sample(brdf, up, view_at(cosine), random_next3(random));
                    energy.add(drawn.seen.pdf > 0.0f ? drawn.seen.value.x / drawn.seen.pdf : 0.0);
                }
                EXPECT_NEAR(prepare(up, view_at(cosine), brdf).specular, energy.mean(),
                            test::z_limit * energy.standard_error() + 0.004);
            }
        }
    }
}

/// Light of unit radiance that the surface reflects from a light: a fine grid of samples.
double reflected(const Brdf& brdf, vec3 normal, vec3 view, const Light& light) {
    constexpr int grid = 96;
    double sum = 0.0;
    for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
            const vec2 u((static_cast<float>(i) + 0.5f) / grid,
                         (static_cast<float>(j) + 0.5f) / grid);
            const LightSample seen = sample_light(light, vec3(0.0f), u);
            sum +=
                double(brdf_evaluate(brdf, normal, view, seen.direction).value.x) * seen.geometry;
        }
    }
    return sum / (grid * grid);
}

// Importance over what is truly reflected, for random lights and surfaces in general orientation:
// close to 1 for most, and never far off where much is reflected.
TEST(LtcTable, ImportanceFollowsGgx) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    for (const float alpha : {0.1f, 0.25f, 0.5f, 0.9f}) {
        std::vector<double> errors;
        double total = 0.0, missed = 0.0;
        for (int i = 0; i < 400; ++i) {
            const vec3 normal = normalize(sample_sphere(random_next2(random)));
            const Basis basis = make_basis(normal);
            const vec3 view = to_world(basis, sample_cosine_hemisphere(random_next2(random)));
            const vec3 center =
                100.0f * to_world(basis, sample_cosine_hemisphere(random_next2(random)));
            const vec3 e1 = 30.0f * normalize(sample_sphere(random_next2(random)));
            const vec3 e2 = 30.0f * normalize(sample_sphere(random_next2(random)));
            Light light{center - (e1 + e2) / 3.0f, e1, e2, vec3(1.0f), 0};
            if (light_facing(light, vec3(0.0f)) < 0.0f) std::swap(light.e1, light.e2);
            const Brdf brdf = make_brdf(0.0f, 0.5f, alpha);
            const double truth = reflected(brdf, normal, view, light);
            const double got = ltc_importance(prepare(normal, view, brdf), light, true);
            ASSERT_TRUE(std::isfinite(got));
            ASSERT_GE(got, 0.0);
            ASSERT_EQ(truth > 0.0, got > 0.0);
            total += truth;
            missed += std::abs(got - truth);
            if (truth > 1e-3) errors.push_back(std::abs(std::log2(got / truth)));
        }
        std::sort(errors.begin(), errors.end());
        ASSERT_GT(errors.size(), 50u);
        EXPECT_LT(errors[errors.size() / 2], 0.3) << alpha; // within 23%, mostly
        EXPECT_LT(errors[errors.size() * 95 / 100], 1.6)
            << alpha; // within a factor of 3, nearly always
        EXPECT_LT(missed, 0.2 * total) << alpha;
    }
}

TEST(LtcTable, DiffuseOnlyIsTheSameWithoutALobe) {
    const Light light{{-10, -10, 50}, {0, 20, 0}, {20, 0, 0}, vec3(2.0f), 0};
    const Brdf brdf = brdf_lambert(vec3(0.4f));
    const LtcSurface surface = ltc_prepare_diffuse(vec3(0.0f), up, 0.4f);
    EXPECT_GT(ltc_importance(surface, light, false), 0.0f);
    EXPECT_EQ(ltc_importance(surface, light, false), ltc_importance(surface, light, true));
    // A coat of next to no reflectance leaves the base's importance nearly as it was.
    Brdf coated = brdf;
    coated.f0 = 1e-6f;
    coated.alpha = 1.0f;
    EXPECT_NEAR(ltc_importance(prepare(up, up, coated), light, true) /
                    ltc_importance(surface, light, false),
                1.0, 0.01);
}

TEST(LtcTable, BadViewsStayFinite) {
    const Light light{{-10, -10, 50}, {0, 20, 0}, {20, 0, 0}, vec3(2.0f), 0};
    for (const vec3& view :
         {up, -up, vec3(1, 0, 0), up * (1.0f + 1e-6f), normalize(vec3(1, 0, -0.5f))}) {
        for (const float alpha : {0.01f, 0.1f, 1.0f}) {
            const float got =
                ltc_importance(prepare(up, view, make_brdf(0.0f, 0.04f, alpha)), light, true);
            EXPECT_TRUE(std::isfinite(got));
            EXPECT_GT(got, 0.0f);
        }
    }
}

} // namespace
} // namespace vigil
