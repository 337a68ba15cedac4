// SPDX-License-Identifier: GPL-2.0-or-later
#include "soak/soak_script.h"

#include "common/error.h"

#include <utility>

namespace vigil::client {

SoakScript::SoakScript(std::filesystem::path path, std::string_view title)
    : path_(std::move(path)), file_(path_, std::ios::binary | std::ios::trunc) {
    write(fmt::format("// {}\n", title));
}

void SoakScript::add_frame(std::string_view commands) {
    if (!commands.empty()) {
        write(frames_ > 0 ? fmt::format("wait {}\n{}", frames_, commands) : std::string(commands));
        frames_ = 0;
    }
    ++frames_;
}

void SoakScript::write(std::string_view text) {
    if (!(file_ << text << std::flush)) fail("{}: cannot write what was typed", path_.string());
}

} // namespace vigil::client
