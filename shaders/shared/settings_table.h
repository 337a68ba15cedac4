// SPDX-License-Identifier: GPL-2.0-or-later
// The one table of console variables: name, life, what it affects, default, range and help text.
// C++ and GLSL compile the same text. GpuSettings at the end is what shaders read of it,
// refresh/settings.h what the renderer reads, and console/cvar.h holds all of it.
// tools/cvar_docs makes docs/play/cvars.md from it.
#ifndef VIGIL_SHARED_SETTINGS_TABLE_H
#define VIGIL_SHARED_SETTINGS_TABLE_H

#ifdef __cplusplus
#include "shared/features.h"
#include "shared/guiders.h"
#include "shared/techniques.h"
#include "shared/views.h"
#endif

// Columns:
//   STRING (name, life, affects, default, help)
//   INTEGER(name, life, affects, default, minimum, maximum, help)
//   REAL   (name, life, affects, default, minimum, maximum, help)
//   CHOICE (name, life, affects, default, choices, help)     the value is the index of the choice
//   GPU_*  the same, and a field of GpuSettings
// Life:
//   Archived  kept in the configuration file when it differs from the default
//   Session   lasts until the program ends
//   Start     read once when the program starts: give it on the command line with +set
//   GuardedArchived, GuardedSession  the same as without Guarded, for variables that say where files
//             go or what the screen does: a cfg inside a game archive cannot set these, nor those with
//             life Start (console/command.h, Trust)
// Affects, each with all that comes before it:
//   Nothing    no pixel
//   Display    how finished radiance is shown, or which of two techniques is seen where
//   Picture    radiance: a running mean starts anew
//   Reference  what a reference picture is kept for: one of another value is not used
// GLSL sees only the names of the GPU_ rows; its preprocessor knows neither stringising nor
// pasting.

