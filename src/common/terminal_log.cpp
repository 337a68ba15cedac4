// SPDX-License-Identifier: GPL-2.0-or-later
// The terminal's log sink: chooses the stream and the colour, and writes one line at a time.
#include "common/terminal_log.h"

#include "common/printable.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>

namespace vigil {

namespace {

void write_line(std::FILE* stream, const char* colour, std::string_view prefix,
                std::string_view line) {
    const char* no_color = std::getenv("NO_COLOR");
    const bool coloured = isatty(fileno(stream)) && !(no_color && *no_color);

    std::string text;
    if (coloured) text += colour;
    text += prefix;
    for (const char c : line)
        text += is_control(c) && c != '\t' ? '?' : c;
    if (coloured && *colour) text += "\033[0m";
    text += '\n';
    std::fwrite(text.data(), 1, text.size(), stream);
    std::fflush(stream);
}

} // namespace

LogSink terminal_log_sink() {
    return [](Severity severity, std::string_view line) {
        switch (severity) {
        case Severity::Info:
            write_line(stdout, "", "", line);
            break;
        case Severity::Warning:
            write_line(stderr, "\033[33m", "warning: ", line);
            break;
        case Severity::Error:
            write_line(stderr, "\033[31m", "error: ", line);
            break;
        }
    };
}

} // namespace vigil
