#include "tests/bench/lab/tissue_cases.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace bench::lab {

namespace {

using tissue::Input;
using tissue::Material;
using tissue::Mesh;
using tissue::Tissue;
using tissue::TubeDef;
using tissue::Vec3;

constexpr double in_the_end = std::numeric_limits<double>::infinity();  // without damping

Tissue newton(const Mesh& mesh) {
    constexpr double force = 0.1e6 * 1e-6;  // of a stress as the modulus on a square millimetre [N]
    return Tissue({}, mesh, {.iterations = 50, .steps_per_factor = 0, .tolerance = 1e-9 * force});
}

// Pressures follow where cells swell and walls turn, step by step: until no node moves by a millionth of a cell.
void settle(Tissue& tissue, const Input& input, double cell) {
    constexpr int most = 300;
    double moved = cell;
    for (int i = 0; i < most && moved > 1e-6 * cell; ++i) {
        const std::vector<Vec3> before(tissue.nodes().begin(), tissue.nodes().end());
        tissue.step(input, in_the_end);
        moved = 0;
        for (std::size_t k = 0; k < before.size(); ++k) moved = std::max(moved, (tissue.nodes()[k] - before[k]).norm());
    }
}

// Within a thousandth of a cell.
bool is_at(double x, double plane, double cell) {
    return std::abs(x - plane) < 1e-3 * cell;
}

Mesh tube(const TubeDef& def, const Resolution& resolution) {
    const Mesh mesh = tissue::make_tube(def);
    return resolution.locks ? with_own_volumes(mesh) : mesh;
}

double pressure_over_mu(double inner_stretch, double axial, double inner, double outer) {
    const double a = inner_stretch * inner, b = std::sqrt(a * a + (outer * outer - inner * inner) / axial),
                 l = b / outer, k = inner_stretch;
    return std::log(k / l) / axial + (1 / (l * l) - 1 / (k * k)) / (2 * axial * axial);
}

}  // namespace

Mesh with_own_volumes(Mesh mesh) {
    mesh.cells.clear();
    for (int t = 0; t <= static_cast<int>(mesh.tetrahedra.size()); ++t) mesh.cells.push_back(t);
    return mesh;
}

Compared patch_stress(Deformation mode, double stretch) {
    constexpr double cell = 0.5e-3, edge = 2 * cell;
    const Mesh mesh = tissue::make_box({2, 2, 2}, cell);
    Tissue tissue = newton(mesh);
    constexpr int steps = 10;
    for (int s = 1; s <= steps; ++s) {
        const double along = 1 + (stretch - 1) * s / steps, across = mode == Deformation::pure_shear ? 1 : along;
        std::vector<tissue::Hold> holds;
        for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
            const Vec3& at = mesh.nodes[static_cast<std::size_t>(i)];
            const bool left = is_at(at.x(), 0, cell), right = is_at(at.x(), edge, cell), front = is_at(at.y(), 0, cell),
                       back = is_at(at.y(), edge, cell);
            holds.push_back(
                {i,
                 {along * at.x(), across * at.y(), at.z()},
                 {left || right, front || (back && mode != Deformation::uniaxial), is_at(at.z(), 0, cell)}});
        }
        settle(tissue, {.holds = holds}, cell);
    }
    double force = 0;
    for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i)
        if (is_at(mesh.nodes[static_cast<std::size_t>(i)].x(), edge, cell)) force += tissue.hold_force(i).x();
    const double power = mode == Deformation::uniaxial ? -2 : mode == Deformation::equibiaxial ? -5 : -3;
    return {force / (edge * edge * tissue.material().shear()), stretch - std::pow(stretch, power)};
}

// Symmetric as its load, it is as well short, and held where planes of symmetry meet its ends.
Compared inflated_radius(const Resolution& resolution, double stretch, double axial) {
    const double inner = 2e-3 * resolution.scale, outer = 2.5e-3 * resolution.scale;
    const double cell = (outer - inner) / resolution.through, length = 2 * resolution.aspect * cell;
    const Mesh mesh = tube({.diameter = 2 * outer,
                            .wall = outer - inner,
                            .length = length,
                            .around = resolution.around,
                            .through = resolution.through,
                            .near = 2,
                            .near_length = length,
                            .far = 0},
                           resolution);
    Tissue tissue = newton(mesh);
    const double pressure = pressure_over_mu(stretch, axial, inner, outer) * tissue.material().shear();
    constexpr int steps = 10;
    for (int s = 1; s <= steps; ++s) {
        const double share = static_cast<double>(s) / steps;
        std::vector<tissue::Hold> holds;
        for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
            const Vec3& at = mesh.nodes[static_cast<std::size_t>(i)];
            holds.push_back({i,
                             {(1 + share * (axial - 1)) * at.x(), 0, 0},
                             {true, is_at(at.y(), 0, cell), is_at(at.z(), 0, cell)}});
        }
        settle(tissue, {.holds = holds, .pressure = share * pressure}, cell);
    }
    // Of the polygon of inner nodes of the section in the middle, which comes second.
    double area = 0, area_at_rest = 0;
    for (int a = 0; a < resolution.around; ++a) {
        const auto node = [&](int k) {
            return static_cast<std::size_t>((resolution.around + k % resolution.around) * (resolution.through + 1));
        };
        area += tissue.nodes()[node(a)].cross(tissue.nodes()[node(a + 1)]).x();
        area_at_rest += mesh.nodes[node(a)].cross(mesh.nodes[node(a + 1)]).x();
    }
    return {std::sqrt(area / area_at_rest), stretch};
}

Compared clamped_force(const Resolution& resolution, double stretch) {
    constexpr double diameter = 4e-3, wall = 0.5e-3, length = 16e-3;
    const int along = 12 * resolution.through;
    const Mesh mesh = tube({.diameter = diameter,
                            .wall = wall,
                            .length = length,
                            .around = resolution.around,
                            .through = resolution.through,
                            .near = along,
                            .near_length = length,
                            .far = 0},
                           resolution);
    Tissue tissue = newton(mesh);
    constexpr int steps = 4;
    for (int s = 1; s <= steps; ++s) {
        std::vector<tissue::Hold> holds;
        for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
            const Vec3& at = mesh.nodes[static_cast<std::size_t>(i)];
            const bool far = is_at(at.x(), length, wall);
            if (far || is_at(at.x(), 0, wall))
                holds.push_back({i, at + (far ? s * (stretch - 1) / steps * length : 0) * Vec3::UnitX()});
        }
        settle(tissue, {.holds = holds}, wall / resolution.through);
    }
    const int section = resolution.around * (resolution.through + 1);
    double force = 0, before = 0, after = 0;
    for (int k = 0; k < section; ++k) {
        force += tissue.hold_force(along * section + k).x();
        before += tissue.nodes()[static_cast<std::size_t>((along / 2 - 1) * section + k)].x() / section;
        after += tissue.nodes()[static_cast<std::size_t>((along / 2 + 1) * section + k)].x() / section;
    }
    const double middle = (after - before) / (2 * length / along), area = std::numbers::pi * (diameter - wall) * wall;
    return {force, tissue.material().shear() * area * (middle - 1 / (middle * middle))};
}

}  // namespace bench::lab