// clang-format off
// What the renderer reads.
#define VIGIL_RENDERER_TABLE(STRING, INTEGER, REAL, CHOICE, GPU_INTEGER, GPU_REAL, GPU_CHOICE) \
    INTEGER(vid_width, GuardedArchived, Reference, 640, 16, 16384, "width of the picture in pixels") \
    INTEGER(vid_height, GuardedArchived, Reference, 360, 16, 16384, "height of the picture in pixels") \
    INTEGER(vid_scale, GuardedArchived, Reference, 100, 25, 100, \
        "percent of the picture's width and height that are traced; the picture is scaled up from them") \
    REAL(vid_fps_target, GuardedArchived, Reference, 0.0, 0.0, 1000.0, \
        "frames a second for which vid_scale is lowered by itself, down to 25; 0: never") \
    INTEGER(vid_vsync, GuardedArchived, Nothing, 1, 0, 1, \
        "1: show a frame only when the display starts a new one") \
    \
    CHOICE(pt_nee, Session, Picture, "vlc", technique_choices, \
        "how next event estimation chooses a light") \
    CHOICE(pt_compare, Session, Reference, "none", compare_choices, \
        "splits the picture: pt_nee and pt_guide on the left, this technique on the right, with guided rays where +cdq or another guider follows; raw: the same unfiltered") \
    REAL(pt_compare_at, Session, Display, 0.5, 0.0, 1.0, \
        "where pt_compare splits the picture, in parts of its width; 0: all of it is the right side, 1: the left") \
    CHOICE(pt_trace, Session, Reference, "auto", "auto|bvh|query", \
        "rays by our BVH in compute or by ray queries; auto: queries on GPUs that have them") \
    CHOICE(pt_features, Session, Picture, "auto", feature_choices, \
        "what shaders are compiled for: auto: what the level and its entities have; with a name that too, with all everything: to measure what it costs") \
    INTEGER(pt_spp, Session, Picture, 1, 1, 4096, "paths per pixel and frame") \
    INTEGER(pt_accumulate, Session, Picture, 0, 0, 1, \
        "1: average all frames while nothing moves; for references") \
    INTEGER(pt_jitter, Session, Reference, 1, 0, 2, \
        "camera rays: 0 through pixel centres, 1 jittered while accumulating, 2 always jittered") \
    INTEGER(pt_subdivide, Session, Picture, 0, 0, 6, \
        "N above 0: the next level's surfaces are cut into 4^N times as many triangles, to measure what triangles cost") \
    GPU_INTEGER(pt_seed, Session, Picture, 0, 0, 2147483647, \
        "seed of all random numbers; same seed, same picture") \
    GPU_INTEGER(pt_bounces, Session, Reference, 1, 0, 1, \
        "number of indirect hits at which lights are sampled") \
    GPU_INTEGER(pt_light_points, Session, Reference, 8, 1, 64, \
        "points weighted on a chosen light, of which one gets the shadow ray; 1: as the paper") \
    GPU_CHOICE(pt_light_density, Session, Reference, "auto", "auto|area|solid_angle", \
        "how points are spread over a light; auto: by area, near lights by solid angle, and along the lobe of glossy surfaces") \
    GPU_INTEGER(pt_sll_max, Session, Reference, 32, 1, 1024, \
        "sll: most lights weighted per hit; longer lists are walked with a stride") \
    GPU_CHOICE(pt_sll_mass, Session, Reference, "ltc", "ltc|solid_angle", \
        "sll: a light's weight: what it adds to the surface unless it is hidden, or solid angle times luminance") \
    GPU_INTEGER(pt_sll_stats, Session, Reference, 0, 0, 1, \
        "sll: 1: weights also follow how many of the last frames' shadow rays reached the light, by cluster and direction") \
    GPU_INTEGER(pt_ris_candidates, Session, Reference, 32, 1, 1024, \
        "ris: lights of the level weighted per hit, of which one is kept") \
    INTEGER(pt_lh_width, Session, Reference, 8, 2, 8, \
        "lh: children of a node; up to 4 of them take 64 bytes, more take 128") \
    INTEGER(pt_lh_leaf, Session, Reference, 2, 1, 16, \
        "lh: most lights in a leaf, where each is weighted by itself") \
    INTEGER(pt_oct_split, Session, Reference, 4096, 1, 2147483647, \
        "octree: a leaf with more surface samples than this is split (at 1920 x 1080)") \
    INTEGER(pt_oct_collapse, Session, Reference, 2048, 0, 2147483647, \
        "octree: eight leaves with fewer samples together become one (at 1920 x 1080)") \
    REAL(pt_oct_scale, Session, Reference, 1.0, 0.001, 1000.0, \
        "octree: factor on both thresholds; they also follow the number of pixels") \
    GPU_INTEGER(pt_vlc_bucket, Session, Reference, 32, 1, 64, \
        "vlc: most lights weighted per hit; caches with more have several buckets") \
    GPU_REAL(pt_vlc_explore, Session, Reference, 0.03, 0.0, 1.0, \
        "vlc: share of light samples that look for lights not in the cache; 0: none do, and lights that no cache has are missing") \
    GPU_INTEGER(pt_vlc_beside, Session, Reference, 1, 0, 1, \
        "vlc: 1: light samples that look for lights are made beside those from the cache; 0: in their place, as the paper") \
    GPU_INTEGER(pt_vlc_adapt, Session, Reference, 1, 0, 1, \
        "vlc: 1: where looking for lights finds much that a cache lacks, a larger share of samples does; 0: the same everywhere, as the paper") \
    GPU_INTEGER(pt_vlc_stats, Session, Reference, 1, 0, 1, \
        "vlc: 1: weights also follow how many of the last frames' shadow rays reached the light, by octree leaf; 0: as the paper") \
    INTEGER(pt_vlc_weigh, Session, Reference, 1, 0, 1, \
        "vlc: 1: buckets are drawn by what draws from them brought; 0: evenly, as the paper") \
    REAL(pt_vlc_hysteresis, Session, Reference, 0.75, 0.0, 1.0, \
        "vlc: buckets must be emptier than this share before their number falls") \
    INTEGER(pt_vlc_merge, Session, Reference, 1, 0, 1, "vlc: 1: caches take over their neighbours' lights") \
    INTEGER(pt_vlc_persist, Session, Reference, 16, 0, 30, \
        "vlc: frames that a light stays in a cache after it was seen there; 0: the paper's caches") \
    GPU_REAL(pt_explore_local, Session, Reference, 0.8, 0.0, 1.0, \
        "vlc: part of the search that weighs lights of the surface's PVS cluster, as sll; 0: as the paper") \
    REAL(pt_explore_energy, Session, Reference, 1.0, 0.0, 1e6, \
        "vlc: weight of a light's power when looking for lights") \
    REAL(pt_explore_change, Session, Reference, 1.0, 0.0, 1e6, \
        "vlc: weight of a light's appearing, moving or brightening when looking for lights") \
    REAL(pt_explore_distance, Session, Reference, 1.0, 0.0, 1e6, \
        "vlc: weight of being near the camera when looking for lights") \
    CHOICE(pt_guide, Session, Reference, "cdq", guider_choices, \
        "how indirect rays are drawn: by the BRDF alone, or also by what learned which directions bring light") \
    CHOICE(pt_cdq_bits, Session, Reference, "128", "32|64|96|128", \
        "cdq: size of a quadtree; 25, 49, 73 or 97 leaves") \
    GPU_REAL(pt_cdq_brdf, Session, Reference, 0.5, 0.0, 1.0, \
        "guided rays: share that the BRDF draws all the same; 0: none") \
    REAL(pt_cdq_margin, Session, Reference, 0.25, 0.0, 1.0, \
        "cdq: a quadtree is refined where this share of a leaf's contribution exceeds what is given up") \
    INTEGER(pt_cdq_rays, Session, Reference, 512, 0, 1000000, \
        "guided rays: a leaf follows about so many, near and recent ones; 0: its own of one frame, as the paper") \
    INTEGER(pt_cdq_migrations, Session, Reference, 4, 0, 16, "cdq: refinements of a quadtree per frame, at most") \
    GPU_REAL(pt_sky_scale, Session, Reference, 1.0, 0.0, 1e6, "factor on the radiance of the sky") \
    GPU_REAL(pt_sun_scale, Session, Reference, 1.0, 0.0, 1e6, "factor on the irradiance of the sun") \
    REAL(pt_sun_size, Session, Reference, -1.0, -1.0, 180.0, \
        "angular diameter of the sun in degrees; 0: a point, which no ray meets; below 0: as the level says, or 1") \
    INTEGER(pt_env_nee, Session, Reference, 1, 0, 1, \
        "1: sky and sun are sampled as lights; 0: rays find them by chance, as in the paper") \
    INTEGER(pt_sky_lights, Session, Reference, 24, 2, 4096, \
        "most lights that a level's windows to the sky are cut into, if there are fewer windows than that") \
    GPU_REAL(pt_emissive_scale, Session, Reference, 1.0, 0.0, 1e6, \
        "factor on the radiance of emissive faces") \
    GPU_INTEGER(pt_emissive_texture, Session, Reference, 1, 0, 1, \
        "1: lamps that the camera sees show their texture; 0: their mean radiance") \
    GPU_CHOICE(pt_texture_filter, Session, Reference, "bilinear", "nearest|bilinear|full", \
        "how textures are magnified; full: bilinear, and never from a smaller mip level") \
    INTEGER(flt_enable, Archived, Picture, 1, 0, 1, \
        "1: light is averaged over time and over neighbouring pixels, unless pt_accumulate is 1; 0: the picture as it is traced") \
    GPU_INTEGER(flt_history, Session, Picture, 32, 1, 1000, \
        "filter: frames that light is averaged over, at most") \
    INTEGER(flt_atrous, Session, Picture, 3, 0, 6, \
        "filter: passes over neighbouring pixels, each over pixels twice as far apart; 0: over time alone") \
    GPU_REAL(flt_sigma, Session, Picture, 4.0, 0.0, 1000.0, \
        "filter: neighbours whose brightness differs by so many standard deviations count 1/e as much") \
    GPU_REAL(flt_firefly, Session, Picture, 8.0, 0.0, 1e6, \
        "filter: brightness of a sample, at most, in standard deviations above what was seen there before; 0: any") \
    INTEGER(flt_antilag, Session, Picture, 1, 0, 1, \
        "filter: 1: where lights change, what was averaged counts less") \
    INTEGER(flt_taa, Archived, Picture, 1, 0, 1, \
        "filter: 1: camera rays move within the pixel from frame to frame, so that edges are smooth") \
    GPU_REAL(pt_exposure, Session, Display, 0.0, 0.0, 1e6, \
        "factor from radiance to brightness; 0: automatic") \
    REAL(pt_exposure_speed, Archived, Display, 3.0, 0.0, 1000.0, \
        "how fast automatic exposure follows, per second, while frames are filtered; 0: at once") \
    GPU_REAL(pt_exposure_bias, Archived, Display, 0.0, -16.0, 16.0, \
        "stops added to the exposure, automatic or not") \
    GPU_CHOICE(pt_tonemap, Archived, Display, "filmic", "none|reinhard|filmic", \
        "curve from exposed radiance to the display") \
    GPU_CHOICE(pt_view, Session, Display, "none", view_choices, \
        "shows what the path tracer knows instead of the picture") \
    \
    STRING(vk_device, Start, Nothing, "", \
        "part of the name or the index of the Vulkan device; empty: the best one") \
    INTEGER(vk_validation, Start, Nothing, 0, 0, 3, \
        "validation layer: 0 off, 1 core, 2 core and synchronisation, 3 core and GPU-assisted") \
    INTEGER(vk_debug_names, Start, Nothing, 0, 0, 1, \
        "1: names and labels for graphics debuggers, also without the validation layer")

