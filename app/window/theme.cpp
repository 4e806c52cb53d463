#include "app/window/theme.hpp"

#include <utility>

namespace app::window::theme {

static void apply_colors(ImGuiStyle& style) {
    const auto mix = [](ImU32 color, float alpha) {
        ImVec4 of = ImGui::ColorConvertU32ToFloat4(color);
        of.w = alpha;
        return of;
    };
    const std::pair<int, ImVec4> colors[] = {
        {ImGuiCol_Text, mix(text, 1)},
        {ImGuiCol_TextDisabled, mix(dim, 1)},
        {ImGuiCol_WindowBg, mix(background, 1)},
        {ImGuiCol_ChildBg, mix(background, 0)},
        {ImGuiCol_PopupBg, mix(panel, 1)},
        {ImGuiCol_Border, mix(line, 1)},
        {ImGuiCol_FrameBg, mix(raised, 1)},
        {ImGuiCol_FrameBgHovered, mix(line, 1)},
        {ImGuiCol_FrameBgActive, mix(line, 1)},
        {ImGuiCol_Button, mix(raised, 1)},
        {ImGuiCol_ButtonHovered, mix(line, 1)},
        {ImGuiCol_ButtonActive, mix(primary, 1)},
        {ImGuiCol_Header, mix(raised, 1)},
        {ImGuiCol_HeaderHovered, mix(line, 1)},
        {ImGuiCol_HeaderActive, mix(primary, 1)},
        {ImGuiCol_CheckMark, mix(accent, 1)},
        {ImGuiCol_SliderGrab, mix(accent, 1)},
        {ImGuiCol_SliderGrabActive, mix(accent, 1)},
        {ImGuiCol_ScrollbarBg, mix(background, 0)},
        {ImGuiCol_ScrollbarGrab, mix(line, 1)},
        {ImGuiCol_Separator, mix(line, 1)},
        {ImGuiCol_NavHighlight, mix(warning, 1)},
        {ImGuiCol_ModalWindowDimBg, mix(background, 0.7f)},
    };
    for (const auto& [which, color] : colors) style.Colors[which] = color;
}

void apply(double scale) {
    ImGuiStyle style;
    apply_colors(style);
    style.WindowPadding = {16, 14};
    style.FramePadding = {12, 7};
    style.ItemSpacing = {10, 9};
    style.WindowRounding = 0;
    style.ChildRounding = style.FrameRounding = style.PopupRounding = style.GrabRounding = 6;
    style.WindowBorderSize = 0;
    style.ScrollbarSize = 12;
    style.ScaleAllSizes(static_cast<float>(scale));
    ImGui::GetStyle() = style;
}

}  // namespace app::window::theme
