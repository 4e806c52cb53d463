#include "app/window/keys_page.hpp"

#include "app/fault.hpp"
#include "app/window/parts.hpp"
#include "app/window/theme.hpp"

namespace app::window {

using hands::Action;

std::string keys_of(const hands::Bindings& bindings, Action action) {
    std::string keys;
    for (const std::string& key : bindings.keys_of(action)) keys += (keys.empty() ? "" : " or ") + key;
    return keys;
}

static void row(Shell& shell, const std::string& key, const std::string& help) {
    ImGui::TableNextColumn();
    words(shell.window.fonts().bold, theme::accent, key);
    ImGui::TableNextColumn();
    words(shell.window.fonts().text, theme::text, help);
}

// Two pairs of columns where there is room.
void draw_keys(Shell& shell, const hands::Bindings& bindings) {
    const float em = ImGui::GetFontSize();
    const int pairs = ImGui::GetContentRegionAvail().x > 56 * em ? 2 : 1;
    const auto table = [&](const char* name) {
        if (!ImGui::BeginTable(name, 2 * pairs, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
            return false;
        for (int pair = 0; pair < pairs; ++pair) {
            ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 1);
            ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch, 2.4f);
        }
        return true;
    };
    words(shell.window.fonts().bold, theme::text, "Mouse");
    if (table("mouse")) {
        for (const auto& gesture : hands::gesture_rows()) row(shell, gesture.gesture, gesture.help);
        ImGui::EndTable();
    }
    words(shell.window.fonts().bold, theme::text, "Keys");
    if (table("keys")) {
        for (const auto& action : hands::action_rows()) row(shell, keys_of(bindings, action.action), action.help);
        ImGui::EndTable();
    }
}

hands::Bindings load_keys(Shell& shell) try {
    return std::filesystem::exists(shell.where.keys) ? hands::load_bindings(shell.where.keys) : hands::Bindings();
} catch (const InputFault& fault) {
    shell.notice = fault.what() + std::string("; the usual keys are used");
    return {};
}

}  // namespace app::window
