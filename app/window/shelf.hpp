#pragma once
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/draw/picture.hpp"
#include "app/window/settings.hpp"

namespace app::window {

/// A drill file, as the menu shows it.
struct ShelfDrill {
    std::filesystem::path file = {};          ///< Where it is.
    std::string title = {};                   ///< For people; that of a broken file is its name.
    std::string goal = {};                    ///< What is to be done.
    std::string problem = {};                 ///< Why it cannot be played, with its line; empty: it can.
    int level = 0;                            ///< The less, the earlier: few instruments, then lessons before knots.
    std::string key = {};                     ///< What its attempts are kept together by.
    std::string best = {};                    ///< The person's best attempt, in words; empty: there is none.
    std::string tries = {};                   ///< All of them, in words.
    std::shared_ptr<draw::Image> image = {};  ///< Its start; none as long as it is being drawn.
};

/// The drills there are, read and drawn by a thread of its own, so that the menu opens at once.
class Shelf {
  public:
    /// drills: the folder of the shipped drills, or empty: beside the program, or where it was installed.
    Shelf(const Places& where, const Settings& settings, const std::filesystem::path& drills);
    ~Shelf();

    /// Looks again: other folders, another person, a new recording.
    void look_again(const Settings& settings);
    /// What is known now, in the order of folders and then of names. Changes from call to call.
    std::vector<ShelfDrill> drills() const;
    /// Whether all has been read.
    bool is_read() const;
    /// Waits until nobody draws any more: for the time of play, when every core is wanted.
    void pause(bool is_paused);

  private:
    void run(const std::stop_token& stop);
    void read(const std::vector<std::filesystem::path>& folders, const std::stop_token& stop);
    void read_history(const std::string& who);
    void draw(const std::stop_token& stop);
    bool wait_to_draw(const std::stop_token& stop);

    const std::filesystem::path cache_, recordings_, shipped_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::vector<ShelfDrill> drills_;
    Settings settings_;
    bool is_wanted_ = true, is_read_ = false, is_paused_ = false;
    std::jthread thread_;  // last: it ends before the rest goes
};

/// The folder of the shipped drills: `named` if it is, else in the source tree above the program, else where `make
/// install` puts them. Throws InputFault where a named one is no folder; empty where there is none.
std::filesystem::path shipped_drills(const std::filesystem::path& named);

}  // namespace app::window
