// SPDX-License-Identifier: GPL-2.0-or-later
// What the guiding passes and the path tracer share: the header, the arrays of leaves, light
// samples, and the settings and statistics of a frame. Scalar layout; the same text is C++ and
// GLSL.
#ifndef VIGIL_SHARED_GUIDING_TYPES_H
#define VIGIL_SHARED_GUIDING_TYPES_H

#include "cdq.h"
#include "glsl.h"
#include "scene_types.h"

SHADER_BEGIN

/// Written by the host when the octree starts anew, caches get more room, learning begins or ends,
/// or lights appear.
struct GuidingHeader {
    vec3 corner;          // lowest corner of the root's cube, map units
    float scale;          // smallest cells per map unit
    uint node_capacity;   // inner nodes that a tree may have
    uint sample_capacity; // light samples that fit
    uint ray_capacity;    // ray samples that fit
    uint vlc_capacity;    // words of all caches that there is room for
    uint vlc_most;        // to which that may grow
    uint stores;          // 1: samples of this frame are stored; 0: nothing is learned from it
    uint explores;        // 1: every surface looks beside its cache: a light has appeared
    uint guides;          // 1: guiders draw rays; 0: the BRDF alone, and nothing is learned of rays
};

/// Arrays by leaf, one after another in one buffer of words (structure of arrays).
struct LeafArray {
    uint first; // the array begins at word first * number of leaves
    uint words; // of a leaf
#ifdef __cplusplus
    constexpr LeafArray(uint from, uint width) : first(from), words(width) {}
#endif
};

// The arrays: ROW(name, words, array before it, first value of each word, what a new leaf has).
//   LEAF_MADE     what octree_augment.comp makes for it
//   LEAF_ZEROED   0
//   LEAF_CARRIED  what its source has, the leaf of the tree before that it comes from
// clang-format off
#define LEAF_ARRAY_TABLE(ROW) \
    ROW(LEAF_COUNT, 1u, LEAF_BEGIN, 0u, LEAF_ZEROED) /* surface samples that fell into the leaf */ \
    ROW(LEAF_STORAGE, 2u, LEAF_COUNT, 0u, LEAF_MADE) /* first light sample, room for how many */ \
    ROW(LEAF_VLC, 2u, LEAF_STORAGE, 0u, LEAF_CARRIED) /* first light id of the cache, number of buckets */ \
    ROW(LEAF_VISIBLE, 1u, LEAF_VLC, 0u, LEAF_ZEROED) /* different lights among the leaf's visible samples */ \
    ROW(LEAF_NEIGHBOURS, 6u, LEAF_VISIBLE, NONE, LEAF_MADE) /* leaf beyond the faces -x +x -y +y -z +z, or NONE */ \
    ROW(LEAF_SOURCE, 1u, LEAF_NEIGHBOURS, 0u, LEAF_MADE) /* its source; SOURCE_SPLIT: it is a part of that */ \
    ROW(LEAF_CACHED, 1u, LEAF_SOURCE, 0u, LEAF_CARRIED) /* lights in the cache */ \
    ROW(LEAF_EXPLORE, 2u, LEAF_CACHED, 0u, LEAF_CARRIED) /* ExploreMemory */
// clang-format on
SHADER_CONST LeafArray LEAF_BEGIN = LeafArray(0u, 0u);
#define LEAF_CONSTANT(name, width, before, value, new_leaf) SHADER_CONST LeafArray name = LeafArray(before.first + before.words, width);
LEAF_ARRAY_TABLE(LEAF_CONSTANT)
#undef LEAF_CONSTANT
/// Words of a leaf altogether.
SHADER_CONST uint LEAF_WORDS = LEAF_EXPLORE.first + LEAF_EXPLORE.words;

/// Arrays by inner node, after those by leaf: what a guider keeps for the leaves of a node together. One of them alone has
/// too few rays. A new node has what its source has, the old node that it was, or that held the leaf; but no rays yet.
struct NodeArray {
    uint first; // the array begins at word first * number of nodes after the leaves
    uint words; // of a node
#ifdef __cplusplus
    constexpr NodeArray(uint from, uint width) : first(from), words(width) {}
#endif
};
SHADER_CONST NodeArray NODE_GUIDE = NodeArray(0u, 4u);       // what rays are drawn by: the guider's business
SHADER_CONST NodeArray NODE_SHARE = NodeArray(4u, 2u);       // ShareMemory
SHADER_CONST NodeArray NODE_RAYS = NodeArray(6u, 2u);        // rays of its leaves: those that brought something, and the others
SHADER_CONST NodeArray NODE_RAY_STORAGE = NodeArray(8u, 2u); // first ray sample, room for how many
SHADER_CONST NodeArray NODE_TAIL = NodeArray(10u, 2u);       // TailMemory
/// Words of a node, but for what the guider remembers beyond them.
SHADER_CONST uint NODE_WORDS = 12u;
SHADER_FN NodeArray guide_memory(uint words) { return NodeArray(NODE_WORDS, words); }

