#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

#include "app/hands/devices.hpp"
#include "app/hands/hands.hpp"
#include "scenarios/drill/motion.hpp"
#include "scenarios/session/guide.hpp"
#include "scenarios/session/live.hpp"

namespace app::window {

using scenarios::session::Guide;
using scenarios::session::View;

/// How an attempt is to be played.
struct PlayerOptions {
    hands::Settings hands;            ///< How the person leads the hands, and the assists to begin with.
    bool is_exam = false;             ///< One attempt without help.
    std::optional<double> pace;       ///< Simulated seconds a second; none: as the drill declares.
    std::string who;                  ///< Pseudonym of the person.
    std::filesystem::path recording;  ///< File that the attempt is recorded to.
};

/// Seconds of a clock that never goes back: stamps of devices and the time of ticks.
double now_s();

/// Where the guide is.
struct GuideView {
    std::size_t step = 0;            ///< To be done now, from 0.
    std::vector<Guide::Mark> marks;  ///< Of the steps behind.
};

/// One attempt at a drill: live session, hands, guide and recording, put together. It waits until begin().
class Player {
  public:
    /// Throws what a bad drill or motion throws, and std::runtime_error where the recording cannot be begun.
    Player(const std::filesystem::path& file, PlayerOptions options);
    ~Player();

    const scenarios::drill::Drill& drill() const { return drill_; }        ///< That is played.
    const scenarios::drill::Motion& reference() const { return motion_; }  ///< Its own motion.
    const PlayerOptions& options() const { return options_; }              ///< As it was made with.
    const std::filesystem::path& file() const { return file_; }            ///< Of the drill.
    scenarios::session::Live& live() { return *live_; }                    ///< The session.
    hands::Devices& devices() { return devices_; }                         ///< Where events of devices go.
    hands::HandsView hands() const { return hands_->view(); }              ///< What the hands do.
    GuideView guide() const;                                               ///< What the guide says.

    /// Ends the attempt, scores it and completes its recording; once.
    scenarios::drill::Result finish();
    bool is_finished() const { return is_finished_; }  ///< Whether that was done.

  private:
    std::optional<double> lead(const scenarios::world::World& world, std::span<instruments::ToolInput> tools);
    void watch_guide(const scenarios::world::World& world);

    std::filesystem::path file_;
    PlayerOptions options_;
    scenarios::drill::Drill drill_;
    scenarios::drill::Motion motion_;
    hands::Devices devices_;
    hands::Taken taken_;  // of the tick thread
    std::unique_ptr<hands::Hands> hands_;
    Guide guide_;  // of the tick thread
    mutable std::mutex mutex_;
    GuideView guide_view_;
    bool is_finished_ = false;
    std::unique_ptr<scenarios::session::Live> live_;  // last: its thread uses all above
};

}  // namespace app::window
