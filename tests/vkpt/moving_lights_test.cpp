// SPDX-License-Identifier: GPL-2.0-or-later
// Light that moves, in the renderer: ids in the light list stay while a door, a ball or a spot
// moves; a spot shines within its cone alone; and 32 wandering lights leave `vlc` unbiased and
// little worse than the same lights at rest. With VIGIL_MEASURE=1 the last is measured in the
// warehouse as well (docs/research/moving_lights.md).
#include "client/play/level_entities.h"
#include "client/play/test_lights.h"
#include "render_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <iostream>
#include <map>

namespace vigil::test {
namespace {

constexpr int light_count = 32;
constexpr double frame_s = 1.0 / 60.0;
/// The moment that is judged.
constexpr double judged_s = 10.0;

/// VIGIL_TEST_PATHS=10 traces ten times as many, to look for smaller biases by hand.
int factor() {
    const char* text = std::getenv("VIGIL_TEST_PATHS");
    return text != nullptr ? std::max(std::atoi(text), 1) : 1;
}

class MovingLights : public RenderTest {
protected:
    /// Lights of this instance in the list of the frame that was rendered last.
    static std::vector<shader::Light> lights_of(uint32_t first, uint32_t count) {
        const auto all = renderer().scene()->lights().lights();
        return {all.begin() + first, all.begin() + first + count};
    }

    /// The view with test lights as they are at a time of the level.
    Shot wandering(const Shot& view, client::TestLights& lights, double time_s) const {
        Shot shot = view;
        shot.dynamic_lights = lights.at(light_count, time_s);
        return shot;
    }

    /// A frame with this seed after `warmup` frames from nothing in which the lights came here at
    /// this speed.
    refresh::RadiancePicture settled(const Shot& view, client::TestLights& lights, double speed,
                                     int warmup, int seed) const {
        set("pt_seed", std::to_string(seed));
        renderer().reset_guiding();
        for (int frame = warmup; frame > 0; --frame)
            renderer().render(wandering(view, lights, judged_s - speed * frame_s * frame).frame());
        return radiance(wandering(view, lights, judged_s));
    }

    struct Errors {
        double mse = 0.0, mse_error = 0.0; ///< and the standard error
        double trimmed = 0.0;              ///< without the worst hundredth of the values
    };
    Errors errors(const Shot& view, client::TestLights& lights, double speed, int warmup, int seeds,
                  const std::vector<double>& reference) const {
        std::vector<double> each;
        Errors result;
        for (int seed = 1; seed <= seeds; ++seed) {
            const refresh::RadiancePicture picture = settled(view, lights, speed, warmup, seed);
            std::vector<double> squares;
            for (size_t i = 0; i < reference.size(); ++i) {
                const double error = static_cast<double>(picture.rgb[i]) - reference[i];
                squares.push_back(error * error);
            }
            double sum = 0.0, kept = 0.0;
            for (const double square : squares)
                sum += square;
            std::ranges::sort(squares);
            const size_t most = squares.size() - squares.size() / 100;
            for (size_t i = 0; i < most; ++i)
                kept += squares[i];
            each.push_back(sum / static_cast<double>(squares.size()));
            result.trimmed += kept / static_cast<double>(most) / seeds;
        }
        for (const double mse : each)
            result.mse += mse / seeds;
        for (const double mse : each)
            result.mse_error += (mse - result.mse) * (mse - result.mse);
        result.mse_error = std::sqrt(result.mse_error / (seeds - 1.0) / seeds);
        return result;
    }

    /// The mean of many paths with the lights where they are judged, by another technique.
    static std::vector<double> reference(const Shot& shot, int pictures, int paths) {
        set("pt_nee", "lh");
        set("pt_guide", "brdf");
        radiance(shot);
        std::vector<double> mean;
        vkpt::FrameDescription frame = params(shot);
        for (int i = 0; i < pictures; ++i) {
            frame.settings.pt_seed = 100000 + i;
            const std::vector<float> picture = trace(frame, static_cast<uint32_t>(paths));
            mean.resize(picture.size(), 0.0);
            for (size_t value = 0; value < mean.size(); ++value)
                mean[value] += static_cast<double>(picture[value]) / pictures;
        }
        return mean;
    }

