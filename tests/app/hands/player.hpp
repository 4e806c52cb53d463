#pragma once
#include <optional>
#include <random>
#include <vector>

#include "app/hands/devices.hpp"
#include "app/hands/led.hpp"
#include "scenarios/drill/motion.hpp"

// Plays a drill as a person does who looks at the picture and has a mouse and a keyboard, and nothing else. Who carries
// what she does to the hands, and how late, is another's business: a test's queue, or an X server.
namespace app::hands {

/// What the player sees.
struct Seen {
    double t_s = 0;                ///< Simulated time.
    std::vector<ToolInput> tools;  ///< Where the instruments are asked to be.
    std::vector<Vec3> thread;      ///< Nodes of the thread.
    std::vector<double> along;     ///< Of each node, how far it is from the thread's first node [m].
    double tension_N = 0;          ///< Largest of the thread.
    std::vector<int> strands;      ///< How many each instrument holds.
    Sight sight;                   ///< How she sees it.
};

/// A place on the thread that jaws are to take.
struct Aim {
    double along;  ///< From the thread's first node [m].
    Vec3 beside;   ///< From there to where the tool is to be [m].
};

/// What she does at a goal.
enum class Deed {
    go,           ///< Leads both instruments to their places and then opens or shuts their jaws.
    pull_both,    ///< Holds the assist of this name until hands come to rest.
    turn_needle,  ///< Turns the needle by the assist "needle-wheel".
    roll,         ///< Rolls the key hand's instrument about its shaft.
    swap,         ///< The mouse leads what keys have led, and keys what the mouse has led.
};

/// One step of a plan; an entry for each instrument.
struct Goal {
    std::vector<std::optional<Vec3>> at;   ///< Places to go to [m]; none: it stays.
    std::vector<std::optional<Aim>> aims;  ///< Instead of places: what is on the thread is found where it is seen.
    std::vector<bool> shut;                ///< Jaws.
    double care = 1;                       ///< Share of her speed and of her lead; less where thread gets taut.
    bool pulls = false;                    ///< Thread gets taut on the way: far enough is where it is.
    Deed deed = Deed::go;                  ///< What is done.
    bool is_fine = false;                  ///< A key makes both hands slow: what keys lead comes three times as near.
    double turn = 0;                       ///< How far the needle or the instrument is turned [rad], above 0.
};

/// What an instrument takes each time that its jaws shut, in the order of the motion.
struct Take {
    int instrument;  ///< Which.
    double along;    ///< From the thread's first node [m]; negative: its jaws shut on nothing.
};

/// The goals of a motion whose instruments keep their turn: its keys, and where it takes thread what is aimed at.
std::vector<Goal> goals_of(const scenarios::drill::Motion& motion, std::vector<Take> takes);

/// How well somebody plays.
struct Skill {
    double speed = 30e-3;                            ///< Of the place that her eyes lead her hands to [m/s].
    double lead = 3e-3;                              ///< So far that is ahead of the slower hand at most [m].
    double mouse_near = 0.7e-3, keys_near = 1.5e-3;  ///< What she takes for being there [m].
    double mouse_error = 3;                          ///< She points beside each goal by up to this [pixels].
    double notch = 0.052;                            ///< A notch of the wheel turns the needle by this [rad].
    double enough_N = 0.7;                           ///< She pulls no farther than to this tension.
    double looks_s = 0;                              ///< She taps keys and looks for so long what came of it; 0: holds.
    double gain = 10;                                ///< The mouse closes what she sees to be left at this rate [1/s].
};

/// A person who goes from goal to goal.
class Player {
  public:
    /// The mouse leads instrument `mouse`, keys lead instrument `keys`.
    Player(std::vector<Goal> goals, int mouse, int keys, const Skill& skill, unsigned seed);

    /// What she does now; to be asked whenever she sees something new, best every `period_s`.
    std::vector<Event> play(const Seen& seen);
    /// All goals are reached.
    bool is_done() const { return next_ >= goals_.size(); }
    /// Which goal is next.
    std::size_t goal() const { return next_; }

    static constexpr double period_s = 8e-3;  ///< As a mouse reports.

  private:
    void begin(const Seen& seen);
    bool takes_again(const Seen& seen);
    void lead(const Seen& seen, std::vector<Event>& events);
    bool pull_both(const Seen& seen, std::vector<Event>& events);
    bool turn_needle(const Seen& seen, std::vector<Event>& events);
    bool roll(const Seen& seen, std::vector<Event>& events);
    bool do_deed(const Seen& seen, std::vector<Event>& events);
    bool go(const Seen& seen, std::vector<Event>& events);
    void lead_mouse(const Seen& seen, std::vector<Event>& events);
    void tap_key(int axis, double lack, const Seen& seen, std::vector<Event>& events);
    void hold_keys(int axis, double lack, std::vector<Event>& events);
    void lead_keys(const Seen& seen, std::vector<Event>& events);
    void click_jaws(const Seen& seen, std::vector<Event>& events);
    void stop_keys(std::vector<Event>& events);
    void press(Action action, bool down, std::vector<Event>& events);
    Vec3 place(const Seen& seen, int instrument) const;
    Vec3 carrot(const Seen& seen, int instrument) const;
    bool goes(int instrument) const;
    bool has_jaws_right(const Seen& seen, int instrument) const;
    bool is_there(const Seen& seen) const;
    double near_share() const { return goals_[next_].is_fine ? 0.3 : 1; }

    std::vector<Goal> goals_;
    int mouse_, keys_;
    Skill skill_;
    std::mt19937 random_;
    std::size_t next_ = 0;
    bool begun_ = false;
    std::vector<Vec3> from_;                    // where the instruments were as the goal became the next
    double last_s_ = 0, elapsed_s_ = period_s;  // since she looked last
    double share_ = 0;                          // of the way from there to the goal
    Vec3 beside_ = Vec3::Zero();                // how far the mouse points beside the goal: right, up [pixels]
    bool pulled_ = false;
    double began_s_ = 0;              // this goal
    double rests_s_ = 0;              // since then the hands have, as far as she sees
    int notches_ = 0;                 // of the needle's turn
    Quat turned_ = Quat::Identity();  // the key hand's instrument, as the goal began
    double wheel_s_ = 0, clicked_s_ = -1;
    std::array<bool, static_cast<std::size_t>(Action::note) + 1> down_{};  // by what keys ask for
    std::array<double, 3> looked_s_{};                                     // of each axis of the keys
    Eigen::Vector2d left_ = Eigen::Vector2d::Zero();                       // parts of pixels
};

}  // namespace app::hands
