// SPDX-License-Identifier: GPL-2.0-or-later
// The log's promises to its sinks, and what the terminal sink prints.
#include "common/log.h"

#include "common/terminal_log.h"
#include "scratch_folder.h"

#include <stdexcept>
#include <thread>

namespace vigil {
namespace {

using test::LogCapture;

TEST(Log, SplitsTextIntoLines) {
    const LogCapture log;
    log_text(Severity::Info, "a\n\nb\n");
    ASSERT_EQ(log.lines.size(), 3u);
    EXPECT_EQ(log.lines[0].text, "a");
    EXPECT_EQ(log.lines[1].text, "");
    EXPECT_EQ(log.lines[2].text, "b");
    log_warning("{} {}", 1, "x");
    EXPECT_EQ(log.lines[3].text, "1 x");
    EXPECT_EQ(log.lines[3].severity, Severity::Warning);
}

TEST(Log, LinesFromInsideASinkFollowTheCurrentOne) {
    std::vector<std::string> seen;
    const int token = add_log_sink([&](Severity, std::string_view line) {
        if (line == "first") log_info("inner");
        seen.emplace_back(line);
    });
    log_info("first\nsecond");
    remove_log_sink(token);
    EXPECT_EQ(seen, (std::vector<std::string>{"first", "second", "inner"}));
}

TEST(Log, SinksMayRemoveThemselvesAndFail) {
    int token = 0;
    int calls = 0;
    token = add_log_sink([&](Severity, std::string_view) {
        ++calls;
        remove_log_sink(token);
        throw std::runtime_error("sink");
    });
    const LogCapture log;
    log_info("a");
    log_info("b");
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(log.lines.size(), 2u);
}

TEST(Log, ThreadsDoNotLoseLines) {
    const LogCapture log;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([] {
            for (int i = 0; i < 500; ++i)
                log_info("line {}", i);
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(log.lines.size(), 2000u);
}

TEST(TerminalLog, UsesBothStreamsAndNeutralisesControlCharacters) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const LogSink sink = terminal_log_sink();
    sink(Severity::Info, "plain\ttext");
    sink(Severity::Error, "bad \x1b[31m name");
    sink(Severity::Warning, "careful");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "plain\ttext\n");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "error: bad ?[31m name\nwarning: careful\n");
}

} // namespace
} // namespace vigil
