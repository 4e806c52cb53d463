#include "scenarios/drill/read_steps.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "scenarios/drill/names.hpp"
#include "scenarios/drill/nearest.hpp"
#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

namespace {

using world::EventKind;

// What Event::what names, by kind of event.
enum class Names { instrument, vessel, knot, nobody };

Names named_by(EventKind kind) {
    switch (kind) {
        case EventKind::pierced:
        case EventKind::through:
        case EventKind::back_in:
        case EventKind::withdrawn:
        case EventKind::drawn:
        case EventKind::torn:
        case EventKind::slipped:
            return Names::vessel;
        case EventKind::knot:
            return Names::knot;
        case EventKind::broken:
        case EventKind::pass_through:
            return Names::nobody;
        default:
            return Names::instrument;
    }
}

const std::map<std::string, Held> held_by_name{
    {"nothing", Held::nothing}, {"thread", Held::thread}, {"needle", Held::needle}, {"wall", Held::wall}};

/// Reads one step, whose place in the document is `pointer`.
class StepReader {
  public:
    StepReader(const JsonText& document, const world::WorldDef& world, std::string pointer)
        : document_(document), world_(world), pointer_(std::move(pointer)) {}

    Step read(const json& entry) const {
        Step step{entry["text"], {}, {}};
        const json& done = entry["done"];
        if (done.contains("held")) read_held(done["held"], step.done);
        if (done.contains("near")) read_near(done["near"], step.done);
        if (done.contains("event")) step.done.event = read_event(done["event"]);
        if (done.contains("knot")) step.done.knot = done["knot"] == "surgeons" ? "surgeon's" : done["knot"];
        if (done.contains("throws") && done["throws"].is_string()) step.done.notation = done["throws"];
        if (done.contains("throws") && done["throws"].is_number())
            step.done.throws = static_cast<int>(done["throws"].get<double>());
        if (done.contains("bites")) step.done.bites = read_bites(done["bites"]);
        if (entry.contains("reference_s")) step.reference_s = read_reference(entry["reference_s"]);
        return step;
    }

  private:
    [[noreturn]] void fail(const std::string& at, const std::string& what, bool at_key = false) const {
        document_.fail(pointer_ + at, what, at_key);
    }

    std::size_t instrument_named(const std::string& name, const std::string& group) const {
        const auto& all = world_.instruments;
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& tool) { return tool.name == name; });
        if (found == all.end())
            fail("/done/" + group + "/" + pointer_part(name), "no instrument has this name, expected " + names_of(all),
                 true);
        return static_cast<std::size_t>(found - all.begin());
    }

    void read_held(const json& entries, Done& done) const {
        for (const auto& [name, what] : entries.items()) {
            const HeldCondition held{instrument_named(name, "held"), held_by_name.at(what)};
            const std::string at = "/done/held/" + pointer_part(name);
            if (held.what == Held::needle && world_.needle_code.empty())
                fail(at, "the thread has no needle to hold: give it one (\"needle\"), or ask for \"thread\"");
            if (held.what == Held::wall && (world_.vessels.empty() || !world_.vessels.front().is_soft))
                fail(at, "there is no wall to hold, expected vessels and \"tissue\": \"elastic\" in effects");
            done.held.push_back(held);
        }
    }

    void read_near(const json& entries, Done& done) const {
        for (const auto& [name, entry] : entries.items()) {
            const json& mm = entry["place_mm"];
            NearCondition near{instrument_named(name, "near"), {}, entry["within_mm"].get<double>() / 1000};
            for (int i = 0; i < 3; ++i) near.place[i] = mm[static_cast<std::size_t>(i)].get<double>() / 1000;
            check_is_in_scene(near.place, "/done/near/" + pointer_part(name) + "/place_mm");
            done.near.push_back(near);
        }
    }

    // Where a tip can do anything: about thread and vessels. Metres or inches for millimetres end outside.
    void check_is_in_scene(const world::Vec3& place, const std::string& at) const {
        constexpr double room = 0.1;  // [m] more than any shipped motion takes
        Eigen::AlignedBox3d scene;
        for (const world::Vec3& corner : world_.thread.start) scene.extend(corner);
        for (const auto& vessel : world_.vessels)
            for (const double end : {-0.5, 0.5}) scene.extend(vessel.centre + end * vessel.length * vessel.axis);
        const double away = std::sqrt(scene.squaredExteriorDistance(place));
        if (away > room)
            fail(at, "is " + shown(std::round(1e3 * away)) + " mm outside of the scene, expected at most " +
                         shown(1e3 * room) + " mm from where thread and vessels begin");
    }

    EventCondition read_event(const json& entry) const {
        const EventCondition event{*world::event_kind(entry["kind"].get<std::string>()), entry.value("what", "")};
        if (event.what.empty()) return event;
        const auto expect_one_of = [&](const auto& all, const std::string& kind) {
            if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.name == event.what; }))
                fail("/done/event/what", "no " + kind + " is named \"" + event.what + "\"" +
                                             (all.empty() ? "" : ", expected " + names_of(all)));
        };
        const Names named = named_by(event.kind);
        if (named == Names::instrument) expect_one_of(world_.instruments, "instrument");
        if (named == Names::vessel) expect_one_of(world_.vessels, "vessel");
        if (named == Names::knot) fail("/done/event/what", "expected \"knot\" in \"done\" for a knot of this name");
        if (named == Names::nobody)
            fail("/done/event/what",
                 std::string("says nothing of \"") + world::words_of(event.kind).name + "\", expected no such key");
        return event;
    }

    int read_bites(const json& entry) const {
        if (world_.needle_code.empty() || world_.vessels.empty())
            fail("/done/bites", "there is no needle or no vessel to bite, expected both, or no such key");
        return static_cast<int>(entry.get<double>());
    }

    std::array<double, 2> read_reference(const json& entry) const {
        const std::array<double, 2> read{entry[0], entry[1]};
        if (!(read[0] < read[1]))
            fail("/reference_s", "expected [begin, end], found " + shown(read[0]) + " not before " + shown(read[1]));
        return read;
    }

    const JsonText& document_;
    const world::WorldDef& world_;
    std::string pointer_;
};

std::string place_of(std::size_t step) {
    return "/steps/" + std::to_string(step);
}

}  // namespace

void read_steps(const JsonText& document, const json& entries, Drill& drill) {
    double last_end = 0;
    for (const json& entry : entries) {
        const std::string pointer = place_of(drill.steps.size());
        drill.steps.push_back(StepReader(document, drill.world, pointer).read(entry));
        const auto& reference = drill.steps.back().reference_s;
        if (!reference) continue;
        if ((*reference)[0] < last_end)
            document.fail(pointer + "/reference_s", "begins before the step before ends, expected " + shown(last_end) +
                                                        " s or later, found " + shown((*reference)[0]));
        last_end = (*reference)[1];
    }
}

void check_references(const JsonText& document, const Drill& drill, std::optional<double> motion_s) {
    for (std::size_t i = 0; i < drill.steps.size(); ++i) {
        const auto& reference = drill.steps[i].reference_s;
        const std::string pointer = place_of(i) + "/reference_s";
        if (!reference) continue;
        if (!motion_s) document.fail(pointer, "are seconds of the drill's motion, expected \"motion\" in the drill");
        if ((*reference)[1] > *motion_s)
            document.fail(pointer, "ends at " + shown((*reference)[1]) + " s, after the motion, which ends at " +
                                       shown(*motion_s) + " s");
    }
}

}  // namespace scenarios::drill