// What only those read who use it.
#define VIGIL_PROGRAM_TABLE(STRING, INTEGER, REAL, CHOICE) \
    STRING(basedir, Start, Nothing, "", \
        "folder that holds baseq2; empty: beside the program, in its sources, or installed") \
    STRING(game, Start, Nothing, "baseq2", \
        "folder below basedir whose files come before those of baseq2") \
    STRING(outdir, GuardedSession, Nothing, "out", "folder for pictures, reports and recorded demos") \
    \
    CHOICE(vid_driver, Start, Nothing, "auto", "auto|sdl|glfw|headless", \
        "what opens the window; auto: sdl, or headless without a display") \
    INTEGER(vid_fullscreen, GuardedArchived, Nothing, 0, 0, 1, "1: the window covers the screen") \
    \
    REAL(sensitivity, Archived, Nothing, 3.0, 0.01, 100.0, \
        "mouse speed: the view turns 0.022 degrees times this per count, as in Quake") \
    INTEGER(m_invert, Archived, Nothing, 0, 0, 1, "1: moving the mouse forward looks down") \
    REAL(joy_deadzone, Archived, Nothing, 0.15, 0.0, 0.9, \
        "game controller: part of a stick's way around its middle that does nothing") \
    REAL(joy_curve, Archived, Nothing, 2.0, 0.25, 8.0, \
        "game controller: response of the sticks: the power of the way beyond the dead zone; 1: linear") \
    REAL(joy_look, Archived, Nothing, 180.0, 1.0, 1440.0, \
        "game controller: degrees per second that the view turns with the stick all the way") \
    INTEGER(joy_invert, Archived, Nothing, 0, 0, 1, "1: pushing the stick forward looks down") \
    REAL(fov, Archived, Reference, 90.0, 1.0, 170.0, \
        "horizontal field of view in degrees for a 4:3 picture; wider pictures see more") \
    REAL(cl_maxfps, Archived, Nothing, 250.0, 1.0, 10000.0, \
        "most frames per second that the program tries to show; timedemo ignores it") \
    REAL(con_notify, Archived, Nothing, 3.0, 0.0, 60.0, \
        "seconds that a new line of the console stays over the picture") \
    CHOICE(scr_stats, Archived, Nothing, "off", "off|groups|passes", \
        "in the window's corner, never in screenshots: frame time, times of groups of passes or of every pass, technique and size") \
    INTEGER(testlights, Session, Reference, 0, 0, 1024, \
        "N above 0: N coloured lights wander through the level, around its start") \
    REAL(testlights_speed, Session, Reference, 1.0, 0.0, 100.0, \
        "how fast they are: 1 is 100 map units per second, 0 stands still") \
    INTEGER(timedemo, Session, Nothing, 0, 0, 1000, \
        "N above 0: demomap renders every frame of a demo once, as fast as it can, N times, and prints frame rate and GPU times") \
    STRING(timedemo_json, GuardedSession, Nothing, "", \
        "file below outdir that receives the numbers of a timedemo or a flight; empty: none") \
    \
    INTEGER(pt_light_styles, Session, Reference, 1, 0, 1, \
        "0: flickering and switched lights shine steadily")
