# SPDX-License-Identifier: GPL-2.0-or-later
"""The faults that the tests must notice: where each is planted, and by which tests it is noticed.

A fault replaces a piece of a file that occurs there once; planted_faults.py --check says which pieces have changed.
Most are of 3 to 5%, as a wrong factor is: what is off by half is seen in any picture. To add one, copy a row; where a
test needs few files, name them with `part`, so that the fault compiles those alone.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Program:
    """A test program: one of the project's, or one of a few files, so that a fault compiles little again."""

    target: str  # what ninja builds
    path: str  # below the build folder
    sources: tuple[str, ...] = ()  # of a program made for faults alone
    libraries: tuple[str, ...] = ()  # that those need
    computes: bool = True  # worth the compiler's time for optimisation
    environment: tuple[tuple[str, str], ...] = ()  # more than the runner's own


def whole(folder, target, **environment):
    return Program(target, f"tests/{folder}/{target}", environment=tuple(environment.items()))


def part(name, *sources, libraries=(), computes=True):
    return Program("fault_" + name, "fault_" + name, sources, libraries, computes)


LIGHT = "src/refresh/vkpt/light/"
SCENE = "src/refresh/vkpt/scene/"

TRIANGLE_LIGHT = part("triangle_light", "tests/light/triangle_light_test.cpp")
SPHERICAL_TRIANGLE = part("spherical_triangle", "tests/light/spherical_triangle_test.cpp")
SAMPLING = part("sampling", "tests/light/sampling_test.cpp")
LIGHT_POINT = part("light_point", "tests/light/light_point_test.cpp", LIGHT + "ltc_table.cpp")
BRDF = part("brdf", "tests/light/brdf_test.cpp")
LTC_TABLE = part("ltc_table", "tests/light/ltc_table_test.cpp", LIGHT + "ltc_table.cpp", libraries=("vigil_ltc_fit",))
FORM_FACTOR = part("form_factor", "tests/light/form_factor_test.cpp")
ALIAS_TABLE = part("alias_table", "tests/light/alias_table_test.cpp", LIGHT + "alias_table.cpp")
EXPLORATION = part("exploration", "tests/light/exploration_test.cpp", LIGHT + "exploration.cpp", LIGHT + "light_changes.cpp",
                   computes=False)
EXPLORE_SHARE = part("explore_share", "tests/light/explore_memory_test.cpp", computes=False)
LIGHT_TREE = part("light_tree", "tests/light/light_tree_test.cpp", LIGHT + "light_tree.cpp", computes=False)
HIERARCHY = part("light_hierarchy", "tests/light/light_hierarchy_test.cpp", "tests/light/light_hierarchy_oracle.cpp",
                 LIGHT + "light_hierarchy.cpp", LIGHT + "light_tree.cpp")
LIGHT_CUTS = part("light_cuts", "tests/light/light_cuts_test.cpp", LIGHT + "light_cuts.cpp", LIGHT + "light_tree.cpp",
                  LIGHT + "ltc_table.cpp", libraries=("vigil_level",), computes=False)
LISTS = part("light_lists", "tests/light/light_lists_test.cpp", "tests/light/list_sight_test.cpp", "tests/light/cluster_margin_test.cpp",
             LIGHT + "light_lists.cpp", LIGHT + "list_sight.cpp", libraries=("vigil_level",), computes=False)
PVS = part("pvs", "tests/level/pvs_test.cpp", "tests/formats/small_level.cpp", "src/level/pvs.cpp",
           libraries=("vigil_formats",), computes=False)
OCTREE_START = part("octree_start", "tests/vkpt/octree_start_test.cpp", "src/refresh/vkpt/guiding/octree_start.cpp",
                    computes=False)
FIRST_PATHS = part("first_paths", "tests/vkpt/first_paths_test.cpp", "src/refresh/vkpt/pathtrace/first_paths.cpp",
                   "src/refresh/vkpt/frame_params.cpp", libraries=("vigil_scene",), computes=False)
LIGHT_SET = part("light_set", "tests/vkpt/light_set_test.cpp", libraries=("vigil_scene",), computes=False)
SKY_WINDOWS = part("sky_windows", "tests/vkpt/sky_windows_test.cpp", SCENE + "sky_windows.cpp",
                   libraries=("vigil_common",))
SKY_LIGHT = part("sky_light", "tests/vkpt/sky_light_test.cpp", "tests/formats/picture_bytes.cpp",
                 libraries=("vigil_scene",), computes=False)
RESERVOIR = part("reservoir", "tests/numerics/reservoir_test.cpp")
DIRECTIONS = part("directions", "tests/numerics/directions_test.cpp")
SOUND = part("sound", "tests/numerics/sound_test.cpp")
LONG_RUNS = part("long_runs", "tests/numerics/time_test.cpp")
CDQ_SAMPLING = part("cdq_sampling", "tests/cdq/sampling_test.cpp", "tests/cdq/quadtree.cpp",
                    "tests/cdq/sphere_cells.cpp")
SUMS = part("sums", "tests/cdq/sums_test.cpp")
QUADTREES = part("quadtrees", "tests/numerics/quadtrees_test.cpp", "tests/cdq/quadtree.cpp")
OCTREE = part("octree", "tests/guiding/octree_maths_test.cpp", "tests/guiding/octree_oracle.cpp", computes=False)
ESTIMATE = part("estimate", "tests/bench/quality_estimate_test.cpp", "tests/bench/trimmed_error_test.cpp",
                "src/bench/quality_estimate.cpp", "src/bench/reference.cpp", libraries=("vigil_common", "vigil_boost"))
REFERENCE = part("reference", "tests/bench/reference_test.cpp", "src/bench/reference.cpp", libraries=("vigil_common",),
                 computes=False)

