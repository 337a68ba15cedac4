// SPDX-License-Identifier: GPL-2.0-or-later
// The reflection model: energy, reciprocity, agreement of sampling, density and value, and safety
// at bad angles.
#include "shared/brdf.h"
#include "shared/random.h"
#include "statistics.h"

#include <gtest/gtest.h>

namespace vigil::shader {
namespace {

using test::Sample;
using test::z_limit;

const vec3 up(0, 0, 1);

Brdf make_brdf(float albedo, float f0, float alpha) {
    Brdf brdf = brdf_lambert(vec3(albedo));
    brdf.f0 = f0;
    brdf.alpha = alpha;
    return brdf;
}

vec3 view_at(float cosine) {
    return {std::sqrt(1.0f - cosine * cosine), 0.0f, cosine};
}

std::vector<Brdf> many_brdfs() {
    std::vector<Brdf> brdfs{brdf_lambert(vec3(0.7f))};
    for (const float f0 : {0.02f, 0.04f, 0.3f, 1.0f})
        for (const float alpha : {0.01f, 0.04f, 0.1f, 0.2f, 0.4f, 0.7f, 1.0f})
            brdfs.push_back(make_brdf(0.7f, f0, alpha));
    return brdfs;
}

/// Share of the light that leaves: stratified draws of both lobes.
double reflected(const Brdf& brdf, vec3 view) {
    constexpr int grid = 128;
    const float p =
        brdf.f0 > 0.0f ? specular_probability(brdf, brdf_cosine(up, brdf_view(up, view))) : 0.0f;
    double sum = 0.0;
    for (int lobe = 0; lobe < 2; ++lobe) {
        const float share = lobe == 0 ? p : 1.0f - p;
        const float choose = lobe == 0 ? 0.5f * p : 0.5f + 0.5f * p;
        if (share == 0.0f) continue;
        for (int i = 0; i < grid; ++i) {
            for (int j = 0; j < grid; ++j) {
                const vec3 u((static_cast<float>(i) + 0.5f) / grid,
                             (static_cast<float>(j) + 0.5f) / grid, choose);
                const BrdfSample drawn = brdf_sample(brdf, up, view, u);
                if (drawn.seen.pdf > 0.0f)
                    sum += double(share) * drawn.seen.value.x / drawn.seen.pdf;
            }
        }
    }
    return sum / (grid * grid);
}

TEST(Brdf, LambertReflectsItsAlbedo) {
    for (const float cosine : {0.01f, 0.5f, 1.0f})
        EXPECT_NEAR(reflected(brdf_lambert(vec3(0.7f)), view_at(cosine)), 0.7, 1e-6);
}

TEST(Brdf, WhiteFurnaceNeverGainsEnergy) {
    for (const float f0 : {0.02f, 0.04f, 0.1f, 0.3f, 0.6f, 1.0f}) {
        for (const float alpha : {0.01f, 0.03f, 0.1f, 0.15f, 0.2f, 0.35f, 0.5f, 0.7f, 1.0f}) {
            for (const float cosine :
                 {0.001f, 0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.6f, 0.7f, 0.85f, 1.0f}) {
                const double energy = reflected(make_brdf(1.0f, f0, alpha), view_at(cosine));
                EXPECT_LE(energy, 1.0005) << f0 << ' ' << alpha << ' ' << cosine;
                EXPECT_GT(energy, 0.3) << f0 << ' ' << alpha << ' ' << cosine;
            }
        }
    }
    // A nearly smooth white surface keeps nearly everything.
    EXPECT_GT(reflected(make_brdf(1.0f, 0.04f, 0.01f), view_at(0.5f)), 0.99);
}

TEST(Brdf, IsReciprocal) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (const Brdf& brdf : many_brdfs()) {
        for (int i = 0; i < 200; ++i) {
            const vec3 a = sample_cosine_hemisphere(random_next2(random));
            const vec3 b = sample_cosine_hemisphere(random_next2(random));
            if (std::min(a.z, b.z) < 0.01f) continue;
            const double ab = brdf_evaluate(brdf, up, a, b).value.x / b.z;
            const double ba = brdf_evaluate(brdf, up, b, a).value.x / a.z;
            EXPECT_NEAR(ab, ba, 1e-4 * (ab + ba));
        }
    }
}

// E over uniform directions of pdf * 2 pi equals the chance that brdf_sample ends above the
// horizon, and the mean of a test function over samples equals its mean under the pdf.
TEST(Brdf, SamplesFollowThePdf) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    for (const Brdf& brdf : many_brdfs()) {
        if (brdf.f0 > 0.0f && brdf.alpha < 0.1f) continue; // too narrow for uniform directions
        for (const float cosine : {-0.2f, 0.05f, 0.4f, 0.9f}) {
            const vec3 view = view_at(cosine);
            Sample above, mean_x, integral, moment_x;
            for (int i = 0; i < 40000; ++i) {
                const BrdfSample drawn = brdf_sample(brdf, up, view, random_next3(random));
                const bool valid = drawn.seen.pdf > 0.0f;
                above.add(valid ? 1.0 : 0.0);
                mean_x.add(valid ? drawn.direction.x : 0.0);
                const vec2 u = random_next2(random);
                const float z = u.x, r = std::sqrt(1.0f - z * z);
                const vec3 uniform(r * std::cos(TWO_PI * u.y), r * std::sin(TWO_PI * u.y), z);
                const double pdf = double(brdf_pdf(brdf, up, view, uniform)) * TWO_PI;
                integral.add(pdf);
                moment_x.add(pdf * uniform.x);
            }
            const auto z = [](const Sample& a, const Sample& b, double floor) {
                return (a.mean() - b.mean()) /
                       std::hypot(std::hypot(a.standard_error(), b.standard_error()), floor);
            };
            EXPECT_LT(std::abs(z(above, integral, 1e-4)), z_limit)
                << brdf.f0 << ' ' << brdf.alpha << ' ' << cosine;
            EXPECT_LT(std::abs(z(mean_x, moment_x, 1e-4)), z_limit)
                << brdf.f0 << ' ' << brdf.alpha << ' ' << cosine;
        }
    }
}

