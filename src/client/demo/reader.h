// SPDX-License-Identifier: GPL-2.0-or-later
// A demo as steps of a tenth of a second: a frame and what was said along with it. What is intact
// of a damaged demo comes first; then the demo ends with a fault.
#pragma once

#include "formats/dm2_file.h"
#include "formats/dm2_parser.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace vigil::client {

struct DemoStep {
    dm2::Frame frame;
    /// Before the frame: server data, configuration strings; and with it: effects, sounds, texts.
    std::vector<dm2::Message> messages;
};

class DemoReader {
public:
    /// `name` is for messages.
    DemoReader(std::string name, std::vector<uint8_t> bytes);

    /// The next step, or nothing at the end.
    std::optional<DemoStep> next();
    /// What is wrong with the demo, once next() has returned nothing; empty: nothing is.
    const std::string& fault() const { return fault_; }
    const std::string& name() const { return file_.name(); }

private:
    dm2::File file_;
    dm2::Parser parser_;
    std::deque<dm2::Message> waiting_;
    bool ended_ = false;
    std::string fault_;
};

} // namespace vigil::client
