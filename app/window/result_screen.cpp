#include "app/window/result_screen.hpp"

#include <algorithm>
#include <cmath>

#include "app/play/output.hpp"
#include "app/window/menu.hpp"
#include "app/window/parts.hpp"
#include "app/window/play_screen.hpp"
#include "app/window/theme.hpp"

namespace app::window {

using scenarios::drill::ScoreItem;
using scenarios::drill::Standing;

namespace {

std::vector<ScoreItem> missed_of(const std::vector<ScoreItem>& items) {
    std::vector<ScoreItem> missed;
    std::copy_if(items.begin(), items.end(), std::back_inserter(missed), [](const auto& item) { return !item.passed; });
    return missed;
}

}  // namespace

ResultScreen::ResultScreen(Shell&, std::shared_ptr<Player> player, scenarios::drill::Result result)
    : player_(std::move(player)),
      result_(std::move(result)),
      work_(player_->options().recording, player_->drill(), missed_of(result_.items)) {
    for (const auto& [item, standing] : scenarios::drill::by_importance(result_.items))
        (standing == Standing::unjudged ? unjudged_ : judged_).push_back({result_.items[item], standing});
}

void ResultScreen::draw(Shell& shell) {
    begin_page(shell);
    draw_header(shell);
    draw_notice(shell);
    watch_report(shell);
    ImGui::BeginChild("items", {0, 0}, false);
    for (const auto& [item, standing] : judged_) draw_item(shell, item, standing);
    draw_unjudged(shell);
    ImGui::EndChild();
    ImGui::End();
}

void ResultScreen::draw_header(Shell& shell) {
    const Fonts& fonts = shell.window.fonts();
    const auto missed = missed_of(result_.items).size();
    words(fonts.title, result_.passed ? theme::good : theme::bad,
          result_.passed ? "✓ Passed" : "✗ Not passed: " + std::to_string(missed) + " to work on");
    const float right =
        button_width("Again") + button_width("Menu") + button_width("Report") + 2 * ImGui::GetStyle().ItemSpacing.x;
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < right) ImGui::NewLine();
    at_right(right);
    if (shell.ui.button("Again", Look::primary)) {
        shell.next = open_drill(shell, player_->file());
    }
    ImGui::SameLine();
    if (shell.ui.button("Menu")) shell.next = std::make_unique<Menu>();
    ImGui::SameLine();
    if (shell.ui.button("Report")) write_report(shell);
    const bool is_comparable = player_->live().is_comparable();
    char line[100];
    std::snprintf(line, sizeof line, "  ·  %.1f s  ·  %s", result_.duration_s,
                  player_->options().is_exam ? "exam" : "practice");
    words(fonts.text, theme::dim, result_.drill_title + line);
    if (!is_comparable)
        words(fonts.text, theme::warning,
              "! Not comparable: it ran slower than the drill is meant to. It is kept, but is never a best attempt.");
    if (const auto trouble = player_->live().trouble()) words(fonts.text, theme::bad, "! Not recorded: " + *trouble);
    if (!report_words_.empty()) words(fonts.small, theme::dim, report_words_);
    ImGui::Separator();
    shell.ui.say("passed", result_.passed ? "yes" : "no");
    shell.ui.say("recording", player_->options().recording.string());
}

void ResultScreen::draw_item(Shell& shell, const ScoreItem& item, Standing standing) {
    const Fonts& fonts = shell.window.fonts();
    const float em = ImGui::GetFontSize();
    ImGui::BeginGroup();
    if (!item.passed) draw_picture(shell, item.name);
    ImGui::BeginGroup();
    words(fonts.bold, item.passed ? theme::good : theme::bad, (item.passed ? "✓ " : "✗ ") + item.title);
    ImGui::SameLine(0, em);
    words(fonts.bold, theme::text, item.value + (item.unit.empty() ? "" : " " + item.unit));
    ImGui::SameLine(0, em);
    words(fonts.text, theme::dim, "asked: " + item.band);
    if (const std::string by = scenarios::drill::missed_by(item); !by.empty()) words(fonts.bold, theme::bad, by);
    if (standing == Standing::close) words(fonts.text, theme::warning, "just inside");
    if (!item.why.empty()) words(fonts.text, theme::text, item.why);
    draw_history(item);
    ImGui::EndGroup();
    ImGui::EndGroup();
    ImGui::Dummy({0, em / 3});
    ImGui::Separator();
}

void ResultScreen::draw_picture(Shell& shell, const std::string& item) {
    const float em = ImGui::GetFontSize();
    const ImVec2 size{10.5f * em, 7 * em};
    if (auto image = work_.take_picture(item)) textures_.emplace(item, Texture(*image));
    const auto found = textures_.find(item);
    if (found != textures_.end()) {
        ImGui::Image(found->second.id(), size);
        if (ImGui::IsItemHovered()) {
            ImGui::BeginTooltip();
            ImGui::Image(found->second.id(), {36 * em, 24 * em});
            ImGui::EndTooltip();
        }
        shell.ui.say("picture " + item, "drawn");
    } else {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, theme::panel, 6);
        ImGui::GetWindowDrawList()->AddText({at.x + em / 2, at.y + 3 * em}, theme::dim, "drawing the moment …");
        ImGui::Dummy(size);
    }
    ImGui::SameLine(0, em);
}

// Bars of the last ten attempts, the newest at the right and lit.
void ResultScreen::draw_history(const ScoreItem& item) {
    const std::vector<double> values = work_.values_of(item.name);
    if (values.size() < 2) return;
    const float em = ImGui::GetFontSize(), high = 1.6f * em, wide = 0.7f * em;
    const double most = std::max(1e-9, *std::max_element(values.begin(), values.end()));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float x = at.x + static_cast<float>(i) * (wide + 2);
        const float tall = std::max(2.0f, high * static_cast<float>(std::max(values[i], 0.0) / most));
        list.AddRectFilled({x, at.y + high - tall}, {x + wide, at.y + high},
                           i + 1 == values.size() ? theme::accent : theme::line, 2);
    }
    list.AddText({at.x + static_cast<float>(values.size()) * (wide + 2) + em / 2, at.y + em / 2}, theme::dim,
                 ("last " + std::to_string(values.size()) + " attempts").c_str());
    ImGui::Dummy({20 * em, high});
}

void ResultScreen::draw_unjudged(Shell& shell) {
    if (unjudged_.empty()) return;
    const std::string label = (shows_unjudged_ ? "Hide" : "Show") + std::string(" what was measured, not judged");
    if (shell.ui.button(label)) shows_unjudged_ = !shows_unjudged_;
    if (!shows_unjudged_) return;
    for (const auto& [item, standing] : unjudged_)
        words(shell.window.fonts().text, theme::dim, item.title + "  " + item.value + " " + item.unit);
}

void ResultScreen::write_report(Shell&) {
    if (report_.valid()) return;
    const std::filesystem::path recording = player_->options().recording;
    const std::filesystem::path folder = recording.parent_path() / (recording.stem().string() + "-report");
    report_words_ = "The report is being written …";
    report_ = std::async(std::launch::async, [player = player_, result = result_, folder]() -> std::string {
        try {
            std::filesystem::create_directories(folder);
            write_output(folder, player->live().session(), result, {});
            return "Report: " + (folder / "report.html").string();
        } catch (const std::exception& error) {
            return std::string("The report could not be written: ") + error.what();
        }
    });
}

void ResultScreen::watch_report(Shell&) {
    if (!report_.valid() || report_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    report_words_ = report_.get();
}

}  // namespace app::window
