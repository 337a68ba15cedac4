// SPDX-License-Identifier: GPL-2.0-or-later
// See guiding_fixture.h.
#include "guiding_fixture.h"

#include "gpu/validated.h"
#include "refresh/vkpt/gpu/commands.h"
#include "shared/cdq.h"
#include "shared/octree.h"
#include "tree_comparison.h"

#include <array>
#include <memory>

namespace vigil::test {
namespace {

/// Between SetUpTestSuite and TearDownTestSuite.
struct Shared {
    Shared()
        : device(test::validated(), nullptr), compiler(device, {}),
          guiding(device, compiler, 2), slots{gpu::FrameCommands(device),
                                              gpu::FrameCommands(device)} {}
    gpu::Device device;
    gpu::PipelineCompiler compiler; // its cache is kept nowhere
    vkpt::Guiding guiding;
    std::array<gpu::FrameCommands, 2> slots; // frames in flight
};
std::unique_ptr<Shared> shared;

std::vector<uint32_t> download(const gpu::Buffer& buffer, size_t words) {
    return gpu::download_now_as<uint32_t>(shared->device, buffer, 0, words);
}

TreeWords download(const vkpt::Guiding::Tree& tree, uint32_t node_capacity) {
    const bool sums =
        tree.leaves.bytes() > uint64_t{8} * shader::LEAF_WORDS * node_capacity * sizeof(uint32_t);
    TreeWords words = TreeWords::sized(node_capacity, sums);
    words.nodes = download(tree.nodes, words.nodes.size());
    words.cells = download(tree.cells, words.cells.size());
    words.leaves = download(tree.leaves, words.leaves.size());
    return words;
}

/// Of a node's cell, as stored.
Path path_of(const uint32_t* words) {
    const shader::OctreeCell cell = shader::octree_unpack_cell({words[0], words[1]});
    Path path;
    for (uint32_t depth = 0; depth < cell.depth; ++depth)
        path.push_back(static_cast<char>('0' + shader::octree_child(cell.corner, depth)));
    return path;
}

/// Submits the passes of one frame.
void record_passes(size_t slot, vkpt::Change change = vkpt::Change::Something,
                   std::span<const glm::vec3> places = {}) {
    gpu::FrameCommands& commands = shared->slots[slot];
    commands.begin();
    shared->guiding.record(commands, slot, change, places);
    commands.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
}

} // namespace

void GuidingTest::SetUpTestSuite() {
    shared = std::make_unique<Shared>();
}

void GuidingTest::TearDownTestSuite() {
    shared.reset();
}

void GuidingTest::SetUp() {
    ASSERT_TRUE(shared);
}

void GuidingTest::TearDown() {
    if (shared) {
        EXPECT_EQ(shared->device.validation_messages(), 0);
    }
}

vkpt::Guiding& GuidingTest::guiding() {
    return shared->guiding;
}

const gpu::Device& GuidingTest::device() {
    return shared->device;
}

void GuidingTest::restart() {
    guiding().restart(glm::vec3(-4096.0f, -4096.0f, -2048.0f), 8192.0f);
}

void GuidingTest::prepare(const shader::GuidingSettings& settings) {
    settings_ = settings;
    const vkpt::GuideChoice guide =
        cdq_bits_ > 0 ? vkpt::GuideChoice{Guide::cdq, cdq_bits_} : vkpt::GuideChoice{};
    guiding().prepare({glm::uvec2(picture_size_), settings, guide, true, first_cache_part_});
    frame_ = 0;
}

void GuidingTest::start(const shader::GuidingSettings& settings, uint32_t picture_size,
                        uint32_t cdq_bits) {
    picture_size_ = picture_size;
    cdq_bits_ = cdq_bits;
    restart();
    start_anew(settings);
}

void GuidingTest::start_anew(const shader::GuidingSettings& settings) {
    prepare(settings);
    // The first frame starts from a tree that exists nowhere yet.
    run_passes();
    take_first_tree();
    ASSERT_EQ(state_.inner, InnerNodes{""});
    frame();
}

void GuidingTest::start_with(const shader::GuidingSettings& settings,
                             std::span<const glm::vec3> places, uint32_t picture_size) {
    picture_size_ = picture_size;
    cdq_bits_ = 0;
    restart();
    prepare(settings);
    run_passes(places);
    take_first_tree();
}

void GuidingTest::take_first_tree() {
    const TreeWords seen = download(guiding().tree(), guiding().header().node_capacity);
    AdaptedOctree first;
    const InnerNodes& inner = first.inner;
    for (uint32_t node = 0; node < seen.nodes[0]; ++node)
        first.inner.insert(path_of(&seen.cells[2 * size_t{node}]));
    ASSERT_EQ(seen.nodes[0], inner.size());
    const Numbering numbers(inner);
    for (const Path& node : inner)
        ASSERT_EQ(seen.nodes[1 + numbers.node(node)] & 0xffu, leaf_mask(inner, node)) << node;
    const std::vector<Path> leaves = leaves_of(inner);
    for (const Path& leaf : leaves)
        first.source[leaf] = leaf;
    state_ = state_after(first, {}, seen, std::vector<uint32_t>(guiding().header().sample_capacity),
                         std::vector<uint32_t>(guiding().header().vlc_capacity), settings_.bucket);
    if (cdq_bits_ > 0) {
        take_quadtrees(
            state_, seen, cdq_bits_, remember(),
            std::vector<uint32_t>(shader::RAY_SAMPLE_WORDS * guiding().header().ray_capacity));
        for (const auto& [path, node] : state_.nodes)
            EXPECT_EQ(field_of(node.quadtree), shader::cdq_even_tree(cdq_bits_)) << path;
    }
    for (const Path& leaf : leaves) {
        EXPECT_EQ(seen.at(shader::LEAF_COUNT, numbers.leaf(leaf)), 0u) << leaf;
        EXPECT_EQ(seen.at(shader::LEAF_VLC, numbers.leaf(leaf), 1), 0u) << leaf;
        EXPECT_EQ(seen.at(shader::LEAF_CACHED, numbers.leaf(leaf)), 0u) << leaf;
    }
    const Disagreements storage = compare_storage(inner, seen, guiding().header().sample_capacity);
    EXPECT_TRUE(storage.empty()) << storage.text();
}

glm::uvec3 GuidingTest::cell_of(glm::vec3 position) {
    return shader::octree_grid(position, guiding().header().corner, guiding().header().scale);
}

void GuidingTest::place(glm::vec3 position, uint32_t light_sample) {
    const glm::ivec3 cell(cell_of(position));
    LeafState& leaf = state_.leaves.at(leaf_with(state_.inner, cell).value());
    if (leaf.count < leaf.room) state_.samples[leaf.first_sample + leaf.count] = light_sample;
    ++leaf.count;
}

void GuidingTest::random_frame(Dice& dice, const InnerNodes& inner, const RandomLights& lights) {
    state_ = random_samples(dice, inner, lights, settings_, guiding().header());
    frame();
}

void GuidingTest::upload() {
    const vkpt::Guiding::Tree& tree = guiding().tree();
    const TreeWords words = encode(state_, guiding().header().node_capacity, garbage_);
    gpu::upload_now(device(), tree.nodes, 0, gpu::bytes_of(words.nodes));
    gpu::upload_now(device(), tree.cells, 0, gpu::bytes_of(words.cells));
    gpu::upload_now(device(), tree.leaves, 0, gpu::bytes_of(words.leaves));
    gpu::upload_now(device(), guiding().samples(), 0, gpu::bytes_of(state_.samples));
    gpu::upload_now(device(), tree.caches, 0, gpu::bytes_of(state_.caches));
    if (cdq_bits_ > 0) gpu::upload_now(device(), guiding().rays(), 0, gpu::bytes_of(state_.rays));
}

void GuidingTest::run_passes(std::span<const glm::vec3> places) {
    record_passes(0, appears_ ? vkpt::Change::NewLights : vkpt::Change::Something, places);
    appeared_ = appears_;
    shared->slots[0].finish();
    statistics_ = guiding().statistics(0);
}

void GuidingTest::ask_oracle() {
    const shader::GuidingHeader& header = guiding().header();
    ByPath<uint32_t> counts;
    ByPath<LeafSamples> samples;
    for (const auto& [path, leaf] : state_.leaves) {
        counts[path] = leaf.count;
        samples[path] = {std::span(state_.samples).subspan(leaf.first_sample, leaf.kept()),
                         leaf.count,
                         leaf.buckets,
                         leaf.cached,
                         leaf.inherited,
                         leaf.explored,
                         leaf.drawn};
    }
    tree_ = adapt(
        state_.inner, counts,
        {settings_.split, settings_.collapse, header.node_capacity, shader::OCTREE_MAX_DEPTH});
    caches_ = make_caches(state_.inner, samples,
                          {settings_.bucket, settings_.small_bucket, settings_.merge_faces,
                           header.vlc_most, settings_.weigh != 0, settings_.persist, appeared_});
    if (cdq_bits_ == 0) return;
    quadtrees_.clear();
    shares_.clear();
    for (const auto& [path, node] : state_.nodes) {
        const bool learns = settings_.adapt_share != 0;
        const float share = learns && node.shared.rays > 0.0 ? static_cast<float>(node.shared.share)
                                                             : settings_.first_share;
        QuadtreeLessons lessons = state_.lessons_of(node);
        QuadtreeLimits limits{settings_.migrations, settings_.margin,
                              shader::cdq_even_density(cdq_bits_, 1.0f - share)};
        if (lessons.rays() > 0) {
            limits.memory = settings_.memory_rays;
            if (remember()) lessons.remembered = node.remembered;
            if (learns)
                shares_[path] = adapt_share(node.shared, lessons, settings_.memory_rays,
                                            static_cast<double>(settings_.first_share));
        } else {
            limits.migrations = 0;
        }
        quadtrees_[path] = adapt_quadtree(node.quadtree, lessons, limits);
    }
}

void GuidingTest::compare_with(const vkpt::Guiding::Tree& old_tree) {
    const shader::GuidingHeader& header = guiding().header();
    ASSERT_NE(&guiding().tree(), &old_tree);
    const TreeWords seen_old = download(old_tree, header.node_capacity);
    const TreeWords seen = download(guiding().tree(), header.node_capacity);
    const std::vector<uint32_t> lights = download(guiding().vlc_lights(), header.vlc_capacity);

    for (const Disagreements& found :
         {compare_tree(tree_, state_.inner, seen),
          compare_storage(tree_.inner, seen, header.sample_capacity),
          compare_caches(caches_, seen_old, state_.inner, lights, settings_.bucket),
          compare_handed_on(tree_, caches_, seen, state_.inner, seen_old),
          compare_statistics(state_, tree_, caches_, statistics_)})
        ASSERT_TRUE(found.empty()) << found.text();
    if (cdq_bits_ > 0) {
        for (const Disagreements& found :
             {compare_quadtrees(state_, quadtrees_, cdq_bits_, remember(), seen_old, statistics_),
              compare_shares(state_, shares_, seen_old, statistics_),
              compare_ray_storage(tree_.inner, seen, header.ray_capacity),
              compare_guides_handed_on(tree_, seen, state_.inner, seen_old, remember())})
            ASSERT_TRUE(found.empty()) << found.text();
    }
    std::vector<uint32_t> rays = std::move(state_.rays);
    state_ = state_after(tree_, caches_, seen, std::move(state_.samples), lights, settings_.bucket);
    if (cdq_bits_ > 0) take_quadtrees(state_, seen, cdq_bits_, remember(), std::move(rays));
}

void GuidingTest::frame() {
    ++frame_;
    SCOPED_TRACE(testing::Message() << "frame " << frame_);
    ask_oracle();
    const vkpt::Guiding::Tree& old_tree = guiding().tree();
    upload();
    run_passes();
    compare_with(old_tree);
}

void GuidingTest::two_frames_in_flight() {
    frame_ += 2;
    SCOPED_TRACE(testing::Message() << "frames " << frame_ - 1 << " and " << frame_);
    ask_oracle();
    upload();
    record_passes(0);
    const vkpt::Guiding::Tree& between = guiding().tree();
    record_passes(1);
    shared->slots[0].finish();
    shared->slots[1].finish();

    // The first frame's caches are gone, its tree and its statistics are not.
    const Disagreements first = compare_statistics(state_, tree_, caches_, guiding().statistics(0));
    ASSERT_TRUE(first.empty()) << first.text();
    const TreeWords seen = download(between, guiding().header().node_capacity);
    state_ =
        state_after(tree_, caches_, seen, std::move(state_.samples),
                    download(between.caches, guiding().header().vlc_capacity), settings_.bucket);
    for (auto& [path, leaf] : state_.leaves)
        leaf.drawn = caches_.by_leaf.at(tree_.source.at(path)).drawn;
    ask_oracle();
    statistics_ = guiding().statistics(1);
    compare_with(between);
}

shader::GuidingSettings settings_with(uint32_t bucket, uint32_t persist) {
    shader::GuidingSettings settings{};
    settings.split = 40;
    settings.collapse = 20;
    settings.bucket = bucket;
    settings.small_bucket = bucket * 3 / 4;
    settings.merge_faces = 0x3f;
    settings.weigh = 1;
    settings.persist = persist;
    settings.first_share = 1.0f;
    return settings;
}

} // namespace vigil::test
