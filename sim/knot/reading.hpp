#pragma once
#include <optional>
#include <vector>

#include "sim/knot/identify.hpp"
#include "sim/knot/projection.hpp"

namespace sim::knot {

/// Type of the passages first .. first + count - 1 of an open one-strand diagram; nothing when it depends on whether
/// the ends are joined above or below. `only_if_knotted`: what is no knot joined above is not looked at below.
std::optional<Identity> type_of_stretch(const Diagram& open, int first, int count, bool only_if_knotted, Work& work);

/// An open strand seen from one side, for the types of its stretches.
class Reading {
  public:
    /// Reads `open`; what types cost is paid from `work`, which must outlive it.
    Reading(OpenDiagram open, Work& work) : open_(std::move(open)), work_(&work) {}

    /// The number of passages along the strand.
    int passages() const { return static_cast<int>(open_.positions.size()); }
    /// The strand's diagram, of one open strand.
    const Diagram& diagram() const { return open_.diagram; }
    /// The work that may still be spent.
    Work& work() const { return *work_; }

    /// The type of the passages first .. first + count - 1, as type_of_stretch() finds it.
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

/// Whether a stretch has a type, and that is a knot.
inline bool knotted(const std::optional<Identity>& type) {
    return type && !type->factors.empty();
}

}  // namespace sim::knot
