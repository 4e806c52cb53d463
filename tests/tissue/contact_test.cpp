#include "tissue/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tissue/tube.hpp"

namespace {

using namespace tissue;

constexpr double step = 2e-3;

// A vessel whose far end is held, and tools.
struct Scene {
    Mesh mesh = make_tube({});
    Tissue tissue{{}, mesh};
    Skin skin{mesh};
    std::vector<Hold> holds;
    CapsuleContact tools;
    WallContact itself;
    std::vector<PointForce> forces;

    explicit Scene(const ContactDef& def = {}) : tools(def), itself(def, TubeDef{}.wall) {
        for (int i = static_cast<int>(mesh.nodes.size()) - 48; i < static_cast<int>(mesh.nodes.size()); ++i)
            holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
    }
    void go(std::span<const Capsule> now, std::span<const Capsule> before) {
        forces.clear();
        for (std::size_t i = 0; i < now.size(); ++i) tools.press(skin, now[i], before[i], forces);
        itself.press(mesh, skin, forces);
        tissue.step({.holds = holds, .forces = forces}, step);
        skin.update(tissue.nodes());
    }
    double deepest_in(const Capsule& capsule) const {
        return capsule.radius - skin.closest(capsule.a, capsule.b, 1).distance;
    }
    double off_rest() const {
        double most = 0;
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
            most = std::max(most, (tissue.nodes()[i] - mesh.nodes[i]).norm());
        return most;
    }
    double smallest_volume() const {
        double least = 1;
        for (const Tetrahedron& tet : mesh.tetrahedra)
            least = std::min(least, volume(tet, tissue.nodes()) / volume(tet, mesh.nodes));
        return least;
    }
    double narrowest() const {  // of the lumen, above over below, half a cell and more from the cut
        double least = 1;
        for (int a = 0; a < 5; ++a) {
            const auto inner = [&](int along, int around) {
                return tissue.nodes()[static_cast<std::size_t>((along * 16 + around) * 3)];
            };
            least = std::min(least, inner(a, 0).y() - inner(a, 8).y());
        }
        return least;
    }
};

Capsule across(double y, double x = 2e-3, double radius = 0.5e-3) {
    return {{x, y, -3e-3}, {x, y, 3e-3}, radius};
}

// A rod that comes down on a vessel by a millimetre, at up to a tenth of a metre a second, thick or as thin as a
// needle: the wall stays out of it.
TEST(CapsuleContact, KeepsTheWallOut) {
    for (const double radius : {0.5e-3, 0.1e-3})
        for (const double speed : {5e-3, 20e-3, 100e-3}) {
            SCOPED_TRACE(testing::Message() << radius << " " << speed);
            Scene scene;
            const double begin = 2e-3 + radius + 1e-4;
            Capsule last = across(begin, 2e-3, radius);
            double deepest = 0;
            const int steps = static_cast<int>(1e-3 / (speed * step));
            for (int i = 0; i <= steps + 50; ++i) {
                const Capsule now = across(begin - std::min(1.0, static_cast<double>(i) / steps) * 1e-3, 2e-3, radius);
                scene.go({&now, 1}, {&last, 1});
                deepest = std::max(deepest, scene.deepest_in(now));
                last = now;
            }
            EXPECT_LT(deepest, 0.5 * radius + 0.3 * speed * step);
            EXPECT_LT(scene.deepest_in(last), 0.1 * radius);
            const Vec3 force = scene.tools.force(scene.skin, last);
            EXPECT_GT(force.y(), 0.5e-3);
            EXPECT_LT(std::abs(force.x()) + std::abs(force.z()), 0.3 * force.y());
            EXPECT_GT(scene.smallest_volume(), 0);
            const Capsule gone = across(0.1);
            for (int i = 0; i < 250; ++i) scene.go({&gone, 1}, {&gone, 1});
            EXPECT_LT(scene.off_rest(), 5e-6);
        }
}

// A tool that goes along a vessel it presses on takes it along by friction, no further without.
TEST(CapsuleContact, DragsByFriction) {
    const auto dragged = [](double friction) {
        Scene scene({.friction = friction});
        Capsule last = across(2.6e-3);
        for (int i = 0; i < 150; ++i) {
            const Capsule now =
                across(2.6e-3 - 0.6e-3 * std::min(1.0, i / 50.0), 2e-3 + 0.5e-3 * std::max(0.0, i / 50.0 - 1));
            scene.go({&now, 1}, {&last, 1});
            last = now;
        }
        const std::size_t below = (4 * 16) * 3 + 2;  // the tool, 2 mm from the cut
        return scene.tissue.nodes()[below].x() - scene.mesh.nodes[below].x();
    };
    EXPECT_GT(dragged(0.5), dragged(0) + 0.02e-3);
}

// E23: pinched flat by two jaws, let go; then nothing is stuck, nothing turned over, half a second later all is as
// before.
TEST(WallContact, LetsAPinchedVesselOpen) {
    Scene scene;
    std::array<Capsule, 2> last{across(2.6e-3), across(-2.6e-3)};
    int touched = 0;
    double least = 1;
    for (int i = 0; i < 200; ++i) {
        const double y =
            2.6e-3 - std::min(1.0, i / 150.0) * 1.65e-3;  // until less than the two walls have room between them
        const std::array now{across(y), across(-y)};
        scene.go(now, last);
        touched = std::max(touched, scene.itself.contacts());
        least = std::min(least, scene.narrowest());
        last = now;
    }
    EXPECT_GT(touched, 3);
    EXPECT_GT(least, -0.1e-3);  // a fifth of the wall
    EXPECT_LT(least, 0.1e-3);   // flat it was
    EXPECT_GT(scene.smallest_volume(), 0);
    const std::array gone{across(0.1), across(-0.1)};
    for (int i = 0; i < 250; ++i) scene.go(gone, gone);
    EXPECT_EQ(scene.itself.contacts(), 0);
    EXPECT_GT(scene.smallest_volume(), 0.99);
    EXPECT_LT(scene.off_rest(), 5e-6);
}

// Two ends 0.1 mm apart, cut against cut, one a little aside.
struct Ends {
    Mesh right = make_tube({}), left;
    Tissue a, b;
    Skin skin_a{right}, skin_b;
    WallContact contact{{}, TubeDef{}.wall};
    std::vector<Hold> holds_a, holds_b;
    std::vector<PointForce> on_a, on_b;

