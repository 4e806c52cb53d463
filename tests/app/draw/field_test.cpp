#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/draw/scenes.hpp"

namespace {

using namespace scenes;

Color seen_at(const Image& image, const Picture& picture, const Vec3& point) {
    const Vec3 p = project(picture, point);
    return at(image, static_cast<int>(p.x()), static_cast<int>(p.y()));
}

/// Two ends of a vessel whose cuts meet at x = 0, drawn in about five bites a side, as a sewn wall is.
std::vector<assets::Mesh> sewn_walls() {
    std::vector<assets::Mesh> walls;
    for (const double side : {-1.0, 1.0}) {
        assets::Mesh& mesh = walls.emplace_back(assets::make_tube(4e-3, 0.5e-3, 4e-3, 32, 12));
        for (Vec3& p : mesh.vertices) {
            p.x() += side * 2e-3;
            for (const double angle : {0.5, 1.6, 2.9, 4.2, 5.5}) {
                const Vec3 outwards(0, std::cos(angle), std::sin(angle));
                const double off = (p - Vec3(side * 1.3e-3, 0, 0) - 2e-3 * outwards).norm() / 1e-3;
                const double ripple = 0.25e-3 * std::sin(off / 0.12) * std::exp(-2 * off * off);
                p += (ripple - 0.55e-3 * std::exp(-4 * off * off)) * outwards;
                p.x() -= side * 0.35e-3 * std::exp(-2 * off * off);
            }
        }
    }
    return walls;
}

/// Sum of the brightness of squares of this many pixels, row by row; negative where a square has anything but flesh.
struct Patches {
    static constexpr int size = 3;
    int across, down;
    std::vector<double> light;

    explicit Patches(const Image& image) : across(image.width / size), down(image.height / size) {
        for (int j = 0; j < down; ++j)
            for (int i = 0; i < across; ++i) light.push_back(of(image, i * size, j * size));
    }
    static double of(const Image& image, int left, int top) {
        double sum = 0;
        for (int y = top; y < top + size; ++y)
            for (int x = left; x < left + size; ++x) {
                const Color color = at(image, x, y);
                if (color.suture() || color.green > color.red) return -1;  // thread; cloth
                sum += color.light();
            }
        return sum;
    }
    /// Of a patch over the mean of those about it; 1 where it or too few of them are of flesh.
    double share(int i, int j) const {
        double sum = 0;
        int count = 0;
        for (int y = j - 1; y <= j + 1; ++y)
            for (int x = i - 1; x <= i + 1; ++x)
                if ((x != i || y != j) && light[y * across + x] >= 0) sum += light[y * across + x], ++count;
        const double own = light[j * across + i];
        return own < 0 || count < 6 ? 1 : own / (sum / count);
    }
};

}  // namespace

