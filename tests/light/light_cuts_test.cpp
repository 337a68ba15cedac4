// SPDX-License-Identifier: GPL-2.0-or-later
// What light cuts must be, whatever the lights: each light of a list in one entry of its cluster's
// cut; groups that hold their lights, and weigh nothing only where none of them can shine; and
// fine enough that a draw is nearly as good as one that weighs every light.
#include "refresh/vkpt/light/light_cuts.h"

#include "formats/bsp.h"
#include "refresh/vkpt/light/ltc_table.h"
#include "shared/brdf.h"
#include "shared/random.h"
#include "shared/sampling.h"

#include <algorithm>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <iterator>
#include <set>
#include <tuple>

namespace vigil::test {
namespace {

using shader::CutGroup;
using shader::Light;
using shader::Random;

constexpr uint32_t cluster_count = 5;
constexpr float room = 512.0f; // width of a cluster, in map units

/// Rooms in a row along x.
Bsp rooms() {
    Bsp bsp;
    for (uint32_t cluster = 0; cluster < cluster_count; ++cluster) {
        BspLeaf& leaf = bsp.leafs.emplace_back();
        leaf.cluster = static_cast<int32_t>(cluster);
        leaf.mins = {room * static_cast<float>(cluster), 0.0f, 0.0f};
        leaf.maxs = leaf.mins + glm::vec3(room, room, 256.0f);
    }
    return bsp;
}

/// Small lamps anywhere in the rooms; two of three look down.
std::vector<Light> lamps(uint32_t count, uint32_t seed) {
    Random random = shader::random_begin({count, seed}, 0, 0);
    std::vector<Light> lights;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 at =
            glm::vec3(room * cluster_count, room, 256.0f) * shader::random_next3(random);
        glm::vec3 e1(8.0f, 0.0f, 0.0f), e2(0.0f, -8.0f, 0.0f);
        if (i % 3 == 0) {
            const shader::Basis basis =
                shader::make_basis(shader::sample_sphere(shader::random_next2(random)));
            e1 = 8.0f * basis.tangent;
            e2 = 8.0f * basis.bitangent;
        }
        lights.push_back({at, e1, e2, 10.0f * shader::random_next3(random) + 0.1f, 0});
    }
    return lights;
}

/// Each cluster lists two of three lights, clusters 0 and 1 the same; the last list has all.
LightLists lists_of(uint32_t first, uint32_t count) {
    LightLists lists;
    for (uint32_t list = 0; list <= cluster_count; ++list) {
        if (list == 1) {
            lists.ranges.push_back(lists.ranges.back());
            continue;
        }
        LightRange range{static_cast<uint32_t>(lists.ids.size()), 0};
        for (uint32_t id = first; id < first + count; ++id)
            if (list == cluster_count || (id * 7919u >> 3) % 3 != list % 3) lists.ids.push_back(id);
        range.count = static_cast<uint32_t>(lists.ids.size()) - range.first;
        lists.ranges.push_back(range);
    }
    return lists;
}

/// The lights of an entry.
std::vector<uint32_t> lights_of(const LightCuts& cuts, uint32_t entry) {
    uint32_t first = shader::cut_run_first(entry), count = shader::cut_run_count(entry);
    if ((entry & shader::CUT_GROUP) != 0) {
        const CutGroup& group = cuts.groups()[entry & ~shader::CUT_GROUP];
        first = group.first;
        count = group.count;
    }
    const auto lights = cuts.order().subspan(first, count);
    return {lights.begin(), lights.end()};
}

struct Point {
    glm::vec3 position, normal;
};

Point point_in(Random& random, uint32_t cluster) {
    const glm::vec3 at = glm::vec3(room, room, 256.0f) * shader::random_next3(random);
    return {at + glm::vec3(room * static_cast<float>(cluster), 0.0f, 0.0f),
            shader::sample_sphere(shader::random_next2(random))};
}

/// The draws of a surface as light/cut_draw.glsl makes them, with all probabilities at once.
class Draws {
public:
    Draws(const LightCuts& cuts, std::span<const Light> lights, const shader::LtcSurface& surface)
        : cuts_(cuts), lights_(lights), surface_(surface) {}

