#pragma once
#include "app/hands/bindings.hpp"
#include "app/window/screen.hpp"

namespace app::window {

/// Size of letters, hands, keys and folders of further drills.
class SettingsScreen : public Screen {
  public:
    /// With the settings and keys as they are.
    explicit SettingsScreen(Shell& shell);

    const char* name() const override { return "settings"; }
    void draw(Shell& shell) override;
    bool handle(Shell& shell, const SDL_Event& event) override;
    void close(Shell& shell) override;

  private:
    void draw_letters(Shell& shell);
    void draw_hands(Shell& shell);
    void draw_folders(Shell& shell);
    void draw_keys(Shell& shell);
    void bind(Shell& shell, const std::string& key);

    hands::Bindings bindings_;
    std::optional<hands::Action> waits_for_;  // a key for it
    std::string folder_;
};

}  // namespace app::window
