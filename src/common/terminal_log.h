// SPDX-License-Identifier: GPL-2.0-or-later
// The log sink of the terminal: messages to stdout, warnings and errors to stderr. It colours them
// only where the stream is a terminal and NO_COLOR is not set; it keeps no file.
#pragma once

#include "common/log.h"

namespace vigil {

/// A sink for add_log_sink. Control characters are shown as '?', so that names from files
/// cannot steer the terminal.
LogSink terminal_log_sink();

} // namespace vigil
