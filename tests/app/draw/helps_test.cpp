#include <gtest/gtest.h>

#include "tests/app/draw/scenes.hpp"

namespace {

using namespace scenes;

Image rendered(const Picture& picture) {
    return render(canvas(), picture, Level::light);
}

/// Where two images differ: how many pixels, and the box about them.
struct Changed {
    int count = 0, left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
    Changed(const Image& one, const Image& other) {
        for (int y = 0; y < one.height; ++y)
            for (int x = 0; x < one.width; ++x)
                if (std::abs(at(one, x, y).light() - at(other, x, y).light()) > 20 ||
                    std::abs(at(one, x, y).red - at(other, x, y).red) > 20) {
                    ++count;
                    left = std::min(left, x), right = std::max(right, x);
                    top = std::min(top, y), bottom = std::max(bottom, y);
                }
    }
    double width() const { return right - left + 1; }
};

/// A tool with open jaws so far above a vessel's top; the vessel's radius is 2 mm.
Picture tool_above(double height) {
    Picture picture = vessel_picture();
    picture.tools = {tool_at({0, 0, 2e-3 + height}, 0.5)};
    return picture;
}

}  // namespace

TEST(Helps, TheGapIsHowFarTheJawsAreFromTheNearestThing) {
    for (const double height : {0.3e-3, 1e-3, 4e-3, 20e-3}) {
        const Picture picture = tool_above(height);
        const auto parts = instruments::parts_at(instruments::shape_of(picture.tools[0].kind), picture.tools[0].pose,
                                                 picture.tools[0].jaw);
        const Vec3 mouth = (parts[instruments::jaw_plus].b + parts[instruments::jaw_minus].b) / 2;
        const double from_axis = Vec3(0, mouth.y(), mouth.z()).norm();
        EXPECT_NEAR(gap(picture, 0), from_axis - 2e-3, 10e-6) << height;  // 48 facets: 4 um
        Picture with_thread = picture;
        with_thread.thread_radius = 0.1e-3;
        with_thread.thread = {{mouth + Vec3(-5e-3, 0.2e-3, 0), mouth + Vec3(5e-3, 0.2e-3, 0)}};
        EXPECT_NEAR(gap(with_thread, 0), 0.1e-3, 1e-9) << "a thread is nearer than the vessel";
        with_thread.thread[0] = {mouth, mouth + Vec3(1e-3, 0, 0)};
        EXPECT_EQ(gap(with_thread, 0), 0) << "it is between the jaws";
    }
    Picture alone = tool_above(1e-3);
    alone.vessels.clear(), alone.thread.clear();
    EXPECT_EQ(gap(alone, 0), std::numeric_limits<double>::infinity());
}

// The ring is read as a length: twice the gap across, and none beyond 5 mm.
TEST(Helps, TheRingIsAsWideAsTheGap) {
    for (const double height : {1e-3, 2e-3, 3.5e-3}) {
        Picture picture = tool_above(height);
        const Image without = rendered(picture);
        picture.helps.ring_tool = 0;
        const Changed ring(without, rendered(picture));
        const double pixels = picture.height / (2 * std::tan(picture.camera.field_of_view / 2)) /
                              project(picture, picture.tools[0].pose.position).z();
        EXPECT_NEAR(ring.width(), 2 * gap(picture, 0) * pixels, 7) << height;  // its line is some pixels wide
    }
    Picture far = tool_above(8e-3);
    const Image without = rendered(far);
    far.helps.ring_tool = 0;
    EXPECT_EQ(Changed(without, rendered(far)).count, 0);
    far.helps.ring_tool = 5;  // there is no such tool
    EXPECT_EQ(Changed(without, rendered(far)).count, 0);
}

// The line must end on what lies under the jaw, not go on through the vessel to the drape.
TEST(Helps, ThePlumbLineEndsOnWhatLiesUnderTheJaw) {
    const auto lowest = [](const Vec3& tips) {
        Picture picture = vessel_picture();
        picture.drape = -8e-3;
        picture.tools = {tool_at(tips, 0)};
        const Image without = rendered(picture);
        picture.helps.plumb = true;
        const Changed line(without, rendered(picture));
        EXPECT_GT(line.count, 30);
        return line.bottom;
    };
    const Picture picture = vessel_picture();
    EXPECT_NEAR(lowest({0, 0, 8e-3}), project(picture, {0, 0, 2e-3}).y(), 8);
    EXPECT_NEAR(lowest({0, -8e-3, 8e-3}), project(picture, {0, -8e-3, -8e-3}).y(), 8) << "beside the vessel";
}

