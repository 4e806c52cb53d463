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
    double t_s;                    ///< Simulated time [s].
    instruments::ToolInput input;  ///< Pose [m] and jaw at that time.
};

/// What moves the instruments of a drill: a list of keys each, in the order of the drill's instruments.
class Motion {
  public:
    /// Keys per instrument; each list has at least one and is strictly increasing in time.
    explicit Motion(std::vector<std::vector<MotionKey>> keys);

    /// Puts tools where they are at time `t` [s]: position and jaw linear, rotation slerp; before the first key as
    /// there, after the last likewise. Fills `tools`, one per instrument. No allocation; cost: logarithmic in keys.
    void at(double t, std::span<instruments::ToolInput> tools) const;

    /// Time of the last key [s].
    double duration() const;
    /// What a drill that ends at this time [s] loses of the motion and of the rest after it, in a sentence; "" for
    /// nothing.
    std::string cut_short_at(double limit_s) const;
    /// Says where a device has left out rows, a sentence for each instrument that moves meanwhile; `instruments` are
    /// their names. A gap is longer than 0.25 s and four times the usual time between rows, of a motion whose rows come
    /// evenly; rows that a person wrote do not.
    std::vector<std::string> gaps(std::span<const std::string> instruments) const;

    /// The keys of each instrument, in order of time.
    std::span<const std::vector<MotionKey>> keys() const { return keys_; }

  private:
    std::vector<std::vector<MotionKey>> keys_;
};

/// Reads a motion file (.csv as CsvReader has it), header t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw; columns behind
/// these are left alone. `instruments` are the drill's names, in its order; each needs at least one row. Rows of
/// different instruments may alternate. Quaternions are normalised, a length outside 0.5 to 2 is a mistake. Throws
/// FileError with line and column.
Motion load_motion(const std::filesystem::path& file, std::span<const std::string> instruments);

/// Reads the text of a motion file, which messages call `name`; the rest as load_motion().
Motion parse_motion(const std::string& text, const std::string& name, std::span<const std::string> instruments);

/// The text of a motion file with these keys, rows in order of time; what is read back differs by rounding alone.
std::string motion_text(const Motion& motion, std::span<const std::string> instruments);

}  // namespace scenarios::drill
