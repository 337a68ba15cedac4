// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/dm2_parser.h"

#include "formats/dm2_fields.h"

namespace vigil::dm2 {

namespace {

template <typename Plain> Plain read(MessageReader& reader, Plain message = {}) {
    fields(reader, message);
    return message;
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
        return read(reader, MuzzleFlash{.monster = type == svc_muzzleflash2});
    case svc_temp_entity:
        return read_temp_entity(reader);
    case svc_layout:
        return read<Layout>(reader);
    case svc_inventory:
        return read<Inventory>(reader);
    case svc_nop:
        return Signal::Nothing;
    case svc_disconnect:
        return Signal::Disconnect;
    case svc_reconnect:
        return Signal::Reconnect;
    case svc_sound:
        return read<Sound>(reader);
    case svc_print:
        return read<Print>(reader);
    case svc_stufftext:
        return read<StuffText>(reader);
    case svc_serverdata: {
        ServerData data = read<ServerData>(reader);
        started_ = true;
        baselines_.clear();
        frames_.fill(std::nullopt);
        return data;
    }
    case svc_configstring:
        return read<ConfigString>(reader);
    case svc_spawnbaseline: {
        const EntityHeader header = read_entity_header(reader);
        if (header.number == 0) reader.bad("a baseline of entity 0");
        EntityState state = read_entity(reader, header, {});
        baselines_[header.number] = state;
        return Baseline{state};
    }
    case svc_centerprint:
        return read<CenterPrint>(reader);
    case svc_download:
        return read<Download>(reader);
    case svc_frame:
        return read_frame(reader);
    default:
        reader.bad("a message of type {} cannot be here", type);
    }
}

Frame Parser::read_frame(MessageReader& reader) {
    Frame frame;
    reader.i32(frame.number);
    reader.expect(frame.number >= 0, "there is no frame {}", frame.number);
    reader.i32(frame.delta_from);
    reader.u8(frame.suppressed);
    reader.raw(frame.area_bits, reader.u8());

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
