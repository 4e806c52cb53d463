#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "sim/knot/namer.hpp"

namespace sim::knot {

/// The throw a factor is: a throw of n turns closes to the torus knot T(2, 2n + 1) of its hand. Nothing for others.
std::optional<Throw> as_throw(const Factor& factor);

/// Tera and Aberg's notation: turns joined by '=' where the hand changes and by 'x' where it stays [TeraAberg1976].
std::string notation(const std::vector<Throw>& throws);

/// Fills `surgical` and `throws` of the name of an open curve. `name_part` names an open piece of it.
/// The type does not tell the order of throws; the pieces that grow from the loop outwards do, since each throw is met
/// before the next. Left empty when the pieces do not decide. Cost: none for one throw or equal throws, else some 40
/// names.
void read_throws(const std::vector<Vec3>& curve, const std::function<Name(const std::vector<Vec3>&)>& name_part,
                 Name& name);

}  // namespace sim::knot
