#pragma once
#include <map>

#include "app/window/screen.hpp"
#include "app/window/shelf.hpp"
#include "app/window/texture.hpp"

namespace app::window {

/// The first screen: who plays, practice or exam, and the drills there are.
class Menu : public Screen {
  public:
    const char* name() const override { return "menu"; }
    void draw(Shell& shell) override;

  private:
    void draw_header(Shell& shell);
    void draw_person(Shell& shell);
    void draw_warnings(Shell& shell);
    void draw_shelf(Shell& shell);
    void draw_card(Shell& shell, const ShelfDrill& drill, ImVec2 size);
    void draw_broken(Shell& shell, const ShelfDrill& drill);
    const Texture* texture_of(const ShelfDrill& drill);

    std::map<const draw::Image*, std::pair<std::shared_ptr<draw::Image>, Texture>> textures_;
};

}  // namespace app::window
