#pragma once
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/draw/picture.hpp"
#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/result.hpp"

namespace app::window {

/// What takes a while after an attempt, on a thread of its own: earlier attempts, and pictures of what was missed,
/// drawn from the recording.
class AttemptWork {
  public:
    /// missed: items whose moments are wanted.
    AttemptWork(const std::filesystem::path& recording, const scenarios::drill::Drill& drill,
                const std::vector<scenarios::drill::ScoreItem>& missed);

    /// The picture of an item's moment; none: not yet, or it cannot be drawn.
    std::optional<draw::Image> take_picture(const std::string& item);
    /// The last ten values of an item, this attempt's among them; none: not yet, or it is no number.
    std::vector<double> values_of(const std::string& item) const;

  private:
    void read_history(const std::filesystem::path& folder, const scenarios::drill::Drill& drill);
    void draw_moments(const std::filesystem::path& recording, const std::stop_token& stop);
    void keep(const std::string& item, draw::Image image);

    const std::vector<scenarios::drill::ScoreItem> missed_;
    mutable std::mutex mutex_;
    std::map<std::string, draw::Image> pictures_;
    std::map<std::string, std::vector<double>> values_;
    std::jthread thread_;  // last: it ends before the rest goes
};

}  // namespace app::window
