#pragma once
#include <functional>
#include <string>

namespace app {

/// What `program` ends with after `work`, which returns it or throws: 2 for a fault of a person or a file, 3 for a
/// check that did not hold, 1 for the rest; then one line says what is wrong on stderr. Writes out what stdout holds
/// back.
int exit_code_of(const std::string& program, const std::function<int()>& work);

}  // namespace app
