// SPDX-License-Identifier: GPL-2.0-or-later
// Points on a light for a glossy surface: whatever part of them is drawn along the lobe, densities
// are true and means the same; the part chosen tames the fireflies of a lamp beside a polished
// wall.
#include "shared/light_point.h"
#include "shared/random.h"
#include "statistics.h"

#include "refresh/vkpt/light/ltc_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vigil::shader {
namespace {

using test::Sample;
using test::z_limit;

struct Place {
    vec3 view;
    Brdf brdf;
    Light light{};
};

const vec3 up(0.0f, 0.0f, 1.0f);

Brdf glossy(float alpha) {
    Brdf brdf = brdf_lambert(vec3(0.4f));
    brdf.f0 = 0.04f;
    brdf.alpha = alpha;
    return brdf;
}

/// A lamp that stands on the surface, beside the point: it covers a good part of its sky.
Place beside_a_lamp(float alpha) {
    return {normalize(vec3(-1.0f, 0.0f, 0.8f)),
            glossy(alpha),
            {{3, -10, 0.5f}, {0, 0, 20}, {0, 20, 0}, vec3(30.0f), 0}};
}

Place random_place(Random& random) {
    Place place;
    place.view = sample_sphere(random_next2(random));
    place.view.z = std::abs(place.view.z);
    place.brdf = glossy(0.02f + 0.5f * random_next(random));
    const float distance = std::pow(10.0f, 2.5f * random_next(random));
    place.light = {distance * sample_sphere(random_next2(random)),
                   20.0f * sample_sphere(random_next2(random)),
                   20.0f * sample_sphere(random_next2(random)), vec3(1.0f), 0};
    if (light_facing(place.light, vec3(0.0f)) < 0.0f) std::swap(place.light.e1, place.light.e2);
    return place;
}

float share_of(const Place& place) {
    const float nv = brdf_cosine(up, brdf_view(up, place.view));
    const LtcSurface prepared = ltc_prepare_glossy(vec3(0.0f), up, place.view, place.brdf,
                                                   ltc_lookup(place.brdf.alpha, nv));
    return lobe_share(prepared, place.view, place.brdf, place.light);
}

struct Moments {
    Sample value, geometry;
};

/// What the light adds, and its solid angle, by samples.
Moments sample(const Place& place, float share, int count, uint seed) {
    Random random = random_begin(uvec2(0, 0), 3, seed);
    const SphericalTriangle near = near_light(place.light, vec3(0.0f));
    Moments moments;
    for (int i = 0; i < count; ++i) {
        const LightSample seen = sample_light_glossy(place.light, near, vec3(0.0f), up, place.view,
                                                     place.brdf, share, random_next2(random));
        EXPECT_TRUE(seen.geometry >= 0.0f && std::isfinite(seen.geometry));
        const float value =
            seen.geometry > 0.0f
                ? brdf_evaluate(place.brdf, up, place.view, seen.direction).value.x * seen.geometry
                : 0.0f;
        moments.value.add(value);
        moments.geometry.add(seen.geometry);
    }
    return moments;
}

TEST(LightPoint, LobeDensityIsPartOfTheBrdfs) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (int i = 0; i < 1000; ++i) {
        const Place place = random_place(random);
        const vec3 direction = sample_sphere(random_next2(random));
        const float nv = brdf_cosine(up, brdf_view(up, place.view));
        const float cosine = std::max(direction.z, 0.0f) * INVERSE_PI;
        const float expected =
            mix(cosine, visible_reflection_pdf(place.brdf, up, place.view, direction),
                specular_probability(place.brdf, nv));
        const float pdf = brdf_pdf(place.brdf, up, place.view, direction);
        EXPECT_NEAR(expected, pdf, 1e-5f * pdf);
    }
}

TEST(LightPoint, MeansAreTheSameWhateverFollowsTheLobe) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    for (int i = 0; i < 20; ++i) {
        const Place place = i == 0 ? beside_a_lamp(0.12f) : random_place(random);
        const Moments plain = sample(place, 0.0f, 60000, static_cast<uint>(i));
        for (const float share : {0.2f, LOBE_SHARE_MOST}) {
            const Moments mixed = sample(place, share, 60000, static_cast<uint>(i) + 100u);
            const auto agree = [&](const Sample& a, const Sample& b) {
                return std::abs(a.mean() - b.mean()) <=
                       z_limit * std::hypot(a.standard_error(), b.standard_error()) +
                           1e-5 * std::abs(a.mean());
            };
            EXPECT_TRUE(agree(plain.geometry, mixed.geometry))
                << i << ", share " << share << ": " << plain.geometry.mean() << ", "
                << mixed.geometry.mean();
            EXPECT_TRUE(agree(plain.value, mixed.value))
                << i << ", share " << share << ": " << plain.value.mean() << ", "
                << mixed.value.mean();
        }
    }
}

TEST(LightPoint, LobeIsFollowedWhereItPays) {
    for (const float alpha : {0.02f, 0.05f, 0.12f}) {
        const Place place = beside_a_lamp(alpha);
        const float share = share_of(place);
        const auto spread = [&](float part) {
            return sample(place, part, 40000, 5).value.standard_error();
        };
        double least = spread(0.0f);
        EXPECT_LT(spread(share), 0.7 * least) << alpha;
        for (float part = 0.1f; part < LOBE_SHARE_MOST; part += 0.1f)
            least = std::min(least, spread(part));
        EXPECT_LT(spread(share), 1.1 * least) << alpha;
    }
    // A distant lamp is smaller than the lobe, and a dull surface has none to follow.
    Place distant = beside_a_lamp(0.12f);
    distant.light.v0.x = 2000.0f;
    EXPECT_EQ(share_of(distant), 0.0f);
    EXPECT_EQ(share_of(beside_a_lamp(1.0f)), 0.0f);
}

TEST(LightPoint, ShareIsAPartForAnyLight) {
    Random random = random_begin(uvec2(0, 0), 0, 4);
    for (int i = 0; i < 20000; ++i) {
        Place place = random_place(random);
        place.light.e1 *= std::pow(10.0f, 8.0f * random_next(random) - 4.0f);
        const float share = share_of(place);
        ASSERT_TRUE(share >= 0.0f && share <= LOBE_SHARE_MOST) << share;
    }
}

} // namespace
} // namespace vigil::shader
