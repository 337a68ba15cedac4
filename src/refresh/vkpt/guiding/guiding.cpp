// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/guiding.h"

#include "shared/bindings.h"
#include "shared/octree.h"
#include "shared/scene_types.h"
#include "shared/views.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <utility>

namespace vigil::vkpt {

namespace {

/// Words per node in the plan of a rebuild.
constexpr uint64_t plan_words = 4;
/// A work group per leaf must fit into one dimension of a dispatch, which Vulkan lets end at
/// 65,535.
constexpr uint32_t most_nodes = 8192, least_nodes = 64;
/// Words of caches for each leaf that a tree may have, at most: at least one largest bucket. Most
/// leaves have no cache, so that in a hall of a thousand lamps one may have 16 buckets or more.
constexpr uint64_t cache_words_per_leaf = 104;
static_assert(cache_words_per_leaf >= shader::VLC_LARGEST_BUCKET + shader::VLC_BUCKET_WORDS);
/// A tree is expected to grow by no more from frame to frame. One of surfaces has four times the
/// leaves with each level.
constexpr double most_growth = 3.0;
/// Light samples of a pixel for each surface of its path that there is room for. A frame without
/// caches stores one and a half, others one; the rest is for leaves that expect more than they get.
constexpr uint64_t samples_per_surface = 2;
/// The same of ray samples: each bounce has one ray to learn from, and those that bring nothing
/// store none.
constexpr uint64_t rays_per_bounce = 1;
/// Beyond so many pixels there is room for three quarters: leaves have more samples than they need.
constexpr uint64_t small_picture = 1 << 20;

uint32_t sample_capacity(uint64_t pixels, uint64_t per_pixel, uint64_t least) {
    const uint64_t quarters = 3 * pixels + std::min(pixels, small_picture);
    return static_cast<uint32_t>(std::max(per_pixel * quarters / 4, least));
}

/// Faces in the order of LEAF_NEIGHBOURS: all, and opposite ones in turn.
constexpr uint32_t all_faces = 0b111111, half_of_faces[] = {0b010101, 0b101010};
/// Where lights stay for so many frames it is enough to ask half of the neighbours in each.
constexpr int persist_for_half = 4;
/// Once nothing new is to be seen, one frame of so many teaches.
constexpr uint32_t turn_at_rest = 31;
/// All of the first frames teach, and those after a light has changed.
constexpr uint32_t eager_frames = 4;
/// Samples in a frame, for every light of the caches and frame of a turn, that make that turn
/// enough (measured: docs/research/history.md).
constexpr double samples_per_light = 0.75;
/// While the picture changes, of a leaf's samples as many count. Large pictures have more, and
/// their caches gain as much by learning from each frame.
constexpr uint64_t samples_per_leaf = 32;
/// Guiders learn from every frame that they draw rays of, until surfaces have stored so many times
/// as many samples as there are rays that guiders follow.
constexpr uint64_t guide_memories = 16;
/// Guiders draw rays in all of so many first frames: nothing is known of their gain.
constexpr uint32_t guide_frames = 8;
/// Where they gain too little, they draw rays in one frame of so many, while they begin and later.
constexpr uint32_t guide_turn_begin = 2, guide_turn = 8;
/// Part of the last frame in what is known of their gain.
constexpr double gain_pace = 0.25;
/// Of a turn's samples one in so many may be without room. Room is for as many as a leaf had the
/// turn before: what has none lies on surfaces that are new to see, of which little is learned.
constexpr uint64_t samples_per_unexpected = 100;

/// Factor on the thresholds of the octree, which are those of 1920 x 1080 pixels. In proportion to
/// the pixels, a small picture would have as many leaves as a large one, each with too few samples
/// to learn from; on `warehouse` at 320 x 180, twice as many a leaf are better
/// (docs/research/caches.md).
double threshold_factor(glm::uvec2 picture_size) {
    const double pixels = static_cast<double>(picture_size.x) * picture_size.y / (1920.0 * 1080.0);
    return std::max(pixels, std::pow(pixels, 0.8));
}

uint32_t memory_words(const GuideChoice& guide) {
    return guide.guides() ? guider_of(guide.guide)->memory_words() : 0;
}

uint32_t scaled(int threshold, double factor, uint32_t least) {
    return std::max(static_cast<uint32_t>(std::min(std::round(threshold * factor), 2147483648.0)),
                    least);
}

/// What the passes start from: nothing is counted.
shader::GuidingWork first_work() {
    shader::GuidingWork work{};
    work.deduplicate_groups = work.merge_groups = work.guide_groups =
        work.augment_groups = {0, 1, 1};
    return work;
}

} // namespace

Guiding::Guiding(const gpu::Device& device, gpu::PipelineCompiler& compiler, size_t slots)
    : device_(device), unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      header_buffer_(device, sizeof(shader::GuidingHeader), gpu::MemoryUse::Device,
                     "guiding header"),
      work_(device, sizeof(shader::GuidingWork), gpu::MemoryUse::Device, "guiding work",
            VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT),
      first_work_(
          gpu::make_buffer(device, gpu::bytes_of_value(first_work()), "first guiding work")),
      mark_(Pass::OctreeMark, compiler, layout_),
      deduplicate_(Pass::VlcDeduplicate, compiler, layout_),
      merge_(Pass::VlcMerge, compiler, layout_), guide_(Pass::GuideAdapt, compiler, layout_),
      adapt_(Pass::OctreeAdapt, compiler, layout_),
      augment_(Pass::OctreeAugment, compiler, layout_) {
    for (Tree& tree : trees_) {
        Sets sets = make_sets();
        tree.lookup = std::move(sets.lookup);
        tree.passes = std::move(sets.passes);
    }
    for (size_t slot = 0; slot < slots; ++slot) {
        statistics_.emplace_back(device, sizeof(shader::GuidingWork), gpu::MemoryUse::Readback,
                                 "guiding statistics");
        std::memset(statistics_.back().mapped(), 0, sizeof(shader::GuidingWork));
    }
    layout_ = gpu::PipelineLayout(device, {&trees_[0].passes});
}

Guiding::Sets Guiding::make_sets() const {
    std::vector<gpu::BindingKind> lookup(GUIDING_BINDING_COUNT, gpu::BindingKind::Storage);
    for (const uint32_t words :
         {BINDING_GUIDING_NODES, BINDING_GUIDING_VLC, BINDING_GUIDING_LEAF_WORDS})
        lookup[words] = gpu::BindingKind::Words;
    const std::vector<gpu::BindingKind> passes(GUIDING_PASS_BINDING_COUNT,
                                               gpu::BindingKind::Storage);
    return {gpu::DescriptorSet(device_, lookup, unused_, "guiding look-up set"),
            gpu::DescriptorSet(device_, passes, unused_, "guiding pass set")};
}

void Guiding::choose_pipelines() {
    const uint32_t subgroup = device_.features().subgroup_size;
    const std::vector<gpu::Specialization> lanes{
        {CONSTANT_GROUP_SIZE, std::max(subgroup, shader::VLC_LEAST_LANES)}};
    for (ComputePass* pass : {&mark_, &adapt_, &augment_})
        pass->choose("", lanes);
    if (options_.lights)
        for (ComputePass* pass : {&deduplicate_, &merge_})
            pass->choose("", lanes);
    if (options_.guide.guides())
        guide_.choose(
            fmt::format(".{}", guider_name(options_.guide.guide)),
            {{CONSTANT_GROUP_SIZE, subgroup}, {CONSTANT_GUIDER_SIZE, options_.guide.size}});
}

Guiding::Options Guiding::options(glm::uvec2 picture_size, Guide guide,
                                  const refresh::Settings& settings) {
    const double factor =
        threshold_factor(picture_size) * static_cast<double>(settings.pt_oct_scale);
    const auto bucket = static_cast<uint32_t>(settings.pt_vlc_bucket);
    Options options;
    options.picture_size = picture_size;
    options.bounces = static_cast<uint32_t>(std::max(settings.pt_bounces, 1));
    options.settings.split = scaled(settings.pt_oct_split, factor, 4);
    // A node must not collapse that would be split again at once.
    options.settings.collapse =
        std::min(scaled(settings.pt_oct_collapse, factor, 1), options.settings.split);
    options.settings.bucket = bucket;
    const float share = settings.pt_vlc_hysteresis * static_cast<float>(bucket);
    options.settings.small_bucket = std::max(static_cast<uint32_t>(share), 1u);
    options.guide = choose_guide(guide, settings);
    if (const Guider* guider = guider_of(guide)) guider->set(options.settings, settings);
    options.settings.memory_rays = static_cast<uint32_t>(settings.pt_cdq_rays);
    options.settings.first_share = 1.0f - settings.pt_cdq_brdf;
    options.settings.adapt_share = static_cast<uint32_t>(settings.pt_cdq_adapt);
    options.settings.tail = options.guide.guides() ? static_cast<uint32_t>(settings.pt_tail) : 0;
    options.rest_after = static_cast<uint32_t>(settings.pt_rest_after);
    options.settings.weigh = static_cast<uint32_t>(settings.pt_vlc_weigh);
    options.settings.persist = static_cast<uint32_t>(settings.pt_vlc_persist);
    options.settings.merge_faces = settings.pt_vlc_merge != 0 ? all_faces : 0;
    options.half_merged = settings.pt_vlc_persist >= persist_for_half;
    options.learn_every = static_cast<uint32_t>(settings.pt_learn_every);
    options.start_fine = settings.pt_oct_start != 0;
    options.least_gain = static_cast<double>(settings.pt_guide_gain);
    if (settings.pt_view == shader::VIEW_SAMPLES) { // of every frame
        options.rest_after = 0;
        options.learn_every = 1;
        options.least_gain = 0.0;
    }
    return options;
}

uint32_t Guiding::node_capacity(const Options& options) {
    // Every node whose children are leaves holds `collapse` samples or vanishes; there is no more
    // than one per surface of a path. As many again for the nodes above them. Trees have a quarter
    // of that; beyond it leaves stay whole.
    const uint64_t samples =
        uint64_t{1 + options.bounces} * options.picture_size.x * options.picture_size.y;
    const uint64_t nodes = 2 * samples / std::max(options.settings.collapse, 1u);
    return static_cast<uint32_t>(std::clamp<uint64_t>(nodes, least_nodes, most_nodes));
}

bool Guiding::prepare(const Options& options) {
    const bool fits =
        header_.node_capacity == node_capacity(options) &&
        options_.picture_size == options.picture_size && options_.bounces == options.bounces &&
        options_.guide.guide == options.guide.guide && options_.lights == options.lights;
    const uint32_t memory = options.settings.memory_rays > 0 ? memory_words(options.guide) : 0;
    // What the frame before left must fit: buckets of the same size, what the same guider learned,
    // shares if they are to be learned, caches that were made in it, and a memory if the guider is
    // to have one.
    restart_ |= options_.settings.bucket != options.settings.bucket ||
                options_.settings.adapt_share != options.settings.adapt_share ||
                options_.settings.tail != options.settings.tail ||
                options_.guide != options.guide || options_.settings.memory_words < memory;
    options_ = options;
    turn_ = std::min(turn_, options_.learn_every);
    options_.settings.memory_words = memory;
    options_.settings.guided = options_.guide.guides() ? 1 : 0;
    choose_pipelines();
    if (fits) return false;
    device_.wait_idle();
    make_buffers();
    restart_ = true;
    return true;
}

void Guiding::make_buffers() {
    const uint64_t pixels = uint64_t{options_.picture_size.x} * options_.picture_size.y;
    header_.node_capacity = 0; // if making any fails, the next frame tries again
    const uint64_t nodes = node_capacity(options_), leaves = 8 * nodes;
    header_.sample_capacity =
        sample_capacity(pixels, samples_per_surface * (1 + options_.bounces), leaves);
    header_.ray_capacity = sample_capacity(pixels, rays_per_bounce * options_.bounces, nodes);
    header_.vlc_most = static_cast<uint32_t>(cache_words_per_leaf * (options_.lights ? leaves : 1));
    header_.vlc_capacity = header_.vlc_most / options_.first_cache_part;
    const auto make = [&](uint64_t words, const char* name) {
        return gpu::Buffer(device_, words * sizeof(uint32_t), gpu::MemoryUse::Device, name);
    };
    for (Tree& tree : trees_) {
        tree.nodes = make(1 + nodes, "octree nodes");
        tree.cells = make(2 * nodes, "octree cells");
        const uint32_t node_words =
            options_.guide.guides() ? shader::NODE_WORDS + memory_words(options_.guide) : 0;
        tree.leaves = make((8 * shader::LEAF_WORDS + node_words) * nodes, "octree leaves");
        tree.caches = make_caches(header_);
    }
    plan_ = make(plan_words * nodes, "octree plan");
    samples_ = make(header_.sample_capacity, "light samples");
    rays_ = options_.guide.guides()
                ? make(uint64_t{shader::RAY_SAMPLE_WORDS} * header_.ray_capacity, "ray samples")
                : gpu::Buffer();
    lists_ = make(2 * leaves + nodes, "lists of leaves and nodes");
    counted_.assign(statistics_.size(), false);
    worst_ = {};
    nodes_before_ = 0;
    bind(trees_[0], trees_[1]);
    bind(trees_[1], trees_[0]);
    header_.node_capacity = static_cast<uint32_t>(nodes);
}

void Guiding::bind(Tree& from, const Tree& to) {
    gpu::DescriptorSet& lookup = from.lookup;
    lookup.bind(BINDING_GUIDING_HEADER, header_buffer_);
    lookup.bind(BINDING_GUIDING_NODES, from.nodes);
    lookup.bind(BINDING_GUIDING_LEAVES, from.leaves);
    lookup.bind(BINDING_GUIDING_LEAF_WORDS, from.leaves);
    lookup.bind(BINDING_GUIDING_SAMPLES, samples_);
    const gpu::Buffer& rays = rays_ ? rays_ : unused_;
    lookup.bind(BINDING_GUIDING_RAYS, rays);
    lookup.bind(BINDING_GUIDING_VLC, from.caches);
    gpu::DescriptorSet& passes = from.passes;
    passes.bind(BINDING_PASS_HEADER, header_buffer_);
    passes.bind(BINDING_PASS_OLD_NODES, from.nodes);
    passes.bind(BINDING_PASS_OLD_CELLS, from.cells);
    passes.bind(BINDING_PASS_OLD_LEAVES, from.leaves);
    passes.bind(BINDING_PASS_OLD_CACHES, from.caches);
    passes.bind(BINDING_PASS_NEW_NODES, to.nodes);
    passes.bind(BINDING_PASS_NEW_CELLS, to.cells);
    passes.bind(BINDING_PASS_NEW_LEAVES, to.leaves);
    passes.bind(BINDING_PASS_NEW_CACHES, to.caches);
    passes.bind(BINDING_PASS_PLAN, plan_);
    passes.bind(BINDING_PASS_SAMPLES, samples_);
    passes.bind(BINDING_PASS_RAYS, rays);
    passes.bind(BINDING_PASS_LISTS, lists_);
    passes.bind(BINDING_PASS_WORK, work_);
}

void Guiding::restart(const glm::vec3& corner, float size) {
    header_.corner = corner;
    header_.scale = static_cast<float>(shader::octree_cell_size(0)) / std::max(size, 1e-3f);
    restart_ = true;
}

void Guiding::upload_start(gpu::FrameCommands& commands, std::span<const glm::vec3> places) {
    const Tree& tree = trees_[current_];
    OctreeNeeds needs;
    needs.corner = header_.corner;
    needs.scale = header_.scale;
    needs.samples = 2.0f * static_cast<float>(options_.picture_size.x) *
                    static_cast<float>(options_.picture_size.y);
    needs.split = options_.settings.split;
    needs.most_nodes = header_.node_capacity / 2;
    const OctreeStart start =
        start_octree(options_.start_fine ? places : std::span<const glm::vec3>(), needs);
    const size_t node_count = start.nodes.size();
    commands.upload(header_buffer_, 0, gpu::bytes_of_value(header_));
    const auto counted = static_cast<uint32_t>(node_count);
    commands.upload(tree.nodes, 0, gpu::bytes_of_value(counted));
    commands.upload(tree.nodes, sizeof(uint32_t), gpu::bytes_of(start.nodes));
    commands.upload(tree.cells, 0, gpu::bytes_of(start.cells));
    // Leaves without samples, caches, neighbours and experience. The passes give them room for as
    // many samples as are expected.
    using shader::NONE;
    const auto fill = [&](const shader::LeafArray& array, uint32_t value) {
        std::vector<uint32_t> words(8 * node_count * array.words, value);
        if (array.first == shader::LEAF_COUNT.first) words = start.leaf_counts;
        const uint64_t word = shader::leaf_array_word(array, 0, header_.node_capacity);
        commands.upload(tree.leaves, word * sizeof(uint32_t), gpu::bytes_of(words));
    };
#define VIGIL_FILL_ARRAY(name, width, before, value, new_leaf) fill(shader::name, value);
    LEAF_ARRAY_TABLE(VIGIL_FILL_ARRAY)
#undef VIGIL_FILL_ARRAY
    if (const Guider* guider = guider_of(options_.guide.guide)) {
        const auto begin = [&](const shader::NodeArray& array, std::span<const std::byte> words) {
            if (words.empty()) return;
            const uint64_t word = shader::node_array_word(array, 0, header_.node_capacity);
            commands.upload(tree.leaves, word * sizeof(uint32_t), words);
        };
        const std::vector<glm::uvec4> first(node_count, guider->first_words(options_.guide.size));
        begin(shader::NODE_GUIDE, gpu::bytes_of(first));
        for (const shader::NodeArray& array :
             {shader::NODE_SHARE, shader::NODE_RAYS, shader::NODE_RAY_STORAGE, shader::NODE_TAIL,
              shader::guide_memory(guider->memory_words())}) {
            const std::vector<uint32_t> zeros(node_count * array.words);
            begin(array, gpu::bytes_of(zeros));
        }
    }
    restart_ = false;
    learned_ = 0;
}

gpu::Buffer Guiding::make_caches(const shader::GuidingHeader& header) const {
    gpu::Buffer caches(device_, uint64_t{header.vlc_capacity} * sizeof(uint32_t),
                       gpu::MemoryUse::Device, "light caches");
    caches.texels(VK_FORMAT_R32_UINT); // made here, where failing harms nothing
    return caches;
}

bool Guiding::make_room(gpu::FrameCommands& commands, const Needs& needs) {
    // The counts are as old as there are frames in flight. While the tree grows, it goes on as it
    // did, and caches with it.
    const double last = std::exchange(nodes_before_, needs.nodes);
    const double growth = last > 0.0 ? std::clamp(needs.nodes / last, 1.0, most_growth) : 1.0;
    const double cache_words = needs.cache_words;
    const double expected = cache_words * std::pow(growth, static_cast<double>(statistics_.size()));
    const double room = header_.vlc_capacity, most = header_.vlc_most;
    if (8.0 * expected <= 7.0 * room || room == most) return false;
    shader::GuidingHeader larger = header_;
    larger.vlc_capacity =
        static_cast<uint32_t>(std::min(std::max({1.5 * cache_words, expected, 1.25 * room}), most));
    // Frames in flight use the sets and the buffers of before. What fails leaves them working.
    std::array<gpu::Buffer, 2> caches{make_caches(larger), make_caches(larger)};
    std::array<Sets, 2> sets{make_sets(), make_sets()};
    header_ = larger;
    for (size_t i = 0; i < 2; ++i) {
        std::swap(trees_.at(i).caches, caches.at(i));
        std::swap(trees_.at(i).lookup, sets.at(i).lookup);
        std::swap(trees_.at(i).passes, sets.at(i).passes);
    }
    bind(trees_[0], trees_[1]);
    bind(trees_[1], trees_[0]);
    if (!restart_) { // else there are no caches to keep
        const VkBufferCopy copy{0, 0, caches.at(current_).bytes()};
        vkCmdCopyBuffer(commands.commands(), caches.at(current_).handle(),
                        trees_.at(current_).caches.handle(), 1, &copy);
    }
    commands.keep(std::move(caches));
    commands.keep(std::move(sets));
    return true;
}

bool Guiding::follow_needs(gpu::FrameCommands& commands, size_t slot) {
    if (!counted_.at(slot)) return false;
    const shader::GuidingWork work = statistics(slot);
    follow_gain(work);
    turn_ = turn_for(work);
    const Needs needs = needs_of(work);
    worst_.nodes = std::max(worst_.nodes, needs.nodes);
    worst_.samples = std::max(worst_.samples, needs.samples);
    worst_.rays = std::max(worst_.rays, needs.rays);
    worst_.cache_words = std::max(worst_.cache_words, needs.cache_words);
    return make_room(commands, needs);
}

uint32_t Guiding::turn_for(const shader::GuidingWork& work) const {
    uint64_t turn = options_.learn_every;
    if (options_.lights && work.cached_lights > 0) {
        const uint64_t counted = uint64_t{samples_per_leaf} * work.sampled_leaves;
        const auto samples = static_cast<double>(
            still_frames_ > 0 ? work.samples : std::min<uint64_t>(work.samples, counted));
        turn = std::min(turn,
                        static_cast<uint64_t>(samples / (samples_per_light * work.cached_lights)));
    }
    // As much is new in each frame of a turn.
    const uint64_t unexpected = options_.lights ? work.dropped : work.rays_dropped;
    const uint64_t all = options_.lights ? work.samples : work.rays;
    if (unexpected > 0) turn = std::min(turn, turn_ * all / (samples_per_unexpected * unexpected));
    return std::bit_floor(static_cast<uint32_t>(std::max<uint64_t>(turn, 1)));
}

void Guiding::follow_gain(const shader::GuidingWork& work) {
    samples_ever_ += work.samples;
    guiders_begin_ =
        samples_ever_ < guide_memories * options_.settings.memory_rays * uint64_t{work.nodes};
    const auto plain = std::bit_cast<float>(work.spreads[shader::GUIDE_SPREAD_PLAIN]);
    const auto guided = std::bit_cast<float>(work.spreads[shader::GUIDE_SPREAD_GUIDED]);
    if (!(plain > 0.0f) || !std::isfinite(guided / plain)) return;
    gain_ += gain_pace * (1.0 - static_cast<double>(guided / plain) - gain_);
}

bool Guiding::rests() const {
    return options_.rest_after > 0 && still_frames_ >= options_.rest_after;
}

/// Whether this frame stores samples, to learn from.
bool Guiding::teaches() const {
    if (rests()) return still_frames_ % turn_at_rest == 0;
    if (options_.guide.guides() && guiders_begin_ && guides()) return true;
    return frames_ < eager_frames || frames_ % turn_ == 0;
}

/// Whether guiders draw this frame's rays.
bool Guiding::guides() const {
    if (options_.least_gain <= 0.0 || gain_ >= options_.least_gain) return true;
    if (options_.settings.tail != 0) return true; // it is learned from guided rays
    if (age_ < guide_frames) return true;
    if (rests()) return teaches();
    return age_ % (guiders_begin_ ? guide_turn_begin : guide_turn) == 0;
}

void Guiding::record(gpu::FrameCommands& commands, size_t slot, Change change,
                     std::span<const glm::vec3> places) {
    still_frames_ = change == Change::Nothing && !restart_ ? still_frames_ + 1 : 0;
    age_ = restart_ ? 0 : age_ + 1;
    frames_ = change >= Change::Lights || restart_ ? 0 : frames_ + 1;
    if (frames_ == 0) {
        samples_ever_ = 0;
        guiders_begin_ = true;
    }
    const shader::GuidingHeader before = header_;
    header_.guides = guides() ? 1 : 0;
    // Without caches there is nothing else to learn from.
    header_.stores = teaches() && (options_.lights || header_.guides != 0) ? 1 : 0;
    header_.explores = change == Change::NewLights && !restart_ ? 1 : 0;
    const bool starts = restart_;
    const bool learns = before.stores != 0 || starts;
    const bool grown = learns && follow_needs(commands, slot);
    if (restart_)
        upload_start(commands, places);
    else if (grown)
        commands.upload(header_buffer_, 0, gpu::bytes_of_value(header_));
    else if (before.stores != header_.stores || before.explores != header_.explores ||
             before.guides != header_.guides)
        vkCmdUpdateBuffer(commands.commands(), header_buffer_.handle(),
                          offsetof(shader::GuidingHeader, stores),
                          sizeof(shader::GuidingHeader) - offsetof(shader::GuidingHeader, stores),
                          &header_.stores);
    if (learns) {
        shader::GuidingSettings settings = options_.settings;
        settings.unguided = before.guides != 0 || starts ? 0 : 1;
        settings.appeared = before.explores;
        if (options_.half_merged) settings.merge_faces &= half_of_faces[learned_++ % 2];
        learn(commands, slot, settings);
    }
    if (starts) counted_.at(slot) = false; // those samples are only expected
}

void Guiding::learn(gpu::FrameCommands& commands, size_t slot,
                    const shader::GuidingSettings& settings) {
    counted_.at(slot) = true;
    const VkBufferCopy whole{0, 0, sizeof(shader::GuidingWork)};
    vkCmdCopyBuffer(commands.commands(), first_work_.handle(), work_.handle(), 1, &whole);
    const VkDescriptorSet set = trees_[current_].passes.handle();
    const gpu::Inputs inputs{std::span(&set, 1), gpu::bytes_of_value(settings)};
    const gpu::WorkGroups nodes{{(header_.node_capacity + 63) / 64, 1, 1}};
    // A work group for each entry of a list that the passes have made.
    const auto listed = [&](size_t counted) {
        return gpu::WorkGroups{{}, work_.handle(), counted};
    };
    mark_.record(commands, inputs, nodes);
    if (options_.lights) {
        deduplicate_.record(commands, inputs,
                            listed(offsetof(shader::GuidingWork, deduplicate_groups)));
        merge_.record(commands, inputs, listed(offsetof(shader::GuidingWork, merge_groups)));
    }
    if (options_.guide.guides())
        guide_.record(commands, inputs, listed(offsetof(shader::GuidingWork, guide_groups)));
    adapt_.record(commands, inputs, {});
    augment_.record(commands, inputs, listed(offsetof(shader::GuidingWork, augment_groups)));

    const VkCommandBuffer buffer = commands.commands();
    gpu::barrier(buffer, gpu::access_of_shaders, gpu::access_of_copies);
    vkCmdCopyBuffer(buffer, work_.handle(), statistics_[slot].handle(), 1, &whole);
    gpu::barrier(buffer, gpu::access_of_copies, gpu::access_of_host);
    current_ = 1 - current_;
}

shader::GuidingWork Guiding::statistics(size_t slot) const {
    return statistics_[slot].mapped_as<shader::GuidingWork>()[0];
}

Guiding::Needs Guiding::needs_of(const shader::GuidingWork& work) {
    return {work.nodes + work.splits_refused, work.samples, work.rays, work.vlc_used};
}

uint64_t Guiding::memory_bytes() const {
    uint64_t bytes = 0;
    for (const Tree& tree : trees_)
        bytes +=
            tree.nodes.bytes() + tree.cells.bytes() + tree.leaves.bytes() + tree.caches.bytes();
    for (const gpu::Buffer* buffer : {&header_buffer_, &plan_, &samples_, &rays_, &lists_, &work_})
        bytes += buffer->bytes();
    return bytes;
}

} // namespace vigil::vkpt