TEST(Brdf, NarrowLobesIntegrateToOne) {
    // Directions drawn by the lobe itself: the mean of 1 / pdf over a patch is the patch's solid
    // angle.
    Random random = random_begin(uvec2(0, 0), 0, 3);
    for (const float alpha : {0.01f, 0.03f}) {
        Brdf brdf = make_brdf(0.0f, 0.5f, alpha); // black base: GGX only
        const vec3 view = view_at(0.7f), mirror(-view.x, 0.0f, view.z);
        const float size = 2.0f * alpha * alpha; // 1 - cos of a cone of half angle 2 alpha
        Sample solid_angle;
        for (int i = 0; i < 40000; ++i) {
            const BrdfSample drawn = brdf_sample(brdf, up, view, random_next3(random));
            const bool inside = drawn.seen.pdf > 0.0f && in_cone(drawn.direction, mirror, size);
            solid_angle.add(inside ? 1.0 / drawn.seen.pdf : 0.0);
        }
        EXPECT_LT(std::abs(solid_angle.z(TWO_PI * size)), z_limit);
    }
}

TEST(Brdf, IsFiniteForAnyDirections) {
    Random random = random_begin(uvec2(0, 0), 0, 4);
    std::vector<vec3> directions{up, -up, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    directions.push_back(up * (1.0f + 1e-6f)); // n.v slightly above 1
    directions.push_back(normalize(vec3(1, 0, -1e-4f)));
    directions.push_back(normalize(vec3(1, 0, 1e-7f)));
    for (int i = 0; i < 40; ++i)
        directions.push_back(normalize(sample_sphere(random_next2(random))));
    for (const Brdf& brdf : many_brdfs()) {
        for (const vec3& view : directions) {
            for (const vec3& light : directions) {
                const BrdfValue seen = brdf_evaluate(brdf, up, view, light);
                ASSERT_TRUE(std::isfinite(seen.value.x) && seen.value.x >= 0.0f);
                ASSERT_TRUE(std::isfinite(seen.pdf) && seen.pdf >= 0.0f);
                if (light.z <= 0.0f) {
                    ASSERT_EQ(seen.value.x, 0.0f);
                    ASSERT_EQ(seen.pdf, 0.0f);
                } else {
                    ASSERT_GT(seen.pdf, 0.0f);
                }
            }
            for (const float x : {0.0f, 0.5f, 1.0f - 1.0f / 16777216.0f})
                for (const float y : {0.0f, 0.5f, 1.0f - 1.0f / 16777216.0f})
                    for (const float z : {0.0f, 1.0f - 1.0f / 16777216.0f}) {
                        const BrdfSample drawn = brdf_sample(brdf, up, view, vec3(x, y, z));
                        ASSERT_NEAR(length(drawn.direction), 1.0f, 1e-5f);
                        ASSERT_TRUE(std::isfinite(drawn.seen.value.x) &&
                                    std::isfinite(drawn.seen.pdf));
                    }
        }
    }
}

TEST(Brdf, GrazingHighlightsOutshineTheBase) {
    const Brdf brdf = make_brdf(0.5f, 0.04f, 0.05f);
    const vec3 view = view_at(0.1f), mirror(-view.x, 0, view.z);
    EXPECT_GT(brdf_evaluate(brdf, up, view, mirror).value.x,
              50.0f * brdf_evaluate(brdf_lambert(vec3(0.5f)), up, view, mirror).value.x);
}

} // namespace
} // namespace vigil::shader
