// SPDX-License-Identifier: GPL-2.0-or-later
// Keeps the log's warnings and errors, so that a test that counts validation messages can show
// them.
#pragma once

#include "common/log.h"

#include <string>

namespace vigil::vkpt {

class ValidationText {
public:
    ValidationText()
        : token_(add_log_sink([this](Severity severity, std::string_view line) {
              if (severity != Severity::Info) text_.append(line).append("\n");
          })) {}
    ~ValidationText() { remove_log_sink(token_); }
    ValidationText(const ValidationText&) = delete;
    ValidationText& operator=(const ValidationText&) = delete;

    const std::string& text() const { return text_; }

private:
    std::string text_;
    int token_;
};

} // namespace vigil::vkpt
