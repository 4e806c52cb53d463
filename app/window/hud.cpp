#include "app/window/hud.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/parts.hpp"
#include "app/window/theme.hpp"

namespace app::window {

using scenarios::drill::Drill;

void begin_panel(const Shell& shell, const char* name, Corner corner, float width, float down) {
    const float edge = 0.6f * ImGui::GetFontSize();
    const auto at = [&](float share, int size) { return edge + share * (static_cast<float>(size) - 2 * edge); };
    ImGui::SetNextWindowPos({at(corner.x, shell.window.width()), at(corner.y, shell.window.height()) + down}, 0,
                            {corner.x, corner.y});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::SetNextWindowBgAlpha(0.78f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12, 9});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     (width > 0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize));
}

void end_panel() {
    ImGui::End();
    ImGui::PopStyleVar(2);
}

static std::string counted(std::size_t step, std::size_t count) {
    return step < count ? "Step " + std::to_string(step + 1) + " of " + std::to_string(count) : "All steps done";
}

void draw_guide(Shell& shell, const Drill& drill, const GuideView& guide) {
    const Fonts& fonts = shell.window.fonts();
    const float em = ImGui::GetFontSize(), room = static_cast<float>(shell.window.width());
    const Corner corner = is_wide(shell) ? Corner{0.47f, 1} : Corner{0, 0};
    begin_panel(shell, "guide", corner, is_wide(shell) ? 25 * em : std::min(24 * em, room - 320));
    if (drill.steps.empty()) {
        words(fonts.bold, theme::text, drill.title);
        words(fonts.text, theme::text, drill.description);
    } else {
        words(fonts.bold, theme::accent, counted(guide.step, drill.steps.size()));
        if (guide.step > 0) {
            const bool was_passed = guide.marks[guide.step - 1].passed_over;
            words(fonts.small, was_passed ? theme::dim : theme::good,
                  (was_passed ? "– " : "✓ ") + drill.steps[guide.step - 1].text);
        }
        if (guide.step < drill.steps.size()) words(fonts.text, theme::text, "▶ " + drill.steps[guide.step].text);
        if (guide.step + 1 < drill.steps.size()) words(fonts.small, theme::dim, drill.steps[guide.step + 1].text);
    }
    shell.ui.say("step", std::to_string(guide.step));
    shell.ui.say("steps", std::to_string(drill.steps.size()));
    end_panel();
}

