// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/dm2_writer.h"

#include "formats/dm2_protocol.h"

namespace vigil::dm2 {

namespace {

template <typename... Cases> struct Overloaded : Cases... { using Cases::operator()...; };
template <typename... Cases> Overloaded(Cases...) -> Overloaded<Cases...>; // clang 14 needs it said

void write_sound(MessageWriter& writer, const Sound& sound) {
    writer.u8(svc_sound);
    writer.u8((sound.volume ? 1u : 0u) | (sound.attenuation ? 2u : 0u) | (sound.place ? 4u : 0u) |
              (sound.entity_channel ? 8u : 0u) | (sound.delay_ms ? 16u : 0u));
    writer.u8(sound.sound);
    if (sound.volume) writer.u8(*sound.volume);
    if (sound.attenuation) writer.u8(*sound.attenuation);
    if (sound.delay_ms) writer.u8(*sound.delay_ms);
    if (sound.entity_channel) writer.i16(*sound.entity_channel);
    if (sound.place) writer.position(*sound.place);
}

} // namespace

void Writer::add(const Message& message) {
    MessageWriter& out = block_;
    const auto text = [&out](uint32_t type, std::string_view chars) {
        out.u8(type);
        out.text(chars);
    };
    std::visit(Overloaded{
                   [&](const ServerData& data) {
                       out.u8(svc_serverdata);
                       out.i32(data.protocol);
                       out.i32(data.server_count);
                       out.u8(data.attract_loop ? 1 : 0);
                       out.text(data.game_folder);
                       out.i16(data.player_number);
                       out.text(data.level_title);
                       baselines_.clear();
                       last_.reset();
                   },
                   [&](const ConfigString& string) {
                       out.u8(svc_configstring);
                       out.i16(static_cast<int32_t>(string.index));
                       out.text(string.text);
                   },
                   [&](const Baseline& baseline) {
                       out.u8(svc_spawnbaseline);
                       const EntityState state = entity_as_sent(baseline.state);
                       write_entity(out, {}, state, true);
                       baselines_[state.number] = state;
                   },
                   [&](const Print& print) {
                       out.u8(svc_print);
                       out.u8(print.level);
                       out.text(print.text);
                   },
                   [&](const CenterPrint& print) { text(svc_centerprint, print.text); },
                   [&](const StuffText& commands) { text(svc_stufftext, commands.text); },
                   [&](const Layout& layout) { text(svc_layout, layout.text); },
                   [&](const Inventory& inventory) {
                       out.u8(svc_inventory);
                       for (const int16_t count : inventory.counts)
                           out.i16(count);
                   },
                   [&](const Sound& sound) { write_sound(out, sound); },
                   [&](const MuzzleFlash& flash) {
                       out.u8(flash.monster ? svc_muzzleflash2 : svc_muzzleflash);
                       out.i16(flash.entity);
                       out.u8(flash.weapon | (flash.silenced ? 0x80u : 0u));
                   },
                   [&](const TempEntity& effect) {
                       out.u8(svc_temp_entity);
                       write_temp_entity(out, effect);
                   },
                   [&](const Download& download) {
                       out.u8(svc_download);
                       out.i16(download.bytes);
                       out.u8(download.percent);
                       out.raw(download.data);
                   },
                   [&](Signal signal) {
                       out.u8(signal == Signal::Nothing      ? svc_nop
                              : signal == Signal::Disconnect ? svc_disconnect
                                                             : svc_reconnect);
                   },
                   [&](const Frame& frame) { add_frame(frame); },
               },
               message);
}

void Writer::add_frame(const Frame& source) {
    Frame frame = source;
    frame.player = player_as_sent(frame.player);
    for (EntityState& entity : frame.entities)
        entity = entity_as_sent(entity);
    static const Frame nothing;
    const Frame& before = last_ ? *last_ : nothing;

    MessageWriter& out = block_;
    out.u8(svc_frame);
    out.i32(frame.number);
    out.i32(last_ ? last_->number : -1);
    out.u8(frame.suppressed);
    out.u8(static_cast<uint32_t>(frame.area_bits.size()));
    out.raw(frame.area_bits);
    out.u8(svc_playerinfo);
    write_player(out, before.player, frame.player);

    out.u8(svc_packetentities);
    auto old = before.entities.begin();
    for (const EntityState& entity : frame.entities) {
        for (; old != before.entities.end() && old->number < entity.number; ++old)
            write_entity_removal(out, old->number);
        if (old != before.entities.end() && old->number == entity.number) {
            write_entity(out, unchanged_entity(*old), entity, false);
            ++old;
            continue;
        }
        const auto baseline = baselines_.find(entity.number);
        write_entity(
            out, baseline != baselines_.end() ? unchanged_entity(baseline->second) : EntityState{},
            entity, true);
    }
    for (; old != before.entities.end(); ++old)
        write_entity_removal(out, old->number);
    out.i16(0); // no bits, entity 0: the end
    last_ = std::move(frame);
}

void Writer::end_block() {
    if (block_.bytes().empty()) return;
    largest_block_ = std::max(largest_block_, block_.bytes().size());
    file_.u32(static_cast<uint32_t>(block_.bytes().size()));
    file_.raw(block_.bytes());
    block_.clear();
}

std::vector<uint8_t> Writer::finish() {
    end_block();
    std::vector<uint8_t> bytes = file_.bytes();
    bytes.insert(bytes.end(), 4, 0xff);
    return bytes;
}

} // namespace vigil::dm2
