#include "app/window/parts.hpp"

#include "app/window/theme.hpp"

namespace app::window {

void begin_page(const Shell& shell) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({static_cast<float>(shell.window.width()), static_cast<float>(shell.window.height())});
    ImGui::Begin("page", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
}

void words(ImFont* font, ImU32 color, const std::string& text) {
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void line(ImFont* font, ImU32 color, const std::string& text) {
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void at_right(float width) {
    const float x = ImGui::GetWindowContentRegionMax().x - width;
    if (x > ImGui::GetCursorPosX()) ImGui::SetCursorPosX(x);
}

float button_width(const std::string& label) {
    return ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

void draw_notice(Shell& shell) {
    if (shell.notice.empty()) return;
    words(shell.window.fonts().text, theme::warning, "! " + shell.notice);
    if (shell.ui.button("Understood")) shell.notice.clear();
}

std::string fitted(const std::string& text, float width, int lines) {
    const float most = static_cast<float>(lines) * ImGui::GetTextLineHeight() + 1;
    const auto fits = [&](const std::string& some) {
        return ImGui::CalcTextSize(some.c_str(), nullptr, false, width).y <= most;
    };
    if (fits(text)) return text;
    std::string some = text;
    while (!some.empty() && !fits(some + " …"))
        some.resize(some.find_last_of(' ') == std::string::npos ? 0 : some.find_last_of(' '));
    return some + " …";
}

}  // namespace app::window
