#include "app/play/picture.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/draw/scene.hpp"
#include "scenarios/session/script.hpp"

namespace {

using scenarios::drill::Drill;

std::vector<Drill> shipped_drills() {
    std::vector<Drill> drills;
    for (const auto& entry : std::filesystem::directory_iterator(CARREL_SOURCE "/scenarios/drills"))
        if (entry.path().extension() == ".json") drills.push_back(scenarios::drill::load_drill(entry.path()));
    return drills;
}

scenarios::session::Snapshot start_of(const Drill& drill) {
    const scenarios::session::Script script(drill);
    return scenarios::session::Session(drill, script.inputs(0)).snapshot("");
}

int held_ends(const scenarios::world::WorldDef& world) {
    int count = 0;
    for (const auto& vessel : world.vessels) count += vessel.start_held + vessel.end_held;
    return count;
}

}  // namespace

// Whoever sees a vessel end at its clamp sees a piece of pipe, not an operating field.
TEST(DrillPicture, EveryHeldEndGoesOnForFifteenMillimetres) {
    const auto drills = shipped_drills();
    ASSERT_GE(drills.size(), 11u);
    for (const Drill& drill : drills) {
        SCOPED_TRACE(drill.title);
        const auto snapshot = start_of(drill);
        const auto picture =
            app::picture_of(drill.world, snapshot, app::camera_of(drill.world, snapshot, 1.5), 960, 640);
        EXPECT_EQ(static_cast<int>(picture.continued.size()), held_ends(drill.world));
        for (const auto& end : picture.continued) {
            double farthest = 0;
            for (const auto& vertex : app::draw::continuation(picture, end).vertices)
                farthest = std::max(farthest, (vertex - end.centre).dot(end.outwards));
            EXPECT_GE(farthest, 15e-3);
            double inside = 0;
            for (const auto& vertex : picture.vessels[end.vessel].vertices)
                inside = std::max(inside, (vertex - end.centre).dot(end.outwards));
            EXPECT_LT(inside, 10e-6) << "it goes on from within the vessel";
        }
    }
}

// The cloth would hide what it lies above.
TEST(DrillPicture, TheDrapeLiesUnderVesselsAndHands) {
    for (const Drill& drill : shipped_drills()) {
        SCOPED_TRACE(drill.title);
        auto snapshot = start_of(drill);
        for (const double z : {0.0, -40e-3}) {
            snapshot.tools[0].pose.position = {0, 0, z};
            const auto picture = app::picture_of(drill.world, snapshot, app::draw::default_view(), 960, 640);
            ASSERT_TRUE(picture.drape);
            EXPECT_LT(*picture.drape, z - 1e-3);
            for (const auto& vessel : picture.vessels)
                for (const auto& vertex : vessel.vertices) ASSERT_LT(*picture.drape, vertex.z());
        }
    }
}
