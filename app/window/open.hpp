#pragma once
#include "app/commands/commands.hpp"

namespace app::window {

/// Opens the window on a drill, or on the menu where none is named, until the person leaves.
/// Throws NoWindow, and what a bad drill or folder throws.
void open(const PlayOptions& options);

}  // namespace app::window
