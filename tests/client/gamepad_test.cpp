// SPDX-License-Identifier: GPL-2.0-or-later
// Game controllers: what sticks ask for, and SDL's events of a controller that exists only in its
// memory.
#include "client/play/stick.h"
#include "platform/gamepad.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <cmath>
#include <variant>

namespace vigil::client {
namespace {

using namespace platform;

TEST(Stick, DoesNothingInTheDeadZoneAndAllAtTheEnd) {
    for (int degrees = 0; degrees < 360; degrees += 15) {
        const float angle = glm::radians(static_cast<float>(degrees));
        const glm::vec2 direction(std::cos(angle), std::sin(angle));
        for (const float dead_zone : {0.0f, 0.15f, 0.5f, 0.9f}) {
            for (const float curve : {0.25f, 1.0f, 2.0f, 8.0f}) {
                EXPECT_EQ(stick_response(direction * (0.999f * dead_zone), dead_zone, curve),
                          glm::vec2(0.0f));
                // The corners of a square stick are no faster.
                for (const float way : {1.0f, 1.2f, 1.41421f}) {
                    const glm::vec2 all = stick_response(direction * way, dead_zone, curve);
                    EXPECT_NEAR(all.x, direction.x, 1e-5f);
                    EXPECT_NEAR(all.y, direction.y, 1e-5f);
                }
            }
        }
    }
    EXPECT_EQ(stick_response({0.0f, 0.0f}, 0.0f, 2.0f), glm::vec2(0.0f));
}

TEST(Stick, GrowsFromNothingAlongItsCurveAndKeepsItsDirection) {
    const float dead_zone = 0.2f;
    float before = 0.0f;
    for (float way = 0.201f; way <= 1.0f; way += 0.01f) {
        const glm::vec2 answer = stick_response(glm::vec2(0.6f, -0.8f) * way, dead_zone, 2.0f);
        const float length = glm::length(answer), part = (way - dead_zone) / (1.0f - dead_zone);
        EXPECT_NEAR(length, part * part, 1e-5f);
        EXPECT_GT(length, before);
        EXPECT_LT(length - before, 0.03f); // no step at the edge of the dead zone
        EXPECT_NEAR(answer.x * -0.8f, answer.y * 0.6f, 1e-6f);
        before = length;
    }
    EXPECT_NEAR(stick_response({0.6f, 0.0f}, dead_zone, 1.0f).x, 0.5f, 1e-6f);
}

TEST(Gamepad, TriggersAreKeysThatDoNotTremble) {
    bool down = false;
    int presses = 0;
    for (const float way : {0.0f, 0.45f, 0.51f, 0.49f, 0.52f, 0.41f, 0.5f, 0.39f, 0.45f, 1.0f}) {
        const bool now = trigger_is_down(down, way);
        presses += now && !down;
        down = now;
    }
    EXPECT_EQ(presses, 2);
}

TEST(Gamepad, ReportsOnlyWhatChanged) {
    GamepadState before, now;
    std::vector<Event> events;
    add_gamepad_events(before, now, events);
    EXPECT_TRUE(events.empty());
    now.button(Key::PadA) = now.button(Key::PadRightTrigger) = true;
    now.right = {0.5f, -1.0f};
    add_gamepad_events(before, now, events);
    ASSERT_EQ(events.size(), 3u);
    EXPECT_EQ(std::get<KeyEvent>(events[0]).key, Key::PadA);
    EXPECT_EQ(std::get<KeyEvent>(events[1]).key, Key::PadRightTrigger);
    EXPECT_TRUE(std::get<KeyEvent>(events[1]).down);
    EXPECT_EQ(std::get<StickEvent>(events[2]).stick, StickEvent::Stick::Right);
    EXPECT_EQ(std::get<StickEvent>(events[2]).place, glm::vec2(0.5f, -1.0f));
}

#if SDL_VERSION_ATLEAST(2, 24, 0)

/// A controller in SDL's memory.
class VirtualGamepad : public testing::Test {
protected:
    void SetUp() override {
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1"); // there is no window
        gamepads_ = std::make_unique<Gamepads>();
        if (SDL_WasInit(SDL_INIT_GAMECONTROLLER) == 0) GTEST_SKIP() << SDL_GetError();
        poll(); // those of this machine
    }
    void TearDown() override {
        gamepads_.reset();
        SDL_Quit();
    }

    void plug_in() {
        device_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER,
                                            SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
        ASSERT_GE(device_, 0) << SDL_GetError();
        poll();
        joystick_ = SDL_JoystickFromInstanceID(SDL_JoystickGetDeviceInstanceID(device_));
        ASSERT_NE(joystick_, nullptr) << "it was not opened";
    }
    std::vector<Event> poll() {
        std::vector<Event> events;
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0)
            gamepads_->handle(event, events);
        return events;
    }
    void button(int button, bool down) {
        SDL_JoystickSetVirtualButton(joystick_, button, down ? 1 : 0);
    }
    void axis(int axis, int value) {
        SDL_JoystickSetVirtualAxis(joystick_, axis, static_cast<Sint16>(value));
    }

    std::unique_ptr<Gamepads> gamepads_;
    int device_ = -1;
    SDL_Joystick* joystick_ = nullptr;
};

TEST_F(VirtualGamepad, ButtonsTriggersAndSticksArrive) {
    plug_in();
    button(SDL_CONTROLLER_BUTTON_START, true);
    std::vector<Event> events = poll();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(std::get<KeyEvent>(events[0]).key, Key::PadStart);
    EXPECT_TRUE(std::get<KeyEvent>(events[0]).down);
    button(SDL_CONTROLLER_BUTTON_START, false);
    events = poll();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_FALSE(std::get<KeyEvent>(events[0]).down);

    axis(SDL_CONTROLLER_AXIS_LEFTY, -32768); // forward
    events = poll();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(std::get<StickEvent>(events[0]).stick, StickEvent::Stick::Left);
    EXPECT_EQ(std::get<StickEvent>(events[0]).place, glm::vec2(0.0f, 1.0f));
    axis(SDL_CONTROLLER_AXIS_RIGHTX, 16384);
    events = poll();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_NEAR(std::get<StickEvent>(events[0]).place.x, 0.5f, 1e-3f);

    axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767);
    events = poll();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(std::get<KeyEvent>(events[0]).key, Key::PadRightTrigger);
}

TEST_F(VirtualGamepad, PulledOutItLetsGoAndPluggedInAgainItWorks) {
    for (int round = 0; round < 3; ++round) {
        plug_in();
        button(SDL_CONTROLLER_BUTTON_A, true);
        axis(SDL_CONTROLLER_AXIS_LEFTX, 32767);
        EXPECT_EQ(poll().size(), 2u) << round;
        ASSERT_EQ(SDL_JoystickDetachVirtual(device_), 0) << SDL_GetError();
        bool released = false, middle = false;
        for (const Event& event : poll()) {
            if (const auto* key = std::get_if<KeyEvent>(&event))
                released |= key->key == Key::PadA && !key->down;
            if (const auto* stick = std::get_if<StickEvent>(&event))
                middle |= stick->place == glm::vec2(0.0f);
        }
        EXPECT_TRUE(released) << round;
        EXPECT_TRUE(middle) << round;
    }
}

#endif

} // namespace
} // namespace vigil::client