# Validation takes time, and notices other faults.
GUIDING = whole("guiding", "guiding_passes_test", VIGIL_VALIDATION="0")
GUIDED_DIRECTIONS = whole("guiding", "guiding_directions_test", VIGIL_VALIDATION="0")
ANALYTIC = whole("vkpt", "vkpt_analytic_test", VIGIL_VALIDATION="0")
FILTER = whole("vkpt", "vkpt_filter_test", VIGIL_VALIDATION="0")
TECHNIQUE = whole("vkpt", "vkpt_technique_test", VIGIL_VALIDATION="0")
EXTREMES = whole("vkpt", "vkpt_extremes_test", VIGIL_VALIDATION="0")
CONVERGENCE = whole("vkpt", "vkpt_convergence_test", VIGIL_VALIDATION="0")
VIEWS = whole("vkpt", "vkpt_view_test", VIGIL_VALIDATION="0")
MOVING_LIGHTS = whole("vkpt", "vkpt_moving_lights_test", VIGIL_VALIDATION="0")
ENTITIES = whole("vkpt", "vkpt_entity_test", VIGIL_VALIDATION="0")
# As in ./run test long.
ASSISTED_FRAMES = whole("vkpt", "vkpt_frames_test", VIGIL_VALIDATION="3", GALLIVM_PERF="nopt")


@dataclass(frozen=True)
class Fault:
    name: str
    file: str
    before: str  # occurs once in the file
    after: str
    program: Program
    tests: str  # GoogleTest filter, without exceptions
    quick: bool = False  # no GPU, and few files to compile


