// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/sky_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numeric>

namespace vigil::vkpt {

namespace {

/// Faces this far from a plane (map units) lie in it.
constexpr float on_plane = 0.1f;
/// Faces of a plane that are farther apart have windows of their own.
constexpr double together = 1.0;
/// A window of which faces cover less is cut in two.
constexpr double least_filled = 0.5;
/// A half cell of which faces leave less is covered by them.
constexpr double whole_but = 1e-5;
/// Faces this far from a window's plane do not lie in it for a ray that ends just in front of it
/// (offset_ray_origin's least is 0.002).
constexpr double in_plane = 1e-3;
/// Directions of edges that are looked at in a plane.
constexpr size_t most_directions = 64;
constexpr uint32_t most_cells = 4095; // of a side: shader::LIGHT_CELLS_MASK

using Polygon = std::vector<glm::dvec2>;

struct Rectangle {
    glm::dvec2 lower{std::numeric_limits<double>::max()};
    glm::dvec2 upper{std::numeric_limits<double>::lowest()};

    void add(const Rectangle& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    bool meets(const Rectangle& other, double gap) const {
        return glm::all(glm::lessThanEqual(lower, other.upper + gap)) &&
               glm::all(glm::lessThanEqual(other.lower, upper + gap));
    }
    glm::dvec2 size() const { return upper - lower; }
    glm::dvec2 middle() const { return 0.5 * (lower + upper); }
};

double area_of(const Polygon& polygon) {
    double twice = 0.0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(twice);
}

/// The part on the left of the line from `a` to `b`.
Polygon clip(const Polygon& polygon, glm::dvec2 a, glm::dvec2 b) {
    const auto side = [&](glm::dvec2 p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    Polygon part;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const double from = side(p), to = side(q);
        if (from >= 0.0) part.push_back(p);
        if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0))
            part.push_back(p + (q - p) * (from / (from - to)));
    }
    return part;
}

/// Adds what is left of a polygon without a convex one, counter-clockwise, to `parts`.
void subtract(Polygon polygon, const Polygon& other, std::vector<Polygon>& parts) {
    for (size_t i = 0; i < other.size() && !polygon.empty(); ++i) {
        const glm::dvec2 a = other[i], b = other[(i + 1) % other.size()];
        if (Polygon beyond = clip(polygon, b, a); area_of(beyond) > 0.0)
            parts.push_back(std::move(beyond));
        polygon = clip(polygon, a, b);
    }
}

/// A sky face in its plane.
struct Face {
    size_t triangle;
    Polygon corners; // counter-clockwise
    Rectangle box;
    bool in_plane; // not a little beside it

    double area_in(const Polygon& half) const {
        Polygon part = corners;
        for (size_t i = 0; i < half.size(); ++i)
            part = clip(part, half[i], half[(i + 1) % half.size()]);
        return area_of(part);
    }
};

/// A direction of edges, up to quarter turns.
struct EdgeDirection {
    glm::dvec3 along; // unit
    double length;    // of all its edges
};

struct Plane {
    glm::dvec3 normal, origin, along, across; // along, across, normal: right-handed
    std::vector<EdgeDirection> directions;
    std::vector<size_t> triangles;

    void add_edge(const glm::dvec3& edge) {
        const glm::dvec3 in_plane = edge - glm::dot(edge, normal) * normal;
        const double length = glm::length(in_plane);
        if (!(length > 0.0)) return;
        const glm::dvec3 unit = in_plane / length;
        const auto same = [&](const EdgeDirection& known) {
            const double cosine = std::abs(glm::dot(known.along, unit));
            return std::max(cosine, std::sqrt(std::max(1.0 - cosine * cosine, 0.0))) > 0.9999;
        };
        const auto known = std::ranges::find_if(directions, same);
        if (known != directions.end())
            known->length += length;
        else if (directions.size() < most_directions)
            directions.push_back({unit, length});
    }
    bool holds(const shader::BvhTriangle& triangle) const {
        const glm::dvec3 v0(triangle.v0), e1(triangle.e1), e2(triangle.e2);
        return std::ranges::all_of(std::array{v0, v0 + e1, v0 + e2}, [&](const glm::dvec3& p) {
            return std::abs(glm::dot(normal, p - origin)) < in_plane;
        });
    }
    /// Windows lie along the direction of most of the edges: of a rectangle's two triangles that is
    /// its sides', not their common diagonal's.
    void turn() {
        const EdgeDirection* most = &directions.front();
        for (const EdgeDirection& direction : directions)
            if (direction.length > 1.001 * most->length) most = &direction; // the first of equals
        along = most->along;
        across = glm::cross(normal, along);
    }

