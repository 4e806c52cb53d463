#include "app/report/result_json.hpp"

#include <nlohmann/json.hpp>

namespace app::report {

using json = nlohmann::ordered_json;
using scenarios::drill::Result;

namespace {

json items(const Result& result) {
    json list = json::array();
    for (const scenarios::drill::ScoreItem& item : result.items)
        list.push_back({{"name", item.name},
                        {"title", item.title},
                        {"value", item.value},
                        {"number", item.number ? json(*item.number) : json(nullptr)},
                        {"unit", item.unit},
                        {"band", item.band},
                        {"passed", item.band.empty() ? json(nullptr) : json(item.passed)},
                        {"at_s", item.at_s},
                        {"why", item.why}});
    return list;
}

json events(const Result& result) {
    json list = json::array();
    for (const scenarios::world::Event& event : result.events)
        list.push_back({{"t_s", event.t_s}, {"kind", event.name()}, {"what", event.what}, {"value", event.value}});
    return list;
}

json session(const Result& result) {
    if (!result.session) return nullptr;
    const scenarios::drill::Circumstances& session = *result.session;
    return {{"who", session.who},
            {"device", session.device},
            {"assists", session.assists},
            {"exam", session.exam},
            {"pace", session.pace},
            {"machine", session.machine},
            {"parent", session.parent},
            {"parent_tick", session.parent_tick},
            {"comparable", result.is_comparable}};
}

json thread(const Result& result) {
    return {{"links", result.links},
            {"stretch", {{"max", result.stretch_max}, {"settled", result.stretch_settled}}},
            {"separation", {{"min", result.separation_min < 1e300 ? json(result.separation_min) : json(nullptr)}}},
            {"node_step", {{"max_over_bound", result.node_step_max_over_bound}}},
            {"pass_throughs", result.pass_throughs},
            {"contacts", {{"max", result.contacts_max}}}};
}

}  // namespace

std::string result_json(const Result& result) {
    const scenarios::drill::Percentiles& tick = result.tick_us;
    const json root = {{"drill", result.drill_title},
                       {"finished", result.finished},
                       {"passed", result.passed},
                       {"items", items(result)},
                       {"knot", result.knot},
                       {"surgical", result.surgical},
                       {"throws", result.throws},
                       {"thread", thread(result)},
                       {"tick_us", {{"p50", tick.p50}, {"p99", tick.p99}, {"max", tick.max}}},
                       {"ticks", result.ticks},
                       {"substeps", result.substeps},
                       {"duration_s", result.duration_s},
                       {"state_hash", result.state_hash},
                       {"events", events(result)},
                       {"machine", result.machine},
                       {"session", session(result)}};
    // The library writes what is not finite as null: JSON has no word for it.
    return root.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace app::report
