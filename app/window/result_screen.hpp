#pragma once
#include <future>

#include "app/window/attempt_work.hpp"
#include "app/window/player.hpp"
#include "app/window/screen.hpp"
#include "app/window/texture.hpp"
#include "scenarios/drill/order.hpp"

namespace app::window {

/// What an attempt came to: what matters first, each miss with its moment and place.
class ResultScreen : public Screen {
  public:
    /// Of an attempt that is finished.
    ResultScreen(Shell& shell, std::shared_ptr<Player> player, scenarios::drill::Result result);

    const char* name() const override { return "result"; }
    void draw(Shell& shell) override;

  private:
    void draw_header(Shell& shell);
    void draw_item(Shell& shell, const scenarios::drill::ScoreItem& item, scenarios::drill::Standing standing);
    void draw_picture(Shell& shell, const std::string& item);
    void draw_history(const scenarios::drill::ScoreItem& item);
    void draw_unjudged(Shell& shell);
    void write_report(Shell& shell);
    void watch_report(Shell& shell);

    std::shared_ptr<Player> player_;
    scenarios::drill::Result result_;
    std::vector<std::pair<scenarios::drill::ScoreItem, scenarios::drill::Standing>> judged_, unjudged_;
    AttemptWork work_;
    std::map<std::string, Texture> textures_;
    std::future<std::string> report_;
    std::string report_words_;
    bool shows_unjudged_ = false;
};

}  // namespace app::window
