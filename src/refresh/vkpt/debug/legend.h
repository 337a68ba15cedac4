// SPDX-License-Identifier: GPL-2.0-or-later
// Legends of the debug views (pt_view): a title and a colour bar with numbers, or the names of
// classes. They are part of the picture, so that a screenshot explains itself, in a window and
// without one. Colours come from the text that the shader uses (shaders/shared/view_colors.h),
// letters from Dear ImGui's own font.
#pragma once

#include "refresh/vkpt/gpu/commands.h"
#include "shared/techniques.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace vigil::vkpt {

/// What a legend depends on.
struct LegendSubject {
    int view = 0; // VIEW_*: shaders/shared/views.h
    Technique technique = Technique::sll;
    bool samples_lights = false; // the technique does, and there are lights
    bool guided = false;
    glm::uvec2 picture_size{0, 0};
    bool caches = false;       // the technique draws from light caches, and explores
    bool quadtrees = false;    // they guide rays
    uint32_t first_column = 0; // of the side of the picture that it is about, and the one after
    uint32_t end_column = 0;   // its last: where there is room for it
    bool operator==(const LegendSubject&) const = default;
};

/// What stands in a legend, before it is drawn. Colours are sRGB, 0 to 1.
struct LegendContent {
    struct Mark {
        float place; // on the bar, 0 to 1
        std::string text;
    };
    struct Class {
        glm::vec3 color;
        std::string text;
    };
    std::string title;
    std::vector<glm::vec3> bar; // colours from left to right; empty: no bar
    std::vector<Mark> marks;
    std::vector<Class> classes;
    std::vector<std::string> notes; // lines below all else
};

/// Without a title where the view needs no legend.
LegendContent legend_content(const LegendSubject& subject);

/// Pixels as the display has them: sRGB, red in the lowest byte; rows from the top.
struct LegendPixels {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint32_t> rgba;
};

/// Letters are 13 pixels high, doubled or tripled in tall pictures.
LegendPixels draw_legend(const LegendContent& content, uint32_t picture_height);

/// Records the copy of pixels into a display buffer (rows of picture_size.x words), behind a
/// barrier. What follows must wait for copies. They must lie inside.
void record_pixels(gpu::FrameCommands& commands, const gpu::Buffer& display,
                   glm::uvec2 picture_size, glm::uvec2 corner, const LegendPixels& pixels);

/// The legend over the lower left corner of a side of a display buffer.
class Legend {
public:
    /// Where it lies in the picture; of size 0 where there is none: the view needs none, or the
    /// picture is too small for it.
    struct Area {
        glm::uvec2 corner{0, 0};
        glm::uvec2 size{0, 0};
    };

    /// Records the copy into `display`, as record_pixels() does, into the lower left corner of the
    /// side's columns. Draws anew only when the subject changes.
    void record(gpu::FrameCommands& commands, const gpu::Buffer& display,
                const LegendSubject& subject);
    /// As recorded last.
    const Area& area() const { return area_; }

private:
    LegendSubject subject_;
    LegendPixels pixels_;
    Area area_;
};

} // namespace vigil::vkpt