/// With the number of an old leaf, where a new node or leaf comes from: the old leaf was split.
SHADER_CONST uint SOURCE_SPLIT = 0x80000000u;

/// Two sums in a word: the upper halves of their floats, rounded (bfloat16). Not negative, below
/// 3e38.
SHADER_FN uint pack_sums(float low, float high) {
    return ((floatBitsToUint(low) + 0x8000u) >> 16u) | ((floatBitsToUint(high) + 0x8000u) & 0xffff0000u);
}

SHADER_FN float unpack_sum(uint word, uint half_index) { return uintBitsToFloat(half_index == 0u ? word << 16u : word & 0xffff0000u); }

/// Four sums in two words.
SHADER_FN uvec2 pack_four_sums(vec4 four) { return uvec2(pack_sums(four.x, four.y), pack_sums(four.z, four.w)); }

SHADER_FN vec4 unpack_four_sums(uvec2 words) {
    return vec4(unpack_sum(words.x, 0u), unpack_sum(words.x, 1u), unpack_sum(words.y, 0u), unpack_sum(words.y, 1u));
}

/// Index of a leaf's first word in an array.
SHADER_FN uint leaf_array_word(LeafArray array, uint leaf, uint node_capacity) {
    return array.first * (8u * node_capacity) + array.words * leaf;
}

/// Index of a node's first word in an array.
SHADER_FN uint node_array_word(NodeArray array, uint node, uint node_capacity) {
    return (8u * LEAF_WORDS + array.first) * node_capacity + array.words * node;
}

/// A light sample: light id, how it was drawn, what a draw of a walk estimates (a power of two), and one bit if the
/// surface saw the light.
SHADER_CONST uint LIGHT_SAMPLE_VISIBLE = 0x80000000u;
SHADER_CONST uint LIGHT_SAMPLE_DRAWN = 0x60000000u;  // one of the next three
SHADER_CONST uint LIGHT_SAMPLE_CACHED = 0u;          // from the cache
SHADER_CONST uint LIGHT_SAMPLE_TABLED = 0x20000000u; // from the table of all lights
SHADER_CONST uint LIGHT_SAMPLE_LISTED = 0x40000000u; // from the cut of the cluster's list
SHADER_CONST uint LIGHT_SAMPLE_ESTIMATE_SHIFT = 22u;
SHADER_CONST uint LIGHT_SAMPLE_ID_MASK = 0x003fffffu;
/// What is stored when there was no light to sample, or one with a larger id, which no cache learns.
SHADER_CONST uint LIGHT_SAMPLE_NONE = LIGHT_SAMPLE_ID_MASK;

/// The power of two next to `estimate`, within 2^-64 .. 2^63, in place; 0, and what is no number, count
/// as the least. Off by a factor of sqrt(2) at most.
SHADER_FN uint light_sample_pack_estimate(float estimate) {
    const float least = estimate > 1e-30f ? estimate : 1e-30f;
    const float power = clamp(floor(log2(least) + 64.5f), 0.0f, 127.0f);
    return uint(power) << LIGHT_SAMPLE_ESTIMATE_SHIFT;
}

/// Of that power of two: its exponent + 64, 0 .. 127.
SHADER_FN uint light_sample_exponent(uint light_sample) { return (light_sample >> LIGHT_SAMPLE_ESTIMATE_SHIFT) & 127u; }

SHADER_FN float light_sample_estimate(uint light_sample) { return exp2(float(light_sample_exponent(light_sample)) - 64.0f); }

/// An entry of a cache: light id, and above it for how many frames no sample has seen the light.
SHADER_CONST uint VLC_ID_MASK = 0x07ffffffu;
SHADER_CONST uint VLC_AGE_SHIFT = 27u;
SHADER_CONST uint VLC_OLDEST = 30u; // so that no entry looks like NONE
/// For how many frames a light stays that only a neighbour has seen: as many as it takes to ask all
/// neighbours.
SHADER_CONST uint VLC_BORROWED = 2u;

