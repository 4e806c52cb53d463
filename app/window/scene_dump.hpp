#pragma once
#include <filesystem>
#include <fstream>

#include "app/hands/hands.hpp"
#include "scenarios/session/view.hpp"

namespace app::window {

/// A file that gets what is seen of a scene, a line of JSON for each frame, so that a test can play as a person does
/// who looks at the picture. Lengths in m, times in s, forces in N, rotations as w, x, y, z.
class SceneDump {
  public:
    /// file: where it goes; empty: nowhere. Throws std::runtime_error: it cannot be written.
    explicit SceneDump(const std::filesystem::path& file);
    /// A frame, as it is seen from `sight`. Costs nothing without a file.
    void write(const scenarios::session::View& view, const hands::HandsView& hands, const hands::Sight& sight);

  private:
    std::ofstream file_;
};

}  // namespace app::window
