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

void set_widget_key(ImGuiKey key, bool down, bool ctrl, bool shift) {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18900
    io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
    io.AddKeyEvent(key, down);
#else
    io.KeyMap[key] = key;
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
    io.KeysDown[key] = down;
#endif
}

} // namespace

void press_widget_key(Key key, bool ctrl, bool shift) {
    for (const auto& [ours, theirs] : editing_keys)
        if (ours == key) set_widget_key(theirs, true, ctrl, shift);
}

bool release_widget_keys() {
    bool any = false;
    for (const auto& [ours, theirs] : editing_keys) {
        if (!ImGui::IsKeyDown(theirs)) continue;
        set_widget_key(theirs, false, false, false);
        any = true;
    }
    return any;
}

void point_at_widgets(glm::vec2 place) {
#if IMGUI_VERSION_NUM >= 18900
    ImGui::GetIO().AddMousePosEvent(place.x, place.y);
#else
    ImGui::GetIO().MousePos = {place.x, place.y};
#endif
}

void hold_widget(bool down) {
#if IMGUI_VERSION_NUM >= 18900
    ImGui::GetIO().AddMouseButtonEvent(0, down);
#else
    ImGui::GetIO().MouseDown[0] = down;
#endif
}

void type_into_widget(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
}

} // namespace vigil::client
