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
    INTEGER(vid_width, GuardedArchived, Reference, 640, 16, 16384, "Width of the picture in pixels.") \
    INTEGER(vid_height, GuardedArchived, Reference, 360, 16, 16384, "Height of the picture in pixels.") \
    INTEGER(vid_scale, GuardedArchived, Reference, 100, 25, 100, \
        "Percent of the picture's width and height that are traced. The picture is scaled up from them.") \
    REAL(vid_fps_target, GuardedArchived, Reference, 0.0, 0.0, 1000.0, \
        "Frames a second to reach. vid_scale falls by itself for it, down to 25. 0: vid_scale stays.") \
    INTEGER(vid_vsync, GuardedArchived, Nothing, 1, 0, 1, \
        "1: A frame is shown only when the display starts a new one.") \
    \
    CHOICE(pt_nee, Archived, Picture, "vlc", technique_choices, \
        "Light sampling: how a surface chooses the lights that it asks for light (next event estimation).") \
    CHOICE(pt_compare, Session, Reference, "none", compare_choices, \
        "Splits the picture. pt_nee and pt_guide draw the left side, this technique the right one. +cdq and +lobe add guided rays. raw: the right side is unfiltered.") \
    REAL(pt_compare_at, Session, Display, 0.5, 0.0, 1.0, \
        "Place of pt_compare's line, in parts of the width. 0: the right side fills the picture. 1: the left one does.") \
    CHOICE(pt_trace, Session, Reference, "auto", "auto|bvh|query", \
        "Where rays are traced. bvh: by our own tree in compute shaders. query: by ray queries. auto: by ray queries on GPUs that have them.") \
    CHOICE(pt_features, Session, Picture, "auto", feature_choices, \
        "What shaders are compiled for. auto: what the level has. A name adds that feature, all adds every one. It measures what a feature costs.") \
    INTEGER(pt_spp, Archived, Picture, 1, 1, 4096, "Paths per pixel and frame.") \
    INTEGER(pt_accumulate, Session, Picture, 0, 0, 1, \
        "1: All frames are averaged while nothing moves. Reference pictures are made so.") \
    INTEGER(pt_jitter, Session, Reference, 1, 0, 2, \
        "Where camera rays cross a pixel. 0: at its centre. 1: anywhere, while frames are averaged. 2: anywhere.") \
    INTEGER(pt_subdivide, Session, Picture, 0, 0, 6, \
        "N above 0: The surfaces of the next level are cut into 4^N times as many triangles. It measures what triangles cost.") \
    GPU_INTEGER(pt_seed, Session, Picture, 0, 0, 2147483647, \
        "Seed of all random numbers.") \
    GPU_INTEGER(pt_bounces, Archived, Reference, 1, 0, 8, \
        "Number of indirect hits at which lights are sampled.") \
    GPU_INTEGER(pt_tail, Archived, Reference, 0, 0, 1, \
        "Guided rays: 1: Paths end with the light of all further bounces, a mean of what rays have found near there. The picture has a small bias. 0: They end without it.") \
    GPU_INTEGER(pt_light_points, Archived, Reference, 8, 1, 64, \
        "Points weighted on a chosen light. One of them gets the shadow ray. 1: as in the paper.") \
    GPU_CHOICE(pt_light_density, Archived, Reference, "auto", "auto|area|solid_angle", \
        "How points are spread over a light. area: evenly. solid_angle: as the surface sees it. auto: evenly, but near lights by solid angle, and along the lobe of glossy surfaces.") \
    GPU_INTEGER(pt_sll_max, Session, Reference, 32, 1, 1024, \
        "sll: Most lights weighted per hit. Longer lists are walked with a stride.") \
    GPU_CHOICE(pt_sll_mass, Session, Reference, "ltc", "ltc|solid_angle", \
        "sll: Weight of a light. ltc: what it adds to the surface unless it is hidden. solid_angle: solid angle times luminance.") \
    GPU_INTEGER(pt_sll_stats, Session, Reference, 0, 0, 1, \
        "sll: 1: Weights also follow how many recent shadow rays reached the light, by cluster and direction.") \
    GPU_INTEGER(pt_ris_candidates, Session, Reference, 32, 1, 1024, \
        "ris: Lights of the level weighted per hit. One of them is kept.") \
    INTEGER(pt_lh_width, Session, Reference, 8, 2, 8, \
        "lh: Children of a node. Up to 4 of them take 64 bytes, more take 128.") \
    INTEGER(pt_lh_leaf, Session, Reference, 2, 1, 16, \
        "lh: Most lights in a leaf. Each of them is weighted by itself.") \
    INTEGER(pt_cut_size, Session, Reference, 16, 1, 256, \
        "cut: Most entries of a PVS cluster's light cut, also those of vlc. A draw weights all of them.") \
    INTEGER(pt_oct_split, Session, Reference, 4096, 1, 2147483647, \
        "Octree: A leaf with more surface samples than this is split. The number is for 1920 x 1080.") \
    INTEGER(pt_oct_collapse, Session, Reference, 2048, 0, 2147483647, \
        "Octree: Eight leaves with fewer samples together become one. The number is for 1920 x 1080.") \
    REAL(pt_oct_scale, Session, Reference, 1.0, 0.001, 1000.0, \
        "Octree: Factor on both thresholds. They also follow the number of pixels.") \
    INTEGER(pt_oct_start, Archived, Reference, 1, 0, 1, \
        "Octree: 1: It begins as fine as paths traced from the camera let expect. 0: It begins with one node, as in the paper.") \
    INTEGER(pt_rest_after, Archived, Reference, 128, 0, 1000000, \
        "Guiding: Frames without any change after which it learns from one frame of 31 only. 0: from each, as in the paper.") \
    INTEGER(pt_learn_every, Archived, Reference, 4, 1, 16, \
        "Guiding: Of up to so many frames one is learned from, where caches have few lights and little is new to see. 1: each, as in the paper.") \
    GPU_INTEGER(pt_vlc_bucket, Archived, Reference, 32, 1, 64, \
        "vlc: Most lights weighted per draw from a cache. Caches with more lights have several buckets.") \
    GPU_REAL(pt_vlc_explore, Archived, Reference, 0.1, 0.0, 1.0, \
        "vlc: Share of light samples that look for lights outside the cache. 0: None do, and lights that no cache has are missing.") \
    GPU_INTEGER(pt_vlc_beside, Archived, Reference, 1, 0, 1, \
        "vlc: 1: Samples that look for lights are added to those from the cache. 0: They take their place, as in the paper.") \
    GPU_INTEGER(pt_vlc_adapt, Archived, Reference, 1, 0, 1, \
        "vlc: 1: More samples look for lights where they find much that the cache lacks. 0: The share is the same everywhere, as in the paper.") \
    INTEGER(pt_vlc_weigh, Archived, Reference, 1, 0, 1, \
        "vlc: 1: Buckets are drawn by what draws from them brought. 0: evenly, as in the paper.") \
    REAL(pt_vlc_enough, Archived, Reference, 0.68, 0.0, 1.0, \
        "vlc: Levels whose places see so much of the light in their clusters' lists need no caches. 0: all do, as in the paper.") \
    REAL(pt_vlc_hysteresis, Session, Reference, 0.75, 0.0, 1.0, \
        "vlc: Buckets must be emptier than this share before their number falls.") \
    INTEGER(pt_vlc_merge, Session, Reference, 1, 0, 1, \
        "vlc: 1: Caches take over the lights of their neighbours.") \
    INTEGER(pt_vlc_persist, Archived, Reference, 16, 0, 30, \
        "vlc: Frames that a light stays in a cache after it was seen there. 0: none, as in the paper.") \
    GPU_REAL(pt_explore_local, Archived, Reference, 0.8, 0.0, 1.0, \
        "vlc: Part of the search that draws from the light cut of the surface's PVS cluster. 0: none, as in the paper.") \
    REAL(pt_explore_energy, Session, Reference, 1.0, 0.0, 1e6, \
        "vlc: Weight of a light's power in the search for lights.") \
    REAL(pt_explore_change, Session, Reference, 1.0, 0.0, 1e6, \
        "vlc: Weight of a light that appears, moves or brightens in the search for lights.") \
    REAL(pt_explore_distance, Session, Reference, 1.0, 0.0, 1e6, \
        "vlc: Weight of a light near the camera in the search for lights.") \
    CHOICE(pt_guide, Archived, Reference, "cdq", guider_choices, \
        "Path guiding: how indirect rays are drawn. brdf: by the surface alone. The others also learn which directions bring light.") \
    CHOICE(pt_cdq_bits, Session, Reference, "128", "32|64|96|128", \
        "cdq: Size of a quadtree in bits. The sizes have 25, 49, 73 and 97 leaves.") \
    GPU_REAL(pt_cdq_brdf, Session, Reference, 0.5, 0.0, 1.0, \
        "Guided rays: Share that the surface's BRDF draws all the same. 0: none.") \
    GPU_INTEGER(pt_guide_directions, Archived, Reference, 2, 1, 16, \
        "Guided rays: Directions weighed by the BRDF and what is known. One of them gets the ray. 1: as in the paper.") \
    REAL(pt_guide_gain, Archived, Reference, 0.06, 0.0, 1.0, \
        "Guided rays: Part of the spread of indirect light that they must take away. Else one frame of eight has them, or of two while guiders begin. 0: All have.") \
    INTEGER(pt_cdq_adapt, Archived, Reference, 1, 0, 1, \
        "Guided rays: 1: Each node of the octree learns that share from what its rays brought, and begins with pt_cdq_brdf. 0: It is pt_cdq_brdf everywhere.") \
    REAL(pt_cdq_margin, Archived, Reference, 0.25, 0.0, 1.0, \
        "cdq: A quadtree is refined where this share of a leaf's contribution exceeds what is given up.") \
    INTEGER(pt_cdq_rays, Archived, Reference, 512, 0, 1000000, \
        "Guided rays: Number of near and recent rays that a leaf follows. 0: those of one frame, as in the paper.") \
    INTEGER(pt_cdq_migrations, Archived, Reference, 4, 0, 16, \
        "cdq: Most refinements of a quadtree per frame.") \
    GPU_REAL(pt_sky_scale, Session, Reference, 1.0, 0.0, 1e6, "Factor on the radiance of the sky.") \
    GPU_REAL(pt_sun_scale, Session, Reference, 1.0, 0.0, 1e6, "Factor on the irradiance of the sun.") \
    REAL(pt_sun_size, Session, Reference, -1.0, -1.0, 180.0, \
        "Angular diameter of the sun in degrees. 0: a point, which no ray meets. Below 0: what the level says, or 1.") \
    INTEGER(pt_env_nee, Archived, Reference, 1, 0, 1, \
        "1: Sky and sun are sampled as lights. 0: Rays find them by chance, as in the paper.") \
    INTEGER(pt_sky_lights, Session, Reference, 24, 2, 4096, \
        "Most lights that the level's windows to the sky are cut into. A level with more windows has two lights for each.") \
    GPU_REAL(pt_emissive_scale, Session, Reference, 1.0, 0.0, 1e6, "Factor on the radiance of glowing faces.") \
    GPU_INTEGER(pt_emissive_texture, Session, Reference, 1, 0, 1, \
        "1: Lamps in view show their texture. 0: They show their mean radiance.") \
    GPU_CHOICE(pt_texture_filter, Session, Reference, "bilinear", "nearest|bilinear|full", \
        "How textures are magnified. full: bilinear, and never from a smaller mip level.") \
    CHOICE(pt_indirect_rate, Archived, Picture, "full", "full|half", \
        "Pixels that trace indirect light in a filtered frame. half: every second one, in turns. Raw frames trace all.") \
    INTEGER(flt_enable, Archived, Picture, 1, 0, 1, \
        "Denoiser. 1: Light is averaged over time and over neighbouring pixels, except while pt_accumulate is 1. 0: The picture stays as it is traced.") \
    INTEGER(flt_first, Archived, Nothing, 12, 0, 100, \
        "Denoiser: Frames that are traced unseen before the first picture of a level, so that it is calm. Timed demos have none.") \
    GPU_INTEGER(flt_history, Session, Picture, 32, 1, 1000, \
        "Denoiser: Most frames that light is averaged over.") \
    GPU_INTEGER(flt_history_moving, Session, Picture, 6, 1, 1000, \
        "Denoiser: The same for direct light of pixels that move in the picture.") \
    INTEGER(flt_atrous, Session, Picture, 5, 0, 6, \
        "Denoiser: Passes over neighbouring pixels. Each looks twice as far as the one before, the last at those beside. 0: Light is averaged over time alone.") \
    GPU_REAL(flt_noise, Session, Picture, 0.1, 0.0, 1e6, \
        "Denoiser: Noise, in parts of a pixel's brightness, below which passes that look 8 pixels away or farther leave it alone.") \
    GPU_REAL(flt_sigma, Session, Picture, 4.0, 0.0, 1000.0, \
        "Denoiser: A neighbour whose brightness differs by this many standard deviations counts 1/e as much. From 4 pixels away on, each pass halves the number.") \
    GPU_REAL(flt_firefly, Session, Picture, 8.0, 0.0, 1e6, \
        "Denoiser: Highest brightness of a sample, in standard deviations above what was seen there before. 0: any.") \
    INTEGER(flt_antilag, Session, Picture, 1, 0, 1, \
        "Denoiser: 1: Older light counts less where lights change.") \
    INTEGER(flt_taa, Archived, Picture, 1, 0, 1, \
        "Smooth edges. 1: Camera rays move within the pixel from frame to frame.") \
    GPU_REAL(pt_exposure, Session, Display, 0.0, 0.0, 1e6, \
        "Factor from radiance to brightness. 0: automatic.") \
    REAL(pt_exposure_speed, Archived, Display, 3.0, 0.0, 1000.0, \
        "How fast automatic exposure follows, per second, while the denoiser is on. 0: at once.") \
    GPU_REAL(pt_exposure_bias, Archived, Display, 0.0, -16.0, 16.0, \
        "Brightness: stops added to the exposure. 1 is twice as bright.") \
    GPU_CHOICE(pt_tonemap, Archived, Display, "filmic", "none|reinhard|filmic", \
        "Curve from exposed radiance to the display.") \
    GPU_CHOICE(pt_view, Session, Display, "none", view_choices, \
        "Shows what the path tracer knows instead of the picture.") \
    \
    STRING(vk_device, Start, Nothing, "", \
        "Part of the name or the index of the Vulkan device. Empty: the best one.") \
    INTEGER(vk_validation, Start, Nothing, 0, 0, 3, \
        "Vulkan's validation layer. 0: off. 1: core. 2: core and synchronisation. 3: core and GPU-assisted.") \
    INTEGER(vk_debug_names, Start, Nothing, 0, 0, 1, \
        "1: Graphics debuggers get names and labels, also without the validation layer.") \
    INTEGER(vk_cache, Start, Nothing, 1, 0, 1, \
        "0: The driver compiles every shader anew. No compiled shader is taken from earlier starts or kept for later ones.")

