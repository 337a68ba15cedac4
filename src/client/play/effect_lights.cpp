// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of the original colours and radii. Random parts of the game's radii are their means here,
// so that a demo looks the same each time.
#include "client/play/effect_lights.h"

#include "formats/dm2_protocol.h"

namespace vigil::client {

namespace {

const glm::vec3 yellow(1.0f, 1.0f, 0.0f), green(0.0f, 1.0f, 0.0f), blue(0.0f, 0.0f, 1.0f),
    red(1.0f, 0.0f, 0.0f), explosion(1.0f, 0.5f, 0.5f), white(1.0f);
constexpr float shell_radius = 100.0f;

struct EntityRow {
    uint32_t effect;
    EffectLight light;
};

/// In order of precedence: a missile has one of them.
const EntityRow missiles[] = {
    {dm2::EF_ROCKET, {200.0f, yellow}},
    {dm2::EF_BLASTER, {200.0f, yellow}},
    {dm2::EF_HYPERBLASTER, {200.0f, yellow}},
    {dm2::EF_BFG, {200.0f, green}},
    {dm2::EF_TRAP, {150.0f, {1.0f, 0.8f, 0.1f}}},
    {dm2::EF_FLAG1, {225.0f, {1.0f, 0.1f, 0.1f}}},
    {dm2::EF_FLAG2, {225.0f, {0.1f, 0.1f, 1.0f}}},
    {dm2::EF_TAGTRAIL, {225.0f, yellow}},
    {dm2::EF_IONRIPPER, {100.0f, explosion}},
    {dm2::EF_BLUEHYPERBLASTER, {200.0f, blue}},
    {dm2::EF_PLASMA, {130.0f, explosion}},
};

const EntityRow shells[] = {
    {dm2::EF_QUAD, {shell_radius, blue}},
    {dm2::EF_PENT, {shell_radius, red}},
    {dm2::EF_DOUBLE, {shell_radius, {0.9f, 0.7f, 0.0f}}},
    {dm2::EF_HALF_DAMAGE, {shell_radius, {0.56f, 0.59f, 0.45f}}},
    {dm2::EF_POWERSCREEN, {shell_radius, green}},
};

/// The explosion of the big ball: brightness by its frame.
constexpr float bfg_radii[] = {300.0f, 400.0f, 600.0f, 300.0f, 150.0f, 75.0f};

EffectLight player_flash(uint8_t weapon) {
    switch (weapon) {
    case 3: // chain gun, one to three bullets
        return {215.0f, {1.0f, 0.25f, 0.0f}};
    case 4:
        return {240.0f, {1.0f, 0.5f, 0.0f}};
    case 5:
        return {265.0f, yellow};
    case 6: // rail gun
        return {215.0f, {0.5f, 0.5f, 1.0f}};
    case 7: // rocket launcher
        return {215.0f, {1.0f, 0.5f, 0.2f}};
    case 8: // grenade launcher
        return {215.0f, {1.0f, 0.5f, 0.0f}};
    case 9:  // log-in
    case 12: // BFG
    case 34: // blaster 2
        return {215.0f, green};
    case 10: // log-out
        return {215.0f, red};
    case 15: // an item appears again: particles only
    case 35: // tracker: darkens
        return {};
    case 16: // ion ripper
    case 18: // phalanx
        return {215.0f, explosion};
    case 17: // blue hyper blaster
        return {215.0f, blue};
    case 30: // ETF rifle
        return {215.0f, {0.9f, 0.7f, 0.0f}};
    case 36: // nuke, counting
        return {215.0f, red};
    case 38:
        return {215.0f, blue};
    case 39:
        return {215.0f, {0.0f, 1.0f, 1.0f}};
    default: // blasters, machine gun, shot guns
        return {215.0f, yellow};
    }
}

/// Monsters number their muzzles, so kinds of weapons are ranges.
glm::vec3 monster_flash_color(uint8_t muzzle) {
    const auto within = [muzzle](int first, int last) { return muzzle >= first && muzzle <= last; };
    if (within(23, 25) || muzzle == 57 || within(70, 72) || within(78, 81))
        return {1.0f, 0.5f, 0.2f};                                 // rockets
    if (within(53, 56)) return {1.0f, 0.5f, 0.0f};                 // grenades
    if (muzzle == 61 || muzzle == 119) return {0.5f, 0.5f, 1.0f};  // rail guns
    if (muzzle == 101 || muzzle == 132) return {0.5f, 1.0f, 0.5f}; // BFG
    return yellow;
}

} // namespace

std::vector<EffectLight> entity_lights(const dm2::EntityState& entity) {
    std::vector<EffectLight> lights;
    const uint32_t effects = entity.effects;
    for (const EntityRow& row : missiles) {
        if ((effects & row.effect) == 0) continue;
        lights.push_back(row.light);
        if ((effects & dm2::EF_TRACKER) != 0 && row.light.color == yellow)
            lights.back().color = green; // of the blaster that uses its trail
        if (row.effect == dm2::EF_BFG && (effects & dm2::EF_ANIM_ALLFAST) == 0)
            lights.back().radius =
                bfg_radii[std::min<size_t>(entity.frame, std::size(bfg_radii) - 1)];
        break;
    }
    if ((effects & dm2::EF_SPINNINGLIGHTS) != 0) lights.push_back({100.0f, red});

    EffectLight shell;
    for (const EntityRow& row : shells) {
        if ((effects & row.effect) == 0) continue;
        shell.radius = row.light.radius;
        shell.color = glm::max(shell.color, row.light.color);
    }
    if ((effects & dm2::EF_COLOR_SHELL) != 0) {
        shell.radius = shell_radius;
        const uint32_t flags = entity.render_flags;
        if ((flags & dm2::RF_SHELL_RED) != 0) shell.color.x = 1.0f;
        if ((flags & dm2::RF_SHELL_GREEN) != 0) shell.color.y = 1.0f;
        if ((flags & dm2::RF_SHELL_BLUE) != 0) shell.color.z = 1.0f;
    }
    if (shell.color != glm::vec3(0.0f)) lights.push_back(shell);
    return lights;
}

Flash muzzle_flash(const dm2::MuzzleFlash& flash) {
    Flash result;
    if (flash.monster) {
        result.light = {215.0f, monster_flash_color(flash.weapon)};
        return result;
    }
    result.light = player_flash(flash.weapon);
    if (flash.silenced) result.light.radius -= 100.0f;
    if (flash.weapon == 9 || flash.weapon == 10 || flash.weapon == 11) result.seconds = 1.0f;
    return result;
}

Burst burst_of(const dm2::TempEntity& effect) {
    using namespace dm2;
    constexpr float big = 350.0f, wall = 150.0f;
    switch (effect.type) {
    case TE_GUNSHOT:
    case TE_SHOTGUN:
        return {{}, 0.0f, 20, palette_color(0), 60.0f};
    case TE_BULLET_SPARKS:
        return {{}, 0.0f, 6, palette_color(0xe0), 60.0f};
    case TE_SPARKS:
        return {{}, 0.0f, 6, palette_color(0xe0), 60.0f};
    case TE_SCREEN_SPARKS:
        return {{}, 0.0f, 40, palette_color(0xd0), 60.0f};
    case TE_SHIELD_SPARKS:
        return {{}, 0.0f, 40, palette_color(0xb0), 60.0f};
    case TE_ELECTRIC_SPARKS:
        return {{}, 0.0f, 40, palette_color(0x75), 60.0f};
    case TE_HEATBEAM_SPARKS:
        return {{}, 0.0f, 50, palette_color(8), 60.0f};
    case TE_HEATBEAM_STEAM:
        return {{}, 0.0f, 20, palette_color(0xe0), 60.0f};
    case TE_BLOOD:
        return {{}, 0.0f, 60, palette_color(0xe8), 60.0f};
    case TE_MOREBLOOD:
        return {{}, 0.0f, 250, palette_color(0xe8), 60.0f};
    case TE_GREENBLOOD:
        return {{}, 0.0f, 30, palette_color(0xdf), 60.0f};
    case TE_SPLASH:
    case TE_LASER_SPARKS:
    case TE_TUNNEL_SPARKS:
        return {{}, 0.0f, effect.count, palette_color(effect.color), 60.0f};
    case TE_WELDING_SPARKS:
        return {
            {137.0f, {1.0f, 1.0f, 0.3f}}, 0.2f, effect.count, palette_color(effect.color), 60.0f};
    case TE_STEAM:
        return {{}, 0.0f, effect.count, palette_color(effect.color), 80.0f};
    case TE_BLUEHYPERBLASTER:
        return {{}, 0.0f, 40, palette_color(0xe0), 80.0f};
    case TE_BLASTER:
        return {{wall, yellow}, 0.4f, 40, palette_color(0xe0), 80.0f};
    case TE_BLASTER2:
        return {{wall, green}, 0.4f, 40, palette_color(0xd0), 80.0f};
    case TE_FLECHETTE:
        return {{wall, {0.19f, 0.41f, 0.75f}}, 0.4f, 40, palette_color(0x6f), 80.0f};
    case TE_EXPLOSION1:
    case TE_EXPLOSION2:
    case TE_ROCKET_EXPLOSION:
    case TE_GRENADE_EXPLOSION:
    case TE_ROCKET_EXPLOSION_WATER:
    case TE_GRENADE_EXPLOSION_WATER:
    case TE_PLASMA_EXPLOSION:
        return {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f};
    case TE_EXPLOSION1_BIG:
    case TE_EXPLOSION1_NP:
    case TE_PLAIN_EXPLOSION:
        return {{big, explosion}, 1.5f, 0, white, 0.0f};
    case TE_BFG_EXPLOSION:
        return {{big, green}, 0.4f, 0, white, 0.0f};
    case TE_BFG_BIGEXPLOSION:
        return {{}, 0.0f, 256, palette_color(0xd0), 190.0f};
    case TE_BOSSTPORT:
    case TE_TELEPORT_EFFECT:
    case TE_DBALL_GOAL:
        return {{}, 0.0f, 256, palette_color(7), 120.0f};
    case TE_TRACKER_EXPLOSION:
    case TE_WIDOWSPLASH:
        return {{}, 0.0f, 128, palette_color(0), 150.0f};
    case TE_WIDOWBEAMOUT:
        return {{300.0f, green}, 2.1f, 0, white, 0.0f};
    case TE_NUKEBLAST:
        return {{600.0f, white}, 1.0f, 256, palette_color(0xe0), 300.0f};
    case TE_FLASHLIGHT:
        return {{400.0f, white}, 0.1f, 0, white, 0.0f};
    case TE_CHAINFIST_SMOKE:
        return {{}, 0.0f, 20, palette_color(0), 20.0f};
    default:
        return {};
    }
}

refresh::DynamicLight dynamic_light(uint32_t id, const glm::vec3& origin,
                                    const EffectLight& light) {
    return {id, origin, light.radius / 25.0f, 11.4f * light.radius * light.color};
}

glm::vec3 palette_color(uint8_t index) {
    // By the ramps of 8 or 16 that the game's effects use.
    if (index < 0x10) return glm::vec3(0.2f + 0.05f * static_cast<float>(index));
    if (index >= 0x60 && index < 0x80) return {0.2f, 0.4f, 0.8f};
    if (index >= 0xb0 && index < 0xc0) return {0.5f, 0.5f, 1.0f};
    if (index >= 0xd0 && index < 0xd8) return {0.1f, 1.0f, 0.1f};
    if (index >= 0xdc && index < 0xe0) return {1.0f, 0.9f, 0.1f};
    if (index >= 0xe0 && index < 0xe8) return {1.0f, 0.6f, 0.1f};
    if (index >= 0xe8 && index < 0xf0) return {0.5f, 0.0f, 0.0f};
    if (index == 0xf0 || index == 0xf2) return {1.0f, 0.05f, 0.05f};
    if (index == 0xf1 || index == 0xf3) return {0.1f, 0.1f, 1.0f};
    return glm::vec3(0.6f);
}

glm::vec3 laser_color(uint32_t skin) {
    glm::vec3 sum(0.0f);
    for (uint32_t shift = 0; shift < 32; shift += 8)
        sum += palette_color(static_cast<uint8_t>(skin >> shift));
    return 0.25f * sum;
}

} // namespace vigil::client
