#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace app::hands {

/// Help for the hands, in practice alone. Each acts on what the hands ask for, before it is recorded.
enum class Assist { wrist, snap, needle_wheel, retake, pull_both, slow_motion, steady };

/// An assist in words.
struct AssistRow {
    Assist assist;     ///< Which it is.
    const char* name;  ///< In recordings and on the command line.
    const char* help;  ///< What it does, for people.
};

/// Every assist once, in the order of the enumeration.
inline constexpr std::array assist_rows{
    AssistRow{Assist::wrist, "wrist",
              "instruments keep their turn in the picture; open jaws roll square to the strand "
              "within 5 mm"},
    AssistRow{Assist::snap, "snap", "what the jaws would take within 3 mm is lit; closing glides there, then closes"},
    AssistRow{Assist::needle_wheel, "needle-wheel", "N: the wheel turns the held needle about its own circle"},
    AssistRow{Assist::retake, "retake", "R: lets go and takes the strand again nearer the knot"},
    AssistRow{Assist::pull_both, "pull-both", "B held: both hands pull apart and stop at the tension set"},
    AssistRow{Assist::slow_motion, "slow-motion", "half of real time"},
    AssistRow{Assist::steady, "steady", "smooths trembling hands"},
};

/// Which assists are on.
class Assists {
  public:
    /// Whether one is on.
    bool has(Assist assist) const { return on_[static_cast<std::size_t>(assist)]; }
    /// Switches one.
    void set(Assist assist, bool on) { on_[static_cast<std::size_t>(assist)] = on; }
    /// Names of those that are on, with commas between; none: "".
    std::string names() const;

  private:
    std::array<bool, assist_rows.size()> on_{};
};

/// The name of one.
const char* name_of(Assist assist);

/// Reads names with commas between, as "wrist,snap"; "" for none. Throws InputFault: no such assist.
Assists parse_assists(const std::string& names);

}  // namespace app::hands
