#include <cstdio>
#include <numeric>

#include "scenarios/world/jaws.hpp"
#include "scenarios/world/world.hpp"

// A thread comes apart where it is pulled too hard or blades close on it, as the tick left it.
namespace scenarios::world {

void World::part_thread() {
    break_where_pulled_too_hard();
    for (Tool& tool : tools_)
        if (tool.def.kind == instruments::Kind::scissors) close_blades(tool);
}

double World::place_mm(int link, double share) const {
    const auto rest = thread_.rest_lengths();
    return 1e3 * std::accumulate(rest.begin(), rest.begin() + link, share * rest[static_cast<std::size_t>(link)]);
}

// The thread breaks in one place a tick: whatever else was pulled as hard is slack then. Where it cannot break, as next
// to an end, it is tried again as long as the pull lasts.
void World::break_where_pulled_too_hard() {
    if (!strength_.gives_way(tension_now_, def_.tick_s, is_elastic())) return;
    const int link = thread_.most_loaded();
    if (link < 0) return;
    const double place = place_mm(link, 0.5);
    char what[40];
    std::snprintf(what, sizeof what, "thread at %.2f N", tension_now_);
    if (!cut(link, 0.5)) {
        strength_.pulled_s = 0;
        return;
    }
    log(EventKind::broken, what, place);
    if (!measures_.broke_s) measures_.broke_s = time_s();
}

// Blades that close cut every strand that passes between them, as jaws would hold it. They start at the last strand, so
// that the links before it keep their numbers.
void World::close_blades(Tool& tool) {
    if (tool.now.jaw > open_above) tool.closed = false;
    if (tool.closed || tool.now.jaw > shut_below) return;
    tool.closed = true;
    const JawRoom room(tool.shape, tool.now.jaw);
    const auto place = [&](int k) { return in_tool(tool.now, thread_.nodes()[static_cast<std::size_t>(k)]); };
    for (int i = static_cast<int>(thread_.rest_lengths().size()) - 1; i >= 0; --i) {
        const Vec3 a = place(i), b = place(i + 1);
        if (thread_.is_cut(i) || !room.is_passed_by(a, b)) continue;
        const double share = JawRoom::crossing(a, b), at_mm = place_mm(i, share);
        if (cut(i, share)) log(EventKind::cut, tool.def.name, at_mm);
    }
}

bool World::cut(int link, double share) {
    list_held();
    if (!thread_.cut(link, share, held_)) return false;
    hold_pieces();
    knot_watch_.note_motion();
    return true;
}

// After a cut each tool and needle finds what it holds by the new numbers in held_.
void World::hold_pieces() {
    std::span<const int> left = held_;
    for (Tool& tool : tools_) {
        std::size_t count = 0;
        for (const Grasp& grasp : tool.grasps) count += static_cast<std::size_t>(grasp.count());
        hold_pieces(tool, left.first(count));
        left = left.subspan(count);
    }
    for (Needle& needle : needles_) needle.node = left.front(), left = left.subspan(2);
}

// When a strand is cut between a tool's jaws, both stumps are held to their ends, each as a strand of its own.
void World::hold_pieces(Tool& tool, std::span<const int> held) {
    std::vector<Grasp> pieces;
    const auto hold = [&](int node, const Vec3& anchor) {
        Grasp& piece = pieces.back();
        if (piece.count() == 0) piece.first = node;
        piece.anchor.push_back(anchor);
    };
    const auto hold_where_it_is = [&](int node) {
        hold(node, in_tool(tool.now, thread_.nodes()[static_cast<std::size_t>(node)]));
    };
    const int last = static_cast<int>(thread_.nodes().size()) - 1;
    std::size_t next = 0;
    for (const Grasp& grasp : tool.grasps) {
        pieces.push_back({});
        bool lost = false;  // a node has gone since the last that is left
        for (int k = 0; k < grasp.count(); ++k) {
            const int node = held[next++];
            if (node < 0) {
                lost = true;
                continue;
            }
            if (pieces.back().count() == 0 && lost && node > 0 && !thread_.is_cut(node - 1)) hold_where_it_is(node - 1);
            for (int i = pieces.back().count() > 0 ? pieces.back().first + pieces.back().count() : node; i <= node;
                 ++i) {
                if (pieces.back().count() > 0 && thread_.is_cut(i - 1)) pieces.push_back({});
                if (i < node) hold_where_it_is(i);
            }
            hold(node, grasp.anchor[static_cast<std::size_t>(k)]);
            lost = false;
        }
        const int end = pieces.back().first + pieces.back().count();  // the node after the last
        if (lost && pieces.back().count() > 0 && end <= last && !thread_.is_cut(end - 1)) hold_where_it_is(end);
        if (pieces.back().count() > 0) continue;
        pieces.pop_back();
        log(EventKind::release, tool.def.name, 0);
    }
    tool.grasps.assign(pieces.begin(), pieces.end());
}

}  // namespace scenarios::world
