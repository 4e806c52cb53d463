#pragma once
#include <memory>

#include "app/hands/hands.hpp"
#include "scenarios/drill/motion.hpp"
#include "scenarios/session/session.hpp"

namespace app::hands {

/// A shipped drill, where its own motion starts.
struct Scene {
    scenarios::drill::Drill drill;        ///< As its file has it.
    scenarios::drill::Motion motion;      ///< Its reference motion.
    std::vector<ToolInput> inputs;        ///< What the instruments are asked for.
    scenarios::session::Session session;  ///< That plays it.
    std::unique_ptr<Hands> hands;         ///< That lead its instruments.
    Taken taken;                          ///< What comes in the next tick.

    explicit Scene(const std::string& name, const Settings& settings = {})
        : drill(scenarios::drill::load_drill(std::string(CARREL_SOURCE "/scenarios/drills/") + name + ".json")),
          motion(scenarios::drill::load_motion(drill.motion, names())),
          inputs(start()),
          session(drill, inputs),
          hands(std::make_unique<Hands>(settings, drill.world.instruments, inputs)) {
        taken.sight = look_at({0, -0.09, 0.1}, {0, 0, 0.01}, Vec3::UnitZ(), 0.5, 700);
    }
    /// The world after the last tick.
    const World& world() const { return session.world(); }
    /// Lets the hands say what they ask for, and leaves the world alone.
    void ask() {
        hands->tick(world(), taken, inputs);
        taken.events.clear();
    }
    /// One tick.
    void tick() {
        ask();
        session.tick(inputs);
    }
    /// Something that a device does before the next tick.
    void post(std::variant<Motion, Wheel, Click, Press, Switch, LetGo> what) { taken.events.push_back({what, 0}); }

  private:
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& instrument : drill.world.instruments) all.push_back(instrument.name);
        return all;
    }
    std::vector<ToolInput> start() const {
        std::vector<ToolInput> at(drill.world.instruments.size());
        motion.at(0, at);
        return at;
    }
};

}  // namespace app::hands