class Levels : public testing::TestWithParam<app::draw::Level> {
  protected:
    Image rendered(const Picture& picture) { return render(canvas(), picture, GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Field, Levels, testing::Values(Level::full, Level::light),
                         [](const auto& level) { return level.param == Level::full ? "Full" : "Light"; });

// Dark slivers about bites looked like torn tissue: faces that fold over were lit from behind, and the shadow of a
// crease on itself was black. A fifth is what a person takes for a sliver; flesh lit as it should be has two thirds.
TEST_P(Levels, ASewnWallHasNoDarkSlivers) {
    Picture picture = thread_picture({}, 42e-6);
    picture.vessels = sewn_walls();
    picture.drape = -10e-3;
    for (const double angle : {0.5, 1.6, 2.9, -2.08, -0.78}) {
        std::vector<Vec3> strand;
        for (int i = 0; i <= 20; ++i) {
            const double turn = 3.14159 * i / 20, radius = 1.6e-3 + 0.9e-3 * std::sin(turn);
            strand.emplace_back(-1e-3 * std::cos(turn), radius * std::cos(angle), radius * std::sin(angle));
        }
        picture.thread.push_back(strand);
    }
    picture.width = 960, picture.height = 640;
    int flesh = 0;
    for (const Vec3& outwards : {Vec3(0, -0.5, 0.8), Vec3(0, -1, 0), Vec3(0, 0.3, -1)})
        for (const double radius : {1.2e-3, 2.4e-3}) {
            SCOPED_TRACE(testing::Message() << "from " << outwards.transpose() << ", " << radius);
            picture.camera = close_view(2e-3 * outwards.normalized(), radius, outwards.normalized());
            const Patches patches(rendered(picture));
            const double seam = project(picture, 2e-3 * outwards.normalized()).x() / Patches::size;
            for (int j = 1; j + 1 < patches.down; ++j)
                for (int i = 1; i + 1 < patches.across; ++i) {
                    if (std::abs(i + 0.5 - seam) < 2) continue;  // between the cuts: the lumen
                    flesh += patches.light[j * patches.across + i] >= 0;
                    ASSERT_GE(patches.share(i, j), 0.6) << "at " << i * Patches::size << ", " << j * Patches::size;
                }
        }
    EXPECT_GT(flesh, 10000) << "the pictures show no wall";
}

// A vessel that ends at its clamp is a piece of pipe; the residents asked where the rest of it was.
TEST_P(Levels, AVesselGoesOnBeyondItsEnds) {
    Picture picture = vessel_picture();
    picture.vessels = {assets::make_tube(4e-3, 0.6e-3, 12e-3, 48, 20)};
    const Vec3 beyond(20e-3, 0, 0);  // 14 mm from the end
    EXPECT_FALSE(seen_at(rendered(picture), picture, beyond).flesh());
    picture.continued = {{0, {6e-3, 0, 0}, Vec3::UnitX()}};
    const Image image = rendered(picture);
    for (double x = 5e-3; x < 21e-3; x += 0.5e-3)
        EXPECT_TRUE(seen_at(image, picture, {x, 0, 0}).flesh()) << x << " m: not one skin";
    EXPECT_FALSE(seen_at(image, picture, -beyond).flesh()) << "the other end ends";
    picture.continued = {{0, {3.3e-3, 0, 0}, Vec3::UnitX()}};  // there is no end there
    EXPECT_FALSE(seen_at(rendered(picture), picture, beyond).flesh());
}

// Where the shadow lies on the cloth tells how high a thing is.
TEST_P(Levels, ShadowsFallOnTheDrape) {
    Picture picture = thread_picture({{0, 0, 0}}, 1e-3);  // a ball
    const auto shadow = [&](double drape) {
        picture.drape = drape;
        Picture bare = picture;
        bare.thread.clear();
        const Image with = rendered(picture), without = rendered(bare);
        Vec3 sum = Vec3::Zero();
        for (int y = 0; y < with.height; ++y)
            for (int x = 0; x < with.width; ++x)
                if (!at(with, x, y).suture() && at(with, x, y).light() < at(without, x, y).light() - 60)
                    sum += Vec3(x, y, 1);
        return Vec3(sum / std::max(sum.z(), 1.0));
    };
    const Vec3 near = shadow(-3e-3), far = shadow(-9e-3);
    ASSERT_EQ(near.z(), 1) << "no shadow";
    ASSERT_EQ(far.z(), 1);
    EXPECT_GT(far.x(), near.x() + 10);  // away from the lamp, which is on the left
    EXPECT_GT(far.y(), near.y() + 10);
}

// At the light level a band casts a thread's shadow: as wide as the thread, wherever that goes.
TEST(Field, AThreadCastsTheSameShadowAtBothLevels) {
    Picture picture = thread_picture({}, 0.5e-3);
    picture.drape = -6e-3;
    std::vector<Vec3> coil;
    for (int i = 0; i <= 60; ++i) coil.emplace_back(4e-3 * std::cos(0.2 * i), 4e-3 * std::sin(0.2 * i), 0.05e-3 * i);
    Picture with = picture;
    with.thread = {coil};
    const auto shadow = [&](Level level) {
        const Image bare = render(canvas(), picture, level), cast = render(canvas(), with, level);
        std::vector<bool> dark;
        for (int y = 0; y < bare.height; ++y)
            for (int x = 0; x < bare.width; ++x)
                dark.push_back(!at(cast, x, y).suture() && at(cast, x, y).light() < at(bare, x, y).light() - 60);
        return dark;
    };
    const auto full = shadow(Level::full), light = shadow(Level::light);
    int both = 0, either = 0;
    for (std::size_t i = 0; i < full.size(); ++i) both += full[i] && light[i], either += full[i] || light[i];
    EXPECT_GT(both, 1000);
    EXPECT_GT(both, 0.75 * either);
}

// What lies under a vessel is looked at from below, through where the cloth would be.
TEST_P(Levels, TheDrapeIsNotSeenFromBelow) {
    Picture picture = vessel_picture();
    picture.drape = -5e-3;
    picture.camera.position.z() *= -1;
    EXPECT_TRUE(seen_at(rendered(picture), picture, {0, 0, 0}).flesh());
    picture.camera.position.z() *= -1;
    picture.drape = 5e-3;
    EXPECT_FALSE(seen_at(rendered(picture), picture, {0, 0, 0}).flesh()) << "there is a drape";
}

// Beyond the cloth's edge, and above the horizon, is the background and not what was drawn there before.
TEST_P(Levels, BeyondTheDrapeIsTheBackground) {
    Picture picture = thread_picture({}, 1e-3);
    picture.camera.position = {0, -0.09, 0.004};
    const Image bare = rendered(picture);
    Picture other = vessel_picture();
    other.camera.position *= 0.2;
    rendered(other);  // red all over
    picture.drape = -5e-3;
    const Image image = rendered(picture);
    EXPECT_EQ(at(image, 240, 2).light(), at(bare, 240, 2).light());
    EXPECT_GT(std::abs(at(image, 240, 310).light() - at(bare, 240, 310).light()), 20) << "no cloth";
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; x += 4) ASSERT_FALSE(at(image, x, y).flesh()) << x << ", " << y;
}

// The light level shows the same scene: a thread beside where the full one has it would teach a wrong knot.
TEST(Field, BothLevelsShowTheSame) {
    const Picture picture = whole_picture();
    const Image full = render(canvas(), picture), light = render(canvas(), picture, Level::light);
    int either = 0, both = 0;
    for (int y = 0; y < full.height; ++y)
        for (int x = 0; x < full.width; ++x) {
            const Color one = at(full, x, y), other = at(light, x, y);
            either += one.suture() || other.suture() || one.flesh() || other.flesh();
            both += (one.suture() && other.suture()) || (one.flesh() && other.flesh());
        }
    EXPECT_GT(both, 10000);
    EXPECT_GT(both, 0.9 * either);
    EXPECT_LT(mean_difference(full, light), 20);
}
