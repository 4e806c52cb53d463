#include "app/play/output.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "app/draw/picture.hpp"
#include "app/files.hpp"
#include "app/report/report_html.hpp"
#include "app/report/result_json.hpp"

namespace app {

namespace {

using sim::geometry::Vec3;

void write_png(const std::filesystem::path& file, const std::vector<unsigned char>& png) {
    write_file(file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

draw::Picture scene_picture(const Session& session, const Snapshot& snapshot) {
    draw::Picture picture;
    picture.thread = snapshot.thread;
    picture.thread_radius = session.drill().world.thread.diameter / 2;
    for (std::size_t i = 0; i < snapshot.tools.size(); ++i)
        picture.tools.push_back(
            {session.drill().world.instruments[i].kind, snapshot.tools[i].pose, snapshot.tools[i].jaw});
    picture.vessels = snapshot.vessels;
    picture.needles = snapshot.needles;
    picture.wires = snapshot.clamps;
    picture.needle_radius = session.drill().world.needle.wire;
    return picture;
}

double aspect_of(const draw::Picture& picture) {
    return static_cast<double>(picture.width) / picture.height;
}

// What must be in every picture: a hand's width of field about the vessels, and all of every hand's jaw.
std::vector<Vec3> field_of(const Session& session, const Snapshot& snapshot) {
    constexpr double across = 19e-3, along = 12e-3, margin = 2e-3;  // [m] as much to either side
    std::vector<Vec3> points;
    const auto add = [&](const Vec3& middle, double x, double y) {
        for (const double side : {-1.0, 1.0})
            for (const Vec3& off : {Vec3(x, 0, 0), Vec3(0, y, 0), Vec3(0, 0, y)}) points.push_back(middle + side * off);
    };
    const auto& world = session.drill().world;
    if (world.vessels.empty()) add(Vec3::Zero(), across, along);
    for (const auto& vessel : world.vessels) add(vessel.centre, across, along);
    for (std::size_t i = 0; i < snapshot.tools.size(); ++i) {
        if (world.instruments[i].kind == instruments::Kind::approximator) continue;  // it stands aside
        const auto& [pose, jaw] = snapshot.tools[i];
        const auto parts = instruments::parts_at(instruments::shape_of(world.instruments[i].kind), pose, jaw);
        for (const int part : {instruments::jaw_plus, instruments::jaw_minus})
            for (const Vec3& end : {parts[part].a, parts[part].b}) add(end, margin, margin);
    }
    return points;
}

// From the vessel that is looked at: unit, or zero about its middle (a quarter of what is seen), where one way to look
// is as good as another.
Vec3 outwards(const Snapshot& snapshot) {
    const auto& [centre, radius] = *snapshot.close_up;
    double nearest = std::numeric_limits<double>::infinity();
    for (const assets::Mesh& mesh : snapshot.vessels)
        for (const Vec3& vertex : mesh.vertices) nearest = std::min(nearest, (vertex - centre).norm());
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const assets::Mesh& mesh : snapshot.vessels)
        for (const Vec3& vertex : mesh.vertices)
            if ((vertex - centre).norm() < nearest + 2 * radius) sum += vertex, ++count;
    const Vec3 way = count > 0 ? Vec3(centre - sum / count) : Vec3(Vec3::Zero());
    return way.norm() > radius / 4 ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace

std::vector<unsigned char> picture_of(const Session& session, const Snapshot& snapshot) {
    static draw::Canvas canvas;
    draw::Picture picture = scene_picture(session, snapshot);
    picture.camera = snapshot.close_up
                         ? draw::close_view(snapshot.close_up->centre, snapshot.close_up->radius, outwards(snapshot))
                         : draw::view_of(field_of(session, snapshot), aspect_of(picture));
    return draw::encode_png(draw::render(canvas, picture));
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
    for (const auto& item : result.items) {
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
