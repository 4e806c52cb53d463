#pragma once
#include "sim/geometry/hash.hpp"
#include "tissue/bite.hpp"

// What a wall's next step depends on, added to a hash; Tissue, Skin and Bites have theirs as friends.
namespace tissue {

using sim::geometry::Hash;

void add_to(Hash& hash, const MaterialPoint& point);  ///< Tetrahedron and weights.
void add_to(Hash& hash, const Hold& hold);            ///< Node, target and axes.
void add_to(Hash& hash, const PointForce& force);     ///< All of it.
void add_to(Hash& hash, const BiteEnd& end);          ///< All of it.
void add_to(Hash& hash, const Bite& bite);            ///< All of it, with both ends.

}  // namespace tissue
