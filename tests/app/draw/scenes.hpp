#pragma once
#include <cmath>
#include <cstdlib>
#include <vector>

#include "app/draw/canvas.hpp"

// What tests of pictures look at, and with.
namespace scenes {

using namespace app::draw;

/// One for all tests of a program.
inline Canvas& canvas() {
    static Canvas one;
    return one;
}

struct Color {
    int red, green, blue;
    int light() const { return red + green + blue; }
    bool suture() const { return blue > green + 25; }  // no other solid is drawn in blue
    bool flesh() const { return red > green + 60; }
};

inline Color at(const Image& image, int x, int y) {
    const unsigned char* p = &image.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                                static_cast<std::size_t>(x))];
    return {p[0], p[1], p[2]};
}

/// Mean difference of two images of one size, over pixels and colours [of 255].
inline double mean_difference(const Image& one, const Image& other) {
    double sum = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i) sum += std::abs(one.pixels[i] - other.pixels[i]);
    return sum / static_cast<double>(one.pixels.size());
}

/// How many pixels differ by more than this in all colours together.
inline int differing(const Image& one, const Image& other, int by = 24) {
    int count = 0;
    for (int y = 0; y < one.height; ++y)
        for (int x = 0; x < one.width; ++x)
            count += std::abs(at(one, x, y).red - at(other, x, y).red) +
                         std::abs(at(one, x, y).green - at(other, x, y).green) +
                         std::abs(at(one, x, y).blue - at(other, x, y).blue) >
                     by;
    return count;
}

inline std::vector<Vec3> line(const Vec3& from, const Vec3& to) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 50; ++i) points.push_back(from + i / 50.0 * (to - from));
    return points;
}

inline Picture thread_picture(std::vector<Vec3> thread, double radius) {
    Picture picture;
    picture.thread = {std::move(thread)};
    picture.thread_radius = radius;
    picture.width = 480;
    picture.height = 320;
    return picture;
}

inline Picture vessel_picture() {
    Picture picture = thread_picture({}, 0.5e-3);
    picture.vessels = {assets::make_tube(4e-3, 0.6e-3, 30e-3, 48, 20)};
    return picture;
}

/// A tool whose jaws' tips are here; it comes from above on the right.
inline ToolPicture tool_at(const Vec3& tips, double jaw, instruments::Kind kind = instruments::Kind::forceps) {
    return {kind, {tips, Eigen::Quaterniond(Eigen::AngleAxisd(-2.2, Vec3::UnitY()))}, jaw};
}

/// A vessel over a drape, a thread over that in the jaws of a tool, another tool beside it.
inline Picture whole_picture() {
    Picture picture = vessel_picture();
    picture.continued = {{0, {-15e-3, 0, 0}, -Vec3::UnitX()}, {0, {15e-3, 0, 0}, Vec3::UnitX()}};
    picture.drape = -10e-3;
    picture.thread = {line({-9e-3, -2e-3, 4e-3}, {9e-3, 2e-3, 4e-3})};
    picture.thread_radius = 0.1e-3;
    picture.tools = {tool_at({0, 0, 4e-3}, 0), tool_at({-9e-3, 3e-3, 8e-3}, 0.6, instruments::Kind::needle_holder)};
    return picture;
}

}  // namespace scenes
