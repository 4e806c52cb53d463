#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/app/draw/scenes.hpp"

namespace {

using namespace scenes;

/// First and last row of a column in which thread is seen.
struct Span {
    int top = -1, bottom = -1;
    double middle() const { return (top + bottom + 1) / 2.0; }
    int width() const { return bottom - top + 1; }
};

Span thread_in(const Image& image, int x) {
    Span span;
    for (int y = 0; y < image.height; ++y)
        if (at(image, x, y).suture()) span.bottom = y, span.top = span.top < 0 ? y : span.top;
    return span;
}

Vec3 random_point(std::mt19937& random, double size) {
    const auto one = [&] { return size * (2.0 * random() / std::mt19937::max() - 1); };
    const double x = one(), y = one();
    return {x, y, one()};
}

}  // namespace

// A picture whose thread is beside where the simulation has it, or of another thickness, proves nothing about a knot.
// A knot under a vessel would be seen from within it.
TEST(Draw, ACloseViewIsFromOutside) {
    const Vec3 point(1e-3, 2e-3, -3e-3);
    const auto eye_from = [&](const Vec3& outwards) {
        return Vec3(close_view(point, 2e-3, outwards).position - point);
    };
    const Vec3 usual = eye_from(Vec3::Zero());
    EXPECT_EQ(eye_from(Vec3::UnitZ()), usual);
    for (const Vec3& outwards : {Vec3(-Vec3::UnitZ()), Vec3(Vec3::UnitY()), Vec3(0.2, 0.6, -0.5).normalized()}) {
        EXPECT_NEAR(eye_from(outwards).dot(outwards), -usual.dot(outwards), 1e-15) << "a rounding of 8 mm";
        EXPECT_GT(eye_from(outwards).dot(outwards), 0);
        EXPECT_NEAR(eye_from(outwards).norm(), usual.norm(), 1e-15);
    }
}

// A forceps that reached over the needle filled the picture of its bite.
TEST(Draw, ACloseViewIsNotHiddenByAToolInFront) {
    Picture picture = thread_picture(line({-5e-3, 0, 0}, {5e-3, 0, 0}), 0.2e-3);
    picture.camera = close_view(Vec3::Zero(), 3e-3, Vec3::Zero());
    const auto is_seen = [&] { return at(render(canvas(), picture), 240, 160).suture(); };
    ASSERT_TRUE(is_seen());
    const auto tip = [](const instruments::Pose& pose) {
        return instruments::parts_at(instruments::shape_of(instruments::Kind::forceps), pose, 0)[instruments::jaw_plus]
            .b;
    };
    picture.tools = {
        {instruments::Kind::forceps, {0.7 * picture.camera.position - tip({}), instruments::Quat::Identity()}, 0}};
    EXPECT_TRUE(is_seen());
    picture.camera.cut_off = Camera().cut_off;
    EXPECT_FALSE(is_seen()) << "the tool is there";
}

TEST(Draw, ThreadIsWhereTheCameraProjectsItAndAsThick) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Vec3 a = Vec3(-12e-3, 0, 0) + random_point(random, 5e-3),
                   b = Vec3(12e-3, 0, 0) + random_point(random, 5e-3);
        const double radius = 0.4e-3 + 0.1e-3 * seed;
        const Picture picture = thread_picture(line(a, b), radius);
        const Image image = render(canvas(), picture);
        ASSERT_EQ(image.width, 480);
        ASSERT_EQ(image.height, 320);
        ASSERT_EQ(image.pixels.size(), 3u * 480 * 320);
        for (const double share : {0.2, 0.5, 0.8}) {
            const Vec3 middle = project(picture, a + share * (b - a)),
                       ahead = project(picture, a + (share + 0.01) * (b - a));
            const Vec3 away = (ahead - middle).cwiseProduct(Vec3(1, 1, 0)).normalized();
            const Span seen = thread_in(image, static_cast<int>(middle.x()));
            // Pixels a metre at that depth, then how far a strand leaning in the picture reaches up and down a column.
            const double pixels = picture.height / (2 * std::tan(picture.camera.field_of_view / 2)) / middle.z();
            const double lean = 1 / std::abs(away.x());
            EXPECT_NEAR(seen.middle(), middle.y(), 1 + lean);  // half a pixel, and the column's own place
            EXPECT_NEAR(seen.width(), 2 * radius * pixels * lean, 1.5 * lean);
        }
    }
}