/// Sums beyond this are kept as this: squares of estimates, which reach 2^126, must not add up to
/// infinity.
SHADER_CONST float EXPLORE_LARGEST_SUM = 1e37f;

/// Words of a bucket in a cache's buffer beside its entries; they follow those of all the cache's buckets. First the probability that this bucket, or
/// one before it, is drawn: a float, 1 for the last. Then what that follows from, a BucketMemory.
SHADER_CONST uint VLC_BUCKET_WORDS = 2u;

/// Words of a cache with buckets of so many entries.
SHADER_FN uint vlc_cache_words(uint buckets, uint bucket_size) { return buckets * (bucket_size + VLC_BUCKET_WORDS); }

/// What draws from a bucket estimated: the sum of its lights' importances where the light drawn was seen, else 0. Of its mean square, the root is
/// the probability with which the bucket should be drawn, but for a factor: then the second moment of all draws is least.
struct BucketMemory {
    float draws; // at most BUCKET_DRAWS
    float root;  // of the mean square
};
/// Draws that are remembered, and those that a bucket nobody knows counts for.
SHADER_CONST float BUCKET_DRAWS = 48.0f;
SHADER_CONST float BUCKET_DOUBT = 4.0f;
/// Part of all draws that are spread evenly over buckets: what was learned may be wrong for a surface.
SHADER_CONST float BUCKET_EVEN = 0.1f;

SHADER_FN BucketMemory bucket_unpack(uint word) {
    BucketMemory memory;
    memory.draws = unpack_sum(word, 0u);
    memory.root = unpack_sum(word, 1u);
    return memory;
}

SHADER_FN uint bucket_pack(BucketMemory memory) { return pack_sums(memory.draws, memory.root); }

/// The part 1 - t of `a` and t of `b`, none negative. Unlike mix(), which may take a small `b` from a large `a` to add it again, it is as
/// exact as the smaller of both parts allows.
SHADER_FN float weighted(float a, float b, float t) { return (1.0f - t) * a + t * b; }

/// The memory after a frame with so many draws, and the root of the mean square of their estimates. Squares are of parts of the larger
/// root: neither overflows nor vanishes.
SHADER_FN BucketMemory bucket_update(BucketMemory memory, float draws, float root) {
    if (!(draws > 0.0f)) return memory;
    memory.draws = min(memory.draws + draws, BUCKET_DRAWS);
    const float fresh = min(draws / memory.draws, 1.0f);
    const float larger = max(memory.root, root);
    if (!(larger > 0.0f)) return memory;
    const float before = memory.root / larger;
    const float now = root / larger;
    memory.root = larger * sqrt(weighted(before * before, now * now, fresh));
    return memory;
}

/// What draws estimated, from cuts in running sums over the last hundred or so, and what follows from it: `share` of all
/// draws should be from cuts.
///
/// A draw estimates the importance of all that its walks can meet, lights of the cache or the others: that of the light
/// drawn, over its probability, or 0 if the light is hidden. The estimates' mean squares are the second moments K and M that the two
/// kinds have if nothing else is drawn. If cuts get a part a of the draws, they are K / (1 - a) and M / a, and
/// their sum is least for a / (1 - a) = sqrt(M / K).
struct ExploreMemory {
    float listed; // draws from cuts of lists
    float found;  // sum of the squares of their estimates
    float cached; // mean square of the estimates of draws from the cache: K
    float share;  // at most EXPLORE_MOST
};
SHADER_CONST float EXPLORE_DRAWS = 48.0f;
SHADER_CONST float EXPLORE_MOST = 0.9f;

SHADER_FN ExploreMemory explore_unpack(uvec2 words) {
    const vec4 four = unpack_four_sums(words);
    ExploreMemory memory;
    memory.listed = four.x;
    memory.found = four.y;
    memory.cached = four.z;
    memory.share = four.w;
    return memory;
}

SHADER_FN uvec2 explore_pack(ExploreMemory memory) {
    return pack_four_sums(vec4(memory.listed, memory.found, memory.cached, memory.share));
}

