#pragma once
#include <cstdint>
#include <optional>
#include <span>

// How fast a live session went, and how long its hands waited to be heard and seen.
namespace scenarios::recording {

/// What half and 99 of 100 of some delays stay below.
struct Delays {
    double p50_ms = 0;  ///< [ms]
    double p99_ms = 0;  ///< [ms]

    bool operator==(const Delays&) const = default;
};

/// About a second of a live session.
struct PaceRow {
    std::uint64_t tick = 0;           ///< How many ticks were made when it ended.
    double wall_s = 0;                ///< Wall clock since the session began, without its pauses, when it ended [s].
    double rate = 0;                  ///< Simulated over wall time within it; 1 is real time.
    double dropped_ms = 0;            ///< Wall time within it that was given up because ticks were too slow [ms].
    std::optional<Delays> used = {};  ///< From a device's event to the tick that used it; none: nothing moved.
    std::optional<Delays> shown =
        {};  ///< From a device's event to the picture that showed it; none: nothing was shown.

    bool operator==(const PaceRow&) const = default;
};

/// Whether a session went as fast as its drill declares, so that its scores may be held against others': in 95 of 100
/// seconds at least 95 % of `declared`. `declared` is above 0, 1 is real time. A session without rows was not live, and
/// is comparable.
bool is_comparable(std::span<const PaceRow> rows, double declared);

}  // namespace scenarios::recording