FAULTS = [
    # Points on lights: next event estimation's densities and weights.
    Fault("points of near lights weigh 3% too much", "shaders/shared/triangle_light.h",
          "        seen.geometry = near.solid_angle;", "        seen.geometry = 1.03f * near.solid_angle;",
          TRIANGLE_LIGHT, "TriangleLight*", quick=True),
    Fault("pdf off by 1%: points of near lights", "shaders/shared/triangle_light.h",
          "        seen.pdf = 1.0f / near.solid_angle;", "        seen.pdf = 1.01f / near.solid_angle;",
          TRIANGLE_LIGHT, "TriangleLight*"),
    Fault("points of far lights weigh 3% too much", "shaders/shared/triangle_light.h",
          "facing > 0.0f ? 0.5f * facing * inverse", "facing > 0.0f ? 0.515f * facing * inverse",
          TRIANGLE_LIGHT, "TriangleLight*", quick=True),
    Fault("points of near lights gather: 4% fewer at the far end", "shaders/shared/spherical_triangle.h",
          "const float z = 1.0f - u.y * (1.0f - cosine);", "const float z = 1.0f - 0.96f * u.y * (1.0f - cosine);",
          SPHERICAL_TRIANGLE, "SphericalTriangle*"),
    Fault("points of far lights gather: 4% fewer at one corner", "shaders/shared/sampling.h",
          "vec2(u.x - 0.5f * u.y, 0.5f * u.y);", "vec2(u.x - 0.48f * u.y, 0.48f * u.y);", SAMPLING, "Sampling*"),
    Fault("mixture pdf: the lobe's part of a light's points is 4% too small", "shaders/shared/light_point.h",
          "seen.pdf = mix(seen.pdf, visible_reflection_pdf(brdf, normal, view, seen.direction), share);",
          "seen.pdf = mix(seen.pdf, visible_reflection_pdf(brdf, normal, view, seen.direction), 0.96f * share);",
          LIGHT_POINT, "LightPoint*"),
    Fault("4% too few points along the lobe", "shaders/shared/light_point.h",
          "    if (u.x < share) {", "    if (u.x < 0.96f * share) {", LIGHT_POINT, "LightPoint*"),
    Fault("the sun's disc is 3% too large", "shaders/shared/sampling.h",
          "return dot(chord, chord) <= 2.0f * one_minus_cosine;",
          "return dot(chord, chord) <= 2.06f * one_minus_cosine;",
          SAMPLING, "Sampling*"),

    # What surfaces reflect, and where their rays go.
    Fault("the base reflects 3% too much", "shaders/shared/brdf.h",
          "    seen.value = brdf.albedo * (nl * INVERSE_PI);",
          "    seen.value = brdf.albedo * (1.03f * nl * INVERSE_PI);",
          BRDF, "Brdf*"),
    Fault("the coat reflects 4% too little", "shaders/shared/brdf.h",
          "float specular = 0.5f * fresnel", "float specular = 0.48f * fresnel", LTC_TABLE, "LtcTable.Albedos*"),
    Fault("the coat reflects 4% too much", "shaders/shared/brdf.h",
          "float specular = 0.5f * fresnel", "float specular = 0.52f * fresnel", BRDF, "Brdf*"),
    Fault("pdf off by 1%: the cosine lobe", "shaders/shared/brdf.h",
          "    seen.pdf = nl * INVERSE_PI;", "    seen.pdf = 1.01f * nl * INVERSE_PI;", BRDF, "Brdf*"),
    Fault("pdf off by 3%: the coat's facets", "shaders/shared/brdf.h",
          "float visible_normals = 0.5f * distribution", "float visible_normals = 0.515f * distribution",
          BRDF, "Brdf*"),
    Fault("4% too few rays from the coat", "shaders/shared/brdf.h",
          "specular = u.z < specular_probability(brdf, brdf_cosine(normal, v));",
          "specular = u.z < 0.96f * specular_probability(brdf, brdf_cosine(normal, v));", BRDF, "Brdf*"),
    Fault("a red light counts 4% more when lights are chosen", "shaders/shared/brdf.h",
          "vec3(0.2126f, 0.7152f, 0.0722f)", "vec3(0.2526f, 0.7152f, 0.0722f)", LIGHT_TREE, "LightPower*"),
    Fault("a missing horizon clip", "shaders/shared/ltc.h",
          "bool clipped = min(height.x, min(height.y, height.z)) < 0.0f;", "bool clipped = false;",
          FORM_FACTOR, "FormFactor*"),
    Fault("a highlight's importance loses 5%", "shaders/shared/ltc.h",
          "surface.specular = brdf.f0 * entry.albedo.x + entry.albedo.y;",
          "surface.specular = 0.95f * (brdf.f0 * entry.albedo.x + entry.albedo.y);", LTC_TABLE, "LtcTable*"),

    # Choosing among lights.
    Fault("a walk past lights keeps each newcomer 3% too often", "shaders/shared/reservoir.h",
          "if (reservoir.u < share) {", "if (reservoir.u < 1.03f * share) {", RESERVOIR, "Reservoir*"),
    Fault("pdf off by 1%: directions of quadtrees", "shaders/shared/cdq.h",
          "float(cdq_leaf_count(bits)) * octahedral_density(direction);",
          "float(cdq_leaf_count(bits)) * (1.01f * octahedral_density(direction));", CDQ_SAMPLING, "*Sampling*"),
    Fault("mixture pdf: the part beside the guider is 4% too small", "shaders/shared/guiding_types.h",
          "return mix(guided, other, other_part);",
          "return mix(guided, other, 0.96f * other_part);",
          QUADTREES, "Quadtrees.SharesOfZeroAndOne"),
    Fault("3% too few draws of a quadtree's last leaves", "shaders/shared/cdq.h",
          "min(uint(u.x * float(leaves)), leaves - 1u)", "min(uint(0.97f * u.x * float(leaves)), leaves - 1u)",
          CDQ_SAMPLING, "*Sampling*"),
    Fault("pdf off by 1%: the octahedral map", "shaders/shared/octahedral.h",
          "return 0.25f / (sum * sum * sum);", "return 0.2525f / (sum * sum * sum);", DIRECTIONS, "Directions*"),

    # Tables of lights, made on the host.
    Fault("alias table: columns are filled up 3% too little", "src/refresh/vkpt/light/alias_table.cpp",
          "share[l] -= 1.0 - share[s];", "share[l] -= 0.97 - share[s];", ALIAS_TABLE, "AliasTable*", quick=True),
    Fault("alias table: densities 3% too high", "src/refresh/vkpt/light/alias_table.cpp",
          "table[i].pdf = static_cast<float>(mass[i] * unit);",
          "table[i].pdf = static_cast<float>(1.03 * mass[i] * unit);", ALIAS_TABLE, "AliasTable*", quick=True),
    Fault("a carry is lost in the alias table", "shaders/shared/alias_table.h",
          "slot.column = high_integer + carry;", "slot.column = high_integer;", ALIAS_TABLE, "AliasTable*", quick=True),
    Fault("exploration: a light's area counts 4% more", "src/refresh/vkpt/light/exploration.cpp",
          "        energy[i] = light_power(lights[i]);",
          "        energy[i] = light_power(lights[i]) * std::pow(shader::light_area(lights[i]), 0.03f);",
          EXPLORATION, "Exploration*", quick=True),
    Fault("exploration: light near the camera falls off too slowly", "src/refresh/vkpt/light/exploration.cpp",
          "std::max(glm::dot(offset, offset) + shader::light_area(light), 1e-20f);",
          "std::max(std::pow(glm::dot(offset, offset), 0.97f) + shader::light_area(light), 1e-20f);",
          EXPLORATION, "Exploration*", quick=True),
    Fault("exploration: 4% of the draws are lost", "src/refresh/vkpt/light/exploration.cpp",
          "(1.0 - even) * sum[i] / blended", "(0.96 - even) * sum[i] / blended", EXPLORATION, "Exploration*",
          quick=True),
    Fault("exploring caches: the odds of lists are 4% too high", "shaders/shared/guiding_types.h",
          "const float odds = sqrt(memory.found);", "const float odds = 1.04f * sqrt(memory.found);",
          EXPLORE_SHARE, "ExploreShare*", quick=True),
    Fault("light tree: a node's energy lacks 4% of its lights'", "src/refresh/vkpt/light/light_tree.cpp",
          "    float energy() const { return sum[3]; }", "    float energy() const { return 0.96f * sum[3]; }",
          LIGHT_TREE, "*LightTree*", quick=True),
    Fault("light tree: a light's energy is off by its size", "src/refresh/vkpt/light/light_tree.cpp",
          "result.energy = std::max(light_power(light), 1e-30f);",
          "result.energy = std::max(std::pow(light_power(light), 0.99f), 1e-30f);",
          LIGHT_TREE, "*LightTree*", quick=True),
    Fault("light hierarchy: energies are rounded down", "src/refresh/vkpt/light/light_hierarchy.cpp",
          "(bits + (1 << 20) - (std::int64_t{64} << 23)) >> 21", "(bits - (std::int64_t{64} << 23)) >> 21",
          HIERARCHY, "LightHierarchy.Energies*"),
    Fault("light hierarchy: boxes half a step too small", "src/refresh/vkpt/light/light_hierarchy.cpp",
          "static_cast<std::uint8_t>(std::ceil(2.0 * half));", "static_cast<std::uint8_t>(std::floor(2.0 * half));",
          HIERARCHY, "*HoldsItsLights*"),
    Fault("light hierarchy: cones 5% too narrow", "src/refresh/vkpt/light/light_hierarchy.cpp",
          "std::ceil(widest * 127.0f * 1.02f + 0.5f)", "std::ceil(widest * 127.0f * 0.97f)",
          HIERARCHY, "*HoldsItsLights*"),
    Fault("light hierarchy: 5% of a far child's weight go to its neighbour", "shaders/shared/light_hierarchy.h",
          "    light_node_pass(choice, 1u, group.y, below, target);",
          "    light_node_pass(choice, 1u, group.y, 0.95f * below, target);", HIERARCHY, "LightHierarchy.Draws*"),
    Fault("light cuts: a large group has the energy of one half", "src/refresh/vkpt/light/light_cuts.cpp",
          "groups_[i + 1].energy + groups_[groups_[i + 1].next].energy", "groups_[i + 1].energy",
          LIGHT_CUTS, "LightCuts.Groups*", quick=True),
    Fault("light cuts: a group's lights are all said to face its axis", "shaders/shared/light_cut.h",
          "facing + facing_reach + group.spread * across <= -slack", "facing + facing_reach <= -slack",
          LIGHT_CUTS, "LightCuts.WeighNothing*", quick=True),
    Fault("light cuts: a quarter of the entries asked for", "src/refresh/vkpt/light/light_cuts.cpp",
          "> size + 1) {", "> size / 4 + 1) {",
          LIGHT_CUTS, "LightCuts.HaveNoGroups*", quick=True),
    Fault("light cuts: the width of a group is the same for every lobe", "shaders/shared/light_cut.h",
          "if (most > CUT_GLINT * weight.importance) weight.width", "if (most > 1e38f) weight.width",
          LIGHT_CUTS, "*NearlyAsGood*", quick=True),
    Fault("light cuts: a lobe is said to be brightest at the middle of a group", "shaders/shared/light_cut.h",
          "float x = max(abs(middle.x) - reach.x, 0.0f);", "float x = abs(middle.x);",
          LIGHT_CUTS, "*MostOfALobe*", quick=True),

    # Lights and clusters that may see each other.
    Fault("a light that reaches into several clusters is missing from one's list",
          "src/refresh/vkpt/light/light_lists.cpp", "    sort_unique(clusters);",
          "    sort_unique(clusters);\n    if (clusters.size() > 1) clusters.pop_back();",
          LISTS, "ClustersTouched*:LightLists.FollowThePvs", quick=True),
    Fault("sight goes one way only", "src/refresh/vkpt/light/light_lists.cpp",
          "            add(b, a, upper);", "            if (a == b) add(b, a, upper);",
          LISTS, "LightLists.SightGoesBothWays*", quick=True),
    Fault("a cluster that shares its list with others gets none", "src/refresh/vkpt/light/light_lists.cpp",
          "        lists.ranges[c] = lists.ranges[owner[groups.group_of(c)]];",
          "        if (owner[groups.group_of(c)] == c) lists.ranges[c] = lists.ranges[c];",
          LISTS, "LightLists.FollowThePvs", quick=True),
    Fault("clusters that begin a unit in front of a light are taken for behind it",
          "src/refresh/vkpt/light/light_lists.cpp",
          "constexpr float box_margin = 2.0f;", "constexpr float box_margin = 1.0f;", LISTS, "LightsBeside*",
          quick=True),
    Fault("a lamp on a cluster's border is listed on one side only", "src/refresh/vkpt/light/light_lists.cpp",
          "            if (front && back) stack.push_back({node.children[1], visit.polygon});",
          "            if (false) stack.push_back({node.children[1], visit.polygon});", LISTS, "ClustersTouched*",
          quick=True),
    Fault("the PVS loses its last cluster", "src/level/pvs.cpp",
          "~uint64_t{0} >> (words_ * 64 - cluster_count_);", "(~uint64_t{0} >> (words_ * 64 - cluster_count_)) >> 1;",
          PVS, "Pvs*"),
    Fault("a cluster of a damaged PVS does not see itself", "src/level/pvs.cpp",
          "        set_bit(row, cluster);", "        set_bit(row, cluster == 0 ? 0 : cluster - 1);", PVS, "Pvs*"),

    # Arithmetic at its limits.
    Fault("off by one in a shift: octree paths", "shaders/shared/octree.h",
          "const uint shift = OCTREE_MAX_DEPTH - 1u - depth;", "const uint shift = OCTREE_MAX_DEPTH - depth;",
          OCTREE, "Octree*"),
    Fault("infinity passes the firewall", "shaders/shared/firewall.h",
          "bits <= 0x7f7fffffu", "bits <= 0x7f800000u", SOUND, "Firewall*"),
    Fault("random streams repeat after 2^30 paths", "shaders/shared/random.h",
          "(path.y << 2u) | (path.x >> 30u);", "0u * path.y;", LONG_RUNS, "LongRuns*"),
    Fault("the running mean forgets what it rounds away", "shaders/shared/running_mean.h",
          "    carry = rest;", "    carry = 0.0f * rest;", LONG_RUNS, "LongRuns*"),

    # The benchmark's statistics.
    Fault("variance over n in place of n - 1", "src/bench/quality_estimate.cpp",
          "return sum / static_cast<double>(values.size() - 1);", "return sum / static_cast<double>(values.size());",
          ESTIMATE, "RatioOverViews*", quick=True),
    Fault("intervals 3% too narrow", "src/bench/quality_estimate.cpp",
          "student_t_quantile(upper, views - 1.0) * std::sqrt(variance(logarithms) / views);",
          "0.97 * student_t_quantile(upper, views - 1.0) * std::sqrt(variance(logarithms) / views);",
          ESTIMATE, "RatioOverViews*", quick=True),
    Fault("one degree of freedom too many", "src/bench/quality_estimate.cpp",
          "student_t_quantile(upper, views - 1.0) * std::sqrt(variance(logarithms) / views);",
          "student_t_quantile(upper, views) * std::sqrt(variance(logarithms) / views);",
          ESTIMATE, "RatioOverViews*"),
    Fault("intervals of 94% in place of 95%", "src/bench/quality_estimate.cpp",
          "constexpr double upper = 1.0 - 0.5 * false_share;", "constexpr double upper = 1.0 - 0.6 * false_share;",
          ESTIMATE, "RatioOverViews*"),
    Fault("Student's t 3% too low", "src/bench/quality_estimate.cpp",
          "return quantile(boost::math::students_t(degrees), probability);",
          "return 0.97 * quantile(boost::math::students_t(degrees), probability);", ESTIMATE, "StudentT*", quick=True),
    Fault("a median's interval misses 5% on each side", "src/bench/quality_estimate.cpp",
          "tail_below(count, rank + 1) <= 0.5 * false_share", "tail_below(count, rank + 1) <= false_share",
          ESTIMATE, "MedianInterval*"),
    Fault("a comparison stands out as if there were one fewer", "src/bench/quality_estimate.cpp",
          "const auto left = static_cast<double>(order.size() - done);",
          "const auto left = static_cast<double>(order.size() - done - (done > 0 ? 1 : 0));", ESTIMATE, "StandsOut*"),
    Fault("a sign test's chance is 5% too low", "src/bench/quality_estimate.cpp",
          "std::min(1.0, 2.0 * tail_below(", "std::min(1.0, 1.9 * tail_below(", ESTIMATE, "TypicalRatio*"),
    Fault("the trimmed share is half as large again", "src/bench/quality_estimate.h",
          "inline constexpr double trimmed_share = 0.001;", "inline constexpr double trimmed_share = 0.0015;",
          ESTIMATE, "TrimmedError*"),
    Fault("4% of the reference's variance stay in the trimmed error", "src/bench/quality_estimate.cpp",
          "error.trimmed_mse += distances[pixel] - variances[pixel];",
          "error.trimmed_mse += distances[pixel] - 0.96 * variances[pixel];", ESTIMATE, "TrimmedError*"),
    Fault("4% of the reference's variance stay in the error", "src/bench/quality_estimate.cpp",
          "const double square = difference * difference - variance;",
          "const double square = difference * difference - 0.96 * variance;", ESTIMATE, "TrimmedError*", quick=True),
    Fault("a reference's variance over n in place of n - 1", "src/bench/reference.h",
          "return squares_[i] / (count * (count - 1.0));", "return squares_[i] / (count * count);",
          REFERENCE, "Reference*"),

    # On the GPU: next event estimation.
    Fault("the points looked at on a light weigh 3% too much together", "shaders/pathtrace/next_event.glsl",
          "choice.value *= reservoir.sum / (reservoir.chosen_importance * float(points));",
          "choice.value *= 1.03 * reservoir.sum / (reservoir.chosen_importance * float(points));",
          ANALYTIC, "Analytic.SquareLampOverAFloor"),
    Fault("direct light lacks 3%", "shaders/pathtrace/direct.comp", "    add_radiance(index, light.radiance, false);",
          "    add_radiance(index, 0.97 * light.radiance, false);", ANALYTIC, "Analytic.SquareLampOverAFloor"),
    Fault("direct light lacks 3% beside brute force", "shaders/pathtrace/direct.comp",
          "    add_radiance(index, light.radiance, false);", "    add_radiance(index, 0.97 * light.radiance, false);",
          CONVERGENCE, "Convergence.RoomWithManyLamps"),
    Fault("the map of directions is 2% too bright", "shaders/debug/direction_map.comp",
          "return finite_or_zero(luminance(brought) / octahedral_density(direction));",
          "return finite_or_zero(1.02 * luminance(brought) / octahedral_density(direction));",
          VIEWS, "DirectionsView.FurnaceIsEvenAboveTheHorizon"),
    Fault("what the map of directions gathers lacks 5%", "shaders/debug/direction_map.comp",
          "        gathered += throughput * (depth", "        gathered += 0.95 * throughput * (depth",
          VIEWS, "DirectionsView.MapHoldsWhatIndirectRaysBring"),
    Fault("a torch is 4% too bright", "src/refresh/vkpt/scene/scene.cpp",
          "add_model(*spot_model_, transform, spot.radiance,", "add_model(*spot_model_, transform, 1.04f * spot.radiance,",
          MOVING_LIGHTS, "MovingLights.SpotsShineWithinTheirCone"),
    Fault("what moves is not copied to the device", "src/refresh/vkpt/scene/scene.cpp",
          "    instances_changed_ |= moved;", "    instances_changed_ |= false;",
          ENTITIES, "*StillTest.WhatChangesIsCopiedInItsFrame/bvh"),
    Fault("the top level stays where things were", "src/refresh/vkpt/scene/scene.cpp",
          "        top_changed_ = true;", "        top_changed_ = false;",
          ENTITIES, "*StillTest.WhatChangesIsCopiedInItsFrame/bvh"),
    Fault("a drawn light weighs 3% too much", "shaders/light/technique.glsl",
          "light == NONE ? 0.0 : 1.0 / probability", "light == NONE ? 0.0 : 1.03 / probability",
          TECHNIQUE, "*KeepsItsPromises/uniform_Default"),
    Fault("ris: a drawn light weighs 3% too much", "shaders/light/ris.glsl",
          "walk.sum / (float(count) * importance)", "1.03 * walk.sum / (float(count) * importance)",
          ANALYTIC, "Analytic.SquareLampOverAFloor:Analytic.WhiteFurnaceByTechniques"),
    Fault("sll: the last walks of a long list are 4% too rare", "shaders/light/sll.glsl",
          "candidates.first = draw_index(u.x, candidates.stride);",
          "candidates.first = draw_index(0.96 * u.x, candidates.stride);",
          TECHNIQUE, "*KeepsItsPromises/sll_FourAtMost"),
    Fault("lh: each step to a child counts 1% too likely", "shaders/light/lh.glsl",
          "        probability *= share;", "        probability *= 1.01 * share;",
          TECHNIQUE, "*KeepsItsPromises/lh_Default"),
    Fault("cut: a light of a group counts 4% too likely", "shaders/light/cut_draw.glsl",
          "CutDraw(draw.light, probability * draw.probability, ", "CutDraw(draw.light, 1.04 * probability * draw.probability, ",
          TECHNIQUE, "*KeepsItsPromises/cut_FourEntries"),
    Fault("cut: a run of lights lacks its last one", "shaders/light/cut_draw.glsl",
          "if (within < cut_run_count(run)) continue;", "if (within + 1u < cut_run_count(run)) continue;",
          TECHNIQUE, "*KeepsItsPromises/cut_*"),
    Fault("mixture of vlc: 4% too few draws from the cache", "shaders/light/vlc.glsl",
          "u.x - shares.cache; // below 0: the cache", "u.x - 0.96 * shares.cache; // below 0: the cache", TECHNIQUE, "*KeepsItsPromises/vlc_FourAtMostWithoutLists"),
    Fault("what vlc draws beside the cache is drawn 4% too rarely", "shaders/pathtrace/next_event.glsl",
          "!(subgroup_number(vertex) < wanted)", "!(subgroup_number(vertex) < 0.96 * wanted)",
          EXTREMES, "Extremes.CachesThatKnowNothing"),
    Fault("vlc: the table keeps lights that the cache has", "shaders/light/vlc.glsl",
          "if (probability > 0.0 && !(beside > 0.0 && cached)) choice", "if (probability > 0.0) choice",
          TECHNIQUE, "*KeepsItsPromises/vlc_Default"),
    Fault("mixture of vlc: cuts count 3% too likely", "shaders/light/vlc.glsl",
          "probability = shares.cut * draw.probability;", "probability = 1.03 * shares.cut * draw.probability;",
          TECHNIQUE, "*KeepsItsPromises/vlc_Default"),
    Fault("vlc: buckets count 3% too likely", "shaders/light/vlc.glsl",
          "? shares.cache * bucket_probability(", "? 1.03 * shares.cache * bucket_probability(",
          TECHNIQUE, "*KeepsItsPromises/vlc_FourAtMost"),
    Fault("vlc: the last bucket is drawn 4% too rarely", "shaders/light/vlc.glsl",
          "draw_bucket(search.cache, u.y) :", "draw_bucket(search.cache, 0.96 * u.y) :",
          TECHNIQUE, "*KeepsItsPromises/vlc_FourAtMost"),
    Fault("caches: what buckets bring is 3% too much", "shaders/guiding/vlc_deduplicate.comp",
          "const float unit = probability * exp2(", "const float unit = 1.03 * probability * exp2(",
          GUIDING, "GuidingTest.RandomTreesOfAllSizes"),
    Fault("caches: a light that appeared counts as one that caches lack", "shaders/guiding/vlc_deduplicate.comp",
          "if (settings.appeared == 0u) draws", "draws", GUIDING, "GuidingTest.LightsThatAppearDoNotTellWhatCachesLack"),
    Fault("caches: joined buckets count as one", "shaders/guiding/vlc_merge.comp",
          "        memory.root += part.root;", "        memory.root = part.root;",
          GUIDING, "GuidingTest.RandomTreesOfAllSizes"),
    Fault("caches: a leaf may fill twice its part of the buffer", "shaders/guiding/vlc_merge.comp",
          "const uint quota = header.vlc_most /", "const uint quota = 2u * header.vlc_most /",
          GUIDING, "GuidingTest.TheBufferOfCachesIsShared"),
    Fault("mixture of vlc: the table counts 5% too unlikely", "shaders/light/vlc.glsl",
          "probability += shares.table * alias_probability(light)", "probability += 0.95 * shares.table * alias_probability(light)",
          TECHNIQUE, "*KeepsItsPromises/vlc_FourAtMostWithoutLists"),
    Fault("vlc: the probability of a cut's light forgets the cache", "shaders/light/vlc.glsl",
          "    left_out = search.cache;", "    if (sought == NONE) left_out = search.cache;",
          TECHNIQUE, "*KeepsItsPromises/vlc_Default"),
    Fault("vlc without caches: draws count 3% too likely", "shaders/light/vlc.glsl",
          "return light_choice(draw.light, draw.probability)", "return light_choice(draw.light, 1.03 * draw.probability)",
          TECHNIQUE, "*KeepsItsPromises/vlc_CutsAlone"),
    Fault("lights behind walls count as in sight", "src/refresh/vkpt/light/list_sight.cpp",
          "if (is_clear_line(bsp,", "if (all > 0.0 || is_clear_line(bsp,", LISTS, "PartInSight.IsThatOfThePlacesDraws"),
    Fault("the first paths end where the camera looks", "src/refresh/vkpt/pathtrace/first_paths.cpp",
          "bounce <= bounces", "bounce < 1", FIRST_PATHS, "FirstPaths.GoOnFromWhatTheyMeet"),
    Fault("the first paths go on into the wall", "src/refresh/vkpt/pathtrace/first_paths.cpp",
          "shader::make_basis(normal)", "shader::make_basis(-normal)", FIRST_PATHS, "FirstPaths.GoOnFromWhatTheyMeet"),
    Fault("the first paths take the sky for a surface", "src/refresh/vkpt/pathtrace/first_paths.cpp",
          "flags & SURF_SKY) != 0", "flags & SURF_SKY) > SURF_SKY", FIRST_PATHS, "FirstPaths.EndInTheSky"),
    Fault("the first octree splits leaves that expect half as much", "src/refresh/vkpt/guiding/octree_start.cpp",
          "samples > needs.split", "2.0 * samples > needs.split", OCTREE_START, "OctreeStart.IsFineWhereSamplesAreExpected"),
    Fault("places do not reach the first octree", "src/refresh/vkpt/guiding/guiding.cpp",
          "options_.start_fine ? places", "!options_.start_fine ? places", GUIDING, "GuidingFrames.TheFirstTreeFollowsThePlaces"),
    Fault("the leaves of the first octree expect nothing", "src/refresh/vkpt/guiding/guiding.cpp",
          "words = start.leaf_counts;", "words.assign(words.size(), 0);", GUIDING, "GuidingFrames.TheFirstTreeFollowsThePlaces"),
    Fault("guiding learns from each frame", "src/refresh/vkpt/guiding/guiding.cpp",
          "frames_ % turn_ == 0", "turn_ > 0", ENTITIES, "*StillTest.LearningTakesTurns/bvh"),
    Fault("guiding takes turns where surfaces are new", "src/refresh/vkpt/guiding/guiding.cpp",
          "if (unexpected > 0)", "if (unexpected > samples_per_unexpected * work.samples)", ENTITIES,
          "*StillTest.LearningTakesTurns/bvh"),
    Fault("all frames are guided while lights move", "src/refresh/vkpt/guiding/guiding.cpp",
          "if (age_ < guide_frames)", "if (frames_ < guide_frames)", ENTITIES, "*StillTest.GuidersThatGainTooLittleDrawFewRays/bvh"),
    Fault("a light of every cluster's list is left out", "shaders/light/light_list.glsl",
          "LightList(cluster, range.x, range.y, 0u, range.y)",
          "LightList(cluster, range.x, max(range.y, 1u) - 1u, 0u, max(range.y, 1u) - 1u)",
          TECHNIQUE, "*KeepsItsPromises/sll_Default"),
    Fault("the first light that moves is in no list", "src/refresh/vkpt/light/cluster_lists.cpp",
          "for (uint32_t id = lights.static_count(); id < lights.lights().size(); ++id) {",
          "for (uint32_t id = lights.static_count() + 8; id < lights.lights().size(); ++id) {",
          TECHNIQUE, "*KeepsItsPromises/sll_Default"),

    # On the GPU: rays.
    Fault("a ray's weight is 3% too high", "shaders/pathtrace/indirect_ray.glsl",
          "    weight = finite_or_zero(seen.value / seen.pdf);", "    weight = 1.03 * finite_or_zero(seen.value / seen.pdf);",
          ANALYTIC, "Analytic.WhiteFurnaceByBruteForceIsExact"),
    Fault("the throughput lacks 3% from the second ray on", "shaders/pathtrace/indirect.comp",
          "        throughput *= weight;", "        throughput *= depth == 0 ? weight : 0.97 * weight;",
          ANALYTIC, "Analytic.WhiteFurnaceByBruteForceIsExact"),
    Fault("tails: what rays that only teach find counts, too", "shaders/pathtrace/indirect.comp",
          "counts = depth < bounces || lit_ends == bounces;", "counts = true;", ANALYTIC, "Analytic.TailsInAFurnaceAreAllBounces"),
    Fault("tails: they are 5% too bright", "shaders/pathtrace/indirect_ray.glsl",
          "finite_or_zero(memory.mean *", "finite_or_zero(1.05 * memory.mean *", ANALYTIC, "Analytic.TailsInAFurnaceAreAllBounces"),
    Fault("tails: rays that bring nothing are forgotten", "shaders/guiding/guide_adapt.comp",
          "* counts.x / (counts.x + counts.y)", "", ANALYTIC, "Analytic.TailsInAFurnaceAreAllBounces"),
    Fault("tails: a part of a leaf that is split believes the leaf's mean", "shaders/shared/guiding_types.h",
          "memory.rays = min(memory.rays, TAIL_DOUBT);", "memory.rays = min(memory.rays, TAIL_RAYS);", SUMS, "Tail.*"),
    Fault("an even sky is 3% too bright", "shaders/pathtrace/sky.glsl",
          "    vec3 value = frame.sky_radiance;", "    vec3 value = 1.03 * frame.sky_radiance;",
          ANALYTIC, "Analytic.EvenSkyOverACourt"),
    Fault("the sun is 5% too bright for rays that find it", "shaders/pathtrace/sky.glsl",
          "(meets_sun(direction) ? frame.sun_radiance : vec3(0.0))",
          "(meets_sun(direction) ? 1.05 * frame.sun_radiance : vec3(0.0))", ANALYTIC, "Analytic.SunOverACourt"),
    Fault("light where rays end lacks 4%", "shaders/pathtrace/indirect_ray.glsl",
          "end.brought += direct.radiance;", "end.brought += 0.96 * direct.radiance;",
          ANALYTIC, "Analytic.WhiteFurnaceWhereRaysEnd"),
    Fault("mixture of rays: the BRDF's part counts 4% too unlikely", "shaders/pathtrace/indirect_ray.glsl",
          "guide_mixture_pdf(density, value.pdf, 1.0 - share)",
          "guide_mixture_pdf(density, value.pdf, 0.96 * (1.0 - share))",
          ANALYTIC, "Analytic.WhiteFurnaceByGuidedRays"),
    Fault("guiders: what rays of the BRDF estimated counts 5% too little", "shaders/guiding/guide_adapt.comp",
          "vec3(1.0 - part, part,", "vec3(0.95 * (1.0 - part), part,",
          GUIDED_DIRECTIONS, "*SharesFollowWhatRaysEstimated/0"),
    Fault("guiders: what rays of the BRDF alone would estimate counts 5% too little", "shaders/guiding/guide_adapt.comp",
          "(1.0 - used) / max(1.0 - part, 1e-3)", "0.95 * (1.0 - used) / max(1.0 - part, 1e-3)",
          GUIDED_DIRECTIONS, "*SharesFollowWhatRaysEstimated/0"),
    Fault("quadtrees: the parts of a split leaf have 4% too little", "shaders/guiding/cdq.glsl",
          "0.25 * sum_of(leaf)", "0.24 * sum_of(leaf)", GUIDED_DIRECTIONS, "*WithMemory/0"),
    Fault("guiders: a new node remembers the sums of the leaf that it was", "shaders/guiding/octree_augment.comp",
          "? share_of_part(share) : share", "? share : share", GUIDED_DIRECTIONS, "*SharesFollowWhatRaysEstimated/0"),
    Fault("guiders: a lobe's density is 4% too large", "shaders/guiding/lobe.glsl",
          "return (guide.power + 1.0) / (4.0 * PI)", "return 1.04 * (guide.power + 1.0) / (4.0 * PI)",
          ANALYTIC, "Analytic.WhiteFurnaceByGuidedRays"),
    Fault("mixture of rays: 4% too many by the guider", "shaders/pathtrace/indirect_ray.glsl",
          "float(count)) < share)", "float(count)) < 1.04 * share)",
          ANALYTIC, "Analytic.WhiteFurnaceByGuidedRays"),
    Fault("guided rays: their density is 4% too large", "shaders/pathtrace/indirect_ray.glsl",
          "float(count) * kept / sum : 0.0;", "1.04 * float(count) * kept / sum : 0.0;",
          ANALYTIC, "Analytic.WhiteFurnaceByGuidedRays"),

    # The filter.
    Fault("filtered surfaces lack 4% of their light", "shaders/filter/filter_compose.comp",
          "* (light.direct + light.indirect);", "* 0.96 * (light.direct + light.indirect);", FILTER,
          "Filter.MakesACalmPictureOfTheSameLight"),
    Fault("filter: surfaces are known by their place in the list", "shaders/filter/filter_temporal.comp",
          "load_instance(hit.instance).entity + 1u", "hit.instance", FILTER, "Filter.AModelKeepsItsPastWhateverComesBeforeItInTheList"),
    Fault("pixels that trace no indirect light in a frame count as dark in 4% of one", "shaders/filter/filter_temporal.comp",
          "traced || asks ? 1.0 : 0.0", "traced || asks ? 1.0 : 0.04", FILTER, "Filter.HalfOfTheIndirectLightHasTheMeanOfAll"),
    Fault("raw pictures, too, trace half of the indirect light", "src/refresh/vkpt/renderer.cpp",
          "filtered ? filter_.indirect_turn() : shader::INDIRECT_ALL", "filter_.indirect_turn()", FILTER,
          "Filter.LeavesTheRawSideOfAComparisonAlone"),
    Fault("the filter knows lamps that move alone, none that go", "src/refresh/vkpt/light/light_changes.cpp",
          "same_place(before, now) ? difference / greatest : 1.0f", "same_place(before, now) ? 0.0f : 1.0f", FILTER,
          "Filter.ForgetsALampThatIsGone"),
    Fault("the filter trusts single bright samples of surfaces that have just come into view", "shaders/filter/filter_temporal.comp",
          "max(max(known, around_second_moments), rare)", "max(known, around_second_moments)", FILTER,
          "Filter.SurfacesThatComeIntoViewHaveNoSpeckles"),
    Fault("passes that look far leave all pixels alone", "shaders/filter/filter_atrous.comp",
          "filter_stride >= FAR && is_calm(middle)", "filter_stride >= FAR", FILTER,
          "Filter.SurfacesThatComeIntoViewHaveNoSpeckles"),
    Fault("the last pass over neighbours looks far, too", "src/refresh/vkpt/filter/filter.cpp",
          "step + 1 < steps_ ? 1u << step : 1u", "1u << step", FILTER,
          "Filter.SurfacesThatComeIntoViewHaveNoGrid"),
    Fault("a still picture's past moves with the point in the pixel", "shaders/filter/past.glsl",
          "const vec2 corner = place - turn.pixel_point, within", "const vec2 corner = place - turn.last_pixel_point, within", FILTER,
          "Filter.APictureThatStandsStillGainsNoContrast"),
    Fault("direct light of pixels that move keeps its long past", "shaders/filter/past.glsl",
          "float(frame.settings.flt_history_moving)", "FILTER_MAX", FILTER, "Filter.FollowsACameraThatMoves"),
    Fault("paint forgets as fast as a mirror while the camera moves", "shaders/filter/past.glsl",
          "max(share * turned, 1e-6)", "max(turned, 1e-6)", FILTER, "Filter.PaintKeepsItsPastWhileTheCameraMoves"),

    # Sky and sun as lights.
    Fault("the sun sends 3% too much by light samples", "src/refresh/vkpt/scene/sun.cpp",
          "return irradiance * (2.0f / (1.0f + std::cos(half_angle)));",
          "return 1.03f * irradiance * (2.0f / (1.0f + std::cos(half_angle)));", SKY_LIGHT, "Sun.*"),
    Fault("the sun sends 3% too much by light samples, in pictures", "src/refresh/vkpt/scene/sun.cpp",
          "return irradiance * (2.0f / (1.0f + std::cos(half_angle)));",
          "return 1.03f * irradiance * (2.0f / (1.0f + std::cos(half_angle)));", ANALYTIC, "Analytic.SunOverACourt"),
    Fault("the sun matters 4% too little where lights are chosen", "src/refresh/vkpt/scene/sun.cpp",
          "sun.irradiance / (shader::PI * form)", "0.96f * sun.irradiance / (shader::PI * form)", SKY_LIGHT, "Sun.*"),
    Fault("the sun's triangle is 5% too narrow for its cone", "src/refresh/vkpt/scene/sun.cpp",
          "const float radius = (1.0f + beyond)", "const float radius = (0.95f + beyond)", SKY_LIGHT, "Sun.*"),
    Fault("windows to the sky: coverage lacks 4%", "src/refresh/vkpt/scene/sky_windows.cpp",
          "static_cast<float>(std::min(share, 1.0));", "static_cast<float>(std::min(0.96 * share, 1.0));",
          SKY_WINDOWS, "SkyWindows*"),
    Fault("windows to the sky: cells with gaps count as whole", "src/refresh/vkpt/scene/sky_windows.cpp",
          "constexpr double whole_but = 1e-5;", "constexpr double whole_but = 0.3;", SKY_WINDOWS, "SkyWindows*"),
    Fault("windows to the sky: the second halves lie 3% beside their cells", "src/refresh/vkpt/scene/sky_windows.cpp",
          "add_half(low + cell, {-cell.x, 0.0}", "add_half(low + 1.03 * cell, {-cell.x, 0.0}", SKY_WINDOWS,
          "SkyWindows*"),
    Fault("the sky's brightness through a plane is 4% too low", "src/refresh/vkpt/scene/sky_brightness.cpp",
          "sum += weight * patch.radiance;", "sum += 0.96f * weight * patch.radiance;", SKY_LIGHT, "Sky*"),
    Fault("rays leave 5% more to light samples than those take", "shaders/pathtrace/indirect_ray.glsl",
          "part -= sampled_share(light_probability(surface, light), inverse_density, brdf_pdf);",
          "part -= sampled_share(1.05 * light_probability(surface, light), inverse_density, brdf_pdf);",
          ANALYTIC, "Analytic.SkyAndSunByLightSamplesAndRays"),
    Fault("the density of sky and sun is 5% too low for light samples", "shaders/pathtrace/next_event.glsl",
          "value *= sampled_share(probability, environment_inverse_density(light, surface.origin, seen.direction), ray_pdf);",
          "value *= sampled_share(probability, 1.05 * environment_inverse_density(light, surface.origin, seen.direction), ray_pdf);",
          ANALYTIC, "Analytic.SkyAndSunByLightSamplesAndRays"),
    Fault("half of the draws are said to be the sun's, and 52% are", "shaders/light/lh.glsl",
          "if (random_number.u < of_sun) return", "if (random_number.u < 1.04 * of_sun) return",
          TECHNIQUE, "*KeepsItsPromises/lh_Default"),
    Fault("the sun is in no list", "src/refresh/vkpt/light/cluster_lists.cpp",
          "if (lights.sun_enters(light)) triangles", "if (false) triangles", TECHNIQUE, "*KeepsItsPromises/sll_Default"),

    # On the GPU: memory.
    Fault("a hash bucket overflows by one", "shaders/guiding/light_table.glsl",
          "const uint end = first + settings.bucket;", "const uint end = first + settings.bucket + 1u;",
          GUIDING, "*FullTables*:*EveryBucketSize*"),
    Fault("a write past a buffer's end in the path tracer", "shaders/pathtrace/direct.comp",
          "pixel_flags[index] |= (light", "pixel_flags[index + 5000000u] |= (light",
          ASSISTED_FRAMES, "*/uniform"),

    # The same lights in the scene.
    Fault("a light that flickers counts as one that appears", "src/refresh/vkpt/scene/light_set.cpp",
          "if (moved || ((went_on || went_out) && !flickers)) ++place_revision_;",
          "if (moved || went_on || went_out) ++place_revision_;", LIGHT_SET, "LightSet*"),
    Fault("lights: what takes the place of one that went out is its flicker", SCENE + "light_set.cpp",
          "went_out_[slot.first + i] = 0;", ";", LIGHT_SET, "LightSet*"),
    Fault("a light that flickers is new each time", "src/refresh/vkpt/scene/light_set.cpp",
          "if (went_on && !flickers) ++new_revision_;", "if (went_on) ++new_revision_;", LIGHT_SET, "LightSet*"),
    Fault("a light that goes on is not new", "src/refresh/vkpt/scene/light_set.cpp",
          "if (went_on && !flickers) ++new_revision_;", "if (went_out && !flickers) ++new_revision_;", LIGHT_SET, "LightSet*"),
    Fault("a light that dims counts as one that appears", "src/refresh/vkpt/scene/light_set.cpp",
          "if (moved || ((went_on", "if (moved || old.radiance != light.radiance || ((went_on", LIGHT_SET, "LightSet*"),
    Fault("lights of entities that flicker are not listed again", "src/refresh/vkpt/scene/light_set.cpp",
          "(moved || went_on || went_out)) ++moving", "(moved || ((went_on || went_out) && !flickers))) ++moving",
          LIGHT_SET, "LightSet*"),
    Fault("translucent lamps lose 4%", "src/refresh/vkpt/scene/light_set.cpp",
          "light.radiance = source.radiance * tint * (source.coverage * dim * scale_);",
          "light.radiance = source.radiance * tint * (0.96f * source.coverage * dim * scale_);",
          LIGHT_SET, "LightSet*"),
]