/// The memory after a frame with so many draws from cuts and from the cache, and the sums of the squares of their
/// estimates. A frame in which nothing was drawn from the cache had none, so it does not tell what a cache lacks: what it found is in
/// the next one, for which memory begins anew. If it found nothing, that is remembered.
SHADER_FN ExploreMemory explore_update(ExploreMemory memory, float listed, float found, float drawn, float squares) {
    if (!(drawn > 0.0f) && found > 0.0f) return explore_unpack(uvec2(0u, 0u));
    // Many new draws leave little of the old: an empty cache is full a frame later.
    const float kept = max(1.0f - listed / EXPLORE_DRAWS, 0.0f);
    memory.listed = kept * memory.listed + listed;
    memory.found = min(kept * memory.found + found, EXPLORE_LARGEST_SUM);
    if (!(drawn > 0.0f)) return memory;
    const float fresh = memory.cached > 0.0f ? min(drawn / EXPLORE_DRAWS, 1.0f) : 1.0f;
    memory.cached = weighted(memory.cached, min(squares, EXPLORE_LARGEST_SUM) / drawn, fresh);
    const float odds = sqrt(memory.found);
    const float others = sqrt(memory.listed) * sqrt(memory.cached);
    memory.share = odds > 0.0f ? min(odds / (odds + others), EXPLORE_MOST) : 0.0f;
    return memory;
}

/// What rays estimated, in running sums, and what follows from it: `share` of the rays should be drawn by the guider.
///
/// A ray's estimate is what it brings, times BRDF and cosine, over the density q = (1 - a) b + a g of the mixture. Its square x is a
/// part of the second moment; the parts that x has of the BRDF and of the guider are (1 - a) b / q and a g / q. Where
/// the two look into different directions, the sums `plain` of (1 - a) times the one and `guided` of a times the other
/// estimate the second moments that each would have alone there, and the sum of both is least for a / (1 - a) =
/// sqrt(guided / plain). Where they overlap the same holds at the least second moment, whose derivative by a is 0.
struct ShareMemory {
    float plain;
    float guided;
    float rays; // that the sums are of
    float share;
};
/// Rare rays that bring much are seen late: the BRDF keeps a quarter.
SHADER_CONST float SHARE_LEAST = 0.125f;
SHADER_CONST float SHARE_MOST = 0.75f;
/// Shares have steps: the order in which threads add to sums hardly ever changes them, and with them the picture.
SHADER_CONST float SHARE_STEPS = 16.0f;
/// Rays that the share at the start counts for.
SHADER_CONST float SHARE_DOUBT = 32.0f;
/// How fast sums fade, beside what the guider learned: single rays decide them.
SHADER_CONST float SHARE_PACE = 0.25f;

SHADER_FN ShareMemory share_unpack(uvec2 words) {
    const vec4 four = unpack_four_sums(words);
    ShareMemory memory;
    memory.plain = four.x;
    memory.guided = four.y;
    memory.rays = four.z;
    memory.share = four.w;
    return memory;
}

SHADER_FN uvec2 share_pack(ShareMemory memory) { return pack_four_sums(vec4(memory.plain, memory.guided, memory.rays, memory.share)); }

/// Part of the rays that the guider draws; `first` is that of a node without experience.
SHADER_FN float share_of(ShareMemory memory, float first) { return memory.rays > 0.0f ? memory.share : first; }

/// What the parts of a leaf that is split begin with: its share. The sums are of other places, maybe much brighter ones.
SHADER_FN ShareMemory share_of_part(ShareMemory memory) {
    ShareMemory part;
    part.plain = 0.0f;
    part.guided = 0.0f;
    part.rays = min(memory.rays, 1.0f);
    part.share = memory.share;
    return part;
}

/// The memory after a frame with `rays` > 0 rays. `plain` and `guided` are the sums of the two parts of their x, `guide_kept` is the part
/// of earlier knowledge that the guider keeps.
SHADER_FN ShareMemory share_update(ShareMemory memory, float guide_kept, float rays, float plain, float guided, float first) {
    const float kept = 1.0f - SHARE_PACE * (1.0f - guide_kept);
    const float used = share_of(memory, first);
    memory.plain = min(kept * memory.plain + (1.0f - used) * plain, EXPLORE_LARGEST_SUM);
    memory.guided = min(kept * memory.guided + used * guided, EXPLORE_LARGEST_SUM);
    memory.rays = kept * memory.rays + rays;
    const float part = sqrt(memory.guided);
    const float all = part + sqrt(memory.plain);
    const float best = all > 0.0f ? part / all : first;
    const float share = mix(first, best, memory.rays / (memory.rays + SHARE_DOUBT));
    memory.share = clamp(floor(SHARE_STEPS * share + 0.5f) / SHARE_STEPS, SHARE_LEAST, SHARE_MOST);
    return memory;
}

