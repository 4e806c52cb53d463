#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "instruments/tool.hpp"
#include "scenarios/drill/file.hpp"

namespace scenarios::drill {

/// How long tools rest after their last key, so that what is at rest can be measured. A drill whose time limit comes
/// before is ended by it.
constexpr double settling_s = 0.5;

/// Where a tool is at one time.
struct MotionKey {
    double t_s;
    instruments::ToolInput input;
};

/// What moves the instruments of a drill: a list of keys each, in the order of the drill's instruments.
class Motion {
  public:
    /// Keys per instrument; each list has at least one and is strictly increasing in time.
    explicit Motion(std::vector<std::vector<MotionKey>> keys);

    /// Tools at time `t` [s]: position and jaw linear, rotation slerp; before the first key as there, after the last
    /// likewise. Fills `tools`, one per instrument. No allocation; cost: logarithmic in keys.
    void at(double t, std::span<instruments::ToolInput> tools) const;

    /// Time of the last key [s].
    double duration() const;
    /// What is lost of it and of the rest after it where a drill ends at this time [s], in a sentence; nothing: "".
    std::string cut_short_at(double limit_s) const;

    std::span<const std::vector<MotionKey>> keys() const { return keys_; }

  private:
    std::vector<std::vector<MotionKey>> keys_;
};

/// Reads a motion file, header t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw. `instruments` are the drill's names, in
/// its order; each needs at least one row. Rows of different instruments may alternate. Quaternions are normalised, a
/// length outside 0.5 to 2 is a mistake. Throws FileError with line and column.
Motion load_motion(const std::filesystem::path& file, std::span<const std::string> instruments);
Motion parse_motion(const std::string& text, const std::string& name, std::span<const std::string> instruments);

/// The text of a motion file with these keys, rows in order of time; what is read back differs by rounding alone.
std::string motion_text(const Motion& motion, std::span<const std::string> instruments);

}  // namespace scenarios::drill
