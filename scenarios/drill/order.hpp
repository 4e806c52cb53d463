#pragma once
#include <span>
#include <string>
#include <vector>

#include "scenarios/drill/result.hpp"

namespace scenarios::drill {

/// How an item stands to its band.
enum class Standing {
    missed,    ///< Outside of it.
    close,     ///< Inside, within a tenth of the band's size of an edge: next time it may be missed.
    passed,    ///< Well inside.
    unjudged,  ///< It has none, and is shown only.
};

/// An item's place in the order of what matters.
struct Placed {
    std::size_t item;   ///< Its number in the list that was ordered.
    Standing standing;  ///< To its band.
};

/// Items by what matters to who was scored: what was missed, that of another kind than asked first (a granny for a
/// square knot) and then by how far it is outside in sizes of its band; what is close to an edge, the closest first;
/// the rest in the order given; at last what has no band. The size of "at most 60" is 60. Pure: it needs the items'
/// texts alone, so that recordings of any version are ordered alike.
std::vector<Placed> by_importance(std::span<const ScoreItem> items);

/// How far a missed item is outside its band, in words: "12.3 mm too much"; empty where that cannot be said in numbers.
std::string missed_by(const ScoreItem& item);

}  // namespace scenarios::drill
