// SPDX-License-Identifier: GPL-2.0-or-later
// Descriptor sets, bindings and specialisation constants of all passes, by name, for C++ and GLSL. In the path tracer's passes set 0 is
// the scene and the frame, set 1 belongs to the light-sampling technique in use, and set 2 is what was learned from the frame before.
// Other passes have one set of their own. Each buffer is declared once in GLSL, in the file named beside its binding. R: bound as
// records, W: as words (trace/records.glsl); the others are storage buffers.
#ifndef VIGIL_SHARED_BINDINGS_H
#define VIGIL_SHARED_BINDINGS_H

#define SET_SCENE 0
#define SET_TECHNIQUE 1
#define SET_GUIDING 2

#define BINDING_FRAME 0                   // uniform FrameParams: shared/frame_params.h, scene/frame.glsl
#define BINDING_BVH_NODES 1               // bottom-level nodes of all models: trace/trace_bvh.glsl
#define BINDING_BVH_TRIANGLES 2           // R, BvhTriangle[]: trace/trace_bvh.glsl, trace/trace_query.glsl
#define BINDING_TOP_NODES 3               // R, top-level nodes of this frame: trace/trace_bvh.glsl
#define BINDING_INSTANCES 4               // R, Instance[]: scene/scene.glsl
#define BINDING_PRIMITIVES 5              // R, Primitive[]: scene/scene.glsl
#define BINDING_MATERIALS 6               // R, Material[]: scene/scene.glsl
#define BINDING_TEXTURES 7                // R, Texture[]: scene/scene.glsl
#define BINDING_TEXELS 8                  // W, uint[], RGB9E5: scene/scene.glsl
#define BINDING_LIGHTS 9                  // R, Light[]: scene/scene.glsl
#define BINDING_BSP 10                    // R, BspTreeNode[]: scene/surface.glsl
#define BINDING_LTC 11                    // R, LtcEntry[]: light/ltc.glsl
#define BINDING_SURFACES 12               // PrimaryHit[]: scene/frame.glsl
#define BINDING_RADIANCE 13               // this frame's radiance: scene/frame.glsl
#define BINDING_ACCUMULATION 14           // running mean: post/picture.glsl
#define BINDING_EXPOSURE 15               // automatic exposure: post/picture.glsl
#define BINDING_COUNTERS 16               // FrameCounters, read back by the host: scene/frame.glsl
#define BINDING_DISPLAY 17                // finished picture, RGBA8: post/picture.glsl
#define BINDING_DIRECTION_MAP 18          // radiance that arrives at the crosshair: debug/direction_map.glsl
#define BINDING_FILTER_INPUT 19           // FilterInput[]: scene/frame.glsl
#define BINDING_PIXEL_FLAGS 20            // PIXEL_*: scene/frame.glsl
#define BINDING_SURFACE_RECORDS 21        // R, BINDING_SURFACES again: scene/frame.glsl
#define BINDING_FILTER_INPUT_RECORDS 22   // R, BINDING_FILTER_INPUT again: filter/filter.glsl
#define BINDING_ACCELERATION_STRUCTURE 23 // only with ray query: trace/trace_query.glsl
#define SCENE_BINDING_COUNT 24

// Specialisation constants, the same in every shader that has them.
#define CONSTANT_INSTANCES 0   // models are placed: trace/trace.glsl
#define CONSTANT_TRANSLUCENT 1 // some faces are: trace/trace.glsl
#define CONSTANT_GROUP_SIZE 2  // invocations of a work group: guiding
#define CONSTANT_GUIDER_SIZE 3 // of what the guider keeps: scene/frame.glsl, guiding/guide_adapt.comp
#define CONSTANT_EFFECTS 4     // some model fades, glows, is a sprite or hidden from some rays: trace/trace.glsl
#define CONSTANT_SKY 5         // what a level has, as GLOSS and LIGHTS: scene/frame.glsl
#define CONSTANT_GLOSS 6
#define CONSTANT_CACHES 7 // light/vlc.glsl
#define CONSTANT_LIGHTS 8
#define CONSTANT_VIEW 9         // pt_view is on: post/tonemap.comp
#define CONSTANT_ANY_HIT 10     // of a benchmark: trace/trace_rays.comp
#define CONSTANT_ENVIRONMENT 11 // sky and sun are sampled as lights: scene/frame.glsl

