// SPDX-License-Identifier: GPL-2.0-or-later
// What every guider (a row of shared/guiders.h) promises: the density of its draws is the one it
// tells, over all directions it is one, and it learns. Of leaves that have seen a level, and of one
// that has not.
#include "refresh/vkpt/guiding/leaf_report.h"
#include "render_test.h"
#include "shared/octahedral.h"
#include "shared/random.h"
#include "shared/sampling.h"
#include "test_pass.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <set>
#include <utility>

namespace vigil::test {
namespace {

class GuiderTest : public RenderTest, public testing::WithParamInterface<std::string_view> {
protected:
    static constexpr uint32_t draws = 1u << 18, edge = 8;

    void SetUp() override {
        RenderTest::SetUp();
        set("pt_nee", "lh");
        set("pt_guide", GetParam());
        load("rooms");
        shot_.view = {{290, 20, 96}, {5, 55, 0}, 90};
    }

    /// Results of guider.comp for these arguments.
    static std::vector<glm::vec4> ask(uint32_t function, const std::vector<glm::vec4>& arguments) {
        vkpt::SidePass pass = test_pass(renderer(), fmt::format("guider.{}", GetParam()),
                                        renderer().compiled_features());
        pass.add_buffer(gpu::bytes_of(arguments));
        pass.add_buffer(arguments.size() * sizeof(glm::vec4));
        const auto count = static_cast<uint32_t>(arguments.size());
        pass.run({(count + 63) / 64, 1, 1}, {function, count});
        return pass.read<glm::vec4>(1, count);
    }

    static size_t cell_of(const glm::vec3& direction) {
        const glm::uvec2 cell(shader::octahedral_encode(direction) * static_cast<float>(edge));
        return cell.y * edge + cell.x;
    }

    /// Draws of a leaf's guide, and its density in all directions, must tell the same of each cell
    /// of an octahedral map.
    void expect_density(uint32_t leaf) {
        shader::Random random = shader::random_begin(glm::uvec2(leaf, 1), 0, 7);
        std::vector<glm::vec4> u, evenly;
        for (uint32_t i = 0; i < draws; ++i) {
            u.emplace_back(shader::random_next3(random), static_cast<float>(leaf));
            const glm::vec3 v = shader::random_next3(random);
            evenly.emplace_back(shader::sample_sphere({v.x, v.y}), static_cast<float>(leaf));
        }
        std::array<double, edge * edge> drawn{}, density{}, squares{};
        std::vector<glm::vec4> there = ask(0, u);
        std::vector<float> said;
        for (glm::vec4& draw : there) {
            ASSERT_NEAR(glm::length(glm::vec3(draw)), 1.0f, 1e-5f);
            ASSERT_TRUE(std::isfinite(draw.w) && draw.w > 0.0f) << draw.w;
            drawn[cell_of(glm::vec3(draw))] += 1.0 / draws;
            said.push_back(std::exchange(draw.w, static_cast<float>(leaf)));
        }
        const std::vector<glm::vec4> told_there = ask(1, there);
        for (uint32_t i = 0; i < draws; ++i)
            ASSERT_NEAR(said[i], told_there[i].x, 1e-5f * said[i]);
        const std::vector<glm::vec4> told = ask(1, evenly);
        for (uint32_t i = 0; i < draws; ++i) {
            ASSERT_TRUE(std::isfinite(told[i].x) && told[i].x >= 0.0f) << told[i].x;
            const double value = 4.0 * 3.14159265358979 * static_cast<double>(told[i].x);
            density[cell_of(glm::vec3(evenly[i]))] += value / draws;
            squares[cell_of(glm::vec3(evenly[i]))] += value * value / draws;
        }
        double worst = 0.0, sum = 0.0, sum_variance = 0.0, planted = 0.0;
        for (size_t cell = 0; cell < drawn.size(); ++cell) {
            const double told_variance = (squares[cell] - density[cell] * density[cell]) / draws;
            const double error = std::sqrt(
                (density[cell] * std::max(1.0 - density[cell], 0.0)) / draws + told_variance);
            sum += density[cell];
            sum_variance += squares[cell] / draws;
            if (density[cell] * draws < 50.0) continue; // too few draws for a normal distribution
            worst = std::max(worst, std::abs(drawn[cell] - density[cell]) / error);
            planted = std::max(planted, std::abs(1.15 * drawn[cell] - density[cell]) / error);
        }
        const double sum_error = std::sqrt(std::max(sum_variance - sum * sum / draws, 0.0)) + 1e-6;
        std::cout << fmt::format("  leaf {}: integral {:.4f} +- {:.4f}, cells off by {:.2f} "
                                 "standard errors at the worst, with 15% "
                                 "planted by {:.1f}\n",
                                 leaf, sum, sum_error, worst, planted);
        EXPECT_LT(std::abs(sum - 1.0), 4.5 * sum_error);
        EXPECT_LT(worst, 5.0);
        EXPECT_GT(planted, 7.0);
    }

    /// Leaves under some pixels of the last frame.
    std::set<uint32_t> leaves() const {
        const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
        std::set<uint32_t> found;
        for (const glm::vec3& position : {glm::vec3(300, 40, 1), glm::vec3(340, 100, 1),
                                          glm::vec3(300, 250, 60), glm::vec3(400, 200, 1)})
            found.insert(tree.leaf_at(position, 32).leaf);
        return found;
    }

    Shot shot_;
};

TEST_P(GuiderTest, DrawsWithTheDensityItTells) {
    renderer().render(shot_.frame()); // nothing is learned yet
    expect_density(*leaves().begin());
    for (int frame = 0; frame < 12; ++frame)
        renderer().render(shot_.frame());
    for (const uint32_t leaf : leaves())
        expect_density(leaf);
}

TEST_P(GuiderTest, Learns) {
    const auto words = [&] {
        const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
        return tree.leaf_at({370, 134, 1}, 32).guide; // in view
    };
    renderer().render(shot_.frame());
    const glm::uvec4 before = words();
    for (int frame = 0; frame < 12; ++frame)
        renderer().render(shot_.frame());
    EXPECT_NE(words(), before);
    renderer().reset_guiding();
    renderer().render(shot_.frame());
    EXPECT_EQ(words(), before);
}

std::vector<std::string_view> guiders() {
    std::vector<std::string_view> names;
    for (const GuiderInfo& info : guider_infos)
        if (info.name != "brdf") names.push_back(info.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(EveryRow, GuiderTest, testing::ValuesIn(guiders()),
                         [](const auto& row) { return std::string(row.param); });

} // namespace
} // namespace vigil::test
