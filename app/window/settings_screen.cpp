#include "app/window/settings_screen.hpp"

#include <utility>

#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/hands/assists.hpp"
#include "app/window/keys_page.hpp"
#include "app/window/menu.hpp"
#include "app/window/parts.hpp"
#include "app/window/theme.hpp"

namespace app::window {

SettingsScreen::SettingsScreen(Shell& shell) : bindings_(load_keys(shell)) {}

void SettingsScreen::draw(Shell& shell) {
    const float em = ImGui::GetFontSize();
    begin_page(shell);
    words(shell.window.fonts().title, theme::text, "Settings");
    ImGui::SameLine();
    at_right(button_width("Back to the menu"));
    if (shell.ui.button("Back to the menu", Look::primary)) shell.next = std::make_unique<Menu>();
    draw_notice(shell);
    ImGui::BeginChild("settings", {0, 0}, false);
    for (const auto part : {&SettingsScreen::draw_letters, &SettingsScreen::draw_hands, &SettingsScreen::draw_folders,
                            &SettingsScreen::draw_keys}) {
        (this->*part)(shell);
        ImGui::Dummy({0, em / 2});
    }
    ImGui::EndChild();
    ImGui::End();
}

void SettingsScreen::draw_letters(Shell& shell) {
    words(shell.window.fonts().bold, theme::text, "Letters");
    for (const double scale : {0.75, 1.0, 1.25, 1.5, 2.0, 2.5}) {
        char label[20];
        std::snprintf(label, sizeof label, "%.0f %%", 100 * scale);
        if (scale != 0.75) ImGui::SameLine();
        if (shell.ui.choice(label, shell.settings.scale == scale)) shell.settings.scale = scale;
    }
}

void SettingsScreen::draw_hands(Shell& shell) {
    Settings& settings = shell.settings;
    words(shell.window.fonts().bold, theme::text, "Hands");
    shell.ui.checkbox("Left-handed: the mouse leads the left instrument", settings.left_handed);
    shell.ui.checkbox("One-handed: the middle button of the mouse changes hands", settings.one_handed);
    shell.ui.checkbox("Press once instead of holding a key", settings.toggles);
    shell.ui.checkbox("Jaws are closed only while their button is down", settings.holds_jaw);
    words(shell.window.fonts().bold, theme::text, "Assists that practice begins with");
    hands::Assists on = hands::parse_assists(settings.assists);
    for (const auto& row : hands::assist_rows) {
        bool is_on = on.has(row.assist);
        if (shell.ui.checkbox(row.name, is_on)) on.set(row.assist, is_on);
        ImGui::SameLine();
        words(shell.window.fonts().small, theme::dim, row.help);
    }
    settings.assists = on.names();
}

void SettingsScreen::draw_folders(Shell& shell) {
    auto& folders = shell.settings.folders;
    words(shell.window.fonts().bold, theme::text, "Folders of further drills");
    for (std::size_t i = 0; i < folders.size(); ++i) {
        if (shell.ui.button("Remove##" + std::to_string(i), Look::plain, {}, "Remove " + folders[i])) {
            folders.erase(folders.begin() + static_cast<long>(i));
            break;
        }
        ImGui::SameLine();
        ImGui::TextUnformatted(folders[i].c_str());
    }
    const float room = ImGui::GetContentRegionAvail().x - button_width("Add") - 6 * ImGui::GetFontSize();
    shell.ui.text_field("Folder", folder_, std::min(room, 25 * ImGui::GetFontSize()), "/home/me/drills");
    ImGui::SameLine();
    if (shell.ui.button("Add") && !folder_.empty()) {
        if (std::filesystem::is_directory(folder_))
            folders.push_back(std::exchange(folder_, ""));
        else
            shell.notice = folder_ + ": there is no such folder";
    }
}

void SettingsScreen::draw_keys(Shell& shell) {
    const float em = ImGui::GetFontSize();
    words(shell.window.fonts().bold, theme::text, "Keys");
    words(shell.window.fonts().small, theme::dim,
          "Press a button, then the key that shall do it; Esc changes nothing.");
    if (shell.ui.button("All keys as usual")) bindings_ = {};
    for (const auto& row : hands::action_rows()) {
        const bool waits = waits_for_ == row.action;
        const std::string label = waits ? "press a key" : keys_of(bindings_, row.action);
        if (shell.ui.button(label + "##" + row.name, waits ? Look::chosen : Look::plain, {9 * em, 0},
                            std::string("key ") + row.name))
            waits_for_ = row.action;
        ImGui::SameLine();
        words(shell.window.fonts().text, theme::dim, row.help);
    }
}

bool SettingsScreen::handle(Shell& shell, const SDL_Event& event) {
    if (!waits_for_ || event.type != SDL_KEYDOWN) return false;
    std::string key = SDL_GetScancodeName(event.key.keysym.scancode);
    for (const std::string side : {"Left ", "Right "})
        if (key.starts_with(side)) key.erase(0, side.size());
    if (key != "Escape") bind(shell, key);
    waits_for_.reset();
    return true;
}

void SettingsScreen::bind(Shell& shell, const std::string& key) try {
    bindings_.bind(*waits_for_, {key}, "Keys");
    shell.notice.clear();
} catch (const InputFault& fault) {
    shell.notice = fault.what();
}

void SettingsScreen::close(Shell& shell) {
    shell.save();
    try {
        std::filesystem::create_directories(shell.where.keys.parent_path());
        write_file(shell.where.keys, bindings_.text());
    } catch (const std::exception& error) {
        shell.notice = error.what();
    }
    shell.shelf.look_again(shell.settings);
}

}  // namespace app::window
