#pragma once
#include <string>
#include <vector>

namespace scenarios::drill {

/// What to say of a key that is not among `known`: the one that was meant, if it is the same quantity in another unit
/// ("length_cm" for "length_mm") or is near in spelling to one of `missing`, those of `known` that are not there yet;
/// else all that are known.
std::string unknown_key(const std::string& key, const std::vector<std::string>& known,
                        const std::vector<std::string>& missing);

/// The nearest of `known` to `word`, or empty if none is near: at most one slip (a letter too many, missing, wrong or
/// swapped with the next) and another for every eight letters, in any case.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace scenarios::drill
