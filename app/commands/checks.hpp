#pragma once
namespace CLI {
class App;
}

namespace app {

/// `carrel validate DRILL...`: checks drill files, and the motions they name, without running them.
void add_validate(CLI::App& program);

/// `carrel explain DRILL`: effects on and off, their error and cost; defaults filled in.
void add_explain(CLI::App& program);

/// `carrel rope CURVE --motion MOTION`: moves one bare thread by its nodes and measures what it does.
void add_rope(CLI::App& program);

}  // namespace app
