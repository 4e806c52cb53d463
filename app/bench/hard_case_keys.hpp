#pragma once
#include "scenarios/drill/schema.hpp"

namespace app::bench {

/// Every key of a scene file but "variants", with its range and default.
const scenarios::drill::Schema& hard_case_schema();

}  // namespace app::bench
