// SPDX-License-Identifier: GPL-2.0-or-later
// Demos: messages byte by byte as other engines write them, what this project writes and reads
// again, damage, and the two real demos where they are.
#include "byte_writer.h"
#include "fault.h"
#include "formats/dm2_parser.h"
#include "formats/dm2_protocol.h"
#include "formats/dm2_writer.h"
#include "real_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vigil::dm2 {
namespace {

/// All messages of a demo; throws at the first fault.
std::vector<Message> read_all(Bytes bytes, std::string name = "x.dm2") {
    File file(name, std::move(bytes));
    Parser parser(std::move(name));
    std::vector<Message> messages;
    while (const auto block = file.next())
        parser.parse(*block, messages);
    return messages;
}

/// One block that begins with server data, and the end mark.
Bytes demo_of(const Bytes& messages) {
    Bytes block;
    append<uint8_t>(block, svc_serverdata);
    append<int32_t>(block, 34);
    append<int32_t>(block, 7);
    append<uint8_t>(block, 1);
    append_text(block, "", 1);
    append<int16_t>(block, 0);
    append_text(block, "Home", 5);
    append_bytes(block, messages);
    Bytes bytes;
    append<int32_t>(bytes, static_cast<int32_t>(block.size()));
    append_bytes(bytes, block);
    append<int32_t>(bytes, -1);
    return bytes;
}

std::vector<Message> read_messages(const Bytes& messages) {
    std::vector<Message> all = read_all(demo_of(messages));
    all.erase(all.begin());
    return all;
}

/// A frame without areas; what follows is the player's state and the entities.
Bytes frame_of(int32_t number, int32_t delta, const Bytes& entities) {
    Bytes bytes;
    append<uint8_t>(bytes, svc_frame);
    append_list<int32_t>(bytes, {number, delta});
    append_list<uint8_t>(bytes, {0, 0, svc_playerinfo, 0, 0, 0, 0, 0, 0, svc_packetentities});
    append_bytes(bytes, entities);
    append_list<uint8_t>(bytes, {0, 0});
    return bytes;
}

TEST(Dm2, ServerDataComesFirst) {
    const std::vector<Message> messages = read_all(demo_of({}));
    ASSERT_EQ(messages.size(), 1u);
    const auto& data = std::get<ServerData>(messages[0]);
    EXPECT_EQ(data.server_count, 7);
    EXPECT_TRUE(data.attract_loop);
    EXPECT_EQ(data.level_title, "Home");
}

TEST(Dm2, ShortMessagesArrive) {
    Bytes bytes;
    append_list<uint8_t>(bytes, {svc_print, 2, 'h', 'i', 0, svc_nop, svc_muzzleflash, 1, 0, 0x8e,
                                 svc_muzzleflash2, 9, 1, 200, svc_configstring, 2, 0, 'u', 0});
    append_list<uint8_t>(bytes, {svc_sound, 0x1d, 5, 255, 0x0b, 0x00, 8, 8, 0, 16, 0, 24, 0});
    const std::vector<Message> messages = read_messages(bytes);
    ASSERT_EQ(messages.size(), 6u);
    EXPECT_EQ(std::get<Print>(messages[0]), (Print{2, "hi"}));
    EXPECT_EQ(std::get<Signal>(messages[1]), Signal::Nothing);
    EXPECT_EQ(std::get<MuzzleFlash>(messages[2]), (MuzzleFlash{1, 14, false, true}));
    EXPECT_EQ(std::get<MuzzleFlash>(messages[3]), (MuzzleFlash{265, 200, true, false}));
    EXPECT_EQ(std::get<ConfigString>(messages[4]), (ConfigString{CS_SKY, "u"}));
    const auto& sound = std::get<Sound>(messages[5]);
    EXPECT_EQ(sound.delay_ms, 0x0b);
    EXPECT_EQ(sound.entity_channel, 0x0800);
    EXPECT_EQ(sound.place, glm::vec3(1, 2, 3));
    EXPECT_EQ(sound.attenuation, std::nullopt);
}

TEST(Dm2, AFrameIsMadeOfTheOneBefore) {
    Bytes bytes;
    // The baseline of entity 3: model 2, origin x = 10, yaw 90.
    append_list<uint8_t>(bytes, {svc_spawnbaseline, 0x85, 0x08, 3, 2, 80, 0, 64});
    // Entity 3 appears as its baseline, entity 4 from nothing with an event; then entity 3 moves
    // and 4 is not mentioned; then 3 vanishes.
    append_bytes(bytes, frame_of(1, -1, {0x00, 3, 0x20, 4, 7}));
    append_bytes(bytes, frame_of(2, 1, {0x01, 3, 88, 0}));
    append_bytes(bytes, frame_of(3, 2, {0x40, 3}));
    const std::vector<Message> messages = read_messages(bytes);
    ASSERT_EQ(messages.size(), 4u);
    const auto& first = std::get<Frame>(messages[1]);
    ASSERT_EQ(first.entities.size(), 2u);
    EXPECT_EQ(first.entities[0].models[0], 2);
    EXPECT_EQ(first.entities[0].origin, glm::vec3(10, 0, 0));
    EXPECT_EQ(first.entities[0].angles, glm::vec3(0, 90, 0));
    EXPECT_EQ(first.entities[1].event, EV_OTHER_TELEPORT);
    const auto& second = std::get<Frame>(messages[2]);
    EXPECT_EQ(second.entities[0].origin, glm::vec3(11, 0, 0));
    EXPECT_EQ(second.entities[0].old_origin, glm::vec3(10, 0, 0));
    EXPECT_EQ(second.entities[1].event, 0);
    const auto& third = std::get<Frame>(messages[3]);
    ASSERT_EQ(third.entities.size(), 1u);
    EXPECT_EQ(third.entities[0].number, 4u);
}

TEST(Dm2, EveryEffectHasItsLength) {
    for (uint8_t type = 0; type < temp_entity_count; ++type) {
        if (type == TE_FLAME) continue; // no engine sends it
        TempEntity effect;
        effect.type = type;
        MessageWriter writer;
        writer.u8(svc_temp_entity);
        write_temp_entity(writer, effect);
        writer.u8(svc_nop);
        const std::vector<Message> messages = read_messages(writer.bytes());
        ASSERT_EQ(messages.size(), 2u) << int{type};
        EXPECT_EQ(std::get<TempEntity>(messages[0]), effect);
    }
    // Lengths that the game's client reads.
    const auto size_of = [](uint8_t type, int16_t entity) {
        TempEntity effect;
        effect.type = type;
        effect.entity = entity;
        MessageWriter writer;
        write_temp_entity(writer, effect);
        return writer.bytes().size();
    };
    EXPECT_EQ(size_of(TE_BLASTER, 0), 8u);
    EXPECT_EQ(size_of(TE_RAILTRAIL, 0), 13u);
    EXPECT_EQ(size_of(TE_SPLASH, 0), 10u);
    EXPECT_EQ(size_of(TE_ROCKET_EXPLOSION, 0), 7u);
    EXPECT_EQ(size_of(TE_GRAPPLE_CABLE, 0), 21u);
    EXPECT_EQ(size_of(TE_LIGHTNING, 0), 17u);
    EXPECT_EQ(size_of(TE_STEAM, 1), 18u);
    EXPECT_EQ(size_of(TE_STEAM, -1), 14u);
}

TEST(Dm2, FaultsNameTheByte) {
    const auto fault = [](const Bytes& messages, std::string_view part) {
        expect_fault("x.dm2", part, [&] { read_messages(messages); });
    };
    fault({77}, "byte 23: a message of type 77");
    fault({svc_playerinfo}, "cannot be here");
    fault({svc_temp_entity, 99}, "the effect 99");
    fault({svc_temp_entity, TE_BLASTER, 0, 0, 0, 0, 0, 0, 200}, "no direction 200");
    fault({svc_print, 1, 'a'}, "a text has no end");
    fault({svc_configstring, 0xff, 0xff, 0}, "configuration string 65535");
    fault({svc_inventory, 0}, "more are needed");
    fault({svc_spawnbaseline, 0, 0}, "baseline of entity 0");
    fault(frame_of(5, 4, {}), "follows from frame 4");
    fault(frame_of(1, -1, {0, 5, 0, 4}), "entity 4 follows entity 5");
    fault(frame_of(1, -1, {0x40, 5}), "vanishes");
    fault(frame_of(1, -1, {0x80, 0x01, 0, 4}), "no entity 1024");
}

TEST(Dm2, FilesEndWithTheirMark) {
    const auto fault = [](Bytes bytes, std::string_view part) {
        expect_fault("x.dm2", part, [&] { read_all(std::move(bytes)); });
    };
    const Bytes whole = demo_of({svc_nop});
    Bytes cut = whole;
    cut.resize(whole.size() - 4);
    fault(cut, "byte 23: the file is cut off");
    cut.resize(10);
    fault(cut, "cut off 6 bytes into a block");
    fault({}, "byte 0");
    Bytes length = whole;
    patch<int32_t>(length, 0, -2);
    fault(length, "cannot be -2 bytes");
    patch<int32_t>(length, 0, 1 << 20);
    fault(length, "cannot be 1048576 bytes");
    Bytes other = whole;
    patch<int32_t>(other, 5, 26);
    fault(other, "protocol 26");
    fault({1, 0, 0, 0, svc_nop, 0xff, 0xff, 0xff, 0xff}, "begins with the server's data");
}

/// A demo with some of everything, and its messages as they arrive.
struct Sample {
    Bytes bytes;
    std::vector<Message> messages;
};

Sample random_demo(uint32_t seed, int frames) {
    std::mt19937 random(seed);
    const auto below = [&random](uint32_t limit) {
        return static_cast<uint32_t>(random() % limit);
    };
    const auto vector = [&](float range) {
        glm::vec3 value;
        for (int i = 0; i < 3; ++i)
            value[i] = range * (static_cast<float>(below(20001)) / 10000.0f - 1.0f);
        return value;
    };
    const auto entity = [&](EntityState state) {
        state.models = {static_cast<uint8_t>(below(256)), static_cast<uint8_t>(below(2)), 0,
                        static_cast<uint8_t>(below(3))};
        state.old_origin = state.origin;
        if (below(3) != 0) state.origin = vector(4000.0f);
        if (below(3) == 0) state.angles = vector(180.0f);
        state.frame = static_cast<uint16_t>(below(600));
        state.skin = below(4) == 0 ? 0xf2f2f0f0u : below(40000);
        state.effects = 1u << below(32);
        state.render_flags = below(2) == 0 ? 0 : 1u << below(19);
        state.event = static_cast<uint8_t>(below(4) == 0 ? below(8) : 0);
        state.sound = static_cast<uint8_t>(below(256));
        state.solid = static_cast<uint16_t>(below(65536));
        return entity_as_sent(state);
    };

    Sample sample;
    Writer writer;
    const auto add = [&](Message message) {
        writer.add(message);
        sample.messages.push_back(std::move(message));
    };
    add(ServerData{34, 3, true, "baseq2", 0, "Random"});
    add(ConfigString{CS_MODELS + 1, "maps/tiny.bsp"});
    add(ConfigString{CS_LIGHTS + 1, "mmnm"});
    for (uint32_t number = 2; number < 600; number += 60) {
        EntityState state = entity({});
        state.number = number;
        state.event = 0;
        state.old_origin = glm::vec3(0.0f);
        add(Baseline{state});
    }
    add(StuffText{"precache\n"});
    writer.end_block();

    Frame frame;
    std::map<uint32_t, EntityState> present;
    for (int i = 1; i <= frames; ++i) {
        frame.delta_from = i == 1 ? -1 : frame.number;
        frame.number = i;
        frame.area_bits.assign(below(4), 0xff);
        frame.player.origin = vector(2000.0f);
        if (below(2) == 0) frame.player.view_angles = vector(179.0f);
        if (below(3) == 0) frame.player.weapon_frame = static_cast<uint8_t>(below(30));
        if (below(3) == 0) frame.player.view_offset = vector(30.0f);
        if (below(3) == 0) frame.player.blend = {1, 2, 3, static_cast<uint8_t>(below(256))};
        frame.player.stats[below(32)] = static_cast<int16_t>(below(1000));
        frame.player.fov = 90;
        frame.player = player_as_sent(frame.player);
        for (auto row = present.begin(); row != present.end();) {
            if (below(6) == 0) {
                row = present.erase(row);
                continue;
            }
            row->second = below(2) == 0 ? unchanged_entity(row->second) : entity(row->second);
            ++row;
        }
        for (int added = 0; added < 4; ++added) {
            const uint32_t number = 1 + below(most_entities - 1);
            if (present.contains(number)) continue;
            EntityState state = entity({});
            state.number = number;
            present[number] = state;
        }
        frame.entities.clear();
        for (const auto& [number, state] : present)
            frame.entities.push_back(state);
        add(frame);
        TempEntity effect;
        effect.type = TE_LASER_SPARKS;
        effect.count = 9;
        effect.direction = 161;
        add(effect);
        add(MuzzleFlash{1, 14, false, below(2) == 0});
        add(Sound{3, 255, {}, {}, 8, glm::vec3(1, 2, 3)});
        add(Print{1, "text"});
        if (i % 20 == 0) add(Inventory{});
        writer.end_block();
    }
    add(Signal::Disconnect);
    sample.bytes = writer.finish();
    return sample;
}

TEST(Dm2, WhatIsWrittenIsReadAgain) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        const Sample sample = random_demo(seed, 60);
        const std::vector<Message> read = read_all(sample.bytes);
        ASSERT_EQ(read.size(), sample.messages.size());
        for (size_t i = 0; i < read.size(); ++i)
            ASSERT_TRUE(read[i] == sample.messages[i]) << "seed " << seed << ", message " << i;
    }
}

