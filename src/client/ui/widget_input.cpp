// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/ui/widget_input.h"

#include <imgui.h>

#include <utility>

namespace vigil::client {

using platform::Key;

namespace {

constexpr std::pair<Key, ImGuiKey> editing_keys[] = {
    {Key::Left, ImGuiKey_LeftArrow},
    {Key::Right, ImGuiKey_RightArrow},
    {Key::Home, ImGuiKey_Home},
    {Key::End, ImGuiKey_End},
    {Key::Delete, ImGuiKey_Delete},
    {Key::Backspace, ImGuiKey_Backspace},
    {Key::C, ImGuiKey_C},
    {Key::V, ImGuiKey_V},
    {Key::X, ImGuiKey_X},
    {Key::Y, ImGuiKey_Y},
    {Key::Z, ImGuiKey_Z},
};

} // namespace

#if IMGUI_VERSION_NUM >= 18900

void press_widget_key(Key key, bool ctrl, bool shift) {
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [ours, theirs] : editing_keys) {
        if (ours != key) continue;
        io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
        io.AddKeyEvent(ImGuiMod_Shift, shift);
        io.AddKeyEvent(theirs, true);
    }
}

void release_widget_keys() {
    ImGui::GetIO().ClearInputKeys();
}

void point_at_widgets(glm::vec2 place) {
    ImGui::GetIO().AddMousePosEvent(place.x, place.y);
}

void hold_widget(bool down) {
    ImGui::GetIO().AddMouseButtonEvent(0, down);
}

#else

void press_widget_key(Key key, bool ctrl, bool shift) {
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [ours, theirs] : editing_keys) {
        io.KeyMap[theirs] = theirs;
        if (ours != key) continue;
        io.KeyCtrl = ctrl;
        io.KeyShift = shift;
        io.KeysDown[theirs] = true;
    }
}

void release_widget_keys() {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = io.KeyShift = false;
    for (const auto& [ours, theirs] : editing_keys) {
        io.KeysDown[theirs] = false;
        io.KeysDownDuration[theirs] = -1.0f; // the next press is a new one
    }
}

void point_at_widgets(glm::vec2 place) {
    ImGui::GetIO().MousePos = {place.x, place.y};
}

void hold_widget(bool down) {
    ImGui::GetIO().MouseDown[0] = down;
}

#endif

void type_into_widget(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
}

} // namespace vigil::client