    /// Of the lights of these entries.
    void draw(std::span<const uint32_t> entries) {
        std::vector<Weighed> all;
        uint32_t opened = 0;
        for (const uint32_t entry : entries)
            weigh(entry, opened, all);
        weighings += static_cast<double>(all.size());
        choose(all, 1.0);
    }

    double lit = 0.0;       // importances of all lights
    double moment = 0.0;    // second moment of estimates of `lit`
    double weighings = 0.0; // of a draw, on average

private:
    struct Weighed {
        double weight;
        uint32_t entry;
    };

    void weigh_lights(uint32_t first, uint32_t count, std::vector<Weighed>& all) const {
        for (const uint32_t id : cuts_.order().subspan(first, count))
            all.push_back(
                {static_cast<double>(shader::ltc_importance(surface_, lights_[id], true)), id});
    }
    shader::CutWeight weight_of(uint32_t number) const {
        return shader::cut_weight(cuts_.groups()[number], surface_, true);
    }
    void weigh(uint32_t entry, uint32_t& opened, std::vector<Weighed>& all) {
        if ((entry & shader::CUT_GROUP) == 0) {
            weigh_lights(shader::cut_run_first(entry), shader::cut_run_count(entry), all);
            return;
        }
        const uint32_t number = entry & ~shader::CUT_GROUP;
        const CutGroup& group = cuts_.groups()[number];
        const shader::CutWeight weight = weight_of(number);
        const float near = shader::CUT_NEAR + shader::CUT_HARDER * static_cast<float>(opened);
        if (!(weight.importance > 0.0f && weight.width > near)) {
            all.push_back({static_cast<double>(weight.importance), entry});
            return;
        }
        weighings += 1.0;
        if (group.count <= shader::CUT_LEAF) {
            opened += group.count;
            weigh_lights(group.first, group.count, all);
            return;
        }
        opened += 2;
        for (const uint32_t half : {number + 1, cuts_.groups()[number + 1].next})
            weigh(shader::CUT_GROUP | half, opened, all);
    }
    /// One of these is drawn, which comes to be done with `probability`.
    void choose(const std::vector<Weighed>& all, double probability) {
        double sum = 0.0;
        for (const Weighed& one : all)
            sum += one.weight;
        for (const Weighed& one : all) {
            if (!(one.weight > 0.0)) continue;
            const double chosen = probability * one.weight / sum;
            if ((one.entry & shader::CUT_GROUP) == 0) {
                lit += one.weight;
                moment += one.weight * one.weight / chosen;
                continue;
            }
            const uint32_t number = one.entry & ~shader::CUT_GROUP;
            const CutGroup& group = cuts_.groups()[number];
            std::vector<Weighed> parts;
            if (group.count <= shader::CUT_WALK)
                weigh_lights(group.first, group.count, parts);
            else
                for (const uint32_t half : {number + 1, cuts_.groups()[number + 1].next})
                    parts.push_back({static_cast<double>(weight_of(half).importance),
                                     shader::CUT_GROUP | half});
            weighings += chosen * static_cast<double>(parts.size());
            choose(parts, chosen);
        }
    }

