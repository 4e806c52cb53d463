#include "sim/knot/faces.hpp"

#include "sim/geometry/at.hpp"

namespace sim::knot {

Faces::Faces(const Diagram& diagram, int strand, int index) : diagram_(diagram) {
    number_edges();
    if (strand >= 0) missing_ = offset_[at(strand)] + index;
    number_rays();
    number_faces();
}

void Faces::number_edges() {
    for (const auto& word : diagram_.strands) {
        offset_.push_back(edges_);
        edges_ += static_cast<int>(word.size());
    }
}

void Faces::number_rays() {
    spokes_.resize(diagram_.sign.size());
    start_.resize(at(edges_)), end_.resize(at(edges_));
    for (std::size_t s = 0; s < diagram_.strands.size(); ++s) {
        const int n = static_cast<int>(diagram_.strands[s].size());
        for (int i = 0; i < n; ++i) {
            const Passage p = diagram_.strands[s][at(i)];
            const int in = offset_[s] + (i + n - 1) % n, out = offset_[s] + i;
            const bool positive = diagram_.sign[at(p.crossing)] > 0;
            // Under runs south to north; over runs west to east at a positive crossing. 0 east, 1 north, ...
            const int turn_out = p.over ? (positive ? 0 : 2) : 1, turn_in = (turn_out + 2) % 4;
            spokes_[at(p.crossing)][at(turn_out)] = {out, true};
            spokes_[at(p.crossing)][at(turn_in)] = {in, false};
            start_[at(out)] = {p.crossing, turn_out};
            end_[at(in)] = {p.crossing, turn_in};
        }
    }
}

// Arriving at a crossing by `ray`, the sharpest left turn: the next spoke clockwise that is there.
int Faces::dart_after(Ray ray) const {
    for (int step = 1; step <= 4; ++step) {
        const Spoke spoke = spokes_[at(ray.crossing)][at((ray.turn + 4 - step % 4) % 4)];
        if (spoke.edge != missing_) return 2 * spoke.edge + (spoke.outgoing ? 0 : 1);
    }
    return -1;
}

void Faces::number_faces() {
    face_.assign(at(2 * edges_), -1);
    for (int first = 0; first < 2 * edges_; ++first) {
        if (first / 2 == missing_ || face_[at(first)] >= 0) continue;
        for (int dart = first; face_[at(dart)] < 0;) {
            face_[at(dart)] = count_;
            dart = dart_after(dart % 2 == 0 ? end_[at(dart / 2)] : start_[at(dart / 2)]);
        }
        ++count_;
    }
}

// The face on the spot of a missing ray: left of whoever arrives by the next spoke counter-clockwise.
int Faces::face_beside(Ray ray) const {
    for (int step = 1; step < 4; ++step) {
        const Spoke spoke = spokes_[at(ray.crossing)][at((ray.turn + step) % 4)];
        if (spoke.edge != missing_) return face_[at(2 * spoke.edge + (spoke.outgoing ? 1 : 0))];
    }
    return -1;
}

}  // namespace sim::knot