/// The indirect light that surfaces of a node reflect, as its rays estimate it: with pt_tail what a path brings beyond its last vertex, if that
/// lies there. Those rays' ends have tails, too. So every frame that is learned from adds a bounce, and the mean is that of all of them.
struct TailMemory {
    float mean; // luminance
    float rays; // that it is of
};
/// Rays that are remembered: enough for a steady mean.
SHADER_CONST float TAIL_RAYS = 2048.0f;
/// Part of earlier rays that is kept at most. Where there are few new ones, light that has changed must be forgotten, too.
SHADER_CONST float TAIL_KEPT = 0.9f;
/// Rays of its source that a part of a split leaf counts its mean as.
SHADER_CONST float TAIL_DOUBT = 32.0f;

SHADER_FN TailMemory tail_unpack(uvec2 words) {
    TailMemory memory;
    memory.mean = uintBitsToFloat(words.x);
    memory.rays = uintBitsToFloat(words.y);
    return memory;
}

SHADER_FN uvec2 tail_pack(TailMemory memory) { return uvec2(floatBitsToUint(memory.mean), floatBitsToUint(memory.rays)); }

/// The memory after a frame with `rays` > 0 rays, whose estimates have the mean `mean`.
SHADER_FN TailMemory tail_update(TailMemory memory, float rays, float mean) {
    const float kept = memory.rays * clamp(1.0f - rays / TAIL_RAYS, 0.0f, TAIL_KEPT);
    memory.rays = kept + rays;
    memory.mean = min(weighted(memory.mean, mean, rays / memory.rays), EXPLORE_LARGEST_SUM);
    return memory;
}

SHADER_FN TailMemory tail_of_part(TailMemory memory) {
    memory.rays = min(memory.rays, TAIL_DOUBT);
    return memory;
}

/// The first word of a ray sample: the cell of its direction on the grid of the smallest quadtree leaves,
/// and what it contributed, in quarters of a power of two from 2^-31.75 to 2^31.75: off by 9.1% at most in
/// between, 0 below, and cut off beyond. It decides where to look, never how bright anything is. The second word
/// is two halves (pack_sums): the square of its estimate, and the guider's part in its density.
SHADER_CONST uint RAY_SAMPLE_WORDS = 2u;
SHADER_FN uint ray_sample_pack(uvec2 grid, float contribution) {
    const float least = contribution > 1e-30f ? contribution : 1e-30f; // also of what is no number
    const float steps = clamp(4.0f * log2(least) + 128.5f, 0.0f, 255.0f);
    return grid.x | (grid.y << 12u) | (uint(steps) << 24u);
}

/// The cell of a direction (unit vector).
SHADER_FN uvec2 ray_sample_cell(vec3 direction) { return uvec2(octahedral_encode(direction) * float(1u << CDQ_MAX_DEPTH)); }

SHADER_FN uvec2 ray_sample_grid(uint packed_sample) { return uvec2(packed_sample & 0xfffu, (packed_sample >> 12u) & 0xfffu); }

SHADER_FN float ray_sample_contribution(uint packed_sample) {
    const uint steps = packed_sample >> 24u;
    return steps == 0u ? 0.0f : exp2(0.25f * (float(steps) - 128.0f));
}

/// A leaf's samples beyond this many are passed over, evenly: as many as make a leaf split at 1920
/// x 1080 pixels. Also, llvmpipe silently ends all loops of an invocation after 65,535 rounds
/// together: each of the VLC_LEAST_LANES puts at most 512 of a leaf's samples, or 896 lights of it
/// and its neighbours, into buckets of at most 64 slots.
SHADER_CONST uint VLC_MOST_SAMPLES = 4096u;
/// The same for a node's ray samples, for the same reasons: each of four invocations looks
/// at 2,048, and finding a quadtree's leaf takes 11 rounds at most. Which ones it looks at depends on
/// the order of threads, so small pictures repeat: the first node has no more rays.
SHADER_CONST uint GUIDE_MOST_RAYS = 8192u;

/// Of a node with `rays` > 0 rays one ray sample in so many is looked at.
SHADER_FN uint guide_stride(uint rays) { return (rays + GUIDE_MOST_RAYS - 1u) / GUIDE_MOST_RAYS; }
/// Invocations of the work groups that make caches: a subgroup, but no fewer than these.
SHADER_CONST uint VLC_LEAST_LANES = 8u;
/// The hash table in shared memory: light ids, and buckets (ids with equal remainder).
SHADER_CONST uint VLC_TABLE_SIZE = 1024u;
SHADER_CONST uint VLC_TABLE_MOST_BUCKETS = 256u;
/// Largest bucket (pt_vlc_bucket).
SHADER_CONST uint VLC_LARGEST_BUCKET = 64u;