    glm::dvec2 flat(const glm::dvec3& p) const {
        return {glm::dot(p - origin, along), glm::dot(p - origin, across)};
    }
    glm::vec3 place(glm::dvec2 p) const { return glm::vec3(origin + p.x * along + p.y * across); }
};

struct Window {
    const Plane* plane;
    std::vector<Face> faces;
    Rectangle frame;
    uint32_t columns = 1, rows = 1;
};

std::vector<Plane> find_planes(std::span<const shader::BvhTriangle> triangles) {
    std::vector<Plane> planes;
    for (size_t i = 0; i < triangles.size(); ++i) {
        const glm::dvec3 v0(triangles[i].v0), e1(triangles[i].e1), e2(triangles[i].e2);
        const glm::dvec3 normal = glm::cross(e1, e2);
        const double length = glm::length(normal);
        if (!(length > 0.0) || !std::isfinite(length)) continue;
        const auto fits = [&](const Plane& plane) {
            const auto height = [&](const glm::dvec3& p) {
                return std::abs(glm::dot(plane.normal, p - plane.origin));
            };
            return glm::dot(plane.normal, normal) > 0.9999 * length && height(v0) < on_plane &&
                   height(v0 + e1) < on_plane && height(v0 + e2) < on_plane;
        };
        auto plane = std::ranges::find_if(planes, fits);
        if (plane == planes.end()) {
            planes.push_back({normal / length, v0, {}, {}, {}, {}});
            plane = planes.end() - 1;
        }
        plane->triangles.push_back(i);
        for (const glm::dvec3& edge : {e1, e2, e2 - e1})
            plane->add_edge(edge);
    }
    for (Plane& plane : planes)
        plane.turn();
    return planes;
}

/// Groups of faces whose boxes touch.
std::vector<std::vector<Face>> faces_together(std::vector<Face> faces) {
    std::vector<size_t> group(faces.size());
    std::iota(group.begin(), group.end(), size_t{0});
    const auto root = [&](size_t i) {
        while (group[i] != i)
            i = group[i] = group[group[i]];
        return i;
    };
    for (size_t i = 0; i < faces.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (faces[i].box.meets(faces[j].box, together)) group[root(i)] = root(j);
    std::vector<std::vector<Face>> parts(faces.size());
    for (size_t i = 0; i < faces.size(); ++i)
        parts[root(i)].push_back(std::move(faces[i]));
    std::erase_if(parts, [](const std::vector<Face>& part) { return part.empty(); });
    return parts;
}

/// Adds the windows of faces that lie together.
void add_windows(const Plane& plane, std::vector<Face> faces, std::vector<Window>& windows) {
    Window window;
    window.plane = &plane;
    double filled = 0.0;
    for (const Face& face : faces) {
        window.frame.add(face.box);
        filled += area_of(face.corners);
    }
    const glm::dvec2 size = window.frame.size();
    if (faces.size() > 1 && filled < least_filled * size.x * size.y) {
        const glm::length_t axis = size.x >= size.y ? 0 : 1;
        std::ranges::stable_sort(faces, {},
                                 [&](const Face& face) { return face.box.middle()[axis]; });
        const auto half = faces.begin() + static_cast<std::ptrdiff_t>(faces.size() / 2);
        add_windows(plane, std::vector<Face>(faces.begin(), half), windows);
        add_windows(plane, std::vector<Face>(half, faces.end()), windows);
        return;
    }
    window.faces = std::move(faces);
    windows.push_back(std::move(window));
}

/// Cells of this size at most, in as many columns and rows as that takes.
uint64_t cut(std::vector<Window>& windows, double size) {
    uint64_t cells = 0;
    const auto pieces = [size](double length) {
        return static_cast<uint32_t>(
            std::clamp(std::ceil(length / size), 1.0, static_cast<double>(most_cells)));
    };
    for (Window& window : windows) {
        window.columns = pieces(window.frame.size().x);
        window.rows = pieces(window.frame.size().y);
        cells += uint64_t{window.columns} * window.rows;
    }
    return cells;
}

/// The smallest cells that are few enough, the same size in all windows.
void cut_evenly(std::vector<Window>& windows, uint32_t most_lights) {
    double least = 1.0, most = 1e6; // map units; the latter is one cell for each
    for (int i = 0; i < 40; ++i) {
        const double size = std::sqrt(least * most);
        (2 * cut(windows, size) <= most_lights ? most : least) = size;
    }
    cut(windows, most);
}

/// Whether each point of half a cell lies on the sky faces of its window, and on no others: who
/// looks at such a point need not ask what is there.
bool is_whole(const Polygon& half, const Window& window, std::span<const Window> all) {
    const double least = whole_but * area_of(half);
    Rectangle box;
    for (const glm::dvec2 corner : half)
        box.add({corner, corner});
    const auto meets = [&](const Face& face) {
        return face.box.meets(box, 0.0) && face.area_in(half) > least;
    };
    std::vector<Polygon> left{half};
    for (const Face& face : window.faces) {
        if (!face.box.meets(box, 0.0)) continue;
        if (!face.in_plane) {
            if (meets(face)) return false;
            continue;
        }
        std::vector<Polygon> parts;
        for (Polygon& polygon : left)
            subtract(std::move(polygon), face.corners, parts);
        left = std::move(parts);
    }
    double sum = 0.0;
    for (const Polygon& polygon : left)
        sum += area_of(polygon);
    if (sum > least) return false;
    return std::ranges::none_of(all, [&](const Window& other) {
        return other.plane == window.plane && &other != &window && other.frame.meets(box, 0.0) &&
               std::ranges::any_of(other.faces, meets);
    });
}

void add_lights(const Window& window, std::span<const Window> all,
                std::vector<LightSource>& lights) {
    const size_t first = lights.size();
    const glm::dvec2 cell = window.frame.size() / glm::dvec2(window.columns, window.rows);
    const auto add_half = [&](glm::dvec2 corner, glm::dvec2 edge1, glm::dvec2 edge2) {
        const glm::dvec2 b = corner + edge1, c = corner + edge2;
        const Polygon half{corner, b, c};
        double covered = 0.0;
        for (const Face& face : window.faces)
            covered += face.area_in(half);
        LightSource light;
        light.v0 = window.plane->place(corner);
        light.v1 = window.plane->place(b);
        light.v2 = window.plane->place(c);
        light.radiance = glm::vec3(1.0f);
        const double share = covered / (0.5 * cell.x * cell.y);
        light.coverage = static_cast<float>(std::min(share, 1.0));
        const bool whole = share > 1.0 - whole_but && is_whole(half, window, all);
        light.flags = shader::LIGHT_SKY | (whole ? shader::LIGHT_WHOLE : 0);
        lights.push_back(light);
    };
    for (uint32_t row = 0; row < window.rows; ++row)
        for (uint32_t column = 0; column < window.columns; ++column) {
            const glm::dvec2 low = window.frame.lower + cell * glm::dvec2(column, row);
            add_half(low, {cell.x, 0.0}, {0.0, cell.y});
            add_half(low + cell, {-cell.x, 0.0}, {0.0, -cell.y});
        }
    lights[first].flags |=
        window.columns << shader::LIGHT_COLUMNS_SHIFT | window.rows << shader::LIGHT_ROWS_SHIFT;
}

} // namespace

SkyWindows make_sky_windows(std::span<const shader::BvhTriangle> triangles, uint32_t most_lights) {
    const std::vector<Plane> planes = find_planes(triangles);
    std::vector<Window> windows;
    for (const Plane& plane : planes) {
        std::vector<Face> faces;
        for (const size_t triangle : plane.triangles) {
            const glm::dvec3 v0(triangles[triangle].v0);
            Face face{triangle,
                      {plane.flat(v0), plane.flat(v0 + glm::dvec3(triangles[triangle].e1)),
                       plane.flat(v0 + glm::dvec3(triangles[triangle].e2))},
                      {},
                      plane.holds(triangles[triangle])};
            for (const glm::dvec2 corner : face.corners)
                face.box.add({corner, corner});
            faces.push_back(std::move(face));
        }
        for (std::vector<Face>& part : faces_together(std::move(faces)))
            add_windows(plane, std::move(part), windows);
    }
    cut_evenly(windows, most_lights);
    SkyWindows result;
    result.first_lights.assign(triangles.size(), shader::NONE);
    for (const Window& window : windows) {
        for (const Face& face : window.faces)
            result.first_lights[face.triangle] = static_cast<uint32_t>(result.lights.size());
        add_lights(window, windows, result.lights);
    }
    return result;
}

} // namespace vigil::vkpt
