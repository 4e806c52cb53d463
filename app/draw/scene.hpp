#pragma once
#include "app/draw/canvas.hpp"
#include "app/draw/surface.hpp"

namespace app::draw {

/// What a surface is made of; what is made of shadow is not seen but casts one.
enum class Look { flesh, suture, steel, cloth, shadow };

/// Triangles of one look, where they lie in the indices.
struct Part {
    Look look;
    std::size_t first, count;
    bool closed;  ///< Nobody sees its back.
    bool casts;   ///< It casts a shadow.
};

/// All of a picture but its tools, its drape and its helps, in the world frame.
struct Scene {
    Surface surface;
    std::vector<Part> parts;

    /// Appends a surface of one look.
    void add(const Surface& more, Look look, bool closed = true, bool casts = true);
};

/// Makes it the scene of a picture, as finely as the level asks, for a lamp in this direction.
void fill(Scene& scene, const Picture& picture, Level level, const Vec3& to_key);

/// A tool's three parts in their own frames, as ToolPart numbers them.
Scene tool_scene(instruments::Kind kind, Level level);

/// How far the drape reaches to either side of its middle [m].
constexpr double cloth_reach = 0.3;

/// Cloth flat at the height 0; soft folds are in its normals.
Surface cloth();

/// A vessel's outer skin drawn on beyond an end of it: a tube through the end's rim. Empty where the end is not there.
assets::Mesh continuation(const Picture& picture, const Continued& end);

/// A mark of one colour that is not lit by lamps.
struct Mark {
    Eigen::Vector4f tint;  ///< Red, green, blue as a screen wants them, and opacity.
    float soft;            ///< 1: fades towards its outline, 0: does not.
    bool on_top;           ///< Seen through what is before it.
    std::size_t first, count;
};

/// The helps of a picture.
struct Marks {
    Surface surface;
    std::vector<Mark> marks;
};

/// As the picture asks for them.
Marks marks_of(const Picture& picture);

}  // namespace app::draw
