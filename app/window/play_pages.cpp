#include <algorithm>
#include <cmath>

#include "app/window/keys_page.hpp"
#include "app/window/menu.hpp"
#include "app/window/parts.hpp"
#include "app/window/play_screen.hpp"
#include "app/window/theme.hpp"

// The pages of the play screen that take the mouse: before an attempt, in a pause, while the pointer is free.
namespace app::window {

using hands::Action;

static void begin_dialog(const Shell& shell, const char* name, float width) {
    const auto wide = static_cast<float>(shell.window.width()), high = static_cast<float>(shell.window.height());
    ImGui::SetNextWindowPos({wide / 2, high / 2}, 0, {0.5f, 0.5f});
    const float room = std::min(width * ImGui::GetFontSize(), 0.96f * wide);
    ImGui::SetNextWindowSizeConstraints({room, 0}, {room, 0.96f * high});
    ImGui::SetNextWindowBgAlpha(0.95f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 10);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
}

void PlayScreen::draw_before(Shell& shell) {
    const Fonts& fonts = shell.window.fonts();
    const auto key = [&](Action action) { return keys_of(bindings_, action); };
    begin_dialog(shell, "before", 40);
    words(fonts.title, theme::text, player_->drill().title);
    words(fonts.text, theme::dim, player_->drill().description);
    ImGui::Spacing();
    if (is_exam())
        words(
            fonts.bold, theme::warning,
            "Exam: this is one attempt, without guide, ghost, assists, pause or slow motion. It counts from Begin on.");
    words(fonts.text, theme::text,
          "The mouse moves one instrument, its wheel away and towards you; the left button closes its jaws, the right "
          "one turns it.");
    words(fonts.text, theme::text,
          key(Action::k_up) + " " + key(Action::k_left) + " " + key(Action::k_down) + " " + key(Action::k_right) +
              ", " + key(Action::k_away) + " and " + key(Action::k_towards) + " move the other one, " +
              key(Action::k_jaw) + " closes its jaws; " + key(Action::swap) + " changes hands.");
    words(fonts.text, theme::text,
          key(Action::free_pointer) + " frees the pointer, then Finish scores the attempt; " + key(Action::all_keys) +
              " shows all keys.");
    ImGui::Spacing();
    if (shell.ui.button("Begin", Look::primary)) begin(shell);
    ImGui::SameLine();
    if (shell.ui.button("All keys")) shown_.keys = true;
    ImGui::SameLine();
    if (shell.ui.button("Menu")) shell.next = std::make_unique<Menu>();
    ImGui::End();
}

void PlayScreen::draw_paused(Shell& shell) {
    const Fonts& fonts = shell.window.fonts();
    begin_dialog(shell, shown_.keys ? "keys" : "paused", shown_.keys ? 66 : 34);
    words(fonts.title, theme::text, shown_.keys ? "All keys" : "Paused");
    if (shown_.keys && state_ != State::paused) {
        if (shell.ui.button("Back", Look::primary)) shown_.keys = false;
    } else {
        if (shell.ui.button("Go on", Look::primary)) go_on();
        ImGui::SameLine();
        if (shell.ui.button("Restart")) restart(shell);
        ImGui::SameLine();
        if (shell.ui.button("Finish and score")) finish(shell);
        ImGui::SameLine();
        if (shell.ui.button("Menu")) shell.next = std::make_unique<Menu>();
    }
    shell.ui.say("keys", shown_.keys ? "shown" : "hidden");
    if (shown_.keys)
        draw_keys(shell, bindings_);
    else
        draw_switches(shell);
    ImGui::End();
}

void PlayScreen::draw_switches(Shell& shell) {
    const Fonts& fonts = shell.window.fonts();
    const double most = player_->live().declared_pace();
    words(fonts.bold, theme::text, "Pace");
    const std::pair<const char*, double> paces[] = {{"1/8", 0.125}, {"1/4", 0.25}, {"1/2", 0.5}, {"Whole", 1}};
    for (const auto& [label, share] : paces) {
        if (shell.ui.choice(label, std::abs(pace_ - share * most) < 1e-3)) pace_ = share * most;
        ImGui::SameLine();
    }
    ImGui::NewLine();
    words(fonts.bold, theme::text, "Help");
    shell.ui.checkbox("Guide", shown_.guide);
    ImGui::SameLine();
    shell.ui.checkbox("Ghost", shown_.ghost);
    ImGui::SameLine();
    shell.ui.checkbox("Second camera", shown_.second_camera);
    words(fonts.bold, theme::text, "Assists: an attempt with one of them is kept apart from those without");
    for (const auto& row : hands::assist_rows) {
        bool is_on = assists_.has(row.assist);
        if (shell.ui.checkbox(row.name, is_on)) {
            assists_.set(row.assist, is_on);
            player_->devices().post({hands::Switch{row.assist, is_on}, now_s()});
        }
        ImGui::SameLine();
        words(fonts.small, theme::dim, row.help);
    }
}

// While the pointer is free and time goes on.
void PlayScreen::draw_actions(Shell& shell) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({static_cast<float>(shell.window.width()) / 2, em}, 0, {0.5f, 0});
    ImGui::Begin("actions", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize);
    words(shell.window.fonts().small, theme::dim,
          "The pointer is free: " + keys_of(bindings_, Action::free_pointer) + " gives the hand back.");
    if (shell.ui.button("Finish and score", Look::primary)) finish(shell);
    ImGui::SameLine();
    if (!is_exam() && shell.ui.button("Pause")) pause();
    if (!is_exam()) ImGui::SameLine();
    if (shell.ui.button("All keys")) act(shell, Action::all_keys);
    ImGui::SameLine();
    if (shell.ui.button("Menu")) shell.next = std::make_unique<Menu>();
    ImGui::End();
}

}  // namespace app::window
