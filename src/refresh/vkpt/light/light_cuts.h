// SPDX-License-Identifier: GPL-2.0-or-later
// Light cuts of all PVS clusters as the GPU reads them (shaders/light/cut_lists.glsl). A cluster's
// cut goes through the tree of the lights in its list, and is fine where they are near. After
// Walter et al., "Lightcuts", 2005, with a cut per cluster instead of one per point. Data only;
// cluster_cuts.h owns the buffers.
#pragma once

#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/light/light_tree.h"
#include "refresh/vkpt/scene/bounds.h"
#include "shared/light_cut.h"

#include <span>
#include <vector>

namespace vigil {

/// What a cluster has of LightCuts, as the GPU reads it.
struct ClusterCut {
    std::uint32_t first = 0, count = 0;             // entries
    std::uint32_t first_light = 0, light_count = 0; // its list's lights in order()
    bool operator==(const ClusterCut&) const = default;
};

class LightCuts {
public:
    /// Lists, and the lights that may be in them: those with ids from `first` on.
    struct Part {
        const LightLists& lists;
        std::uint32_t first;
        /// As they are when lit: what cannot light anything is left out.
        std::span<const shader::Light> lights;
    };
    /// Cuts of at most `size` entries (at least 1) for the lists of a level's clusters and for the
    /// last one, of all lights. Lists that are too long together are replaced by the last one.
    void set_still(const Bsp& bsp, const Part& part, std::uint32_t size);
    /// The same for lights that can move; those that stay are kept. After set_still().
    void set_moving(const Bsp& bsp, const Part& part, std::uint32_t size);
    /// Brings the energies of all groups to those of all lights by id now.
    void set_energies(std::span<const shader::Light> lights);

    /// By list: of the lights that stay, and after all these of those that can move.
    std::span<const ClusterCut> cuts() const { return cuts_; }
    /// Groups with shader::CUT_GROUP, the largest errors first; then runs of single lights
    /// (shader::cut_run), and the sun as the last, if a list has it.
    std::span<const std::uint32_t> entries() const { return entries_; }
    /// Ids of the lights of all lists, each in the order of the tree; and those of runs.
    std::span<const std::uint32_t> order() const { return order_; }
    /// By id: place in the order of the tree; shader::NONE for lights that are in none.
    std::span<const std::uint32_t> places() const { return places_; }
    std::span<const shader::CutGroup> groups() const { return groups_; }

    /// How much of each belongs to lights that stay.
    struct Sizes {
        std::size_t cuts = 0, entries = 0, order = 0, places = 0, groups = 0;
    };
    const Sizes& still() const { return still_; }

private:
    /// A node of the tree with only the lights of one list.
    struct Node {
        Bounds bounds;
        glm::vec3 normal_sum;
        double energy;
        std::uint32_t first, count; // in order_
        std::uint32_t right;        // second child, the first one follows; 0: a light
        std::uint32_t group;        // number in groups_, where there is one
    };

    /// The list's part of the subtree of a node, as nodes_; `places` are the list's lights in it,
    /// of which the first is at `first` of order_.
    void grow(std::uint32_t node, std::span<const std::uint32_t> places, std::uint32_t first);
    /// Adds the entries of a cut through nodes_.
    void cut(const Bounds& cluster, std::uint32_t size);
    /// Adds entries for single lights.
    void add_run(std::span<const std::uint32_t> lights);
    /// The groups of a node of nodes_ and of all its parts.
    void make_groups(std::uint32_t node);

    LightTree tree_;
    std::uint32_t first_id_ = 0; // of the tree's lights
    std::vector<ClusterCut> cuts_;
    std::vector<std::uint32_t> entries_, order_, places_;
    std::vector<shader::CutGroup> groups_;
    std::vector<Node> nodes_; // of the list that is being cut
    Sizes still_;
};

} // namespace vigil