TEST(Dm2, DamageIsNoticedAndNeverCrashes) {
    const Sample sample = random_demo(99, 40);
    std::mt19937 random(7);
    size_t noticed = 0;
    constexpr size_t rounds = 1500;
    for (size_t round = 0; round < rounds; ++round) {
        Bytes bytes = sample.bytes;
        for (size_t flips = 1 + random() % 3; flips > 0; --flips) {
            uint8_t& byte = bytes[random() % bytes.size()];
            byte = static_cast<uint8_t>(byte ^ 1u << random() % 8);
        }
        if (random() % 4 == 0) bytes.resize(random() % bytes.size());
        try {
            const std::vector<Message> messages = read_all(std::move(bytes));
            for (const Message& message : messages) {
                if (const auto* frame = std::get_if<Frame>(&message)) {
                    ASSERT_TRUE(std::ranges::is_sorted(frame->entities, std::ranges::less(),
                                                       &EntityState::number));
                }
            }
        } catch (const Error& error) {
            ++noticed;
            ASSERT_TRUE(std::string_view(error.what()).starts_with("x.dm2: ")) << error.what();
        }
    }
    EXPECT_GT(noticed, rounds / 4);
}

TEST(Dm2, EveryCutIsNoticed) {
    const Sample sample = random_demo(5, 3);
    for (size_t size = 0; size < sample.bytes.size(); ++size) {
        Bytes bytes = sample.bytes;
        bytes.resize(size);
        EXPECT_THROW(read_all(std::move(bytes)), Error) << size;
    }
}

