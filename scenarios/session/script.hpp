#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/motion.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::session {

/// A drill and the motion that plays it.
struct Script {
    /// Reads a drill and the motion that it names. Throws FileError.
    explicit Script(const std::filesystem::path& file);
    /// A drill as it is here and the motion that it names. Throws FileError.
    explicit Script(drill::Drill of);

    /// How long the drill takes: the motion, the rest after it and not more than the drill's limit [ticks].
    std::uint64_t ticks() const;
    /// What the motion asks for at a tick, from 0; one input per instrument.
    std::vector<instruments::ToolInput> inputs(std::uint64_t tick) const;
    /// The world before the first tick.
    world::World start() const;
    /// Plays the world's next tick.
    void tick(world::World& world) const { world.tick(inputs(world.ticks())); }

    drill::Drill drill;    ///< What is played.
    drill::Motion motion;  ///< By what.
};

}  // namespace scenarios::session
