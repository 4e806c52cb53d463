#include "app/window/menu.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/window/parts.hpp"
#include "app/window/play_screen.hpp"
#include "app/window/settings_screen.hpp"
#include "app/window/theme.hpp"
#include "scenarios/session/recordings_folder.hpp"

namespace app::window {

void Menu::draw(Shell& shell) {
    begin_page(shell);
    draw_header(shell);
    draw_notice(shell);
    draw_warnings(shell);
    ImGui::Spacing();
    draw_shelf(shell);
    ImGui::End();
}

void Menu::draw_header(Shell& shell) {
    const float em = ImGui::GetFontSize();
    words(shell.window.fonts().title, theme::text, "Carrel");
    ImGui::SameLine(0, 2 * em);
    const bool is_wide = static_cast<float>(shell.window.width()) > 64 * em;
    if (is_wide) draw_person(shell);
    const float right = button_width("Settings") + button_width("Quit") + ImGui::GetStyle().ItemSpacing.x;
    at_right(right);
    if (shell.ui.button("Settings")) shell.next = std::make_unique<SettingsScreen>(shell);
    ImGui::SameLine();
    if (shell.ui.button("Quit")) shell.is_over = true;
    if (!is_wide) draw_person(shell), ImGui::NewLine();
    words(shell.window.fonts().small, theme::dim,
          shell.settings.is_exam
              ? "Exam: one attempt without help, pause or slow motion; it is recorded."
              : "Practice: guidance, ghost, pause and assists as you like; every attempt is recorded.");
}

void Menu::draw_person(Shell& shell) {
    const float em = ImGui::GetFontSize();
    shell.ui.text_field("Who plays", shell.settings.who, 10 * em, "a pseudonym");
    if (ImGui::IsItemDeactivatedAfterEdit()) shell.save(), shell.shelf.look_again(shell.settings);
    ImGui::SameLine(0, 1.5f * em);
    if (shell.ui.choice("Practice", !shell.settings.is_exam)) shell.settings.is_exam = false, shell.save();
    ImGui::SameLine(0, 2);
    if (shell.ui.choice("Exam", shell.settings.is_exam)) shell.settings.is_exam = true, shell.save();
    ImGui::SameLine();
}

void Menu::draw_warnings(Shell& shell) {
    const ImU32 color = theme::warning;
    if (const auto problem = scenarios::session::problem_with_player(who_of(shell.settings)))
        words(shell.window.fonts().text, color, "! Who plays: " + *problem);
    if (const auto low = scenarios::session::low_space(shell.where.recordings))
        words(shell.window.fonts().text, color, "! " + *low);
}

void Menu::draw_shelf(Shell& shell) {
    const auto drills = shell.shelf.drills();
    const float em = ImGui::GetFontSize();
    ImGui::BeginChild("drills", {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    const float gap = ImGui::GetStyle().ItemSpacing.x + 0.3f * em, room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>((room + gap) / (23 * em + gap)));
    const float width = (room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns);
    int column = 0;
    for (const ShelfDrill& drill : drills) {
        if (!drill.problem.empty()) continue;
        if (column > 0) ImGui::SameLine(0, gap);
        draw_card(shell, drill, {width, 0.5f * width + 10.2f * em});
        column = (column + 1) % columns;
    }
    for (const ShelfDrill& drill : drills)
        if (!drill.problem.empty()) draw_broken(shell, drill);
    if (drills.empty())
        words(shell.window.fonts().text, theme::dim,
              shell.shelf.is_read() ? "No drills are here. Add a folder of drill files in the settings."
                                    : "Reading the drills …");
    ImGui::EndChild();
}

// The whole card is the button.
void Menu::draw_card(Shell& shell, const ShelfDrill& drill, ImVec2 size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(drill.file.c_str());
    const bool is_chosen = ImGui::InvisibleButton("card", size);
    shell.ui.note(drill.title, "drill");
    shell.ui.say("tries " + drill.title, drill.tries);
    const bool is_lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize(), pad = 0.7f * em;
    const ImVec2 most{at.x + size.x, at.y + size.y};
    list.AddRectFilled(at, most, is_lit ? theme::raised : theme::panel, 8);
    const float picture = size.x * 0.5f;
    if (const Texture* texture = texture_of(drill)) {
        // What is cut off is rather sky than field.
        const float cut = 1 - (picture / size.x) / (texture->size().y / texture->size().x);
        list.AddImageRounded(texture->id(), at, {most.x, at.y + picture}, {0, 0.75f * cut}, {1, 1 - 0.25f * cut},
                             IM_COL32_WHITE, 8, ImDrawFlags_RoundCornersTop);
    }
    list.AddRect(at, most, is_lit ? theme::accent : theme::line, 8);
    const float wide = size.x - 2 * pad;
    ImVec2 pen{at.x + pad, at.y + picture + 0.6f * em};
    const auto write = [&](ImFont* font, ImU32 color, const std::string& text, int lines) {
        ImGui::PushFont(font);
        const std::string some = fitted(text, wide, lines);
        list.AddText(font, font->FontSize, pen, color, some.c_str(), nullptr, wide);
        pen.y += ImGui::CalcTextSize(some.c_str(), nullptr, false, wide).y + 0.3f * em;
        ImGui::PopFont();
    };
    write(shell.window.fonts().bold, theme::text, drill.title, 2);
    write(shell.window.fonts().small, theme::dim, drill.goal, 3);
    pen.y = most.y - 3.1f * em;
    write(shell.window.fonts().small, drill.best.empty() ? theme::dim : theme::accent,
          drill.best.empty() ? "Not tried yet" : drill.best, 1);
    write(shell.window.fonts().small, theme::dim, drill.tries, 1);
    if (is_chosen) shell.next = open_drill(shell, drill.file);
    ImGui::PopID();
}

void Menu::draw_broken(Shell& shell, const ShelfDrill& drill) {
    shell.ui.say("broken " + drill.title, drill.problem);
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::warning);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(("✗ " + drill.title + " cannot be played").c_str());
    ImGui::PopStyleColor();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::dim);
    ImGui::TextUnformatted(drill.problem.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

const Texture* Menu::texture_of(const ShelfDrill& drill) {
    if (!drill.image) return nullptr;
    const auto found = textures_.find(drill.image.get());
    if (found != textures_.end()) return &found->second.second;
    return &textures_.emplace(drill.image.get(), std::pair(drill.image, Texture(*drill.image))).first->second.second;
}

}  // namespace app::window
