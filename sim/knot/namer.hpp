#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::knot {

using geometry::Vec3;

/// A prime knot that a knot is composed of.
struct Factor {
    std::string name;     ///< As the table lists it: "3_1".
    bool mirror = false;  ///< Whether it is the mirror image of the listing.
    int crossings = 0;    ///< The least crossings of the type.
};

/// One throw, read along the thread from the loop outwards.
struct Throw {
    int turns = 1;             ///< Turns of the strands about each other, at least 1, all of one hand.
    bool right_handed = true;  ///< Whether the strands turn about each other as a right-handed screw.
};

/// What a curve is called, and how sure that is.
struct Name {
    std::string knot = "0_1";     ///< "3_1#m3_1": factors sorted and joined by '#'; "unknown" if not in the table.
    std::vector<Factor> factors;  ///< The prime factors of `knot`, sorted.
    std::string surgical;         ///< "square", "surgeon's", "slip", "bowline", "clove hitch", ... or empty.
    std::string throws;           ///< Tera and Aberg: "1=1", "2=1", "1x1", or empty.
    int crossings_projected = 0;  ///< Crossings of the first view, after reduction in space.
    int crossings_reduced = 0;    ///< Crossings left after simplification; -1 when there were too many to count.
    bool certain = true;          ///< Whether `knot` is decided.
    std::vector<std::string> candidates;  ///< Names of the types that remain when not certain.
    bool flat = true;  ///< Whether the throws lie flat (square); else they have capsized to sliding half hitches.
    std::string half_hitches;  ///< Trimbos's notation of a stack that is not flat, "S=S" or "SxS"; else empty.
    /// The surgeon's name, or the knot's where there is none.
    const std::string& called() const { return surgical.empty() ? knot : surgical; }

    std::vector<Throw> throw_list;  ///< `throws` with the hand of each, from the loop outwards.
};

/// Places no further apart than this, in sizes of the curve, are one: strands must stay further apart.
constexpr double same_place = 1e-8;

/// One strand of a link, any unit. A closed one does not repeat its first vertex.
struct Component {
    std::vector<Vec3> vertices;  ///< In their order along the strand.
    bool closed = false;         ///< Whether the last vertex is joined to the first.
};

/// What several curves together are called.
struct LinkName {
    Name name;                                 ///< `knot`: "L2a1#3_1", "unlink", "3_1|0_1", or as for one component.
    std::vector<std::string> component_knots;  ///< Per component, the name of its knot alone.
    std::vector<int> linking_numbers;          ///< |lk| of each pair 01, 02, ..., 12, ...
};

/// Names the knot in an open curve (its ends joined outside its convex hull) or a closed one.
/// Vertices in order, any unit, at least two, finite. Scale, rotation and translation do not matter.
///
/// Never wrong: what cannot be decided comes back with `certain` false and the remaining candidates.
/// An end that lies inside the hull is led out in several directions; unless all agree, `certain` is false.
/// Cost: about 0.1 to 1 ms at 300 vertices; bounded work on any input (then "unknown"). Deterministic.
/// Strands must stay further apart than 1e-8 of the curve's size (undefined type otherwise; see first_touch).
Name name_knot(const std::vector<Vec3>& curve, bool closed = false);

/// Names several components together, direction and order of components not counting. Open ones are closed outside the
/// hull of all of them. Surgical names are of the first component: of its own knot, or if it has none and there is one
/// other, of how it is hitched round that.
LinkName name_link(const std::vector<Component>& components);

/// A thread in a scene: its own knot, or when it has none, the hitch it makes round one of the objects.
struct Tied {
    Name name;       ///< The name of the knot, or of the hitch.
    int round = -1;  ///< Number of the object that it is hitched to; -1: none.
};

/// Names what a thread is tied to. `objects`: each a core line that goes on beyond the thread at either end. A turn
/// round one is no hitch: nothing holds it. Cost: that of name_knot, and of a thread without a knot that of name_link
/// and four names for each object.
Tied name_among(const std::vector<Vec3>& thread, const std::vector<std::vector<Vec3>>& objects);

/// Two edges that meet, so that the curve has no type.
struct Touch {
    int component_a, vertex_a;  ///< The first edge: its component, and the index of its first vertex.
    int component_b, vertex_b;  ///< The second edge: its component, and the index of its first vertex.
};

/// The first pair of edges that are not neighbours and come closer than 1e-8 of the curve's size; nothing when there is
/// none. Repeated neighbouring vertices do not count. Stops with an answer "none found" after 2e8 box tests.
std::optional<Touch> first_touch(const std::vector<Component>& components);

}  // namespace sim::knot
