#pragma once

namespace CLI {
class App;
}

namespace app {

/// carrel knot CURVE... [--closed] [--around CURVE]... [--json]
void add_knot_command(CLI::App& program);

}  // namespace app
