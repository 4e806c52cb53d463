#include "app/play/output.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "app/draw/picture.hpp"
#include "app/report/report_html.hpp"
#include "app/report/result_json.hpp"

namespace app {

namespace {

using sim::geometry::Vec3;

void write_file(const std::filesystem::path& file, std::string_view bytes) {
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

void write_png(const std::filesystem::path& file, const std::vector<unsigned char>& png) {
    write_file(file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

draw::Picture scene_picture(const Session& session, const Snapshot& snapshot) {
    draw::Picture picture;
    picture.thread = snapshot.thread;
    picture.thread_radius = session.drill().world.thread.diameter / 2;
    for (std::size_t i = 0; i < snapshot.tools.size(); ++i)
        picture.tools.push_back({session.drill().world.instruments[i].kind, snapshot.tools[i].pose, snapshot.tools[i].jaw});
    picture.vessels = session.vessels();
    return picture;
}

}  // namespace

std::vector<unsigned char> picture_of(const Session& session, const Snapshot& snapshot, bool close) {
    static draw::Canvas canvas;
    draw::Picture picture = scene_picture(session, snapshot);
    const auto& vessels = session.drill().world.vessels;
    const Vec3 middle = vessels.empty() ? Vec3::Zero() : vessels.front().centre;
    constexpr double knot_view_m = 6e-3;  // a 4 mm vessel with the knot on top of it
    picture.camera = close ? draw::close_view(middle + Vec3(0, 0, 1e-3), knot_view_m) : draw::default_view();
    return draw::encode_png(draw::render(canvas, picture));
}

void write_output(const std::filesystem::path& dir, const Session& session, const scenarios::drill::Result& result,
                  const std::vector<Snapshot>& frames) {
    std::filesystem::create_directories(dir);
    write_file(dir / "result.json", report::result_json(result));
    std::vector<report::Moment> moments;
    for (const Snapshot& snapshot : session.key_moments())
        moments.push_back({snapshot.t_s, snapshot.caption, picture_of(session, snapshot)});
    moments.push_back({session.world().time_s(), "the end, close", picture_of(session, session.key_moments().back(), true)});
    write_file(dir / "report.html", report::report_html(result, moments));
    write_png(dir / "end.png", moments[moments.size() - 2].png);
    write_png(dir / "end-close.png", moments.back().png);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        char name[40];
        std::snprintf(name, sizeof name, "frame-%04zu.png", i + 1);
        write_png(dir / name, picture_of(session, frames[i]));
    }
}

std::string score_table(const scenarios::drill::Result& result) {
    std::string text = result.drill_title + ": " + (result.passed ? "passed" : "not passed") + '\n';
    for (const auto& item : result.items) {
        char line[200];
        std::snprintf(line, sizeof line, "  %-4s %-38s %12s %-3s %-16s at %6.2f s\n",
                      item.band.empty() ? "-" : item.passed ? "ok" : "MISS", item.title.c_str(), item.value.c_str(),
                      item.unit.c_str(), item.band.c_str(), item.at_s);
        text += line;
        if (!item.why.empty()) text += "       " + item.why + '\n';
    }
    char line[300];
    std::snprintf(line, sizeof line,
                  "  thread: %d links, stretch at most %.3f %%, at rest %.3f %%, pass-throughs %llu; tick p50 %.0f us, p99 %.0f us\n",
                  result.links, 100 * result.stretch_max, 100 * result.stretch_settled,
                  static_cast<unsigned long long>(result.pass_throughs), result.tick_us.p50, result.tick_us.p99);
    return text + line;
}

}  // namespace app