    Ends(double aside, const Material& material)
        : left(opposite(right, aside)), a(material, right), b(material, left), skin_b(left) {
        for (int i = static_cast<int>(right.nodes.size()) - 48; i < static_cast<int>(right.nodes.size()); ++i)
            holds_a.push_back({i, right.nodes[static_cast<std::size_t>(i)]}),
                holds_b.push_back({i, left.nodes[static_cast<std::size_t>(i)]});
    }
    static Mesh opposite(Mesh end, double aside) {
        for (Vec3& p : end.nodes) p = Vec3(-p.x() - 0.1e-3, p.y() + aside, -p.z());
        return end;
    }
    // Of a stitch that draws both ends together, at a node of the outer skin 1.5 mm from the cut [N].
    double drawn = 0;
    PointForce draws(const Mesh& end, double way) const {
        constexpr int node = 3 * 16 * 3 + 2;
        for (std::size_t t = 0;; ++t)
            for (std::size_t k = 0; k < 4; ++k)
                if (MaterialPoint at{static_cast<int>(t), {0, 0, 0, 0}}; end.tetrahedra[t][k] == node)
                    return at.weights[k] = 1, PointForce{at, way * drawn * Vec3::UnitX()};
    }
    void go(double nearer) {
        on_a.assign(1, draws(right, -1)), on_b.assign(1, draws(left, 1));
        contact.press(right, skin_a, on_a, left, skin_b, on_b);
        for (Hold& hold : holds_b) hold.target.x() += nearer;
        a.step({.holds = holds_a, .forces = on_a}, step), b.step({.holds = holds_b, .forces = on_b}, step);
        skin_a.update(a.nodes()), skin_b.update(b.nodes());
    }
    double fastest() const {
        double most = 0;
        for (const Tissue* wall : {&a, &b})
            for (const Vec3& v : wall->velocity()) most = std::max(most, v.norm());
        return most;
    }
    // Into each other by so much, in 0.2 s; from 0.5 s later on [m/s].
    double fastest_once_pressed(double by) {
        for (int s = 0; s < 100; ++s) go((by + 0.1e-3) / 100);
        for (int s = 0; s < 250; ++s) go(0);
        double most = 0;
        for (int s = 0; s < 100; ++s) go(0), most = std::max(most, fastest());
        return most;
    }
};

Material soft() {
    Material material;
    material.young = 0.2e6;
    return material;
}

// They stay apart, and push each other as much.
TEST(WallContact, KeepsTwoVesselsApart) {
    Ends ends(0.1e-3, {});
    int most = 0;
    double overlap = 0;
    for (int s = 0; s < 500; ++s) {
        ends.go(s < 100 ? 4e-6 : s < 150 ? 0 : s < 250 ? -8e-6 : 0);
        Vec3 sum = Vec3::Zero();
        for (const auto* forces : {&ends.on_a, &ends.on_b})
            for (const auto& force : *forces) sum += force.force;
        EXPECT_LE(sum.norm(), 1e-12);
        most = std::max(most, ends.contact.contacts());
        double low = 0, high = 0;  // the cuts' mean places
        for (std::size_t i = 0; i < 48; ++i) low += ends.a.nodes()[i].x() / 48, high += ends.b.nodes()[i].x() / 48;
        overlap = std::max(overlap, high - low);
    }
    EXPECT_GT(most, 10);
    EXPECT_LT(overlap, 0.05e-3);  // a tenth of the wall, pushed by 0.3 mm
    EXPECT_EQ(ends.contact.contacts(), 0);
    double off = 0;
    for (std::size_t i = 0; i < 48; ++i) off = std::max(off, (ends.a.nodes()[i] - ends.right.nodes[i]).norm());
    EXPECT_LT(off, 10e-6);
}

// Pressed on by a few tenths of a millimetre and aside by as much they lie over each other, edges on edges, and then
// rest. A node just before a cut that leans is behind the skin that ends there: taken for a touch, that pushed it by a
// tenth of a newton, and walls trembled by 0.1 m/s for ever.
TEST(WallContact, EndsThatLieOverEachOtherRest) {
    for (const double by : {0.1e-3, 0.3e-3}) {
        SCOPED_TRACE(by);
        Ends ends(by, soft());
        EXPECT_LT(ends.fastest_once_pressed(by), 1e-3);  // they creep by 0.2 mm/s yet
        EXPECT_GT(ends.contact.contacts(), 10);
    }
}

// Nor does a stitch that draws them together shake them: pushed as each triangle faces, what lay in a crease was thrown
// to and fro by 23 and 25 mm/s.
TEST(WallContact, EndsThatAStitchDrawsTogetherRest) {
    for (const double aside : {0.1e-3, 0.2e-3}) {
        SCOPED_TRACE(aside);
        Ends ends(aside, soft());
        ends.drawn = 0.05;
        EXPECT_LT(ends.fastest_once_pressed(0.05e-3), 2e-3);  // 0.4 and 0.3
        EXPECT_GT(ends.contact.contacts(), 10);
    }
}

}  // namespace
