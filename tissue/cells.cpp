#include "tissue/cells.hpp"

#include <algorithm>
#include <cassert>

namespace tissue {

namespace {

using Corners = std::array<Lanes, Cells::most_nodes>;

Corners corners_of(const Cells& cells, std::span<const Vec3> nodes) {
    Corners at;
    for (std::size_t k = 0; k < cells.count; ++k) at[k] = gathered(cells, k, nodes);
    return at;
}

// One cell, in all four lanes.
Cells cell_of(const Mesh& mesh, std::size_t c) {
    Cells cell;
    cell.used = 1;
    for (int t = mesh.cells[c]; t < mesh.cells[c + 1]; ++t) {
        const Tetrahedron& tet = mesh.tetrahedra[static_cast<std::size_t>(t)];
        assert(cell.tetrahedra < Cells::most_tetrahedra && "a cell of at most six tetrahedra");
        for (std::size_t k = 0; k < 4; ++k) {
            std::size_t place = 0;
            while (place < cell.count && cell.nodes[place][0] != tet[k]) ++place;
            assert(place < Cells::most_nodes && "a cell of at most eight nodes");
            if (place == cell.count) cell.nodes[cell.count++].fill(tet[k]);
            cell.corners[cell.tetrahedra][k] = static_cast<unsigned char>(place);
        }
        ++cell.tetrahedra;
        cell.rest_volume += Lane(volume(tet, mesh.nodes));
    }
    return cell;
}

void join(Cells& cells, const Cells& one) {
    for (std::size_t k = cells.used; k < Cells::lanes; ++k) {
        for (std::size_t n = 0; n < cells.count; ++n) cells.nodes[n][k] = one.nodes[n][0];
        cells.rest_volume.q[k] = one.rest_volume[0];
    }
    ++cells.used;
}

}  // namespace

std::vector<Cells> cells_of(const Mesh& mesh) {
    std::vector<Cells> all;
    for (std::size_t c = 0; c + 1 < mesh.cells.size(); ++c) {
        const Cells one = cell_of(mesh, c);
        const auto like = std::find_if(all.rbegin(), all.rend(), [&](const Cells& other) {
            return other.used < Cells::lanes && other.count == one.count && other.tetrahedra == one.tetrahedra &&
                   other.corners == one.corners;
        });
        if (like == all.rend())
            all.push_back(one);
        else
            join(*like, one);
    }
    return all;
}

Volumes volumes(const Cells& cells, std::span<const Vec3> nodes) {
    const Corners at = corners_of(cells, nodes);
    constexpr double sixth = 1.0 / 6;
    Volumes six{};
    for (std::size_t t = 0; t < cells.tetrahedra; ++t) {
        const auto [o, a, b, c] = cells.corners[t];
        const Lanes u = at[a] - at[o], v = at[b] - at[o], w = at[c] - at[o], of_a = cross(v, w), of_b = cross(w, u),
                    of_c = cross(u, v);
        six.value += dot(u, of_a);
        six.gradient[a] += of_a, six.gradient[b] += of_b, six.gradient[c] += of_c;
        six.gradient[o] -= of_a, six.gradient[o] -= of_b, six.gradient[o] -= of_c;
    }
    six.value = sixth * six.value;
    for (std::size_t k = 0; k < cells.count; ++k) six.gradient[k] = Lane(sixth) * six.gradient[k];
    return six;
}

Bulge bulge(const Cells& cells, std::span<const Vec3> nodes, std::span<const Vec3> direction) {
    const Corners at = corners_of(cells, nodes), by = corners_of(cells, direction);
    Bulge six{};
    for (std::size_t t = 0; t < cells.tetrahedra; ++t) {
        const auto [o, a, b, c] = cells.corners[t];
        const Lanes u = by[a] - by[o], v = by[b] - by[o], w = by[c] - by[o], vw = cross(v, w);
        six.second += dot(at[a] - at[o], vw) + dot(at[b] - at[o], cross(w, u)) + dot(at[c] - at[o], cross(u, v));
        six.third += dot(u, vw);
    }
    return {six.second / Lane(6), six.third / Lane(6)};
}

// In a tetrahedron o a b c, the derivative of the volume by one corner changes with another corner across the edge
// between the two others.
std::array<Lanes, Cells::most_pairs> second_derivatives(const Cells& cells, std::span<const Vec3> nodes) {
    const Corners at = corners_of(cells, nodes);
    std::array<Lanes, Cells::most_pairs> six{};
    const auto add = [&](std::size_t a, std::size_t b, const Lanes& edge) {
        if (a < b)
            six[pair(a, b)] += edge;
        else
            six[pair(b, a)] -= edge;
    };
    for (std::size_t t = 0; t < cells.tetrahedra; ++t) {
        const auto [o, a, b, c] = cells.corners[t];
        add(o, a, at[b] - at[c]), add(o, b, at[c] - at[a]), add(o, c, at[a] - at[b]);
        add(a, b, at[o] - at[c]), add(b, c, at[o] - at[a]), add(c, a, at[o] - at[b]);
    }
    for (Lanes& edge : six) edge = Lane(1.0 / 6) * edge;
    return six;
}

}  // namespace tissue
