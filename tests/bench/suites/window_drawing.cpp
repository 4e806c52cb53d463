#include <stdlib.h>
#include <time.h>

#include "app/draw/canvas.hpp"
#include "app/draw/gl.hpp"
#include "app/play/picture.hpp"
#include "scenarios/session/script.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/suites/speed.hpp"
#include "tests/bench/suites/window.hpp"

namespace bench::suites {

using namespace lab;
namespace draw = app::draw;

namespace {

constexpr int width = 1280, height = 720;

/// Of all threads of this program [ms]: Mesa draws on one of its own.
double spent_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// A drill after so many seconds of its own motion.
struct Scene {
    scenarios::world::WorldDef world;
    scenarios::session::Snapshot snapshot;
};

Scene played(const std::filesystem::path& file, double seconds) {
    const scenarios::session::Script script(file);
    scenarios::session::Session session(script.drill, script.inputs(0));
    while (session.world().time_s() < seconds) session.tick(script.inputs(session.world().ticks()));
    return {script.drill.world, session.snapshot("")};
}

struct Times {
    std::vector<double> frame_ms, clear_ms;
};

// The camera goes a little on from frame to frame, so that nothing is kept from the last one.
Times drawn(const Scene& scene, draw::Level level, int frames) {
    const auto context = draw::memory_context();
    draw::Canvas canvas(*context);
    draw::Gl& gl = context->gl();
    const draw::Target target(gl, width, height, true);
    draw::Camera camera = draw::default_view();
    Times times;
    for (int i = 0; i < frames + 2; ++i) {
        camera.position.x() += 50e-6;
        const double begin = spent_ms();
        target.draw_here();
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.Finish();
        const double cleared = spent_ms();
        const auto picture = app::picture_of(scene.world, scene.snapshot, camera, width, height);
        draw::draw(canvas, picture, level, {.framebuffer = target.frame()});
        gl.Finish();
        if (i < 2) continue;  // shaders are compiled, buffers found
        times.frame_ms.push_back(spent_ms() - cleared);
        times.clear_ms.push_back(cleared - begin);
    }
    return times;
}

}  // namespace

void add_drawing(Suite& suite, const std::filesystem::path& drills, bool quick, const Progress& progress) {
    setenv("LP_NUM_THREADS", "1", 0);
    struct Drill {
        const char *id, *file;
        double seconds, bound_ms;
    };
    for (const Drill& drill : {Drill{"square-knot", "square-knot.json", 10, 35},
                               Drill{"interrupted-stitch", "interrupted-stitch.json", 2, 45}}) {
        progress(std::string("drawing ") + drill.file);
        const Scene scene = played(drills / drill.file, quick ? drill.seconds / 10 : drill.seconds);
        for (const auto level : {draw::Level::light, draw::Level::full}) {
            const bool light = level == draw::Level::light;
            const Stopwatch watch;
            const Times times = drawn(scene, level, quick ? 3 : light ? 200 : 12);
            const double median = percentile(times.frame_ms, 0.5), clear = percentile(times.clear_ms, 0.5);
            const std::string id = std::string("draw-") + (light ? "light-" : "full-") + drill.id;
            const auto add = [&](const char* figure, const char* what, double value, const char* unit) -> Row& {
                suite.rows.push_back(told(id + figure,
                                          std::string(drill.id) + (light ? ", light: " : ", full: ") + what, value,
                                          unit, watch.seconds()));
                return suite.rows.back();
            };
            Row& row = add("-ms", "processor time of a frame, median", median, "ms");
            if (light) row.bound = drill.bound_ms;
            add("-p99", "99 of 100 frames", percentile(times.frame_ms, 0.99), "ms");
            add("-ratio", "a frame over an empty clear", median / clear, "ratio");
        }
    }
}

Suite window_suite(const std::filesystem::path& drills, bool quick, const Progress& progress) {
    Suite suite{"window", {}};
    add_live(suite, drills, quick, progress);
    add_drawing(suite, drills, quick, progress);
    return suite;
}

}  // namespace bench::suites
