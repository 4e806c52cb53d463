#include "app/play/output.hpp"

#include <algorithm>
#include <cstdio>

#include "app/draw/canvas.hpp"
#include "app/files.hpp"
#include "app/play/picture.hpp"
#include "app/report/report_html.hpp"
#include "app/report/result_json.hpp"
#include "scenarios/drill/order.hpp"

namespace app {

namespace {

void write_png(const std::filesystem::path& file, const std::vector<unsigned char>& png) {
    write_file(file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace

std::vector<unsigned char> picture_of(const Session& session, const Snapshot& snapshot) {
    static thread_local draw::Canvas canvas;  // a window draws menu and report on threads of their own
    constexpr int width = 960, height = 640;
    const auto& world = session.drill().world;
    const draw::Camera camera = camera_of(world, snapshot, static_cast<double>(width) / height);
    return draw::encode_png(draw::render(canvas, picture_of(world, snapshot, camera, width, height)));
}

void expect_output(const std::filesystem::path& dir, std::initializer_list<std::filesystem::path> others) {
    make_folder("--out", dir);
    for (const char* name : {"result.json", "report.html", "end.png", "end-close.png"})
        expect_writable("--out", dir / name, others);
}

static std::string frame_name(std::size_t i) {
    char name[40];
    std::snprintf(name, sizeof name, "frame-%04zu.png", i + 1);
    return name;
}

// What an earlier run left and this one does not draw would be taken for its own.
void write_output(const std::filesystem::path& dir, const Session& session, const scenarios::drill::Result& result,
                  const std::vector<Snapshot>& frames) {
    write_file(dir / "result.json", report::result_json(result));
    std::vector<report::Moment> moments;
    for (const Snapshot& snapshot : session.key_moments())
        moments.push_back({snapshot.t_s, snapshot.caption, picture_of(session, snapshot)});
    write_file(dir / "report.html", report::report_html(result, moments));
    const std::size_t close =
        session.key_moments().back().close_up ? 1 : 0;  // what is seen from near follows the field
    write_png(dir / "end.png", moments[moments.size() - 1 - close].png);
    if (close)
        write_png(dir / "end-close.png", moments.back().png);
    else
        std::filesystem::remove(dir / "end-close.png");
    for (std::size_t i = 0; i < frames.size(); ++i) write_png(dir / frame_name(i), picture_of(session, frames[i]));
    for (std::size_t i = frames.size(); std::filesystem::remove(dir / frame_name(i)); ++i) {
    }
}

std::string score_table(const scenarios::drill::Result& result) {
    std::string text = result.drill_title + ": " +
                       (!result.finished ? "broken off, not finished"
                        : result.passed  ? "passed"
                                         : "not passed") +
                       '\n';
    for (const auto& placed : scenarios::drill::by_importance(result.items)) {
        const auto& item = result.items[placed.item];
        char line[200];
        std::snprintf(line, sizeof line, "  %-4s %-38s %12s %-3s %-16s at %6.2f s\n",
                      item.band.empty() ? "-"
                      : item.passed     ? "ok"
                                        : "MISS",
                      item.title.c_str(), item.value.c_str(), item.unit.c_str(), item.band.c_str(), item.at_s);
        text += line;
        if (!item.why.empty()) text += "       " + item.why + '\n';
    }
    char line[300];
    std::snprintf(line, sizeof line,
                  "  thread: %d links, stretch at most %.3f %%, at rest %.3f %%, pass-throughs %llu; tick p50 %.0f us, "
                  "p99 %.0f us\n",
                  result.links, 100 * result.stretch_max, 100 * result.stretch_settled,
                  static_cast<unsigned long long>(result.pass_throughs), result.tick_us.p50, result.tick_us.p99);
    return text + line;
}

}  // namespace app
