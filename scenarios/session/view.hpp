#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/session/session.hpp"

namespace scenarios::session {

/// What an instrument has in its jaws: "thread", "needle", "wall", several of them with " and " between, or "".
std::string held_by(const scenarios::world::World& world, std::size_t tool);

/// One instrument, as a window shows it.
struct ToolView {
    std::string name;        ///< As the drill has it.
    instruments::Kind kind;  ///< What it is.
    std::string held;        ///< What is in its jaws, as held_by() says it.
    double lag_mm = 0;       ///< How far it is behind its hand; a turn counts at a jaw's length [mm].
};

/// What a window shows of a live session: a copy, so that drawing never touches the world.
struct View {
    std::uint64_t tick = 0;                       ///< How many ticks were made.
    double t_s = 0;                               ///< Simulated time since the drill's start [s].
    Snapshot scene{};                             ///< The whole scene, without a caption.
    double tension_N = 0;                         ///< Largest along the thread now [N].
    double tension_max_N = 0;                     ///< Largest so far [N].
    std::vector<ToolView> tools;                  ///< In the drill's order.
    std::string knot;                             ///< As a surgeon calls it, some 20 ms ago: "0_1", "square" ...
    std::vector<scenarios::world::Event> events;  ///< What happened since the view that was taken before this one.
    std::size_t first_event = 0;                  ///< How many events there were before these.
    double pace = 0;                              ///< Measured over the last second: simulated over wall time.
    double dropped_s = 0;                         ///< Wall time given up so far because ticks were too slow [s].
    std::optional<double> device_s;               ///< When the newest event of a device came that is in here [s].
    double used_s = 0;                            ///< When the tick began that used it, by the same clock [s].
};

/// Fills in what can be seen of a session now; its events from number `first_event` on. Cost: copies what is seen.
void look_at(const Session& session, std::size_t first_event, View& view);

/// Hands values from one thread to another so that neither ever waits: the reader gets the newest, what lies between is
/// lost.
template <typename T>
class TripleBuffer {
  public:
    /// Of the writer: what publish() will hand over.
    T& back() { return slots_[back_]; }
    /// Of the writer: whether the reader has taken what was published last; true where nothing was.
    bool was_taken() const { return !(middle_.load(std::memory_order_acquire) & fresh); }
    /// Of the writer: hands back() over, and has another one from now on.
    void publish() { back_ = middle_.exchange(back_ | fresh, std::memory_order_acq_rel) & ~fresh; }
    /// Of the reader: goes on to the newest, if there is one that it has not seen yet.
    bool take() {
        if (!(middle_.load(std::memory_order_relaxed) & fresh)) return false;
        front_ = middle_.exchange(front_, std::memory_order_acq_rel) & ~fresh;
        return true;
    }
    /// Of the reader: what it has; valid until take().
    T& front() { return slots_[front_]; }

  private:
    static constexpr unsigned fresh = 4;  // a bit beside the three numbers

    std::array<T, 3> slots_{};
    unsigned front_ = 0, back_ = 2;
    std::atomic<unsigned> middle_ = 1;
};

}  // namespace scenarios::session
