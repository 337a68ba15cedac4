// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of the original colours and radii. Random parts of the game's radii are their means here,
// so that a demo looks the same each time.
#include "client/play/effect_lights.h"

#include "formats/dm2_protocol.h"

#include <algorithm>
#include <iterator>

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

struct FlashRow {
    uint8_t weapon;
    EffectLight light;
};

const FlashRow player_flashes[] = {
    {3, {215.0f, {1.0f, 0.25f, 0.0f}}}, // chain gun, one to three bullets
    {4, {240.0f, {1.0f, 0.5f, 0.0f}}},
    {5, {265.0f, yellow}},
    {6, {215.0f, {0.5f, 0.5f, 1.0f}}},  // rail gun
    {7, {215.0f, {1.0f, 0.5f, 0.2f}}},  // rocket launcher
    {8, {215.0f, {1.0f, 0.5f, 0.0f}}},  // grenade launcher
    {9, {215.0f, green}},               // log-in
    {10, {215.0f, red}},                // log-out
    {12, {215.0f, green}},              // BFG
    {15, {}},                           // an item appears again: particles only
    {16, {215.0f, explosion}},          // ion ripper
    {17, {215.0f, blue}},               // blue hyper blaster
    {18, {215.0f, explosion}},          // phalanx
    {30, {215.0f, {0.9f, 0.7f, 0.0f}}}, // ETF rifle
    {34, {215.0f, green}},              // blaster 2
    {35, {}},                           // tracker: darkens
    {36, {215.0f, red}},                // nuke, counting
    {38, {215.0f, blue}},
    {39, {215.0f, {0.0f, 1.0f, 1.0f}}},
};

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

constexpr float big = 350.0f, wall = 150.0f; // radii of explosions, and of what hits a wall
constexpr int as_said = -1;                  // particles: number and colour as the effect says

struct BurstRow {
    dm2::TempEntityType type;
    Burst burst;
};

