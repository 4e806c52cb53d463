#include "app/window/ui.hpp"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/window/theme.hpp"

namespace app::window {

Ui::Ui(const std::filesystem::path& dump) {
    if (dump.empty()) return;
    dump_.open(dump, std::ios::trunc);
    if (!dump_) throw std::runtime_error(dump.string() + ": --ui-dump: cannot be written");
}

void Ui::begin(const std::string& screen, int width, int height) {
    screen_ = screen;
    size_ = {static_cast<float>(width), static_cast<float>(height)};
    controls_.clear();
    said_.clear();
}

void Ui::forget_focus() {
    wanted_ = 0;
    ImGui::ClearActiveID();
    GImGui->NavId = 0;
}

// Dear ImGui 1.86 reaches only fields by Tab; here every control that the last frame had comes in its turn.
void Ui::end() {
    if (move_ != 0 && !controls_.empty()) {
        std::vector<const Control*> all;
        for (const Control& control : controls_)
            if (control.is_enabled) all.push_back(&control);
        const auto now = std::find_if(all.begin(), all.end(), [](const Control* c) { return c->is_focused; });
        const auto count = static_cast<long>(all.size());
        const long at = now == all.end() ? (move_ > 0 ? -1 : count) : now - all.begin();
        if (count > 0) wanted_ = all[static_cast<std::size_t>((at + move_ + count) % count)]->id;
        ImGui::ClearActiveID();
    }
    move_ = 0;
    had_focus_ = std::any_of(controls_.begin(), controls_.end(), [](const Control& c) { return c.is_focused; });
    if (dump_.is_open()) write();
}

void Ui::note(const std::string& label, const char* kind) {
    const ImGuiID id = ImGui::GetItemID();
    ImGuiWindow* here = ImGui::GetCurrentWindow();
    if (here->RootWindow->Hidden) return;  // its first frame, which is not shown, finds out how large it is
    if (wanted_ == id) {
        ImGui::FocusWindow(here);
        ImGui::SetFocusID(id, here);
        GImGui->NavDisableHighlight = false;
        ImGui::ScrollToBringRectIntoView(here, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
        wanted_ = 0;
    }
    const ImRect rect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    const bool is_enabled = !(GImGui->LastItemData.InFlags & ImGuiItemFlags_Disabled);
    controls_.push_back({label, kind, rect.Min, rect.Max, id, GImGui->NavId == id && !GImGui->NavDisableHighlight,
                         here->ClipRect.Contains(rect), is_enabled});
}

bool Ui::button(const std::string& label, Look look, ImVec2 size, const std::string& name) {
    const int pushed = look == Look::plain ? 0 : 3;
    if (look == Look::primary) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme::primary);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(20, 136, 200, 255));
        ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_WHITE);
    } else if (look == Look::chosen) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme::accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme::accent);
        ImGui::PushStyleColor(ImGuiCol_Text, theme::background);
    }
    const bool is_pressed = ImGui::Button(label.c_str(), size);
    ImGui::PopStyleColor(pushed);
    note(name.empty() ? label.substr(0, label.find("##")) : name, "button");
    return is_pressed;
}

bool Ui::checkbox(const std::string& label, bool& is_on) {
    const bool is_changed = ImGui::Checkbox(label.c_str(), &is_on);
    note(label, "checkbox");
    return is_changed;
}

bool Ui::text_field(const std::string& label, std::string& text, float width, const char* hint) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(width);
    const bool is_changed = ImGui::InputTextWithHint(("##" + label).c_str(), hint, &text);
    note(label, "field");
    return is_changed;
}

bool Ui::slider(const std::string& label, double& value, double least, double most, const char* format) {
    const bool is_changed = ImGui::SliderScalar(("##" + label).c_str(), ImGuiDataType_Double, &value, &least, &most,
                                                format, ImGuiSliderFlags_AlwaysClamp);
    note(label, "slider");
    return is_changed;
}

void Ui::say(const std::string& name, double x, double y) {
    say(name, std::to_string(std::lround(x)) + " " + std::to_string(std::lround(y)));
}

std::string Ui::as_json() const {
    nlohmann::json controls = nlohmann::json::array();
    for (const Control& c : controls_)
        controls.push_back({{"label", c.label},
                            {"kind", c.kind},
                            {"rect", {c.least.x, c.least.y, c.most.x, c.most.y}},
                            {"focus", c.is_focused},
                            {"whole", c.is_whole},
                            {"enabled", c.is_enabled}});
    const nlohmann::json all{
        {"screen", screen_}, {"size", {size_.x, size_.y}}, {"controls", controls}, {"says", said_}};
    return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void Ui::write() {
    std::string now = as_json();
    if (now == last_) return;
    last_ = std::move(now);
    dump_ << last_ << std::endl;
}

}  // namespace app::window