    const LightCuts& cuts_;
    std::span<const Light> lights_;
    const shader::LtcSurface& surface_;
};

TEST(LightCuts, HaveEachLightOfAListOnce) {
    const Bsp bsp = rooms();
    for (const uint32_t count : {0u, 1u, 2u, 40u, 3000u}) {
        const std::vector<Light> lights = lamps(count, 1);
        const LightLists lists = lists_of(0, count);
        for (const uint32_t size : {1u, 7u, 32u}) {
            SCOPED_TRACE(fmt::format("{} lights, {} entries", count, size));
            LightCuts cuts;
            cuts.set_still(bsp, {lists, 0, lights}, size);
            ASSERT_EQ(cuts.cuts().size(), lists.ranges.size());
            for (size_t list = 0; list < lists.ranges.size(); ++list) {
                const ClusterCut& cut = cuts.cuts()[list];
                std::vector<uint32_t> found;
                size_t weighed = 0;
                bool groups = true;
                for (const uint32_t entry : cuts.entries().subspan(cut.first, cut.count)) {
                    const std::vector<uint32_t> some = lights_of(cuts, entry);
                    found.insert(found.end(), some.begin(), some.end());
                    const bool group = (entry & shader::CUT_GROUP) != 0;
                    weighed += group ? 1 : some.size();
                    EXPECT_TRUE(groups || !group) << "a group after a run";
                    groups = group;
                }
                EXPECT_LE(weighed, size);
                std::ranges::sort(found);
                const auto wanted = lists.list(list);
                EXPECT_TRUE(std::ranges::equal(found, wanted));
                const auto ordered = cuts.order().subspan(cut.first_light, cut.light_count);
                EXPECT_EQ(ordered.size(), wanted.size());
                EXPECT_TRUE(std::ranges::is_sorted(ordered, {},
                                                   [&](uint32_t id) { return cuts.places()[id]; }));
            }
        }
    }
}

TEST(LightCuts, HaveNoGroupsWhereAllLightsHaveRoom) {
    const std::vector<Light> lights = lamps(40, 7);
    LightCuts cuts;
    cuts.set_still(rooms(), {lists_of(0, 40), 0, lights}, 40);
    for (const uint32_t entry : cuts.entries())
        EXPECT_EQ(entry & shader::CUT_GROUP, 0u);
}

TEST(LightCuts, GroupsHoldTheirLights) {
    const std::vector<Light> lights = lamps(3000, 2);
    LightCuts cuts;
    cuts.set_still(rooms(), {lists_of(0, 3000), 0, lights}, 32);
    cuts.set_energies(lights);
    for (size_t number = 0; number < cuts.groups().size(); ++number) {
        const CutGroup& group = cuts.groups()[number];
        double energy = 0.0;
        for (const uint32_t id : cuts.order().subspan(group.first, group.count)) {
            const Light& light = lights[id];
            for (const glm::vec3& corner : {light.v0, light.v0 + light.e1, light.v0 + light.e2})
                for (glm::length_t axis = 0; axis < 3; ++axis)
                    EXPECT_LE(std::abs(corner[axis] - group.middle[axis]),
                              group.reach[axis] + 1e-3f);
            EXPECT_LE(glm::distance(shader::light_normal(light), group.axis), group.spread);
            energy +=
                static_cast<double>(shader::light_area(light) * shader::luminance(light.radiance));
        }
        EXPECT_NEAR(static_cast<double>(group.energy) / energy, 1.0, 1e-5);
        ASSERT_GT(group.next, number);
        if (group.count <= shader::CUT_LEAF) continue;
        const CutGroup& left = cuts.groups()[number + 1];
        const CutGroup& right = cuts.groups()[left.next];
        EXPECT_EQ(left.first, group.first);
        EXPECT_EQ(right.first, left.first + left.count);
        EXPECT_EQ(left.count + right.count, group.count);
        EXPECT_EQ(right.next, group.next);
    }
}

TEST(LightCuts, WeighNothingOnlyWhereNoLightCanShine) {
    const std::vector<Light> lights = lamps(600, 3);
    LightCuts cuts;
    cuts.set_still(rooms(), {lists_of(0, 600), 0, lights}, 8);
    cuts.set_energies(lights);
    Random random = shader::random_begin({3, 3}, 0, 0);
    uint32_t shone = 0, none = 0;
    for (uint32_t i = 0; i < 4000; ++i) {
        Point point = point_in(random, i % cluster_count);
        const CutGroup& group = cuts.groups()[i % cuts.groups().size()];
        if (i % 4 == 0) { // on a light, in its plane or facing it
            const Light& light = lights[cuts.order()[group.first]];
            point.position = light.v0 + 0.3f * light.e1 + 0.3f * light.e2;
            const glm::vec3 normal = shader::light_normal(light);
            if (i % 8 == 0) point.position += 40.0f * shader::make_basis(normal).tangent;
            point.normal = i % 3 == 0 ? -normal : shader::make_basis(normal).bitangent;
        }
        const shader::LtcSurface surface =
            shader::ltc_prepare_diffuse(point.position, point.normal, 0.5f);
        const float weight = shader::cut_weight(group, surface, true).importance;
        ASSERT_TRUE(std::isfinite(weight) && weight >= 0.0f);
        none += weight == 0.0f ? 1u : 0u;
        for (const uint32_t id : cuts.order().subspan(group.first, group.count)) {
            if (!(shader::ltc_importance(surface, lights[id], true) > 0.0f)) continue;
            ++shone;
            ASSERT_GT(weight, 0.0f) << "point " << i << " light " << id;
        }
    }
    EXPECT_GT(shone, 4000u);
    EXPECT_GT(none, 100u);
}

TEST(LightCuts, MostOfALobeIsThatOfItsPoints) {
    Random random = shader::random_begin({5, 5}, 0, 0);
    for (uint32_t i = 0; i < 300; ++i) {
        const glm::vec3 reach = glm::vec3(0.01f) + shader::random_next3(random);
        glm::vec3 middle = 4.0f * (shader::random_next3(random) - 0.5f);
        middle.z = reach.z * (1.5f + 4.0f * shader::random_next3(random).x);
        constexpr int steps = 32;
        float most = 0.0f;
        for (int x = 0; x <= steps; ++x)
            for (int y = 0; y <= steps; ++y)
                for (int z = 0; z <= steps; ++z) {
                    const glm::vec3 part = 2.0f / steps * glm::vec3(x, y, z) - 1.0f;
                    const glm::vec3 point = middle + part * reach;
                    const float squared = glm::dot(point, point);
                    most = std::max(most, point.z / (squared * squared));
                }
        EXPECT_LE(most, 1.0001f * shader::cut_most(middle, reach));
        EXPECT_GT(most, 0.8f * shader::cut_most(middle, reach));
        middle.z = -reach.z * 1.01f; // below the horizon
        EXPECT_EQ(shader::cut_most(middle, reach), 0.0f);
    }
}

/// A surface at a point, seen from anywhere; glossy ones mirror more than they scatter.
shader::LtcSurface surface_at(const Point& point, bool glossy, Random& random) {
    if (!glossy) return shader::ltc_prepare_diffuse(point.position, point.normal, 0.5f);
    shader::Brdf brdf = shader::brdf_lambert(glm::vec3(0.5f));
    brdf.f0 = 0.6f;
    brdf.alpha = 0.04f;
    const glm::vec3 from = shader::sample_sphere(shader::random_next2(random));
    const glm::vec3 view = glm::dot(from, point.normal) < 0.0f ? -from : from;
    const float cosine = shader::brdf_cosine(point.normal, shader::brdf_view(point.normal, view));
    return shader::ltc_prepare_glossy(point.position, point.normal, view, brdf,
                                      ltc_lookup(brdf.alpha, cosine));
}

/// How many lamps, and on what they shine.
class LightCutDraws : public ::testing::TestWithParam<std::tuple<uint32_t, bool>> {};
INSTANTIATE_TEST_SUITE_P(LightCuts, LightCutDraws,
                         ::testing::Combine(::testing::Values(300u, 1000u, 4000u),
                                            ::testing::Bool()));

TEST_P(LightCutDraws, AreNearlyAsGoodAsAWalkPastAllLights) {
    const auto [count, glossy] = GetParam();
    const std::vector<Light> lights = lamps(count, 4);
    LightCuts cuts;
    cuts.set_still(rooms(), {lists_of(0, count), 0, lights}, 24);
    cuts.set_energies(lights);
    Random random = shader::random_begin({4, 4}, 0, 0);
    // Second moments of estimates, over the squared mean: 1 if every light is weighed.
    std::vector<double> relative;
    double moments = 0.0, squares = 0.0, weighings = 0.0;
    for (uint32_t i = 0; i < 2000; ++i) {
        const uint32_t cluster = i % cluster_count;
        const Point point = point_in(random, cluster);
        const shader::LtcSurface surface = surface_at(point, glossy, random);
        const ClusterCut& cut = cuts.cuts()[cluster];
        Draws draws(cuts, lights, surface);
        draws.draw(cuts.entries().subspan(cut.first, cut.count));
        if (!(draws.lit > 0.0)) continue;
        relative.push_back(draws.moment / (draws.lit * draws.lit));
        moments += draws.moment;
        squares += draws.lit * draws.lit;
        weighings += draws.weighings;
    }
    ASSERT_GT(relative.size(), 1900u);
    std::ranges::sort(relative);
    weighings /= static_cast<double>(relative.size());
    const double median = relative[relative.size() / 2];
    const double most = relative[relative.size() * 9 / 10];
    fmt::print("{} lamps{}: second moment {:.2f} of a picture, {:.2f} of a typical place, {:.2f} "
               "of one of ten; {:.0f} weighings\n",
               count, glossy ? ", glossy" : "", moments / squares, median, most, weighings);
    EXPECT_LT(moments / squares, 1.2);
    EXPECT_LT(median, 1.3);
    EXPECT_LT(most, 1.9);
    EXPECT_LT(weighings, 250.0);
}

TEST(LightCuts, KeepWhatStaysWhileOthersMove) {
    const Bsp bsp = rooms();
    std::vector<Light> lights = lamps(200, 5);
    const LightLists still = lists_of(0, 150), moving = lists_of(150, 50);
    LightCuts cuts;
    cuts.set_still(bsp, {still, 0, std::span(lights).first(150)}, 16);
    const std::vector<uint32_t> entries(cuts.entries().begin(), cuts.entries().end());
    const std::vector<uint32_t> order(cuts.order().begin(), cuts.order().end());
    const auto of_moving = [&] {
        const ClusterCut& cut = cuts.cuts()[cuts.still().cuts + 2];
        std::set<uint32_t> found;
        for (const uint32_t entry : cuts.entries().subspan(cut.first, cut.count))
            for (const uint32_t id : lights_of(cuts, entry))
                found.insert(id);
        return found;
    };
    for (int frame = 0; frame < 3; ++frame) {
        cuts.set_moving(bsp, {moving, 150, std::span(lights).subspan(150)}, 16);
        EXPECT_TRUE(std::ranges::equal(cuts.entries().first(entries.size()), entries));
        EXPECT_TRUE(std::ranges::equal(cuts.order().first(order.size()), order));
        const auto wanted = moving.list(2);
        EXPECT_EQ(of_moving(), std::set<uint32_t>(wanted.begin(), wanted.end()));
        for (size_t id = 150; id < lights.size(); ++id)
            lights[id].v0 += glm::vec3(64.0f, 0.0f, 0.0f);
    }
}

TEST(LightCuts, HaveTheSunLast) {
    std::vector<Light> lights = lamps(20, 6);
    lights.back().flags = shader::LIGHT_SUN;
    LightCuts cuts;
    cuts.set_still(rooms(), {lists_of(0, 20), 0, lights}, 4);
    const ClusterCut& all = cuts.cuts()[cluster_count];
    EXPECT_LE(all.count, 5u); // the cut, and the sun
    EXPECT_EQ(lights_of(cuts, cuts.entries()[all.first + all.count - 1]), std::vector{19u});
    std::vector<uint32_t> found;
    for (const uint32_t entry : cuts.entries().subspan(all.first, all.count - 1))
        std::ranges::copy(lights_of(cuts, entry), std::back_inserter(found));
    EXPECT_EQ(found.size(), 19u);
    EXPECT_EQ(all.light_count, 19u);
}

} // namespace
} // namespace vigil::test
