#pragma once
#include <vector>

#include "sim/thread/contact/link_tree.hpp"
#include "sim/thread/contact/state.hpp"

namespace sim::thread::contact {

/// Finds what links are near, into State::contacts: a bounding-volume tree over the links against itself, against
/// tools and against the surface's own tree. O(n log n) when it looks, O(holds + capsules) when what is known still
/// stands.
class Detection {
  public:
    /// Makes room for a thread of at most so many links.
    explicit Detection(std::size_t most_links);

    /// Finds every pair within State::reach of each other, where it is not known already, with room for held nodes and
    /// tools to go `path` [m] from here; returns whether it had to look.
    bool look_around(State& state, double path);
    /// Finds only what tools are near; the next look_around() sees the rest, and before it contacts serve for nothing
    /// else. `path` and the result are as in look_around().
    bool look_at_tools(State& state, double path);

  private:
    /// A link's middle and half its length [m]: most pairs are told apart by these.
    struct Middle {
        Vec3 place;
        double half;
    };
    bool scene_changed(State& state);
    bool is_due(State& state, double path);
    void detect_self(State& state);
    void detect_capsules(State& state);
    void detect_surface(State& state);

    LinkTree tree_;
    std::vector<Middle> middles_;
    std::vector<int> found_;
};

}  // namespace sim::thread::contact
