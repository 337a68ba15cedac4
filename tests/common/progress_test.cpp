// SPDX-License-Identifier: GPL-2.0-or-later
// What long work says on stderr where that is no terminal, and on one.
#include "common/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <pty.h>
#include <string>
#include <thread>
#include <unistd.h>

namespace vigil {
namespace {

using namespace std::chrono_literals;

/// What `work` prints to stderr.
std::string printed(const auto& work) {
    testing::internal::CaptureStderr();
    work();
    return testing::internal::GetCapturedStderr();
}

/// The same on a terminal.
std::string printed_on_terminal(const auto& work) {
    int master = -1, slave = -1;
    if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) return "no terminal";
    std::fflush(stderr);
    const int kept = dup(STDERR_FILENO);
    dup2(slave, STDERR_FILENO);
    work();
    std::fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    close(slave);
    std::string text;
    char part[256];
    for (ssize_t count; (count = read(master, part, sizeof(part))) > 0;)
        text.append(part, static_cast<size_t>(count));
    close(master);
    return text;
}

TEST(ProgressLineTest, SaysNothingOfShortWork) {
    const auto work = [] {
        ProgressLine line(60.0, 60.0);
        line.show(0.5, "half");
    };
    EXPECT_EQ(printed(work), "");
    EXPECT_EQ(printed_on_terminal(work), "");
}

TEST(ProgressLineTest, TellsOfLongWork) {
    const auto work = [] {
        ProgressLine line(0.05, 0.05);
        line.show(0.25, "too early");
        std::this_thread::sleep_for(60ms);
        line.show(0.5, "half");
        line.show(0.75, "too soon after it");
    };
    EXPECT_EQ(printed(work), "half\n");
    EXPECT_EQ(printed_on_terminal(work), "\r\033[K[##########..........] half\r\033[K");
}

TEST(ProgressTest, StepsThatAreSkippedAndTheFirstOneDoNotCountForThePace) {
    const std::string text = printed_on_terminal([] {
        Progress progress(102);
        progress.skip(1);
        progress.begin("flight");
        std::this_thread::sleep_for(900ms); // with these, the others would take over a minute
        progress.advance("frames");
        std::this_thread::sleep_for(250ms);
        progress.advance("frames"); // 99 of a quarter of a second are left
    });
    EXPECT_NE(text.find("flight, 1 of 102, time left not known yet"), std::string::npos) << text;
    EXPECT_NE(text.find("flight: frames, 2 of 102, time left not known yet"), std::string::npos)
        << text;
    EXPECT_NE(text.find("flight: frames, 3 of 102, 0:"), std::string::npos) << text;
}

} // namespace
} // namespace vigil