// clang-format on

#define VIGIL_NO_STRING(name, life, affects, value, help)
#define VIGIL_NO_NUMBER(name, life, affects, value, low, high, help)
#define VIGIL_NO_CHOICE(name, life, affects, value, choices, help)
#define VIGIL_GPU_INTEGER(name, life, affects, value, low, high, help) int name;
#define VIGIL_GPU_REAL(name, life, affects, value, low, high, help) float name;
#define VIGIL_GPU_CHOICE(name, life, affects, value, choices, help) int name;

#ifdef __cplusplus
namespace vigil {
#endif

/// The settings that shaders read. Every field has 4 bytes, so scalar layout is the C++ layout.
struct GpuSettings {
    VIGIL_RENDERER_TABLE(VIGIL_NO_STRING, VIGIL_NO_NUMBER, VIGIL_NO_NUMBER, VIGIL_NO_CHOICE, VIGIL_GPU_INTEGER, VIGIL_GPU_REAL,
                         VIGIL_GPU_CHOICE)
};

#ifdef __cplusplus
} // namespace vigil
#endif

#undef VIGIL_NO_STRING
#undef VIGIL_NO_NUMBER
#undef VIGIL_NO_CHOICE
#undef VIGIL_GPU_INTEGER
#undef VIGIL_GPU_REAL
#undef VIGIL_GPU_CHOICE

#endif
