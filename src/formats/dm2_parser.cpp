// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/dm2_parser.h"

#include "formats/dm2_protocol.h"

namespace vigil::dm2 {

namespace {

enum SoundBit : uint32_t {
    SND_VOLUME = 1,
    SND_ATTENUATION = 2,
    SND_POSITION = 4,
    SND_ENTITY = 8,
    SND_DELAY = 16,
};
constexpr uint32_t silenced_flag = 0x80;

Sound read_sound(MessageReader& reader) {
    Sound sound;
    const uint32_t bits = reader.u8();
    sound.sound = reader.u8();
    if ((bits & SND_VOLUME) != 0) sound.volume = reader.u8();
    if ((bits & SND_ATTENUATION) != 0) sound.attenuation = reader.u8();
    if ((bits & SND_DELAY) != 0) sound.delay_ms = reader.u8();
    if ((bits & SND_ENTITY) != 0) {
        sound.entity_channel = reader.u16();
        if (*sound.entity_channel / 8u >= most_entities)
            reader.bad("a sound comes from entity {}", *sound.entity_channel / 8u);
    }
    if ((bits & SND_POSITION) != 0) sound.place = reader.position();
    return sound;
}

MuzzleFlash read_muzzle_flash(MessageReader& reader, bool monster) {
    MuzzleFlash flash;
    flash.monster = monster;
    flash.entity = reader.u16();
    if (flash.entity == 0 || flash.entity >= most_entities)
        reader.bad("a weapon of entity {} flashes", flash.entity);
    const uint32_t kind = reader.u8();
    flash.silenced = !monster && (kind & silenced_flag) != 0;
    flash.weapon = static_cast<uint8_t>(monster ? kind : kind & ~silenced_flag);
    return flash;
}

Download read_download(MessageReader& reader) {
    Download download;
    download.bytes = reader.i16();
    download.percent = reader.u8();
    if (download.bytes > 0) {
        const auto data = reader.take(static_cast<size_t>(download.bytes));
        download.data.assign(data.begin(), data.end());
    }
    return download;
}

ConfigString read_config_string(MessageReader& reader) {
    ConfigString string;
    string.index = reader.u16();
    if (string.index >= config_string_count)
        reader.bad("there is no configuration string {}, only 0 to {}", string.index,
                   config_string_count - 1);
    string.text = reader.text();
    return string;
}

} // namespace

void Parser::parse(const File::Block& block, std::vector<Message>& messages) {
    MessageReader reader(name_, block.offset, block.bytes);
    while (!reader.at_end())
        messages.push_back(read_message(reader));
}

Message Parser::read_message(MessageReader& reader) {
    const uint8_t type = reader.u8();
    if (!started_ && type != svc_serverdata)
        reader.bad("a demo begins with the server's data (12), not with a message {}", type);
    switch (type) {
    case svc_muzzleflash:
    case svc_muzzleflash2:
        return read_muzzle_flash(reader, type == svc_muzzleflash2);
    case svc_temp_entity:
        return read_temp_entity(reader);
    case svc_layout:
        return Layout{reader.text()};
    case svc_inventory: {
        Inventory inventory;
        for (int16_t& count : inventory.counts)
            count = reader.i16();
        return inventory;
    }
    case svc_nop:
        return Signal::Nothing;
    case svc_disconnect:
        return Signal::Disconnect;
    case svc_reconnect:
        return Signal::Reconnect;
    case svc_sound:
        return read_sound(reader);
    case svc_print: {
        Print print;
        print.level = reader.u8();
        print.text = reader.text();
        return print;
    }
    case svc_stufftext:
        return StuffText{reader.text()};
    case svc_serverdata:
        return read_server_data(reader);
    case svc_configstring:
        return read_config_string(reader);
    case svc_spawnbaseline: {
        const EntityHeader header = read_entity_header(reader);
        if (header.number == 0) reader.bad("a baseline of entity 0");
        EntityState state = read_entity(reader, header, {});
        baselines_[header.number] = state;
        return Baseline{state};
    }
    case svc_centerprint:
        return CenterPrint{reader.text()};
    case svc_download:
        return read_download(reader);
    case svc_frame:
        return read_frame(reader);
    default:
        reader.bad("a message of type {} cannot be here", type);
    }
}

ServerData Parser::read_server_data(MessageReader& reader) {
    ServerData data;
    data.protocol = reader.i32();
    if (data.protocol != protocol_version)
        reader.bad("the demo has protocol {}; only {} (Quake II 3.15 to 3.24) is understood",
                   data.protocol, protocol_version);
    data.server_count = reader.i32();
    data.attract_loop = reader.u8() != 0;
    data.game_folder = reader.text();
    data.player_number = reader.i16();
    data.level_title = reader.text();
    started_ = true;
    baselines_.clear();
    frames_.fill(std::nullopt);
    return data;
}

Frame Parser::read_frame(MessageReader& reader) {
    Frame frame;
    frame.number = reader.i32();
    if (frame.number < 0) reader.bad("there is no frame {}", frame.number);
    frame.delta_from = reader.i32();
    frame.suppressed = reader.u8();
    const auto areas = reader.take(reader.u8());
    frame.area_bits.assign(areas.begin(), areas.end());

    static const Frame nothing;
    const Frame* before = &nothing;
    if (frame.delta_from > 0) {
        const std::optional<Frame>& kept =
            frames_[static_cast<size_t>(frame.delta_from) % kept_frames];
        if (!kept || kept->number != frame.delta_from)
            reader.bad("frame {} follows from frame {}, which is not there", frame.number,
                       frame.delta_from);
        before = &*kept;
    }
    if (const uint8_t type = reader.u8(); type != svc_playerinfo)
        reader.bad("a frame needs the player's state (17), not a message {}", type);
    frame.player = read_player(reader, before->player);
    if (const uint8_t type = reader.u8(); type != svc_packetentities)
        reader.bad("a frame needs its entities (18), not a message {}", type);
    frame.entities = read_entities(reader, before->entities);
    frames_[static_cast<size_t>(frame.number) % kept_frames] = frame;
    return frame;
}

std::vector<EntityState> Parser::read_entities(MessageReader& reader,
                                               const std::vector<EntityState>& before) {
    // Both lists ascend by number, so they are merged.
    std::vector<EntityState> entities;
    auto old = before.begin();
    uint32_t last = 0;
    for (;;) {
        const EntityHeader header = read_entity_header(reader);
        if (header.number == 0) break;
        if (header.number <= last) reader.bad("entity {} follows entity {}", header.number, last);
        last = header.number;
        for (; old != before.end() && old->number < header.number; ++old)
            entities.push_back(unchanged_entity(*old));
        const bool known = old != before.end() && old->number == header.number;
        if (header.removed()) {
            if (!known) reader.bad("entity {} vanishes, but was not there", header.number);
            ++old;
            continue;
        }
        const auto baseline = baselines_.find(header.number);
        static const EntityState empty;
        const EntityState& from =
            known ? *old : (baseline != baselines_.end() ? baseline->second : empty);
        entities.push_back(read_entity(reader, header, from));
        if (known) ++old;
    }
    for (; old != before.end(); ++old)
        entities.push_back(unchanged_entity(*old));
    return entities;
}

} // namespace vigil::dm2
