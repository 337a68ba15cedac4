// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/demo/reader.h"

#include "common/error.h"

#include <iterator>

namespace vigil::client {

DemoReader::DemoReader(std::string name, std::vector<uint8_t> bytes)
    : file_(name, std::move(bytes)), parser_(std::move(name)) {}

std::optional<DemoStep> DemoReader::next() {
    DemoStep step;
    bool framed = false;
    for (;;) {
        // Up to the next frame, or to the end of the block that holds this one.
        while (!waiting_.empty()) {
            if (auto* frame = std::get_if<dm2::Frame>(&waiting_.front())) {
                if (framed) return step;
                step.frame = std::move(*frame);
                framed = true;
            } else if (framed && std::holds_alternative<dm2::ServerData>(waiting_.front())) {
                return step; // begins another level
            } else {
                step.messages.push_back(std::move(waiting_.front()));
            }
            waiting_.pop_front();
        }
        if (framed) return step;
        if (ended_) return std::nullopt;
        std::vector<dm2::Message> messages;
        try {
            const std::optional<dm2::File::Block> block = file_.next();
            if (block)
                parser_.parse(*block, messages);
            else
                ended_ = true;
        } catch (const Error& error) {
            fault_ = error.what();
            ended_ = true;
        }
        waiting_.insert(waiting_.end(), std::make_move_iterator(messages.begin()),
                        std::make_move_iterator(messages.end()));
    }
}

} // namespace vigil::client
