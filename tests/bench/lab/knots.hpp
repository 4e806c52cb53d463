#pragma once
#include <array>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace bench::lab {

using sim::geometry::Vec3;

enum class Knot { trefoil, figure_eight, five_one, five_two, square, granny, surgeons, bowline };

struct KnownKnot {
    Knot knot;
    const char* words;  ///< "square"
    const char* type;   ///< What the namer calls it: "3_1#m3_1".
};

/// The knots of the seeded ties.
extern const std::array<KnownKnot, 8> known_knots;
const KnownKnot& known(Knot knot);

/// A loose open knot, any unit; its ends can go straight on for ever.
std::vector<Vec3> loose(Knot knot);

/// Even pieces, each vertex drawn towards its neighbours' middle again and again: corners become bends.
std::vector<Vec3> rounded(const std::vector<Vec3>& corners, int times, int pieces = 160);

/// A square or granny knot above a loop that hangs `deep` below it, in z, where the throws are 2 wide; symmetric about
/// its middle vertex, which is the lowest.
std::vector<Vec3> looped(Knot knot, double deep);

/// That knot in a thread: its nodes [m], loose enough that no two strands touch and no bend is too tight.
struct Loose {
    std::vector<Vec3> nodes;
    int tail = 0;  ///< Links of the shorter straight end.
};

/// `link` and `radius` [m]. At least `links` links: more when the knot needs them; both ends share what is over.
Loose loose_thread(Knot knot, int links, double link, double radius);
Loose loose_thread(const std::vector<Vec3>& path, int links, double link, double radius);

}  // namespace bench::lab
