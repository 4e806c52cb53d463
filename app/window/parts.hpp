#pragma once
#include <string>

#include "app/window/screen.hpp"

// What several screens are put together from.
namespace app::window {

/// Begins a window that fills the screen; ImGui::End() ends it.
void begin_page(const Shell& shell);
/// Words in one of the letters and colours, broken to the room there is.
void words(ImFont* font, ImU32 color, const std::string& text);
/// The same on one line, however wide that is.
void line(ImFont* font, ImU32 color, const std::string& text);
/// Puts what follows at the right edge: `width` is how wide it is.
void at_right(float width);
/// How wide a button with this label is.
float button_width(const std::string& label);
/// What went wrong, with a button that puts it away; nothing where all is well.
void draw_notice(Shell& shell);
/// The text cut so that it fits into so many lines of a width, with dots where it is.
std::string fitted(const std::string& text, float width, int lines);

}  // namespace app::window
