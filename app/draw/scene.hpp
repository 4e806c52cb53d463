#pragma once
#include "app/draw/canvas.hpp"
#include "app/draw/surface.hpp"

namespace app::draw {

/// What a surface is made of.
enum class Look { flesh, suture, steel };

/// Triangles of one look, where they lie in the indices.
struct Part {
    Look look;
    std::size_t first, count;
};

/// All of a picture but its tools, in the world frame.
struct Scene {
    Surface surface;
    std::vector<Part> parts;

    /// Appends a surface of one look.
    void add(const Surface& more, Look look);
};

/// The scene of a picture, as finely as the level asks.
Scene scene_of(const Picture& picture, Level level);

/// A tool's three parts in their own frames, as ToolPart numbers them.
Scene tool_scene(instruments::Kind kind, Level level);

}  // namespace app::draw
