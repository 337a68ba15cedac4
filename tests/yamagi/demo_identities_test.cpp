// SPDX-License-Identifier: GPL-2.0-or-later
// A measurement: how often numbers are wrong in demos that people recorded, which have the true
// ones. VIGIL_DEMOS names the folder of the demos; frames are made in between the demo's, as the
// game's client does.
#include "formats/dm2_parser.h"
#include "yamagi/identities.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <optional>

namespace vigil::yamagi {
namespace {

struct Score {
    int frames = 0, wrong_frames = 0, things = 0, wrong_things = 0;
};

/// Frames between two of the demo, `fps` a second.
class Between {
public:
    explicit Between(int fps) : steps_(fps / 10) {}

    void add(const dm2::Frame& now) {
        if (before_) {
            for (int step = 0; step < steps_; ++step)
                show(now, static_cast<float>(step) / static_cast<float>(steps_));
        }
        before_ = now;
    }
    const Score& score() const { return score_; }

private:
    void show(const dm2::Frame& now, float part) {
        std::vector<Sighting> things;
        std::vector<uint32_t> numbers;
        for (const dm2::EntityState& entity : now.entities) {
            if (entity.models[0] == 0) continue; // nothing is seen of it
            const dm2::EntityState* const old = dm2::find_entity(before_->entities, entity.number);
            const bool same = old != nullptr && old->models == entity.models;
            Sighting thing;
            for (const uint8_t model : entity.models)
                thing.kind = thing.kind << 8 | model;
            thing.kind = thing.kind << 32 | entity.skin;
            // As the client does: a jump is not interpolated.
            const bool jumped = !same || glm::distance(old->origin, entity.origin) > 512.0f;
            thing.place = jumped ? entity.origin : glm::mix(old->origin, entity.origin, part);
            thing.frame = entity.frame;
            thing.old_frame = same ? old->frame : entity.frame;
            things.push_back(thing);
            numbers.push_back(entity.number);
        }
        const auto ids = identities_.assign(things, time_s_);
        time_s_ += 0.1 / steps_;
        ++frame_;
        bool all = true;
        for (size_t i = 0; i < ids.size(); ++i) {
            Known& known = known_[numbers[i]];
            // Seen in the frame before as the same kind of thing: it must have the same number.
            const bool expected = known.frame == frame_ - 1 && known.kind == things[i].kind;
            if (expected && known.id != ids[i]) {
                ++score_.wrong_things;
                all = false;
            }
            score_.things += expected ? 1 : 0;
            known = {frame_, things[i].kind, ids[i]};
        }
        ++score_.frames;
        score_.wrong_frames += all ? 0 : 1;
    }

    struct Known {
        int frame = -2;
        uint64_t kind = 0;
        uint32_t id = 0;
    };
    int steps_;
    std::optional<dm2::Frame> before_;
    Identities identities_;
    std::map<uint32_t, Known> known_;
    double time_s_ = 0.0;
    int frame_ = 0;
    Score score_;
};

TEST(DemoIdentities, AreMeasured) {
    const char* const folder = std::getenv("VIGIL_DEMOS");
    if (std::getenv("VIGIL_MEASURE") == nullptr || folder == nullptr)
        GTEST_SKIP() << "VIGIL_MEASURE=1 measures";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".dm2") continue;
        for (const int fps : {10, 30, 60}) {
            std::ifstream stream(entry.path(), std::ios::binary);
            dm2::File file(entry.path().filename().string(),
                           std::vector<uint8_t>(std::istreambuf_iterator<char>(stream), {}));
            dm2::Parser parser(file.name());
            Between between(fps);
            while (const auto block = file.next()) {
                std::vector<dm2::Message> messages;
                parser.parse(*block, messages);
                for (const dm2::Message& message : messages)
                    if (const auto* frame = std::get_if<dm2::Frame>(&message)) between.add(*frame);
            }
            const Score& score = between.score();
            std::printf("%s, %d frames a second: %d of %d frames, %d of %d things\n",
                        file.name().c_str(), fps, score.wrong_frames, score.frames,
                        score.wrong_things, score.things);
            EXPECT_LE(score.wrong_frames, score.frames / 100) << file.name() << ' ' << fps;
        }
    }
}

} // namespace
} // namespace vigil::yamagi
