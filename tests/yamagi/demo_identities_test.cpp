// SPDX-License-Identifier: GPL-2.0-or-later
// How often numbers are wrong in recorded demos, which have the true ones: those of ../shared, or
// of the folder that VIGIL_DEMOS names. Frames are made in between the demo's, as the game's client
// does.
#include "formats/dm2_parser.h"
#include "formats/real_levels.h"
#include "yamagi/identities.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
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

std::optional<std::filesystem::path> folder_of_demos() {
    if (const char* const folder = std::getenv("VIGIL_DEMOS")) return folder;
    const auto levels = real_levels_folder();
    return levels ? std::optional(*levels / "demos") : std::nullopt;
}

TEST(DemoIdentities, AreRightInNearlyAllFrames) {
    const auto folder = folder_of_demos();
    if (!folder) GTEST_SKIP() << "the real demos are not there";
    for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
        if (entry.path().extension() != ".dm2") continue;
        for (const int fps : {10, 30, 60}) {
            dm2::File file(entry.path().filename().string(), read_file(entry.path()));
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
