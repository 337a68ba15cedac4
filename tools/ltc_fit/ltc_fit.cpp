// SPDX-License-Identifier: GPL-2.0-or-later
// The fit: quadrature points drawn from GGX's visible normals, their average direction, and a
// Nelder-Mead search for the three numbers that shape a cosine around it.
#include "ltc_fit.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vigil {
namespace {

using glm::dmat3;
using glm::dvec3;

constexpr double pi = 3.14159265358979323846;
constexpr int grid = 48;             // quadrature points per side
constexpr double least_alpha = 1e-3; // the table's first column; surfaces have at least 0.01
constexpr double least_cosine = shader::BRDF_MIN_COSINE;

/// A direction drawn from the lobe; the lobe's integral is the mean of the weights.
struct Direction {
    dvec3 direction;
    double weight; // lobe / density
    double value;  // BRDF * cosine with Fresnel 1
};

struct Lobe {
    std::vector<Direction> directions;
    double albedo = 0.0;  // with Fresnel 1
    double schlick = 0.0; // with Fresnel (1 - v.h)^5
};

/// Quadrature of the GGX lobe seen from (sin, 0, cos): the formulas of brdf.h in double precision.
Lobe make_lobe(double alpha, double cosine) {
    const dvec3 view(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    const double alpha2 = alpha * alpha;
    const auto root = [&](double c) { return std::sqrt(alpha2 + (1.0 - alpha2) * c * c); };
    Lobe lobe;
    for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
            // A visible normal by spherical caps, as sample_visible_reflection does.
            const dvec3 stretched = glm::normalize(dvec3(alpha * view.x, alpha * view.y, view.z));
            const double angle = 2.0 * pi * (i + 0.5) / grid;
            const double z = (1.0 - (j + 0.5) / grid) * (1.0 + stretched.z) - stretched.z;
            const double radius = std::sqrt(std::max(1.0 - z * z, 0.0));
            dvec3 h = dvec3(radius * std::cos(angle), radius * std::sin(angle), z) + stretched;
            h = glm::normalize(dvec3(alpha * h.x, alpha * h.y, std::max(h.z, 1e-12)));
            const double vh = glm::dot(view, h);
            const dvec3 light = 2.0 * vh * h - view;
            if (light.z <= 0.0) continue;
            // Masking is in the density; shadowing remains as the weight.
            const double rv = root(view.z), rl = root(light.z);
            const double weight = light.z * (view.z + rv) / (light.z * rv + view.z * rl);
            const double slope = (1.0 - h.z * h.z) + alpha2 * h.z * h.z;
            const double density = 0.5 * alpha2 / (pi * slope * slope) / (view.z + rv);
            lobe.directions.push_back({light, weight, weight * density});
            lobe.albedo += weight;
            lobe.schlick += weight * std::pow(1.0 - std::min(vh, 1.0), 5.0);
        }
    }
    lobe.albedo /= grid * grid;
    lobe.schlick /= grid * grid;
    return lobe;
}

/// Density of the transformed cosine whose inverse matrix is given, mixed with the plain cosine as
/// ltc_importance mixes them.
double mixture_density(const dmat3& inverse, double determinant, const dvec3& direction) {
    const dvec3 w = inverse * direction;
    const double length2 = glm::dot(w, w);
    const double transformed = std::max(w.z, 0.0) / pi * determinant / (length2 * length2);
    return (1.0 - shader::LTC_DEFENSIVE) * transformed + shader::LTC_DEFENSIVE * direction.z / pi;
}

/// What the search varies: logarithms of the widths across and along, the skew, and the tilt
/// against the frame.
constexpr size_t shape_size = 4;
using Shape = std::array<double, shape_size>;

/// Inverse of frame * rotation(tilt) * [x 0 skew; 0 y 0; 0 0 1], scaled so that the middle element
/// is 1.
dmat3 inverse_of(const dmat3& frame, const Shape& shape) {
    const double c = std::cos(shape[3]), s = std::sin(shape[3]);
    const dmat3 tilt(c, 0, -s, 0, 1, 0, s, 0, c);
    const dmat3 matrix =
        frame * tilt * dmat3(std::exp(shape[0]), 0, 0, 0, std::exp(shape[1]), 0, shape[2], 0, 1);
    const dmat3 inverse = glm::inverse(matrix);
    return inverse / inverse[1][1];
}

/// E[f^2 / p^2] over E[f]^2 where directions are drawn from the mixture p; 1 = perfect. The
/// integral of f^2 / p is taken over directions that come with density f / weight.
double second_moment(const Lobe& lobe, const dmat3& inverse) {
    const double determinant = glm::determinant(inverse);
    double sum = 0.0;
    for (const Direction& d : lobe.directions)
        sum += d.weight * d.value / mixture_density(inverse, determinant, d.direction);
    return sum / (grid * grid) / (lobe.albedo * lobe.albedo);
}

