#pragma once
#include <array>
#include <vector>

#include "sim/knot/diagram.hpp"

namespace sim::knot {

/// The plane graph of a diagram, where asked with one edge (`missing`) left out. Edge (strand s, index i) leads from
/// passage i to i + 1. Dart 2e walks edge e forwards with its left face on the left hand, dart 2e + 1 backwards with
/// its right face there. The diagram must outlive it.
class Faces {
  public:
    /// The faces of a whole diagram. O(crossings).
    explicit Faces(const Diagram& diagram) : Faces(diagram, -1, -1) {}
    /// The faces of a diagram without the edge from passage `index` of `strand` on.
    Faces(const Diagram& diagram, int strand, int index);

    /// The number of edges, the missing one included: two for each crossing.
    int edges() const { return edges_; }
    /// The number of the missing edge; -1: none is missing.
    int missing() const { return missing_; }
    /// The number of a strand's first edge; the others follow in order.
    int offset(int strand) const { return offset_[static_cast<std::size_t>(strand)]; }
    /// The face, 0 to count() - 1, that a dart has on its left hand; -1 beside the missing edge.
    int face_of_dart(int dart) const { return face_[static_cast<std::size_t>(dart)]; }
    /// The number of faces.
    int count() const { return count_; }
    /// The face in which the missing edge starts.
    int face_at_start() const { return face_beside(start_[static_cast<std::size_t>(missing_)]); }
    /// The face in which the missing edge ends.
    int face_at_end() const { return face_beside(end_[static_cast<std::size_t>(missing_)]); }

  private:
    struct Ray {
        int crossing = 0, turn = 0;  // turn: 0..3 counter-clockwise
    };
    struct Spoke {
        int edge = 0;
        bool outgoing = false;
    };

    void number_edges();
    void number_rays();
    void number_faces();
    int dart_after(Ray ray) const;
    int face_beside(Ray ray) const;

    const Diagram& diagram_;
    std::vector<int> offset_, face_;
    std::vector<Ray> start_, end_;
    std::vector<std::array<Spoke, 4>> spokes_;
    int edges_ = 0, missing_ = -1, count_ = 0;
};

}  // namespace sim::knot