// 10-0 thread is a tenth of a pixel in a thumbnail: it must thin out to a line, never to dashes or to nothing.
TEST(Draw, AFineThreadNeverVanishes) {
    const Image image = render(canvas(), thread_picture(line({-10e-3, 0, 0}, {10e-3, 3e-3, 1e-3}), 10e-6));
    for (int x = 160; x < 320; ++x) EXPECT_GT(thread_in(image, x).width(), 1) << "column " << x;
}

// A picture that is mirrored or turned over shows a left-handed trefoil as a right-handed one.
TEST(Draw, RightIsRightAndUpIsUp) {
    const auto seen_at = [](const Vec3& place) {
        const Image image = render(canvas(), thread_picture({place}, 1e-3));  // a ball
        double x = 0, y = 0, count = 0;
        for (int row = 0; row < image.height; ++row)
            for (int column = 0; column < image.width; ++column)
                if (at(image, column, row).suture()) x += column + 0.5, y += row + 0.5, ++count;
        return Vec3(x / count, y / count, count);
    };
    const Vec3 left = seen_at({-8e-3, 0, 0}), right = seen_at({8e-3, 0, 0}), high = seen_at({0, 0, 8e-3}),
               low = seen_at({0, 0, -8e-3}), near = seen_at({0, -8e-3, 0}), far = seen_at({0, 8e-3, 0});
    EXPECT_LT(left.x(), 240);
    EXPECT_NEAR(left.x() + right.x(), 480, 0.5);  // mirror images about the middle
    EXPECT_NEAR(left.y(), right.y(), 0.5);
    EXPECT_NEAR(left.z(), right.z(), 20);
    EXPECT_LT(high.y(), 160);
    EXPECT_GT(low.y(), 160);
    EXPECT_GT(near.z(), 1.1 * far.z());  // nearer is larger
}

// Metres and millimetres must not mix: a scene twice as large from twice as far is the same picture.
TEST(Draw, ScaleChangesNothing) {
    const auto scaled = [](double scale) {
        const std::vector<Vec3> bow = {{-9e-3, 0, 0}, {-3e-3, 1e-3, 4e-3}, {4e-3, -2e-3, -3e-3}, {9e-3, 2e-3, 0}};
        Picture picture = thread_picture(bow, scale * 0.8e-3);
        for (Vec3& p : picture.thread.front()) p *= scale;
        picture.camera.position *= scale;
        return render(canvas(), picture);
    };
    const Image one = scaled(1), other = scaled(3);
    int differ = 0;
    for (int y = 0; y < one.height; ++y)
        for (int x = 0; x < one.width; ++x) differ += std::abs(at(one, x, y).light() - at(other, x, y).light()) > 24;
    EXPECT_LT(differ, 100);  // of 153600: rounding at outlines
}

// Flat colour hides which strand lies on top; the lamp is above on the left.
TEST(Draw, TheSideToTheLampIsBrighter) {
    const Picture picture = vessel_picture();
    const Image image = render(canvas(), picture);
    const int x = picture.width / 2;
    int top = 0, bottom = 0;
    for (int y = 0; y < image.height; ++y)
        if (at(image, x, y).flesh()) bottom = y, top = top ? top : y;
    ASSERT_GT(bottom - top, 20);
    const auto brightness = [&](int from, int to) {
        double sum = 0;
        for (int y = from; y < to; ++y)
            for (int column = x - 40; column < x + 40; ++column) sum += at(image, column, y).light();
        return sum / (80 * (to - from));
    };
    const int third = (bottom - top) / 3;
    EXPECT_GT(brightness(top + 2, top + third), 1.3 * brightness(bottom - third, bottom - 2));
}

// Whether thread runs over or under the vessel is the point of the picture.
TEST(Draw, WhatIsInFrontHidesWhatIsBehind) {
    const auto over_vessel = [](double towards_eye) {
        Picture picture = vessel_picture();
        const Vec3 off = towards_eye * picture.camera.position.normalized();
        picture.thread = {line(Vec3(-1e-3, 0, 0) + off, Vec3(1e-3, 0, 0) + off)};
        const Vec3 middle = project(picture, off);
        return at(render(canvas(), picture), static_cast<int>(middle.x()), static_cast<int>(middle.y()));
    };
    EXPECT_TRUE(over_vessel(4e-3).suture());
    EXPECT_TRUE(over_vessel(-4e-3).flesh());
}