/// Nelder and Mead's simplex search with the usual coefficients, the first `dimensions` numbers
/// free.
template <typename Objective> Shape minimise(Shape start, size_t dimensions, Objective objective) {
    struct Vertex {
        Shape at;
        double cost;
    };
    const auto along = [&](const Shape& from, const Shape& to, double t) {
        Shape at = start;
        for (size_t i = 0; i < dimensions; ++i)
            at[i] = from[i] + t * (to[i] - from[i]);
        return Vertex{at, objective(at)};
    };
    std::vector<Vertex> simplex{{start, objective(start)}};
    for (size_t i = 0; i < dimensions; ++i) {
        auto at = start;
        at[i] += 0.1;
        simplex.push_back({at, objective(at)});
    }
    const auto by_cost = [](const Vertex& a, const Vertex& b) { return a.cost < b.cost; };
    for (int step = 0; step < 300; ++step) {
        std::stable_sort(simplex.begin(), simplex.end(), by_cost);
        Vertex& worst = simplex.back();
        if (worst.cost - simplex.front().cost < 1e-10 * std::abs(simplex.front().cost)) break;
        Shape center{};
        for (size_t v = 0; v < dimensions; ++v)
            for (size_t i = 0; i < dimensions; ++i)
                center[i] += simplex[v].at[i] / static_cast<double>(dimensions);
        const Vertex reflected = along(worst.at, center, 2.0);
        if (reflected.cost < simplex.front().cost) {
            const Vertex expanded = along(worst.at, center, 3.0);
            worst = expanded.cost < reflected.cost ? expanded : reflected;
        } else if (reflected.cost < simplex[dimensions - 1].cost) {
            worst = reflected;
        } else {
            const Vertex contracted =
                along(worst.at, center, reflected.cost < worst.cost ? 1.5 : 0.5);
            if (contracted.cost < std::min(worst.cost, reflected.cost)) {
                worst = contracted;
            } else {
                for (size_t v = 1; v <= dimensions; ++v)
                    simplex[v] = along(simplex.front().at, simplex[v].at, 0.5);
            }
        }
    }
    return std::min_element(simplex.begin(), simplex.end(), by_cost)->at;
}

} // namespace

double ltc_table_alpha(unsigned column) {
    const double t = double(column) / double(shader::LTC_TABLE_SIZE - 1);
    return std::max(t * t, least_alpha);
}

double ltc_table_view_cosine(unsigned row) {
    const double t = double(row) / double(shader::LTC_TABLE_SIZE - 1);
    return std::max(1.0 - t * t, least_cosine);
}

LtcFit fit_ltc(double alpha, double view_cosine) {
    const Lobe lobe = make_lobe(alpha, view_cosine);

    // The frame: z along the average direction, y across the plane of view and normal.
    dvec3 average(0.0);
    for (const Direction& d : lobe.directions)
        average += d.weight * d.direction;
    average.y = 0.0;
    const bool isotropic = view_cosine > 1.0 - 1e-9;
    const dvec3 z = isotropic ? dvec3(0, 0, 1) : glm::normalize(average);
    const dmat3 frame(dvec3(z.z, 0.0, -z.x), dvec3(0, 1, 0), z);

    // Seen from above the lobe is round: one free number, used twice.
    const auto widen = [&](const Shape& s) { return isotropic ? Shape{s[0], s[0], 0.0, 0.0} : s; };
    const auto cost = [&](const Shape& s) {
        return std::log(second_moment(lobe, inverse_of(frame, widen(s))));
    };
    // Fresh simplices leave collapsed ones behind.
    Shape shape{std::log(alpha), std::log(alpha), 0.0, 0.0};
    for (int attempt = 0; attempt < 4; ++attempt)
        shape = minimise(shape, isotropic ? 1 : shape_size, cost);

    const dmat3 inverse = inverse_of(frame, widen(shape));
    LtcFit fit;
    fit.entry.matrix = glm::vec4(inverse[0][0], inverse[2][0], inverse[0][2], inverse[2][2]);
    fit.entry.albedo = glm::vec2(lobe.albedo - lobe.schlick, lobe.schlick);
    fit.excess = second_moment(lobe, inverse) - 1.0;
    return fit;
}

std::vector<LtcFit> fit_ltc_table() {
    constexpr unsigned size = shader::LTC_TABLE_SIZE;
    std::vector<LtcFit> table;
    for (unsigned row = 0; row < size; ++row)
        for (unsigned column = 0; column < size; ++column)
            table.push_back(fit_ltc(ltc_table_alpha(column), ltc_table_view_cosine(row)));
    return table;
}

} // namespace vigil
