#pragma once
#include "scenarios/drill/shape.hpp"

namespace app::bench {

/// Every key of a scene file but "variants", with its range and default.
const scenarios::drill::Shape& hard_case_shape();

}  // namespace app::bench