/// Place of number `i` of `taken` samples, spread evenly over `kept`: floor(i * kept / taken). 0 < taken <= kept, i < taken < 65536.
SHADER_FN uint spread_place(uint i, uint kept, uint taken) { return i * (kept / taken) + i * (kept % taken) / taken; }

/// Push constants of all passes.
struct GuidingSettings {
    uint split;        // a leaf with more samples is split
    uint collapse;     // an inner node of eight leaves that have fewer together is collapsed
    uint bucket;       // most lights in a bucket
    uint small_bucket; // the same where buckets would get fewer than in the frame before (hysteresis)
    uint merge_faces;  // bit i: caches take over the lights of their neighbours beyond face i (LEAF_NEIGHBOURS)
    uint weigh;        // 1: buckets are drawn by what their draws brought; 0: evenly
    uint persist;      // frames that a light stays in a cache after it was seen, at most VLC_OLDEST
    uint migrations;   // of a directional quadtree in a frame, at most
    float margin;      // how far a migration must pay off
    uint guided;       // 1: a guider draws rays
    uint memory_rays;  // it follows about so many of a node's last rays; 0: those of the last frame
    float first_share; // of guided rays, where nothing is known
    uint adapt_share;  // 1: their share follows what rays estimated
    uint memory_words; // of the guider, per node; 0 without memory
    uint tail;         // 1: nodes learn what rays bring to them
    uint unguided;     // 1: the frame had no rays to learn from
    uint appeared;     // 1: a light appeared in the frame
};

/// Density of directions of which `other_part` are drawn with the density `other`, the rest with that of the guider.
SHADER_FN float guide_mixture_pdf(float guided, float other, float other_part) { return mix(guided, other, other_part); }

/// Part of what a guider learned that is kept in a frame which brings `rays` new ones.
SHADER_FN float guide_kept(GuidingSettings settings, uint rays) {
    if (settings.memory_rays == 0u) return 0.0f;
    return clamp(1.0f - float(rays) / float(settings.memory_rays), 0.0f, 0.98f);
}

/// Words that quadtrees remember: what their leaves contributed lately, two per word.
SHADER_CONST uint CDQ_SUM_WORDS = 64u;

/// The density that the BRDF adds to a quadtree's, in units in which that of a leaf is 4^depth.
/// Rays of the BRDF are taken as spread evenly over a hemisphere; `brdf_part` of all rays are such.
SHADER_FN float cdq_even_density(uint bits, float brdf_part) {
    return 2.0f * float(cdq_leaf_count(bits)) * brdf_part / max(1.0f - brdf_part, 1e-6f);
}

/// Counted anew each frame: the passes begin with all of it 0 (but the group counts' y and z, which
/// are 1).
struct GuidingWork {
    uvec3 deduplicate_groups; // indirect dispatches, one work group per entry of a list (passes.glsl)
    uvec3 merge_groups;
    uvec3 guide_groups;
    uvec3 augment_groups;
    uint vlc_used;    // words that caches ask for
    uint sample_used; // light samples' room given to leaves
    uint demand;      // samples that the new leaves are expected to receive together
    uint ray_used;    // the same of rays and nodes
    uint ray_demand;
    // Statistics of the frame that was rendered last, and of the trees made from it.
    uint nodes;          // inner nodes
    uint depth;          // of the deepest leaf
    uint samples;        // surface samples
    uint dropped;        // of them: light samples without room
    uint rays;           // that brought something
    uint rays_dropped;   // of them: without room
    uint sampled_leaves; // leaves with samples
    uint cached_leaves;  // leaves with a cache of at least one light
    uint cached_lights;  // their lights together
    uint cached_buckets;
    uint most_lights;     // in one cache
    uint lights_left_out; // found by samples, but the table was full
    uint caches_refused;  // leaves that should have a cache, which had no room
    uint splits;
    uint collapses;
    uint cdq_migrations;
    uint splits_refused; // the tree had no room for more nodes
    uint spreads[2];     // GUIDE_SPREAD_*: roots of the nodes' second moments added up, as bits of floats
};
SHADER_CONST uint GUIDE_SPREAD_PLAIN = 0u;  // if the BRDF drew all rays
SHADER_CONST uint GUIDE_SPREAD_GUIDED = 1u; // as they are drawn

SHADER_END
#endif
