#include <charconv>
#include <iostream>

#include "app/commands/commands.hpp"
#include "app/fault.hpp"
#include "app/machine.hpp"
#include "app/play/output.hpp"
#include "app/play/recorded.hpp"
#include "app/progress.hpp"
#include "app/report/result_json.hpp"

namespace app {

namespace {

using scenarios::recording::Recording;

// The first stored hash that the re-simulation does not reproduce, or nothing.
struct Difference {
    std::uint64_t tick = 0, stored = 0, found = 0;
};

std::string in_words(const std::string& file, const Difference& difference) {
    char text[120];
    std::snprintf(text, sizeof text, ": error: tick %llu: the state differs, recorded %016llx, replayed %016llx",
                  static_cast<unsigned long long>(difference.tick), static_cast<unsigned long long>(difference.stored),
                  static_cast<unsigned long long>(difference.found));
    return file + text;
}

struct Comparison {
    std::size_t compared = 0;
    std::optional<Difference> first_difference;
};

Comparison play(Session& session, const Recording& recording, bool to_the_end) {
    Comparison comparison;
    Progress progress(static_cast<double>(recording.ticks()) * recording.head.tick_s);
    for (std::uint64_t tick = 0; tick < recording.ticks(); ++tick) {
        session.tick(recording.tick(tick));
        auto& [next, difference] = comparison;
        for (; next < recording.hashes.size() && recording.hashes[next].tick == tick + 1; ++next)
            if (!difference && recording.hashes[next].hash != session.world().hash())
                difference = {tick + 1, recording.hashes[next].hash, session.world().hash()};
        if (difference && !to_the_end) break;
        progress.at(session.world().time_s());
    }
    return comparison;
}

// A session that came to its end stored the hash of its last tick, on which all before have had their influence, and
// every one between; one that was broken off may lack its last.
bool all_hashes_are_there(const Recording& recording, std::size_t compared) {
    const auto& hashes = recording.hashes;
    const auto period = scenarios::recording::hash_period;
    if (compared < hashes.size()) return false;
    if (!recording.finished) return compared + 1 >= recording.ticks() / period;
    const bool has_last = !hashes.empty() && hashes.back().tick == recording.ticks();
    return has_last && compared >= (recording.ticks() + period - 1) / period;
}

std::string with_all_digits(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string said(const scenarios::drill::ScoreItem& item) {
    return item.name + " (" + item.title + ") " + item.value + (item.unit.empty() ? "" : " " + item.unit) +
           (item.number ? " (" + with_all_digits(*item.number) + ")" : "") + ", asked \"" + item.band + "\", " +
           (item.passed ? "passed" : "missed") + " at " + std::to_string(item.at_s) + " s, \"" + item.why + "\"";
}

// Recordings of version 1 hold no numbers.
std::vector<scenarios::drill::ScoreItem> without_numbers(std::vector<scenarios::drill::ScoreItem> items) {
    for (auto& item : items) item.number.reset();
    return items;
}

std::string said(const scenarios::world::Event& event) {
    return std::string(event.name()) + " " + event.what + " " + std::to_string(event.value) + " at " +
           std::to_string(event.t_s) + " s";
}

// The states say nothing of what was asked: without this a recording could be given another verdict or course. Of a
// session that was broken off the last of what was found need not be stored.
template <class All>
void compare(const std::string& file, const char* what, const All& stored, const All& found, bool to_the_end = true) {
    for (std::size_t i = 0; i < (to_the_end ? std::max(stored.size(), found.size()) : stored.size()); ++i) {
        const auto at = [i](const All& all) { return i < all.size() ? said(all[i]) : "nothing"; };
        const bool is_same = i < stored.size() && i < found.size() && stored[i] == found[i];
        if (!is_same)
            throw CheckFailed(file + ": error: the " + what + " differ, recorded " + at(stored) + ", replayed " +
                              at(found));
    }
}

}  // namespace

int replay_command(const ReplayOptions& options) {
    if (!options.out.empty()) expect_output(options.out, {options.recording});
    const auto [recording, drill] = load_recorded(options.recording);
    Session session(drill, recording.tick(0), processor_us);
    const bool scores_asked_for = !options.verify || !options.out.empty() || options.json;
    const auto [compared, difference] = play(session, recording, scores_asked_for);
    auto result = session.finish();
    result.machine = machine_name();
    result.finished = recording.finished;
    result.passed = result.passed && recording.finished;
    result.session = recording.head.session;
    result.is_comparable = recording.is_comparable();
    if (!options.out.empty()) write_output(options.out, session, result, {});
    if (options.json || !options.verify)
        std::cout << (options.json ? report::result_json(result) : score_table(result));
    if (const auto fault = recording.fault(options.recording)) throw InputFault(*fault);
    if (options.verify && difference) throw CheckFailed(in_words(options.recording, *difference));
    if (options.verify && !all_hashes_are_there(recording, compared))
        throw InputFault(options.recording + ": error: damaged recording, only " + std::to_string(compared) +
                         " of its state hashes belong to its " + std::to_string(recording.ticks()) + " ticks");
    if (options.verify && recording.finished)
        compare(options.recording, "scores", recording.scores,
                recording.version >= 2 ? result.items : without_numbers(result.items));
    if (options.verify && !recording.stray_numbers.empty())
        throw CheckFailed(options.recording + ": error: the measure \"" + recording.stray_numbers.front() +
                          "\" belongs to no score");
    if (options.verify) compare(options.recording, "events", recording.events, result.events, recording.finished);
    if (options.verify)
        std::cerr << options.recording << ": " << recording.ticks() << " ticks, all " << compared
                  << (recording.finished ? " stored hashes equal, and all scores and events\n"
                                         : " stored hashes equal; it was broken off there, so that no score counts\n");
    return 0;
}

}  // namespace app
