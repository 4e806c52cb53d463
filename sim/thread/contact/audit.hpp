#pragma once
#include <vector>

#include "sim/thread/contact/state.hpp"

namespace sim::thread::contact {

using geometry::Box;

/// An independent witness that nothing passed through anything: it knows nothing of contacts, reach or bounds, only
/// where every link, tool and triangle was and is.
class Audit {
  public:
    /// Makes room for a thread of at most so many links.
    explicit Audit(std::size_t most_links);

    /// How often the thread passed through itself, tools or the surface between State::before and State::nodes.
    int count_pass_throughs(const State& state);

  private:
    void measure(const State& state);
    int count_strands(const State& state) const;
    int count_capsules(const State& state) const;
    int count_surface(const State& state);

    std::vector<Box> boxes_;     // of each block of links, as they move
    std::vector<Box> swept_by_;  // of each link, as it moves
    std::vector<int> found_;     // triangles near a block
};

}  // namespace sim::thread::contact
