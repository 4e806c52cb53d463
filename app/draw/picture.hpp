#pragma once
#include <optional>
#include <vector>

#include "app/draw/context.hpp"
#include "assets/mesh.hpp"
#include "instruments/tool.hpp"

namespace app::draw {

using sim::geometry::Vec3;

/// A pinhole camera; `up` need only not lie along the line of sight.
struct Camera {
    Vec3 position, target, up = Vec3::UnitZ();  ///< [m], world; up has no unit.
    double field_of_view = 0.5;                 ///< Vertical [rad], in (0, pi).
    double cut_off = 0.02;  ///< What is nearer than this share of the way to the target is not drawn, in (0, 1).
};

/// The operative field, 25 mm to either side of the origin, from the front (-y) and above.
Camera default_view();

/// The nearest eye, looking as default_view() does, that has all these points in its picture; default_view() for none.
/// aspect: the picture's width over its height. The points must not all be one.
Camera view_of(const std::vector<Vec3>& points, double aspect);

/// A ball filling the height of the picture, from where default_view() looks, or from the mirror image of that in the
/// plane across `outwards` where it would look the other way: what lies under a vessel is seen from below. outwards:
/// unit, or zero for any side; radius > 0 [m].
Camera close_view(const Vec3& point, double radius, const Vec3& outwards);

/// A tool as it is drawn.
struct ToolPicture {
    instruments::Kind kind = instruments::Kind::forceps;
    instruments::Pose pose;
    double jaw = 1.0;  ///< 0 closed to 1 open.
};

/// An end of a vessel beyond which it is drawn on, as in a body: 15 mm straight, then down under the drape.
struct Continued {
    std::size_t vessel = 0;  ///< Which of the picture's vessels.
    Vec3 centre;             ///< Of its end, which must be flat [m].
    Vec3 outwards;           ///< Square to the end, away from the vessel; unit.
};

/// A ball in space, say a place to go to.
struct Ball {
    Vec3 centre;        ///< [m]
    double radius = 0;  ///< [m]
};

/// What helps to see depth on a flat screen; all are off. Colours are of Okabe and Ito, and a size says the same.
struct Helps {
    bool plumb = false;           ///< From each jaw a line down to what lies under it, and a drop shadow there.
    int ring_tool = -1;           ///< Number of the tool whose jaws close: a ring as wide as its gap(), below 5 mm.
    bool contact = false;         ///< A glow where jaws touch something.
    bool strand = false;          ///< The strand between two jaws that hold the same thread is lit.
    double tension = 0;           ///< Of that strand, 0 to 1, a share of what breaks it: colour and width.
    std::vector<Ball> places;     ///< Where something is to be brought: seen through, with a plumb line.
    std::vector<Vec3> candidate;  ///< What the jaws would take if they closed: a line or a point, lit.
};

/// All that is to be seen, in the world frame.
struct Picture {
    std::vector<std::vector<Vec3>>
        thread;  ///< Its pieces: nodes along the centre line [m]; fewer than two apart: a ball, or nothing.
    double thread_radius = 50e-6;  ///< [m] Drawn true, yet nowhere under 1.6 pixels, or a fine thread would vanish.
    std::vector<std::vector<Vec3>> needles;  ///< From tail to tip [m].
    double needle_radius = 0;                ///< Of their wire [m].
    std::vector<std::vector<Vec3>> wires;    ///< Of clamps, as the thread's pieces.
    double wire_radius = 0.2e-3;             ///< [m]
    std::vector<ToolPicture> tools;          ///< Steel.
    std::vector<ToolPicture> ghosts;         ///< Translucent, so that a tool beside or in one is seen; cast no shadow.
    std::vector<assets::Mesh> vessels;
    std::vector<Continued> continued;  ///< Ends of them.
    std::optional<double> drape;       ///< Height of the cloth under the field [m]; none: a bare background.
    Helps helps;
    Camera camera = default_view();
    int width = 960, height = 640;  ///< Pixels, 1 to 4096 each.
};

/// Rows from the top, red, green and blue, 8 bits each, as a screen wants them (sRGB).
struct Image {
    int width = 0, height = 0;
    std::vector<unsigned char> pixels;  ///< 3 * width * height
};

/// How far the jaws of a tool of the picture are from the nearest thread, needle or vessel [m]: from the middle of
/// their tips to its surface; 0 where that is inside, infinite where there is nothing. Some 20 us.
double gap(const Picture& picture, std::size_t tool);

/// The place of a point of the world in the picture: pixels from its left and top edge; z is the depth [m] before the
/// camera, not positive behind it.
Vec3 project(const Picture& picture, const Vec3& point);

/// Bytes of a PNG file. Throws DrawError: no pixels, or as many as do not fit the size.
std::vector<unsigned char> encode_png(const Image& image);

}  // namespace app::draw