TEST(Dm2, RealDemosAreReadToTheirEnd) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "the real demos are not there";
    for (const char* name : {"test.dm2", "testduel.dm2"}) {
        const Bytes bytes = read_file(*folder / "demos" / name);
        ASSERT_FALSE(bytes.empty()) << name;
        const std::vector<Message> messages = read_all(bytes, name);
        int32_t last = 0;
        size_t frames = 0;
        for (const Message& message : messages) {
            const auto* frame = std::get_if<Frame>(&message);
            if (frame == nullptr) continue;
            // Frames follow one another: no message was misread as one.
            EXPECT_GT(frame->number, last);
            last = frame->number;
            ++frames;
            for (const float angle : {frame->player.view_angles.x, frame->player.view_angles.z})
                EXPECT_LE(std::abs(angle), 90.0f);
        }
        EXPECT_GT(frames, 20u) << name;
        // Written again and read again, all of it is the same: but for what frames follow from.
        Writer writer;
        for (const Message& message : messages) {
            writer.add(message);
            writer.end_block();
        }
        std::vector<Message> again = read_all(writer.finish(), name);
        ASSERT_EQ(again.size(), messages.size());
        for (size_t i = 0; i < again.size(); ++i) {
            if (auto* frame = std::get_if<Frame>(&again[i]))
                frame->delta_from = std::get<Frame>(messages[i]).delta_from;
            ASSERT_TRUE(again[i] == messages[i]) << name << ": message " << i;
        }
    }
}

} // namespace
} // namespace vigil::dm2
