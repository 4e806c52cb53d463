#include "app/window/scene_dump.hpp"

#include <nlohmann/json.hpp>

namespace app::window {

using Json = nlohmann::json;
using sim::geometry::Quat;
using sim::geometry::Vec3;

namespace {

Json json_of(const Vec3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json json_of(const Quat& q) {
    return Json::array({q.w(), q.x(), q.y(), q.z()});
}

}  // namespace

SceneDump::SceneDump(const std::filesystem::path& file) {
    if (file.empty()) return;
    file_.open(file, std::ios::trunc);
    if (!file_) throw std::runtime_error(file.string() + ": --scene-dump: cannot be written");
}

void SceneDump::write(const scenarios::session::View& view, const hands::HandsView& hands, const hands::Sight& sight) {
    if (!file_.is_open()) return;
    Json tools = Json::array(), thread = Json::array();
    for (std::size_t i = 0; i < view.tools.size(); ++i) {
        const auto& pose = view.scene.tools[i].pose;
        tools.push_back({{"at", json_of(pose.position)},
                         {"turned", json_of(pose.rotation)},
                         {"jaw", hands.jaw.size() > i ? hands.jaw[i] : view.scene.tools[i].jaw},
                         {"held", view.tools[i].held}});
    }
    for (const auto& piece : view.scene.thread)
        for (const Vec3& node : piece) thread.push_back(json_of(node));
    const Json scene = {{"t_s", view.t_s},
                        {"tools", tools},
                        {"thread", thread},
                        {"tension_N", view.tension_N},
                        {"knot", view.knot},
                        {"eye", json_of(sight.eye)},
                        {"turned", json_of(sight.turned)},
                        {"pixels", sight.pixels}};
    file_ << scene.dump() << std::endl;
}

}  // namespace app::window
