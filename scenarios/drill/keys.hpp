#pragma once
#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

/// Every key of a drill file: the one table behind the loader's checks, the defaults and the published schema.
const Schema& drill_schema();

}  // namespace scenarios::drill
