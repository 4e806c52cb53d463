#pragma once
#include <imgui.h>

// Colours and measures of every screen. Signal colours are those of Okabe and Ito, which colour-blind people tell
// apart; none of them speaks alone: a word or a sign goes with each.
namespace app::window::theme {

inline constexpr ImU32 background = IM_COL32(17, 22, 28, 255);
inline constexpr ImU32 panel = IM_COL32(26, 33, 41, 255);
inline constexpr ImU32 raised = IM_COL32(37, 46, 56, 255);
inline constexpr ImU32 line = IM_COL32(58, 70, 82, 255);
inline constexpr ImU32 text = IM_COL32(235, 240, 244, 255);
inline constexpr ImU32 dim = IM_COL32(164, 180, 193, 255);
inline constexpr ImU32 accent = IM_COL32(86, 180, 233, 255);  // sky blue
inline constexpr ImU32 primary = IM_COL32(0, 114, 178, 255);  // blue
inline constexpr ImU32 good = IM_COL32(0, 158, 115, 255);     // bluish green
inline constexpr ImU32 warning = IM_COL32(230, 159, 0, 255);  // orange
inline constexpr ImU32 bad = IM_COL32(213, 94, 0, 255);       // vermilion
inline constexpr ImU32 band = IM_COL32(0, 158, 115, 70);      // where a value passes

/// Colours and spaces of Dear ImGui; scale as that of the letters.
void apply(double scale);

}  // namespace app::window::theme
