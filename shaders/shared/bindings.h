// SPDX-License-Identifier: GPL-2.0-or-later
// Descriptor sets, bindings and specialisation constants of the path tracer's passes, by name, for C++ and GLSL. Set 0 is the scene and
// the frame. Set 1 belongs to the light-sampling technique in use. Set 2 is what was learned from the frame before. Each buffer
// is declared once in GLSL, in the file named beside its binding.
#ifndef VIGIL_SHARED_BINDINGS_H
#define VIGIL_SHARED_BINDINGS_H

#define SET_SCENE 0
#define SET_TECHNIQUE 1
#define SET_GUIDING 2

#define BINDING_FRAME 0                   // uniform FrameParams: shared/frame_params.h, scene/frame.glsl
#define BINDING_BVH_NODES 1               // texel buffer, bottom-level nodes of all models: trace/trace_bvh.glsl
#define BINDING_BVH_TRIANGLES 2           // BvhTriangle[]: trace/trace_bvh.glsl, trace/trace_query.glsl
#define BINDING_TOP_NODES 3               // top-level nodes of this frame: trace/trace_bvh.glsl
#define BINDING_INSTANCES 4               // Instance[]: scene/scene.glsl
#define BINDING_PRIMITIVES 5              // Primitive[]: scene/scene.glsl
#define BINDING_MATERIALS 6               // Material[]: scene/scene.glsl
#define BINDING_TEXTURES 7                // Texture[]: scene/scene.glsl
#define BINDING_TEXELS 8                  // uint[], RGB9E5: scene/scene.glsl
#define BINDING_LIGHTS 9                  // Light[]: scene/scene.glsl
#define BINDING_BSP 10                    // BspTreeNode[]: scene/surface.glsl
#define BINDING_LTC 11                    // LTC tables: light/ltc.glsl
#define BINDING_SURFACES 12               // PrimaryHit[]: scene/frame.glsl
#define BINDING_RADIANCE 13               // this frame's radiance: scene/frame.glsl
#define BINDING_ACCUMULATION 14           // running mean: post/picture.glsl
#define BINDING_EXPOSURE 15               // automatic exposure: post/picture.glsl
#define BINDING_COUNTERS 16               // FrameCounters, read back by the host: scene/frame.glsl
#define BINDING_DISPLAY 17                // finished picture, RGBA8: post/picture.glsl
#define BINDING_DIRECTION_MAP 18          // radiance that arrives at the crosshair: debug/direction_map.glsl
#define BINDING_ACCELERATION_STRUCTURE 19 // only with ray query: trace/trace_query.glsl
#define SCENE_BINDING_COUNT 20

// Specialisation constants, the same in every shader that has them.
#define CONSTANT_INSTANCES 0   // models are placed: trace/trace.glsl
#define CONSTANT_TRANSLUCENT 1 // some faces are: trace/trace.glsl
#define CONSTANT_GROUP_SIZE 2  // invocations of a work group: guiding
#define CONSTANT_GUIDER_SIZE 3 // of what the guider keeps: scene/frame.glsl, guiding/guide_adapt.comp
#define CONSTANT_EFFECTS 4     // some model fades, glows, is a sprite or hidden from some rays: trace/trace.glsl
#define CONSTANT_SKY 8         // these six say what a level has: scene/frame.glsl
#define CONSTANT_SUN 9
#define CONSTANT_GLOSS 10
#define CONSTANT_LIQUID 11    // warping or flowing textures
#define CONSTANT_ANIMATION 12 // animated textures
#define CONSTANT_LIGHTS 13
#define CONSTANT_VIEW 14    // pt_view is on: post/tonemap.comp
#define CONSTANT_ANY_HIT 15 // of a benchmark: trace/trace_rays.comp

// Set 1 holds this many storage buffers; what they are is the technique's business (shaders/light/NAME.glsl).
#define TECHNIQUE_BINDING_COUNT 6

// Set 2, declared in guiding/octree.glsl. Vulkan 1.2 lets a device stop at few storage buffers per stage, and Mesa 22.3's
// software driver at 32 for all sets together.
#define BINDING_GUIDING_HEADER 0  // GuidingHeader: shared/guiding_types.h
#define BINDING_GUIDING_NODES 1   // number of inner nodes, and the nodes: shared/octree.h
#define BINDING_GUIDING_LEAVES 2  // arrays by leaf: shared/guiding_types.h
#define BINDING_GUIDING_SAMPLES 3 // light samples
#define BINDING_GUIDING_VLC 4     // light ids of the caches
#define BINDING_GUIDING_RAYS 5    // ray samples
#define GUIDING_BINDING_COUNT 6

#endif