// Which of these buffers a technique has is its business (shaders/light/NAME.glsl).
#define BINDING_SHADOW_STATISTICS 0 // light/shadow_statistics.glsl; the pass of that name has it as well, alone in set 0
#define BINDING_STATIC_RANGES 1     // W, as are the next three; with the counts these are the light lists: light/light_list.glsl
#define BINDING_STATIC_IDS 2
#define BINDING_MOVING_RANGES 3
#define BINDING_MOVING_IDS 4
#define BINDING_LIST_COUNTS 5
#define BINDING_ALIAS_TABLE 6 // W, number of entries, AliasEntry[]: light/alias.glsl
#define BINDING_LEAF_LIGHTS 1 // W, as are the next two; these four are the Light Hierarchy: light/lh.glsl
#define BINDING_LIGHT_PARENTS 2
#define BINDING_LIGHT_PLACES 6
#define BINDING_LIGHT_NODES 7 // R
#define BINDING_LIGHT_CUTS 8  // R, with the next three, W, and records of groups at BINDING_LIGHT_NODES: light/cut_lists.glsl
#define BINDING_CUT_ENTRIES 1
#define BINDING_CUT_ORDER 2
#define BINDING_CUT_PLACES 3
#define TECHNIQUE_BINDING_COUNT 9

// Set 2, declared in guiding/octree.glsl. Vulkan 1.2 lets a device stop at few storage buffers per stage, and Mesa 22.3's
// software driver at 32 for all sets together.
#define BINDING_GUIDING_HEADER 0     // GuidingHeader: shared/guiding_types.h
#define BINDING_GUIDING_NODES 1      // W, number of inner nodes, and the nodes: shared/octree.h
#define BINDING_GUIDING_LEAVES 2     // arrays by leaf: shared/guiding_types.h
#define BINDING_GUIDING_SAMPLES 3    // light samples
#define BINDING_GUIDING_VLC 4        // W, light ids of the caches
#define BINDING_GUIDING_RAYS 5       // ray samples
#define BINDING_GUIDING_LEAF_WORDS 6 // W, the leaves again
#define GUIDING_BINDING_COUNT 7

// The set of the guiding passes, declared in guiding/passes.glsl: this frame's octree ("new") and that of the frame before ("old").
#define BINDING_PASS_HEADER 0     // GuidingHeader: shared/guiding_types.h
#define BINDING_PASS_OLD_NODES 1  // number of inner nodes, and the nodes: shared/octree.h
#define BINDING_PASS_OLD_CELLS 2  // cells of inner nodes
#define BINDING_PASS_OLD_LEAVES 3 // arrays by leaf: shared/guiding_types.h
#define BINDING_PASS_NEW_NODES 4
#define BINDING_PASS_NEW_CELLS 5
#define BINDING_PASS_NEW_LEAVES 6
#define BINDING_PASS_PLAN 7       // what becomes of nodes
#define BINDING_PASS_SAMPLES 8    // light samples
#define BINDING_PASS_NEW_CACHES 9 // light ids of the caches
#define BINDING_PASS_LISTS 10     // leaves to work on
#define BINDING_PASS_WORK 11      // GuidingWork: shared/guiding_types.h
#define BINDING_PASS_OLD_CACHES 12
#define BINDING_PASS_RAYS 13 // ray samples
#define GUIDING_PASS_BINDING_COUNT 14

// Beside set 0 in the passes of the filter, declared in filter/filter.glsl.
#define SET_FILTER 1
#define BINDING_FILTER_SURFACES 0 // FilterSurface[], two frames: shared/filter_types.h
#define BINDING_FILTER_HISTORY 1  // FilterHistory[], two frames
#define BINDING_FILTER_LIGHT 2    // between two passes over neighbours, twice
#define BINDING_FILTER_RESOLVED 3 // the picture, two frames
#define BINDING_FILTER_TILES 4
#define BINDING_FILTER_LIGHT_CHANGES 5
#define BINDING_FILTER_STATISTICS 6 // FilterStatistics[], two frames
// R, some of them again.
#define BINDING_FILTER_SURFACE_RECORDS 7
#define BINDING_FILTER_HISTORY_RECORDS 8
#define BINDING_FILTER_LIGHT_RECORDS 9
#define BINDING_FILTER_TILE_RECORDS 10
#define BINDING_FILTER_STATISTICS_RECORDS 11
#define BINDING_FILTER_RESOLVED_RECORDS 12
#define FILTER_BINDING_COUNT 13

// The set of pass `draws`: post/draws.comp.
#define BINDING_DRAWS_DISPLAY 0 // the finished picture
#define BINDING_DRAWS_RECTS 1   // DrawRect[]: shared/draw.h
#define BINDING_DRAWS_TEXELS 2  // of all pictures, RGBA8
#define DRAWS_BINDING_COUNT 3

// The set of pass `upscale`: post/upscale.comp.
#define BINDING_UPSCALE_TRACED 0  // the picture as it was traced
#define BINDING_UPSCALE_DISPLAY 1 // the finished picture
#define UPSCALE_BINDING_COUNT 2

#endif
