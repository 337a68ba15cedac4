// SPDX-License-Identifier: GPL-2.0-or-later
// The log: lines with a severity, sent to every registered sink (terminal, console, file). It holds
// no history of its own; the console keeps the scroll-back.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string_view>

namespace vigil {

enum class Severity { Info, Warning, Error };

using LogSink = std::function<void(Severity, std::string_view line)>;

/// Adds a sink that receives every later line (without a trailing newline). Returns a token for
/// remove_log_sink. Thread-safe; sinks are called one at a time.
int add_log_sink(LogSink sink);
void remove_log_sink(int token);

/// Sends `text`, split at newlines, to all sinks.
void log_text(Severity severity, std::string_view text);

template <typename... Args> void log_info(fmt::format_string<Args...> text, Args&&... args) {
    log_text(Severity::Info, fmt::format(text, std::forward<Args>(args)...));
}
template <typename... Args> void log_warning(fmt::format_string<Args...> text, Args&&... args) {
    log_text(Severity::Warning, fmt::format(text, std::forward<Args>(args)...));
}
template <typename... Args> void log_error(fmt::format_string<Args...> text, Args&&... args) {
    log_text(Severity::Error, fmt::format(text, std::forward<Args>(args)...));
}

} // namespace vigil
