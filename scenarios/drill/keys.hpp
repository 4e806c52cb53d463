#pragma once
#include "scenarios/drill/shape.hpp"

namespace scenarios::drill {

/// Every key of a drill file: the one table behind the loader's checks, the defaults and the published schema.
const Shape& drill_shape();

}  // namespace scenarios::drill
