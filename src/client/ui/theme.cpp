// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/theme.h"

#include <algorithm>
#include <cmath>

namespace vigil::client::theme {

namespace {

constexpr int font_scales = 3;
constexpr float font_pixels = 13.0f; // ImGui's own font is drawn for this size
constexpr float pixels_per_scale = 720.0f;

} // namespace

ImGuiContext* make_context() {
    IMGUI_CHECKVERSION();
    ImGuiContext* context = ImGui::CreateContext();
    ImGui::SetCurrentContext(context);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // nothing is placed by hand, so nothing is remembered
    io.LogFilename = nullptr;
    for (int i = 1; i <= font_scales; ++i) {
        ImFontConfig config;
        config.SizePixels = font_pixels * static_cast<float>(i);
        config.OversampleH = 1;
        config.PixelSnapH = true;
        io.Fonts->AddFontDefault(&config);
    }
#if IMGUI_VERSION_NUM >= 19200
    // Whoever draws the lists makes the textures that they ask for.
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#else
    io.Fonts->Build();
#endif
    return context;
}

float scale_for(float height) {
    return std::clamp(std::floor(height / pixels_per_scale + 0.5f), 1.0f,
                      static_cast<float>(font_scales));
}

ImFont* letters(float scale) {
    return ImGui::GetIO().Fonts->Fonts[static_cast<int>(scale) - 1];
}

ImGuiStyle style(float scale) {
    const ImVec4 none{0.0f, 0.0f, 0.0f, 0.0f}, chosen{edge.x, edge.y, edge.z, 0.35f};
    ImGuiStyle style;
    style.WindowPadding = {7.0f, 6.0f};
    style.WindowMinSize = {1.0f, 1.0f};
    style.WindowBorderSize = 1.0f;
    style.FramePadding = {0.0f, 1.0f};
    style.ItemSpacing = {6.0f, 2.0f};
    style.CellPadding = {4.0f, 1.0f};
    style.ScrollbarSize = 8.0f;
    style.ScaleAllSizes(scale);
    const auto color = [&](ImGuiCol part) -> ImVec4& { return style.Colors[part]; };
    color(ImGuiCol_Text) = text;
    color(ImGuiCol_TextDisabled) = {0.59f, 0.59f, 0.57f, 1.0f};
    color(ImGuiCol_WindowBg) = {0.06f, 0.07f, 0.09f, 0.92f};
    color(ImGuiCol_PopupBg) = {0.05f, 0.055f, 0.07f, 0.96f};
    color(ImGuiCol_Border) = edge;
    color(ImGuiCol_FrameBg) = none;
    color(ImGuiCol_ScrollbarBg) = none;
    color(ImGuiCol_ScrollbarGrab) = chosen;
    color(ImGuiCol_ScrollbarGrabHovered) = color(ImGuiCol_ScrollbarGrabActive) = edge;
    color(ImGuiCol_Header) = color(ImGuiCol_HeaderActive) = chosen;
    color(ImGuiCol_HeaderHovered) = {edge.x, edge.y, edge.z, 0.2f};
    color(ImGuiCol_PlotHistogram) = edge;
    color(ImGuiCol_TextSelectedBg) = {value.x, value.y, value.z, 0.35f};
    return style;
}

void begin_note(const char* name) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
}

} // namespace vigil::client::theme
