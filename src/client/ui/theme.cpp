// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/theme.h"

namespace vigil::client::theme {

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
