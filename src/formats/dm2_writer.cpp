// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/dm2_writer.h"

#include "formats/dm2_fields.h"

namespace vigil::dm2 {

namespace {

template <typename... Cases> struct Overloaded : Cases... { using Cases::operator()...; };
template <typename... Cases> Overloaded(Cases...) -> Overloaded<Cases...>; // clang 14 needs it said

} // namespace

void Writer::add(const Message& message) {
    MessageWriter& out = block_;
    const auto plain = [&out](uint32_t type, const auto& body) {
        out.u8(type);
        fields(out, body);
    };
    std::visit(Overloaded{
                   [&](const ServerData& data) {
                       plain(svc_serverdata, data);
                       baselines_.clear();
                       last_.reset();
                   },
                   [&](const Baseline& baseline) {
                       out.u8(svc_spawnbaseline);
                       write_entity(out, {}, baseline.state, true);
                       baselines_[baseline.state.number] = baseline.state;
                   },
                   [&](const ConfigString& string) { plain(svc_configstring, string); },
                   [&](const Print& print) { plain(svc_print, print); },
                   [&](const CenterPrint& print) { plain(svc_centerprint, print); },
                   [&](const StuffText& commands) { plain(svc_stufftext, commands); },
                   [&](const Layout& layout) { plain(svc_layout, layout); },
                   [&](const Inventory& inventory) { plain(svc_inventory, inventory); },
                   [&](const Sound& sound) { plain(svc_sound, sound); },
                   [&](const MuzzleFlash& flash) {
                       plain(flash.monster ? svc_muzzleflash2 : svc_muzzleflash, flash);
                   },
                   [&](const TempEntity& effect) {
                       out.u8(svc_temp_entity);
                       write_temp_entity(out, effect);
                   },
                   [&](const Download& download) { plain(svc_download, download); },
                   [&](Signal signal) {
                       out.u8(signal == Signal::Nothing      ? svc_nop
                              : signal == Signal::Disconnect ? svc_disconnect
                                                             : svc_reconnect);
                   },
                   [&](const Frame& frame) { add_frame(frame); },
               },
               message);
}

void Writer::add_frame(const Frame& frame) {
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
            write_entity(out, *old, entity, false);
            ++old;
            continue;
        }
        const auto baseline = baselines_.find(entity.number);
        write_entity(out, baseline != baselines_.end() ? baseline->second : EntityState{}, entity,
                     true);
    }
    for (; old != before.entities.end(); ++old)
        write_entity_removal(out, old->number);
    out.i16(0); // no bits, entity 0: the end
    last_ = frame;
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
