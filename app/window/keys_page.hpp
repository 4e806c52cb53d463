#pragma once
#include "app/hands/bindings.hpp"
#include "app/window/screen.hpp"

namespace app::window {

/// A table of all keys and of what the mouse does, with a heading.
void draw_keys(Shell& shell, const hands::Bindings& bindings);

/// The keys as the person has them; what is wrong with the file becomes the notice, and the usual keys are used.
hands::Bindings load_keys(Shell& shell);

/// A key's name for people: "Esc", "Space".
std::string keys_of(const hands::Bindings& bindings, hands::Action action);

}  // namespace app::window
