#pragma once
#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/recording/recording.hpp"
#include "scenarios/session/pacer.hpp"
#include "scenarios/session/view.hpp"

namespace scenarios::session {

/// Asked on the tick thread before each tick: what the tools are told. The span holds what was said last, at first
/// where the tools start; what is not written stays. The world is only to be read, and only during the call. Returns
/// when the newest event came that it heeds [s by Time::now], if there was one yet: latencies are measured from there.
using Hand =
    std::function<std::optional<double>(const scenarios::world::World& world, std::span<instruments::ToolInput> tools)>;

/// The time that a live session goes by; called from its tick thread alone.
struct Time {
    std::function<double()> now;          ///< Seconds of a clock that never goes back.
    std::function<void(double)> sleep;    ///< Waits about so many seconds.
    std::function<double()> stopwatch{};  ///< Processor time of the calling thread [us]; none: no tick is timed.
};

/// How a live session is played.
struct LiveOptions {
    bool exam = false;          ///< It cannot be paused nor slowed down.
    bool starts_paused = true;  ///< The first tick waits for resume(), also in an exam.
};

/// A drill being played by hands, tick by tick on a thread of its own: world and inputs are those of a Session, so that
/// a replay of what was recorded gives the same bits. A computer that is too slow makes time dilate (see Pacer);
/// looking on, pausing and slowing down change nothing that is computed. All methods may be called from one other
/// thread, those that say so from any. Restart by making a new one.
class Live {
  public:
    /// `start`: where the tools are before the first tick, one per instrument. `recorder`: gets each tick's inputs
    /// before that tick, and all that happens; one that does not wait for the disk; none: nothing is recorded. Throws
    /// as Session does.
    Live(scenarios::drill::Drill drill, std::span<const instruments::ToolInput> start, Hand hand, Time time,
         LiveOptions options = {}, std::optional<recording::Recorder> recorder = {});
    ~Live();  ///< Without finish() the recording stays readable, and says that it was broken off.
    Live(const Live&) = delete;
    Live& operator=(const Live&) = delete;

    /// Stops the ticks until resume(); from any thread. Does nothing in an exam.
    void pause();
    /// Lets ticks go on; from any thread.
    void resume();
    bool is_paused() const { return is_paused_; }  ///< Whether it waits for resume(); from any thread.
    /// Simulated over wall time that is aimed at, from any thread: 1/8 to what the drill declares; beyond, the nearest
    /// of these. Does nothing in an exam.
    void set_pace(double pace);
    double pace() const { return pace_; }  ///< What is aimed at; from any thread.
    /// The drill's own pace, at which attempts are comparable.
    double declared_pace() const;

    /// Notes in the recording what happens beside the ticks, now; from any thread. `kind`: "assist", "note",
    /// "focus" ... one word; `text`: "snap on" ... "pause", "resume" and "pace" are noted by the methods of that name.
    void mark(const std::string& kind, const std::string& text);
    /// Notes how long after a device's event the picture was seen that shows it [s]; from any thread.
    void note_shown(double delay_s);

    /// The newest view, at most 1/120 s old while somebody looks; valid until the next call. Never waits.
    const View& view();
    /// Whether ticks have ended: the drill's time is over, or something failed; from any thread.
    bool has_ended() const { return has_ended_; }
    /// How many ticks were made; from any thread.
    std::uint64_t ticks() const { return ticks_; }
    /// Why the recording is not on disk, if so, in one line that says how much is; play goes on. From any thread.
    std::optional<std::string> trouble() const;

    /// Ends the ticks, scores and completes the recording; once. A recording that cannot be completed shows in
    /// trouble(). Throws what the tick thread failed of, if it did.
    scenarios::drill::Result finish();
    /// The session that was played, for its pictures; after finish().
    const Session& session() const { return session_; }
    /// The pace second by second; after finish().
    const std::vector<recording::PaceRow>& pace_rows() const { return rows_; }
    /// Whether it went as fast as its drill declares (see recording::is_comparable); after finish().
    bool is_comparable() const { return recording::is_comparable(rows_, declared_pace()); }

  private:
    void run();
    void start_clocks();
    bool goes_on();
    void wait_for_resume();
    void tick();
    void measure(double begin_s, std::optional<double> device_s);
    void record_what_happened();
    void publish(double now_s);
    void add_row(const std::optional<recording::PaceRow>& row);
    void end_ticks();
    void set_paused(bool paused);
    void save(std::uint64_t hash, const scenarios::drill::Result& result);

    Session session_;
    Hand hand_;
    Time time_;
    LiveOptions options_;
    std::optional<recording::Recorder> recorder_;

    // Of the tick thread, until it has ended.
    std::uint64_t last_tick_;
    Pacer pacer_;
    PaceMeter meter_;
    std::vector<instruments::ToolInput> inputs_;
    std::optional<double> device_s_;  // newest event of a device
    double used_s_ = 0;               // when the tick began that used it
    double published_s_ = 0;
    std::size_t events_recorded_ = 0;
    std::vector<recording::PaceRow> rows_;
    std::exception_ptr fault_;

    TripleBuffer<View> views_;
    std::atomic<std::size_t> events_seen_ = 0;  // in views that were taken
    std::atomic<bool> is_paused_, stops_ = false, has_ended_ = false;
    std::atomic<double> pace_;
    std::atomic<std::uint64_t> ticks_ = 0;
    mutable std::mutex mutex_;  // of what follows
    std::condition_variable changed_;
    std::vector<double> shown_s_;

    std::thread thread_;  // last, for it uses all above
};

}  // namespace scenarios::session
