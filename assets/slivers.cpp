#include "assets/slivers.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace assets {

namespace {

using Corners = std::array<int, 3>;

class Mender {
  public:
    Mender(Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {}

    int mend() {
        join_near_corners();
        flip_long_edges();
        drop_unused_vertices();
        return slivers_;
    }

  private:
    const Vec3& at(int vertex) const { return mesh_.vertices[static_cast<std::size_t>(vertex)]; }

    double length(int a, int b) const { return (at(b) - at(a)).norm(); }

    static bool is_collapsed(const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

    void join_near_corners() {
        std::vector<int> stands_for(mesh_.vertices.size());
        std::iota(stands_for.begin(), stands_for.end(), 0);
        const auto root = [&](int vertex) {
            while (stands_for[static_cast<std::size_t>(vertex)] != vertex)
                vertex = stands_for[static_cast<std::size_t>(vertex)];
            return vertex;
        };
        for (const Corners& t : mesh_.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                if (const int a = root(t[k]), b = root(t[(k + 1) % 3]); length(t[k], t[(k + 1) % 3]) <= tolerance_)
                    stands_for[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        for (Corners& t : mesh_.triangles)
            for (int& corner : t) corner = root(corner);
        slivers_ += static_cast<int>(std::erase_if(mesh_.triangles, is_collapsed));
    }

    // Turned so that the longest edge is from its first corner to its second.
    Corners from_longest(const Corners& t) const {
        const std::array<double, 3> edges{length(t[0], t[1]), length(t[1], t[2]), length(t[2], t[0])};
        const auto k = static_cast<std::size_t>(std::max_element(edges.begin(), edges.end()) - edges.begin());
        return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
    }

    bool is_sliver(const Corners& t) const {
        const Vec3 along = at(t[1]) - at(t[0]);
        return along.cross(at(t[2]) - at(t[0])).norm() <= tolerance_ * along.norm();
    }

    void put(std::size_t triangle, const Corners& t) {
        mesh_.triangles[triangle] = t;
        for (std::size_t k = 0; k < 3; ++k) triangle_at_[{t[k], t[(k + 1) % 3]}] = triangle;
    }

    void take_away(std::size_t triangle) {
        const Corners& t = mesh_.triangles[triangle];
        for (std::size_t k = 0; k < 3; ++k) triangle_at_.erase({t[k], t[(k + 1) % 3]});
        mesh_.triangles[triangle] = {0, 0, 0};
    }

    void flip_long_edges() {
        std::vector<std::size_t> to_look_at(mesh_.triangles.size());
        std::iota(to_look_at.rbegin(), to_look_at.rend(), 0u);
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) put(i, mesh_.triangles[i]);
        for (std::size_t left = 4 * to_look_at.size(); left > 0 && !to_look_at.empty(); --left) {
            const std::size_t i = to_look_at.back();
            to_look_at.pop_back();
            if (is_collapsed(mesh_.triangles[i])) continue;
            const auto [a, b, middle] = from_longest(mesh_.triangles[i]);
            if (!is_sliver({a, b, middle})) continue;
            ++slivers_;
            const auto neighbour = triangle_at_.find({b, a});
            const std::size_t j = neighbour == triangle_at_.end() ? i : neighbour->second;
            const Corners beside = mesh_.triangles[j];
            take_away(i);
            if (j == i) continue;
            const int far = *std::find_if(beside.begin(), beside.end(),
                                          [&, from = a, to = b](int corner) { return corner != from && corner != to; });
            take_away(j);
            if (far == middle) continue;  // the two lay on each other
            put(i, {a, far, middle}), put(j, {far, b, middle});
            to_look_at.push_back(i), to_look_at.push_back(j);
        }
        std::erase_if(mesh_.triangles, is_collapsed);
    }

    void drop_unused_vertices() {
        std::vector<int> number(mesh_.vertices.size(), -1);
        for (const Corners& t : mesh_.triangles)
            for (const int corner : t) number[static_cast<std::size_t>(corner)] = 0;
        int next = 0;
        for (std::size_t i = 0; i < number.size(); ++i) {
            if (number[i] < 0) continue;
            mesh_.vertices[static_cast<std::size_t>(next)] = mesh_.vertices[i];
            number[i] = next++;
        }
        mesh_.vertices.resize(static_cast<std::size_t>(next));
        for (Corners& t : mesh_.triangles)
            for (int& corner : t) corner = number[static_cast<std::size_t>(corner)];
    }

    Mesh& mesh_;
    double tolerance_;
    int slivers_ = 0;                                        // found so far
    std::map<std::array<int, 2>, std::size_t> triangle_at_;  // by directed edge
};

}  // namespace

int take_out_slivers(Mesh& mesh, double tolerance) {
    return Mender(mesh, tolerance).mend();
}

}  // namespace assets
