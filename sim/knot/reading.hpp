#pragma once
#include <optional>
#include <vector>

#include "sim/knot/identify.hpp"
#include "sim/knot/projection.hpp"

namespace sim::knot {

/// Type of the passages first .. first + count - 1 of an open one-strand diagram; nothing when it depends on whether
/// the ends are joined above or below. `only_if_knotted`: what is no knot joined above is not looked at below.
std::optional<Identity> type_of_stretch(const Diagram& open, int first, int count, bool only_if_knotted, Work& work);

/// An open strand seen from one side; types of its stretches.
class Reading {
  public:
    Reading(OpenDiagram open, Work& work) : open_(std::move(open)), work_(&work) {}

    int passages() const { return static_cast<int>(open_.positions.size()); }
    const Diagram& diagram() const { return open_.diagram; }
    Work& work() const { return *work_; }

    std::optional<Identity> type(int first, int count, bool only_if_knotted = false) const {
        if (count < 6) return Identity{};  // fewer than three crossings
        return type_of_stretch(open_.diagram, first, count, only_if_knotted, *work_);
    }

  private:
    OpenDiagram open_;
    Work* work_;
};

/// The strand from several sides, those that show the fewest crossings first. `work` must outlive them.
std::vector<Reading> views_of(const std::vector<Vec3>& strand, Work& work);

/// Those of the views in which the whole strand has its true type, as many as are wanted.
std::vector<Reading> good_ones(std::vector<Reading> views, const Identity& whole, std::size_t wanted);

inline bool knotted(const std::optional<Identity>& type) {
    return type && !type->factors.empty();
}

}  // namespace sim::knot