// Tension is told by colour and by width, for who cannot tell the colours apart.
TEST(Helps, TheStrandBetweenTwoJawsShowsItsTension) {
    Picture picture = thread_picture(line({-12e-3, 0, 0}, {12e-3, 0, 0}), 0.15e-3);
    picture.tools = {tool_at({-6e-3, 0, 0}, 0), tool_at({6e-3, 0, 0}, 0)};
    const Image plain = rendered(picture);
    const auto strand = [&](double tension) {
        Picture lit = picture;
        lit.helps.strand = true;
        lit.helps.tension = tension;
        return rendered(lit);
    };
    const Image slack = strand(0), taut = strand(1);
    const Vec3 middle = project(picture, Vec3::Zero()), outside = project(picture, {-11e-3, 0, 0});
    const auto color = [](const Image& image, const Vec3& p) {
        return at(image, static_cast<int>(p.x()), static_cast<int>(p.y()));
    };
    EXPECT_TRUE(color(plain, middle).suture());
    EXPECT_GT(color(slack, middle).green, color(slack, middle).red) << "bluish green";
    EXPECT_GT(color(taut, middle).red, color(taut, middle).green + 60) << "vermillion";
    EXPECT_TRUE(color(taut, outside).suture()) << "not between the jaws";
    EXPECT_GT(Changed(plain, taut).count, 1.4 * Changed(plain, slack).count) << "no wider";
    picture.tools[1].jaw = 1;  // it holds nothing
    Picture one = picture;
    one.helps.strand = true;
    EXPECT_EQ(Changed(rendered(picture), rendered(one)).count, 0);
}

TEST(Helps, AJawThatTouchesGlows) {
    for (const double off : {0.0, 1e-3}) {
        Picture picture = thread_picture(line({-12e-3, 0, 0}, {12e-3, 0, 0}), 0.15e-3);
        picture.tools = {tool_at({0, 0, off}, 0)};
        const Image without = rendered(picture);
        picture.helps.contact = true;
        EXPECT_EQ(Changed(without, rendered(picture)).count > 5, off == 0.0) << off;
    }
}

TEST(Helps, WhatWouldBeTakenIsLit) {
    Picture picture = thread_picture(line({-12e-3, 0, 0}, {12e-3, 0, 0}), 0.15e-3);
    const Image without = rendered(picture);
    picture.helps.candidate = {{-2e-3, 0, 0}, {0, 0, 0}, {2e-3, 0, 0}};
    const Changed lit(without, rendered(picture));
    EXPECT_NEAR(lit.left, project(picture, {-2e-3, 0, 0}).x(), 4);
    EXPECT_NEAR(lit.right, project(picture, {2e-3, 0, 0}).x(), 4);
    picture.helps.candidate = {{5e-3, 0, 0}};
    EXPECT_NEAR(Changed(without, rendered(picture)).left, project(picture, {5e-3, 0, 0}).x(), 9);
}

// A place to go to must be seen in depth too, and not hide the thread that is in it.
TEST(Helps, APlaceIsAsLargeAsItSaysAndSeenThrough) {
    Picture picture = thread_picture(line({-12e-3, 0, 0}, {12e-3, 0, 0}), 0.15e-3);
    const Image without = rendered(picture);
    picture.helps.places = {{{0, 0, 0}, 4e-3}};
    const Image with = rendered(picture);
    const double pixels =
        picture.height / (2 * std::tan(picture.camera.field_of_view / 2)) / project(picture, Vec3::Zero()).z();
    EXPECT_NEAR(Changed(without, with).width(), 8e-3 * pixels, 4);
    const Vec3 thread = project(picture, {2e-3, 0, 0});
    const Color through = at(with, static_cast<int>(thread.x()), static_cast<int>(thread.y()));
    EXPECT_LT(through.red, 140) << "the thread is hidden";
    picture.drape = -8e-3;
    Picture bare = picture;
    bare.helps.places.clear();
    EXPECT_GT(Changed(rendered(bare), rendered(picture)).bottom, project(picture, {0, 0, -7.5e-3}).y())
        << "no plumb line";
}

// A ghost that hid what lies behind it would hide the knot it is to teach; one that cast a shadow would be taken for a
// tool.
TEST(Helps, AGhostIsSeenThroughAndCastsNoShadow) {
    for (const Level level : {Level::full, Level::light}) {
        Picture picture = vessel_picture();
        picture.drape = -6e-3;
        const Image without = render(canvas(), picture, level);
        picture.ghosts = {tool_at({0, -1e-3, 3e-3}, 0)};
        const Image ghost = render(canvas(), picture, level);
        Picture solid = picture;
        std::swap(solid.tools, solid.ghosts);
        const Image tool = render(canvas(), solid, level);
        const int seen = Changed(without, ghost).count;
        EXPECT_GT(seen, 300);
        EXPECT_LT(seen, 0.8 * Changed(without, tool).count) << "a tool's shadow changes more";
        const Vec3 shaft =
            project(picture, picture.ghosts[0].pose.position + picture.ghosts[0].pose.rotation * Vec3(0, 0, -20e-3));
        const int x = static_cast<int>(shaft.x()), y = static_cast<int>(shaft.y());
        const int change = std::abs(at(ghost, x, y).light() - at(without, x, y).light()),
                  solid_change = std::abs(at(tool, x, y).light() - at(without, x, y).light());
        EXPECT_LT(change, solid_change + 200);
    }
}
