// SPDX-License-Identifier: GPL-2.0-or-later
// The module in an engine of ours, with a few files of a game.
#pragma once

#include "engine_host.h"
#include "formats/picture_bytes.h"
#include "formats/small_models.h"
#include "gpu/validated.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <utility>

namespace vigil::test {

using Color = std::array<int, 3>;
using yamagi::EngineView;
using yamagi::ModelObject;
using yamagi::ModuleFunctions;
using yamagi::PictureObject;
using yamagi::ViewEntity;

constexpr Color red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, black{0, 0, 0};

/// A picture of one colour.
inline Bytes plain(uint32_t width, uint32_t height, const Color& color) {
    Image image{width, height, {}};
    for (uint32_t i = 0; i < width * height; ++i)
        for (const int part : {color[0], color[1], color[2], 255})
            image.rgba.push_back(static_cast<uint8_t>(part));
    return write_tga(image, {2, 32, 0x28});
}

/// 16 x 16 characters of 8 x 8 texels: red, those of the last row green, and the space blue.
inline Bytes characters() {
    Image image{128, 128, {}};
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const int number = y / 8 * 16 + x / 8;
            const Color color = number == 32 ? blue : number >= 240 ? green : red;
            for (const int part : {color[0], color[1], color[2], 255})
                image.rgba.push_back(static_cast<uint8_t>(part));
        }
    return write_tga(image, {2, 32, 0x28});
}

inline MemorySource::Files game_files() {
    return {{"pics/conchars.tga", characters()},
            {"pics/tile.tga", plain(4, 4, green)},
            {"pics/icon.tga", plain(6, 3, blue)},
            {"models/box/tris.md2", small_md2()},
            {"models/box/skin.tga", plain(2, 2, red)}};
}

class ModuleTest : public testing::Test {
protected:
    /// Of API 5, 7 and 8.
    void start(const std::string& version, int api, MemorySource::Files files = game_files()) {
        host_.emplace(version, std::move(files));
        host_->get_functions(api);
        for (const auto& [name, text] : {std::pair("pt_nee", "sll"),
                                         {"pt_guide", "brdf"},
                                         {"flt_enable", "0"},
                                         {"flt_taa", "0"}})
            host_->set(name, text);
        host_->set("vk_validation", std::to_string(validation()));
    }
    void start() { start("8.20 x86_64", 5); }
    void begin() {
        start();
        ASSERT_EQ(module().init(), 1);
    }
    void TearDown() override {
        if (!host_) return;
        EXPECT_EQ(host_->count("Vulkan validation"), 0);
        host_.reset();
    }
    EngineHost& host() { return *host_; }
    const ModuleFunctions& module() { return host_->module(); }

    /// A view into a room of tests/data, over all of the screen.
    static EngineView view() {
        static const std::array<yamagi::ViewLightStyle, yamagi::view_light_styles> styles = [] {
            std::array<yamagi::ViewLightStyle, yamagi::view_light_styles> on{};
            on.fill({{1, 1, 1}, 3});
            return on;
        }();
        EngineView view{};
        view.width = EngineHost::width;
        view.height = EngineHost::height;
        view.fov_x = 90;
        view.fov_y = 67.4f;
        std::ranges::copy(std::array{290.0f, 20.0f, 96.0f}, view.origin);
        std::ranges::copy(std::array{5.0f, 55.0f, 0.0f}, view.angles);
        view.light_styles = styles.data();
        return view;
    }
    void show(const EngineView& view) {
        host().frame([&](const ModuleFunctions& f) { f.render_view(&view); });
    }
    static double mean(const HostPicture& picture) {
        double sum = 0.0;
        for (const uint8_t value : picture.rgb)
            sum += value;
        return sum / static_cast<double>(picture.rgb.size());
    }
    static int count(const HostPicture& picture, const Color& color) {
        int count = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                count += picture.at(x, y) == color ? 1 : 0;
        return count;
    }

private:
    std::optional<EngineHost> host_;
};

} // namespace vigil::test