const BurstRow bursts[] = {
    {dm2::TE_GUNSHOT, {{}, 0.0f, 20, palette_color(0), 60.0f}},
    {dm2::TE_SHOTGUN, {{}, 0.0f, 20, palette_color(0), 60.0f}},
    {dm2::TE_BULLET_SPARKS, {{}, 0.0f, 6, palette_color(0xe0), 60.0f}},
    {dm2::TE_SPARKS, {{}, 0.0f, 6, palette_color(0xe0), 60.0f}},
    {dm2::TE_SCREEN_SPARKS, {{}, 0.0f, 40, palette_color(0xd0), 60.0f}},
    {dm2::TE_SHIELD_SPARKS, {{}, 0.0f, 40, palette_color(0xb0), 60.0f}},
    {dm2::TE_ELECTRIC_SPARKS, {{}, 0.0f, 40, palette_color(0x75), 60.0f}},
    {dm2::TE_HEATBEAM_SPARKS, {{}, 0.0f, 50, palette_color(8), 60.0f}},
    {dm2::TE_HEATBEAM_STEAM, {{}, 0.0f, 20, palette_color(0xe0), 60.0f}},
    {dm2::TE_BLOOD, {{}, 0.0f, 60, palette_color(0xe8), 60.0f}},
    {dm2::TE_MOREBLOOD, {{}, 0.0f, 250, palette_color(0xe8), 60.0f}},
    {dm2::TE_GREENBLOOD, {{}, 0.0f, 30, palette_color(0xdf), 60.0f}},
    {dm2::TE_SPLASH, {{}, 0.0f, as_said, white, 60.0f}},
    {dm2::TE_LASER_SPARKS, {{}, 0.0f, as_said, white, 60.0f}},
    {dm2::TE_TUNNEL_SPARKS, {{}, 0.0f, as_said, white, 60.0f}},
    {dm2::TE_WELDING_SPARKS, {{137.0f, {1.0f, 1.0f, 0.3f}}, 0.2f, as_said, white, 60.0f}},
    {dm2::TE_STEAM, {{}, 0.0f, as_said, white, 80.0f}},
    {dm2::TE_BLUEHYPERBLASTER, {{}, 0.0f, 40, palette_color(0xe0), 80.0f}},
    {dm2::TE_BLASTER, {{wall, yellow}, 0.4f, 40, palette_color(0xe0), 80.0f}},
    {dm2::TE_BLASTER2, {{wall, green}, 0.4f, 40, palette_color(0xd0), 80.0f}},
    {dm2::TE_FLECHETTE, {{wall, {0.19f, 0.41f, 0.75f}}, 0.4f, 40, palette_color(0x6f), 80.0f}},
    {dm2::TE_EXPLOSION1, {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f}},
    {dm2::TE_EXPLOSION2, {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f}},
    {dm2::TE_ROCKET_EXPLOSION, {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f}},
    {dm2::TE_GRENADE_EXPLOSION, {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f}},
    {dm2::TE_ROCKET_EXPLOSION_WATER, {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f}},
    {dm2::TE_GRENADE_EXPLOSION_WATER, {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f}},
    {dm2::TE_PLASMA_EXPLOSION, {{big, explosion}, 1.5f, 256, palette_color(0xe0), 190.0f}},
    {dm2::TE_EXPLOSION1_BIG, {{big, explosion}, 1.5f, 0, white, 0.0f}},
    {dm2::TE_EXPLOSION1_NP, {{big, explosion}, 1.5f, 0, white, 0.0f}},
    {dm2::TE_PLAIN_EXPLOSION, {{big, explosion}, 1.5f, 0, white, 0.0f}},
    {dm2::TE_BFG_EXPLOSION, {{big, green}, 0.4f, 0, white, 0.0f}},
    {dm2::TE_BFG_BIGEXPLOSION, {{}, 0.0f, 256, palette_color(0xd0), 190.0f}},
    {dm2::TE_BOSSTPORT, {{}, 0.0f, 256, palette_color(7), 120.0f}},
    {dm2::TE_TELEPORT_EFFECT, {{}, 0.0f, 256, palette_color(7), 120.0f}},
    {dm2::TE_DBALL_GOAL, {{}, 0.0f, 256, palette_color(7), 120.0f}},
    {dm2::TE_TRACKER_EXPLOSION, {{}, 0.0f, 128, palette_color(0), 150.0f}},
    {dm2::TE_WIDOWSPLASH, {{}, 0.0f, 128, palette_color(0), 150.0f}},
    {dm2::TE_WIDOWBEAMOUT, {{300.0f, green}, 2.1f, 0, white, 0.0f}},
    {dm2::TE_NUKEBLAST, {{600.0f, white}, 1.0f, 256, palette_color(0xe0), 300.0f}},
    {dm2::TE_FLASHLIGHT, {{400.0f, white}, 0.1f, 0, white, 0.0f}},
    {dm2::TE_CHAINFIST_SMOKE, {{}, 0.0f, 20, palette_color(0), 20.0f}},
};

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
    const auto* row = std::ranges::find(player_flashes, flash.weapon, &FlashRow::weapon);
    // Blasters, machine gun and shot guns are the others.
    result.light = row != std::end(player_flashes) ? row->light : EffectLight{215.0f, yellow};
    if (flash.silenced) result.light.radius -= 100.0f;
    if (flash.weapon == 9 || flash.weapon == 10 || flash.weapon == 11) result.seconds = 1.0f;
    return result;
}

Burst burst_of(const dm2::TempEntity& effect) {
    const auto* row = std::ranges::find(bursts, effect.type, &BurstRow::type);
    if (row == std::end(bursts)) return {};
    Burst burst = row->burst;
    if (burst.particles == as_said) {
        burst.particles = effect.count;
        burst.particle_color = palette_color(effect.color);
    }
    return burst;
}

refresh::DynamicLight dynamic_light(uint32_t id, const glm::vec3& origin,
                                    const EffectLight& light) {
    return {id, origin, refresh::game_light_size * light.radius,
            refresh::game_light_radiance * light.radius * light.color};
}

glm::vec3 laser_color(uint32_t skin) {
    glm::vec3 sum(0.0f);
    for (uint32_t shift = 0; shift < 32; shift += 8)
        sum += palette_color(static_cast<uint8_t>(skin >> shift));
    return 0.25f * sum;
}

} // namespace vigil::client
