// SPDX-License-Identifier: GPL-2.0-or-later
// The log: one list of sinks behind a lock. A line that a sink logs while it handles another one is
// delivered after that one, so that sinks never run inside each other.
#include "common/log.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace vigil {

namespace {

struct Sink {
    int token;
    LogSink function;
};

struct Line {
    Severity severity;
    std::string text;
};

struct Log {
    std::recursive_mutex mutex;
    std::vector<std::shared_ptr<const Sink>> sinks;
    std::deque<Line> lines;
    bool delivering = false;
    int next_token = 1;
};

// Never destroyed: destructors of other statics may still log.
Log& the_log() {
    static Log& log = *new Log;
    return log;
}

void deliver(Log& log) {
    log.delivering = true;
    while (!log.lines.empty()) {
        const Line line = std::move(log.lines.front());
        log.lines.pop_front();
        const auto sinks = log.sinks; // a sink may add or remove sinks
        for (const auto& sink : sinks) {
            // The log is where failures are told; one of its own has nowhere left to go.
            try {
                sink->function(line.severity, line.text);
            } catch (...) {
            }
        }
    }
    log.delivering = false;
}

} // namespace

int add_log_sink(LogSink sink) {
    Log& log = the_log();
    const std::lock_guard lock(log.mutex);
    log.sinks.push_back(std::make_shared<const Sink>(Sink{log.next_token, std::move(sink)}));
    return log.next_token++;
}

void remove_log_sink(int token) {
    Log& log = the_log();
    const std::lock_guard lock(log.mutex);
    std::erase_if(log.sinks, [&](const auto& sink) { return sink->token == token; });
}

void log_text(Severity severity, std::string_view text) {
    Log& log = the_log();
    const std::lock_guard lock(log.mutex);

    // One trailing newline ends the last line; it does not begin another one.
    if (text.ends_with('\n')) text.remove_suffix(1);
    for (;;) {
        const auto end = text.find('\n');
        log.lines.push_back({severity, std::string(text.substr(0, end))});
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    if (!log.delivering) deliver(log);
}

} // namespace vigil