// Tools drawn apart from the parts that touch would show a grasp that grasps nothing.
TEST(Draw, ToolsStandWhereTheirPartsAre) {
    Picture empty = thread_picture({}, 0.5e-3);
    const Image without = render(canvas(), empty);
    for (const auto kind : {instruments::Kind::forceps, instruments::Kind::needle_holder}) {
        Picture picture = empty;
        picture.tools = {{kind, {{2e-3, 0, 3e-3}, Eigen::Quaterniond(Eigen::AngleAxisd(-1.7, Vec3::UnitY()))}, 1}};
        const Image image = render(canvas(), picture);
        const auto parts = instruments::parts_at(instruments::shape_of(kind), picture.tools[0].pose, 1);
        for (const int part : {instruments::jaw_plus, instruments::jaw_minus}) {
            const Vec3 tip = project(picture, parts[part].b);
            const int x = static_cast<int>(tip.x()), y = static_cast<int>(tip.y());
            EXPECT_GT(std::abs(at(image, x, y).light() - at(without, x, y).light()), 20) << part;
        }
        const Vec3 between = project(picture, (parts[instruments::jaw_plus].b + parts[instruments::jaw_minus].b) / 2);
        const int x = static_cast<int>(between.x()), y = static_cast<int>(between.y());
        EXPECT_LT(std::abs(at(image, x, y).light() - at(without, x, y).light()), 20) << "open jaws are drawn closed";
    }
}

// Reports are compared byte for byte; a picture that depends on the one before would make two of one session differ.
TEST(Draw, TheSamePictureIsTheSameBytes) {
    Picture picture = vessel_picture();
    picture.thread = {line({-9e-3, 2e-3, 3e-3}, {9e-3, -2e-3, 3e-3})};
    picture.tools = {{instruments::Kind::forceps, {}, 0.5}};
    const std::vector<unsigned char> first = encode_png(render(canvas(), picture));
    render(canvas(), thread_picture({Vec3::Zero()}, 3e-3));
    Picture large = vessel_picture();
    large.width = 900;
    render(canvas(), large);
    EXPECT_EQ(encode_png(render(canvas(), picture)), first);
    Canvas other;
    EXPECT_EQ(encode_png(render(other, picture)), first);
}

// A tool outside the frame is the first thing a resident asks about; a frame far too wide hides the knot.
TEST(Draw, AViewHoldsAllPointsAndNoMore) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        std::vector<Vec3> points;
        const Vec3 middle = random_point(random, 30e-3), spread = random_point(random, 30e-3);
        for (int i = 0; i < 12; ++i) points.push_back(middle + random_point(random, 1).cwiseProduct(spread));
        Picture picture;
        picture.camera = view_of(points, 1.5);  // 960 x 640
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (const Vec3& point : points) {
            const Vec3 p = project(picture, point);
            EXPECT_GT(p.z(), 0);
            left = std::min(left, p.x()), right = std::max(right, p.x());
            top = std::min(top, p.y()), bottom = std::max(bottom, p.y());
        }
        const double rounding = 1e-6;  // pixels
        EXPECT_GE(left, -rounding);
        EXPECT_LE(right, 960 + rounding);
        EXPECT_GE(top, -rounding);
        EXPECT_LE(bottom, 640 + rounding);
        EXPECT_TRUE(right - left > 959 || bottom - top > 639) << right - left << " x " << bottom - top;
    }
}

// Asked for the impossible, the renderer must say so; an allocation of 10^10 pixels would take the machine down.
TEST(Draw, ImpossiblePicturesAreRefused) {
    for (const int size : {-1, 0, 4097, 1 << 30}) {
        Picture wide = vessel_picture(), high = wide;
        wide.width = high.height = size;
        EXPECT_THROW(render(canvas(), wide), DrawError) << size;
        EXPECT_THROW(render(canvas(), high), DrawError) << size;
    }
    Picture blind = vessel_picture();
    blind.camera.position = blind.camera.target;
    EXPECT_THROW(render(canvas(), blind), DrawError);
    blind.camera.position = Vec3(0, 0, NAN);
    EXPECT_THROW(render(canvas(), blind), DrawError);
    blind.camera = default_view();
    blind.camera.up = blind.camera.position;
    EXPECT_THROW(render(canvas(), blind), DrawError);
    blind.camera = default_view();
    blind.camera.cut_off = 0;
    EXPECT_THROW(render(canvas(), blind), DrawError);
    EXPECT_THROW(encode_png({2, 2, {1, 2, 3}}), DrawError);
}