static std::string in_digits(const char* format, double value) {
    char text[60];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

static std::string clock_of(double t_s) {
    const int minutes = static_cast<int>(t_s / 60);
    return std::to_string(minutes) + in_digits(":%04.1f", t_s - 60 * minutes);
}

void draw_status(Shell& shell, const StatusLine& status, float down) {
    const Fonts& fonts = shell.window.fonts();
    begin_panel(shell, "status", {1, 0}, 0, down);
    line(fonts.title, theme::text, clock_of(status.t_s));
    ImGui::SameLine();
    if (status.is_exam) line(fonts.bold, theme::warning, "EXAM");
    if (!status.is_exam) line(fonts.text, theme::dim, status.is_paused ? "paused" : "practice");
    const bool is_slow = !status.is_paused && status.t_s > 1 && status.pace < 0.95 * status.aimed_at;
    if (!status.is_paused)
        line(fonts.text, is_slow ? theme::warning : theme::text, in_digits("%.2f", status.pace) + "× real time");
    if (is_slow) line(fonts.small, theme::warning, "! the computer is too slow");
    std::string small = std::to_string(status.frames_per_s) + " pictures/s";
    if (status.latency_ms >= 0) small += " · hand to picture " + std::to_string(status.latency_ms) + " ms";
    line(fonts.small, theme::dim, small);
    shell.ui.say("trouble", status.trouble.value_or(""));
    if (status.trouble)
        line(fonts.text, theme::bad, "! not recorded: " + *status.trouble);
    else
        line(fonts.small, theme::dim, "● recording");
    shell.ui.say("time", in_digits("%.1f", status.t_s));
    shell.ui.say("pace", in_digits("%.2f", status.pace));
    shell.ui.say("paused", status.is_paused ? "yes" : "no");
    end_panel();
}

static const char* words_of(instruments::Kind kind) {
    switch (kind) {
        case instruments::Kind::forceps:
            return "forceps";
        case instruments::Kind::needle_holder:
            return "needle holder";
        case instruments::Kind::scissors:
            return "scissors";
        case instruments::Kind::approximator:
            return "approximator";
    }
    return "";
}

static std::string leader_of(int tool, const hands::HandsView& hands) {
    return tool == hands.mouse ? "mouse" : tool == hands.keys ? "keys" : "";
}

bool is_wide(const Shell& shell) {
    return static_cast<float>(shell.window.width()) > 76 * ImGui::GetFontSize();
}

float draw_tools(Shell& shell, const View& view, const hands::HandsView& hands) {
    const Fonts& fonts = shell.window.fonts();
    begin_panel(shell, "tools", {0, 1});
    for (std::size_t i = 0; i < view.tools.size(); ++i) {
        const auto& tool = view.tools[i];
        const std::string leader = leader_of(static_cast<int>(i), hands);
        line(fonts.bold, leader.empty() ? theme::dim : theme::text, std::to_string(i + 1) + "  " + tool.name);
        ImGui::SameLine();
        line(fonts.text, theme::dim, words_of(tool.kind));
        if (!leader.empty()) {
            ImGui::SameLine();
            line(fonts.text, leader == "mouse" ? theme::accent : theme::warning, leader);
        }
        ImGui::SameLine();
        line(fonts.text, tool.held.empty() ? theme::dim : theme::good,
             tool.held.empty() ? "holds nothing" : "holds " + tool.held);
        if (tool.lag_mm > 1) {
            ImGui::SameLine();
            line(fonts.text, theme::warning, in_digits("held back %.0f mm", tool.lag_mm));
        }
        shell.ui.say("held " + tool.name, tool.held);
    }
    if (hands.is_fine || hands.scale != 1)
        line(fonts.small, theme::dim, in_digits("moves × %.2f", hands.scale * (hands.is_fine ? 0.25 : 1)));
    if (const std::string names = hands.assists.names(); !names.empty())
        line(fonts.small, theme::warning, "assists: " + names);
    const float high = ImGui::GetWindowHeight();
    end_panel();
    return high;
}

std::string knot_words(const std::string& knot) {
    if (knot.empty() || knot == "0_1") return "no knot yet";
    return knot;
}

void draw_tension(Shell& shell, const View& view, const Drill& drill, float up) {
    const Fonts& fonts = shell.window.fonts();
    const float em = ImGui::GetFontSize();
    begin_panel(shell, "tension", {1, 1}, 19 * em, -up);
    const auto& band = drill.bands.tension_N;
    const double most = band && std::isfinite(band->high) ? band->high : 2;
    const double full = 1.5 * most;
    const bool is_over = band && !band->holds(view.tension_max_N);
    line(fonts.text, theme::dim, "Knot so far");
    ImGui::SameLine();
    line(fonts.bold, theme::text, knot_words(view.knot));
    line(fonts.text, theme::dim, "Tension");
    ImGui::SameLine();
    line(fonts.bold, is_over ? theme::bad : theme::text, in_digits("%.2f N", view.tension_N));
    ImGui::SameLine();
    line(fonts.small, is_over ? theme::bad : theme::dim,
         band ? in_digits(is_over ? "✗ was over %.2f N" : "at most %.2f N", most)
              : in_digits("largest %.2f N", view.tension_max_N));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float wide = ImGui::GetContentRegionAvail().x, high = 0.7f * em;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto x_of = [&](double N) { return at.x + wide * static_cast<float>(std::clamp(N / full, 0.0, 1.0)); };
    list.AddRectFilled(at, {at.x + wide, at.y + high}, theme::raised, 4);
    if (band) list.AddRectFilled({x_of(band->low), at.y}, {x_of(most), at.y + high}, theme::band, 4);
    list.AddRectFilled(at, {x_of(view.tension_N), at.y + high}, view.tension_N > most ? theme::bad : theme::accent, 4);
    list.AddLine({x_of(view.tension_max_N), at.y - 2}, {x_of(view.tension_max_N), at.y + high + 2}, theme::text, 2);
    ImGui::Dummy({wide, high});
    shell.ui.say("knot", view.knot);
    end_panel();
}

void draw_marks(Shell& shell, const draw::Picture& picture, const View& view, const hands::HandsView& hands) {
    const float em = ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (std::size_t i = 0; i < view.scene.tools.size(); ++i) {
        const draw::Vec3 at = draw::project(picture, view.scene.tools[i].pose.position);
        if (at.z() <= 0) continue;
        shell.ui.say("tip " + view.tools[i].name, at.x(), at.y());
        const std::string leader = leader_of(static_cast<int>(i), hands);
        if (leader.empty()) continue;
        const ImU32 color = leader == "mouse" ? theme::accent : theme::warning;
        const ImVec2 label{static_cast<float>(at.x()) + 0.9f * em, static_cast<float>(at.y()) - 1.6f * em};
        list.AddText(shell.window.fonts().bold, shell.window.fonts().bold->FontSize, label, color, leader.c_str());
    }
}

}  // namespace app::window