    /// Records a row of docs/research/moving_lights.md for each speed.
    std::map<double, Errors> compare_speeds(const Shot& view, client::TestLights& lights,
                                            int warmup, int seeds, int reference_pictures,
                                            int reference_paths) {
        const std::vector<double> mean =
            reference(wandering(view, lights, judged_s), reference_pictures, reference_paths);
        set("pt_nee", "vlc");
        set("pt_guide", "cdq");
        std::map<double, Errors> found;
        for (const double speed : {0.0, 1.0, 4.0}) {
            const Errors row = found[speed] = errors(view, lights, speed, warmup, seeds, mean);
            const double units = speed * static_cast<double>(client::TestLights::speed);
            const auto record = [&](const char* name, double value) {
                RecordProperty(fmt::format("measured/{:.0f} units per second/{}", units, name),
                               fmt::format("{:.6g}", value));
                std::cout << fmt::format("{:.0f} units per second, {}: {:.4g}\n", units, name,
                                         value);
            };
            record("mse", row.mse);
            record("standard_error", row.mse_error);
            record("trimmed_mse", row.trimmed);
        }
        return found;
    }

    static Shot in_rooms() {
        Shot shot;
        shot.view = {{40, 40, 60}, {0, 45, 0}, 90};
        return shot;
    }
};

TEST_F(MovingLights, KeepTheirPlacesInTheListAndLeaveIt) {
    load("rooms");
    const refresh::ModelHandle door = renderer().register_model("*1");
    std::map<uint32_t, uint32_t> first_ids; // first light by entity or light
    std::map<uint32_t, glm::vec3> last;
    for (int frame = 0; frame < 12; ++frame) {
        const float t = static_cast<float>(frame);
        Shot shot = in_rooms();
        shot.entities = {{1, door, {-40, -20, 4 * t}, {0, 5 * t, 0}}};
        // One comes late, one before it goes early: the others stay what they are.
        if (frame < 8) shot.dynamic_lights.push_back({7, {60 + t, 60, 60}, 8, {9, 9, 9}});
        if (frame > 3) shot.dynamic_lights.push_back({8, {90, 60 + t, 60}, 8, {9, 9, 9}});
        shot.dynamic_lights.push_back({9, {60, 90, 60 + t}, 8, {9, 9, 9}});
        shot.spots = {{99, {100, 100, 60 + t}, {0, 7 * t, 0}, 1.5f, {100, 100, 100}}};
        radiance(shot);
        for (const shader::Instance& instance : renderer().scene()->host_instances()) {
            if (instance.entity == 0) continue;
            const auto [known, fresh] = first_ids.emplace(instance.entity, instance.first_light);
            EXPECT_EQ(instance.first_light, known->second) << instance.entity;
            const shader::Light light = lights_of(instance.first_light, 1).front();
            EXPECT_NE(light.radiance, glm::vec3(0.0f)) << instance.entity;
            if (!fresh) {
                EXPECT_NE(light.v0, last[instance.entity]) << instance.entity;
            }
            last[instance.entity] = light.v0;
        }
    }
    EXPECT_EQ(first_ids.size(), 5u);
    radiance(in_rooms());
    for (const auto& [entity, first] : first_ids)
        EXPECT_EQ(lights_of(first, 1).front().radiance, glm::vec3(0.0f)) << entity;
}

/// Irradiance over radiance at a point of the floor below a spot that looks down from `mouth` with
/// this radius (spot_geometry): a square of edge 0.7 radii lies 2.6 radii up a tube whose mouth is
/// a regular 12-gon.
double spot_irradiance(glm::dvec3 mouth, double radius, glm::dvec3 floor_point) {
    constexpr int steps = 24;
    const double pi = glm::pi<double>(), up = 2.6 * radius, edge = 0.7 * radius;
    double sum = 0.0;
    for (int i = 0; i < steps * steps; ++i) {
        const glm::dvec2 cell(i % steps + 0.5, i / steps + 0.5);
        const glm::dvec2 at = edge * (cell / double{steps} - 0.5);
        const glm::dvec3 lamp = mouth + glm::dvec3(at, up), way = lamp - floor_point;
        const glm::dvec2 crossing =
            glm::dvec2(floor_point - mouth + way * ((mouth.z - floor_point.z) / way.z));
        const double turn = std::fmod(std::atan2(crossing.y, crossing.x) + 2.0 * pi, pi / 6.0);
        if (glm::length(crossing) * std::cos(turn - pi / 12.0) > radius * std::cos(pi / 12.0))
            continue;
        const double distance = glm::length(way), cosine = way.z / distance;
        sum += cosine * cosine / (distance * distance);
    }
    return sum * edge * edge / (steps * steps);
}

/// A spot above a floor lights a disc of it: 10 degrees wide in full, dark beyond 30.
TEST_F(MovingLights, SpotsShineWithinTheirCone) {
    load("rooms", [](Level& level) {
        for (BspTexInfo& info : level.bsp.texinfos)
            info.flags &= ~static_cast<uint32_t>(SURF_LIGHT);
    });
    set("pt_bounces", "0");
    set("pt_nee", "lh");
    set_size(64, 64);
    Shot shot;
    shot.view = {{128, 128, 140}, {89.9f, 0, 0}, 60};
    // Below the eye, looking down; the floor is at 0.
    constexpr glm::dvec3 mouth(128, 128, 130);
    shot.spots = {{1, mouth, {90, 0, 0}, 1.5f, {75000, 75000, 75000}}};
    radiance(shot);
    const std::vector<float> seen = trace(params(shot), 128);
    const std::vector<shader::PrimaryHit> hits = primary_hits();
    struct Band {
        double from, to, tolerance;
    };
    for (const Band& band : {Band{2, 9, 0.01}, Band{11, 15, 0.01}, Band{15, 19, 0.02},
                             Band{19, 23, 0.03}, Band{31, 36, 0.0}}) {
        double sum = 0.0, expected = 0.0;
        int pixels = 0;
        for (size_t i = 0; i < hits.size(); ++i) {
            if (hits[i].primitive == shader::NONE || hits[i].position.z > 0.1f) continue;
            const glm::dvec3 point(hits[i].position);
            const double angle = glm::degrees(
                std::atan2(glm::distance(glm::dvec2(point), glm::dvec2(mouth)), mouth.z - point.z));
            if (angle < band.from || angle > band.to) continue;
            ++pixels;
            sum += static_cast<double>(seen[3 * i]);
            expected += 75000.0 * static_cast<double>(hits[i].albedo.x) / glm::pi<double>() *
                        spot_irradiance(mouth, 1.5, point);
        }
        std::cout << fmt::format("{} to {} degrees: {} pixels, {:.4g} of {:.4g}\n", band.from,
                                 band.to, pixels, sum / pixels, expected / pixels);
        EXPECT_GT(pixels, 10);
        EXPECT_NEAR(sum, expected, band.tolerance * expected);
    }
}

TEST_F(MovingLights, LeaveVlcUnbiased) {
    load("rooms");
    client::TestLights lights(load_level(files(), "rooms"));
    const Shot view = in_rooms();
    constexpr int block = 4, batch_count = 16, warmup = 6;
    const int sequences = 16 * factor() * subgroup_factor();
    set("pt_nee", "lh");
    const PictureBatches expected =
        batches(wandering(view, lights, judged_s), batch_count, 256 * factor(), 1000, block);
    for (const char* guide : {"brdf", "cdq"}) {
        set("pt_nee", "vlc");
        set("pt_guide", guide);
        PictureBatches seen(cvars()->vid_width, cvars()->vid_height, block);
        int seed = 0;
        for (int batch = 0; batch < batch_count; ++batch) {
            std::vector<float> sum;
            for (int sequence = 0; sequence < sequences; ++sequence) {
                const refresh::RadiancePicture picture = settled(view, lights, 4.0, warmup, ++seed);
                sum.resize(picture.rgb.size(), 0.0f);
                for (size_t i = 0; i < sum.size(); ++i)
                    sum[i] += picture.rgb[i] / static_cast<float>(sequences);
            }
            seen.add(sum);
        }
        judge(guide, seen, expected, {.everywhere = 0.02, .quadrant = 0.07, .five_blocks = 0.6});
    }
}

TEST_F(MovingLights, CostVlcLittle) {
    load("rooms");
    client::TestLights lights(load_level(files(), "rooms"));
    const auto found = compare_speeds(in_rooms(), lights, 32, 16, 16, 512);
    for (const auto& [speed, row] : found)
        EXPECT_LT(row.mse, 2.0 * found.at(0.0).mse) << speed;
}

TEST_F(MovingLights, MeasuredInTheWarehouse) {
    if (std::getenv("VIGIL_MEASURE") == nullptr) GTEST_SKIP() << "VIGIL_MEASURE=1 measures";
    files().mount_folder(std::filesystem::path(VIGIL_SOURCE_DIR) / "baseq2");
    load("warehouse");
    set_size(96, 54);
    client::TestLights lights(load_level(files(), "warehouse"));
    const client::StartPlace start = client::find_start(level().bsp);
    Shot shot;
    shot.view = {start.origin, start.angles, 90};
    const auto found = compare_speeds(shot, lights, 32, 48, 16, 256);
    for (const auto& [speed, row] : found)
        EXPECT_LT(row.mse, 2.0 * found.at(0.0).mse) << speed;
}

} // namespace
} // namespace vigil::test
