#pragma once
#include <string>
#include <vector>

namespace scenarios::drill {

/// What to say of a key that is not among `known`: the one that was meant, if it is near in spelling or is the same
/// quantity in another unit ("length_cm" for "length_mm"); else all that are known.
std::string unknown_key(const std::string& key, const std::vector<std::string>& known);

/// The nearest of `known` to `word` by edit distance, or empty if none is nearer than a third of its letters.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace scenarios::drill
