#pragma once
#include "scenarios/drill/schema.hpp"

namespace bench::lab {

/// Every key of a scene file but "variants", with its range and default.
const scenarios::drill::Schema& hard_case_schema();

}  // namespace bench::lab
