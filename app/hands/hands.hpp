#pragma once
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/hands/assist_needle.hpp"
#include "app/hands/assist_pull.hpp"
#include "app/hands/assist_retake.hpp"
#include "app/hands/assist_snap.hpp"
#include "app/hands/assist_steady.hpp"
#include "app/hands/assist_wrist.hpp"
#include "app/hands/mouse.hpp"
#include "app/hands/rate_keys.hpp"

namespace app::hands {

/// What a person should see of her hands; plain values.
struct HandsView {
    int mouse = -1;                 ///< The instrument that the mouse leads; none: -1.
    int keys = -1;                  ///< The instrument that the keys lead; none: -1.
    bool is_free = false;           ///< The pointer is free: the mouse leads nothing.
    bool is_fine = false;           ///< Moves and turns are a quarter.
    double scale = 1;               ///< Of moves.
    Assists assists;                ///< That are on.
    bool pulls = false;             ///< "Pull both" is at work.
    bool turns_needle = false;      ///< The wheel turns the needle.
    double pace = 1;                ///< That hands would have, at most: less by "slow motion".
    std::vector<double> jaw;        ///< For each instrument, how far it is asked to be open, 0 to 1.
    std::vector<bool> closing;      ///< For each instrument, whether it is asked to shut.
    std::vector<double> gap;        ///< For each, from its open jaws to what they would take [m]; -1: beyond 5 mm.
    std::optional<Vec3> lit;        ///< What the mouse hand's jaws would take [m].
    std::optional<double> stamp_s;  ///< Of the newest event that has been used [s]; none: there was none.
};

/// From what devices do to what instruments are asked for, once a tick. Hands belong to the tick thread but for view().
class Hands {
  public:
    /// Says a mark for the recording: a kind and a text. Called on the tick thread.
    using Mark = std::function<void(const std::string& kind, const std::string& text)>;

    /// `start`: where the instruments are asked to be before the first tick, one for each of `instruments`; at least
    /// one. The mouse hand has the instrument named "right" (left-handed: "left"), or else the last, the key hand the
    /// first other one.
    Hands(const Settings& settings, std::span<const scenarios::world::InstrumentDef> instruments,
          std::span<const ToolInput> start, Mark mark = {});

    /// Fills one input for each instrument. With no event it changes no bit of them, but for what is under way.
    void tick(const World& world, const Taken& taken, std::span<ToolInput> inputs);
    /// As the last tick left them; for any thread.
    HandsView view() const;
    /// Stamp of the newest event that has been used [s], if there was one; of the tick thread.
    std::optional<double> stamp_s() const { return stamp_s_; }

  private:
    /// An instrument, and the help that its hand has.
    struct Helped : Led {
        Wrist wrist;
        Snap snap;
        Steady steady;
        std::optional<Takeable> near;  // what its jaws would take, within 5 mm
    };

    void look_round();
    void take(const Event& event);
    void take(const Motion& motion);
    void take(const Wheel& wheel);
    void take(const Click& click);
    void take(const Press& press);
    void take(const Switch& change);
    void take(const LetGo&);
    void begin(Action action);
    void choose(int instrument);
    void step_scale(int by);
    void press_jaw(int instrument, bool down);
    void shut(Helped& tool);
    void hold(bool& held, bool down) const;
    void move();
    void help();
    void move_jaws();
    void answer(std::span<ToolInput> inputs);
    void publish();
    bool has(Assist assist) const { return settings_.assists.has(assist); }
    double share() const { return fine_ ? 0.25 : 1; }
    Helped& tool(int instrument) { return tools_[static_cast<std::size_t>(instrument)]; }

    Settings settings_;
    Mark mark_;
    std::vector<Helped> tools_;
    int m_ = -1, k_ = -1;  // instruments of the mouse hand and of the key hand
    Mouse mouse_;
    RateKeys keys_;
    PullBoth pull_;
    Retake retake_;
    int retakes_ = -1;              // the instrument that does
    const World* world_ = nullptr;  // during a tick
    Sight sight_;
    double seconds_ = 0;
    bool begun_ = false, free_ = false, fine_ = false, k_turns_ = false, m_turns_ = false;
    bool pulls_ = false, turns_needle_ = false;
    std::optional<double> stamp_s_;
    mutable std::mutex mutex_;
    HandsView view_;
};

}  // namespace app::hands