// What only those read who use it.
#define VIGIL_PROGRAM_TABLE(STRING, INTEGER, REAL, CHOICE) \
    STRING(basedir, Start, Nothing, "", \
        "Folder that holds baseq2. Empty: beside the program, in its sources, or installed.") \
    STRING(game, Start, Nothing, "baseq2", "Folder below basedir. Its files come before those of baseq2.") \
    STRING(outdir, GuardedSession, Nothing, "out", "Folder for pictures, reports and recorded demos.") \
    \
    CHOICE(vid_driver, Start, Nothing, "auto", "auto|sdl|glfw|headless", \
        "What opens the window. auto: sdl, or headless where there is no display.") \
    INTEGER(vid_fullscreen, GuardedArchived, Nothing, 0, 0, 1, "1: The window covers the screen.") \
    \
    REAL(sensitivity, Archived, Nothing, 3.0, 0.01, 100.0, \
        "Mouse speed. The view turns 0.022 degrees times this per count, as in Quake.") \
    INTEGER(m_invert, Archived, Nothing, 0, 0, 1, "1: The view goes down when the mouse moves forward.") \
    REAL(joy_deadzone, Archived, Nothing, 0.15, 0.0, 0.9, \
        "Game controller: Part of a stick's way around its middle that does nothing.") \
    REAL(joy_curve, Archived, Nothing, 2.0, 0.25, 8.0, \
        "Game controller: Response of the sticks, as the power of the way beyond the dead zone. 1: linear.") \
    REAL(joy_look, Archived, Nothing, 180.0, 1.0, 1440.0, \
        "Game controller: Degrees per second that the view turns with the stick all the way.") \
    INTEGER(joy_invert, Archived, Nothing, 0, 0, 1, \
        "Game controller: 1: The view goes down when the stick is pushed forward.") \
    REAL(fov, Archived, Reference, 90.0, 1.0, 170.0, \
        "Horizontal field of view in degrees for a 4:3 picture. Wider pictures see more.") \
    REAL(cl_maxfps, Archived, Nothing, 250.0, 1.0, 10000.0, \
        "Most frames per second that the program tries to show. timedemo ignores it.") \
    REAL(con_notify, Archived, Nothing, 3.0, 0.0, 60.0, \
        "Seconds that a new line of the console stays over the picture.") \
    CHOICE(scr_stats, Archived, Nothing, "off", "off|groups|passes", \
        "Statistics in the window's corner, never in screenshots. groups: frame rate and sums of times. passes: the time of every pass.") \
    INTEGER(testlights, Session, Reference, 0, 0, 1024, \
        "N above 0: N coloured lights wander through the level, around its start.") \
    REAL(testlights_speed, Session, Reference, 1.0, 0.0, 100.0, \
        "Speed of testlights. 1 is 100 map units per second. 0: They stand still.") \
    INTEGER(timedemo, Session, Nothing, 0, 0, 1000, \
        "N above 0: demomap renders every frame of a demo once, as fast as it can, N times. It prints frame rate and GPU times.") \
    STRING(timedemo_json, GuardedSession, Nothing, "", \
        "File below outdir that receives the numbers of a timedemo or a flight. Empty: none.") \
    \
    CHOICE(pt_preset, Archived, Nothing, "balanced", "paper|fast|balanced|accurate|custom", \
        "Quality: light sampling, path guiding and their cost, all at once. It reads custom where the settings are none of the presets. `presets` lists them.") \
    INTEGER(pt_light_styles, Session, Reference, 1, 0, 1, "0: Flickering and switched lights shine steadily.")
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
