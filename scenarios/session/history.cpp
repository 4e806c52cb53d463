#include "scenarios/session/history.hpp"

#include <algorithm>
#include <charconv>
#include <future>
#include <map>

#include "scenarios/recording/outline.hpp"
#include "scenarios/recording/recording.hpp"

namespace scenarios::session {

namespace {

struct Known {
    std::string key, title;
};

Known known(const recording::Outline& outline) try {
    const std::filesystem::path base = std::filesystem::path(outline.drill_name).parent_path();
    const drill::Drill drill = drill::parse_drill(outline.drill_text, outline.drill_name, base);
    return {drill::history_key(drill), drill.title};
} catch (const drill::FileError&) {  // of another version: its scores can be shown, its drill is none of ours
    return {"", outline.drill_name};
}

/// Reads attempts, and each drill once.
class Reader {
  public:
    Attempt read(const std::filesystem::path& file) {
        recording::Outline outline = recording::read_outline(file);
        auto [drill, is_new] = drills_.try_emplace(outline.drill_text);
        if (is_new) drill->second = known(outline);
        Attempt attempt{.file = file,
                        .key = drill->second.key,
                        .drill_title = drill->second.title,
                        .recorded_at = outline.recorded_at,
                        .duration_s = outline.duration_s,
                        .finished = outline.finished,
                        .exam = outline.exam,
                        .assisted = outline.assisted,
                        .comparable = outline.comparable,
                        .items = std::move(outline.scores)};
        attempt.passed = attempt.finished && !attempt.items.empty() && attempt.missed() == 0;
        return attempt;
    }

  private:
    std::map<std::string, Known> drills_;  // by text
};

// What was found in some files.
struct Found {
    std::vector<Attempt> attempts;
    std::vector<std::string> unreadable;
};

// Of a folder that nobody has looked into for long, one reader waits for the disk most of the time.
constexpr std::size_t readers = 4;

Found read_all(std::span<const std::filesystem::path> files) {
    Found found;
    Reader reader;
    for (const auto& file : files) try {
            found.attempts.push_back(reader.read(file));
        } catch (const recording::RecordingError& error) {
            found.unreadable.push_back(error.what());
        }
    return found;
}

// By name, so that what is told of them is in the same order on every disk.
std::vector<std::filesystem::path> recordings_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        std::error_code gone;
        const bool is_begun = entry.file_size(gone) > 0;  // an empty one is about to be recorded into
        if (entry.path().extension() == ".carrel" && !gone && is_begun) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void add(Tally& tally, std::span<const Attempt> attempts, std::size_t i) {
    const Attempt& attempt = attempts[i];
    if (!attempt.finished && !attempt.exam) return;
    ++tally.tries;
    tally.passes += attempt.passed;
    tally.passes_in_a_row = attempt.passed ? tally.passes_in_a_row + 1 : 0;
    if (!attempt.finished) return;
    const auto rank = [](const Attempt& of) { return std::pair(of.missed(), of.duration_s); };
    if (!tally.best || rank(attempt) < rank(attempts[*tally.best])) tally.best = i;
}

}  // namespace

std::size_t Attempt::missed() const {
    return static_cast<std::size_t>(std::count_if(items.begin(), items.end(), [](auto& item) { return !item.passed; }));
}

Attempt read_attempt(const std::filesystem::path& file) {
    return Reader().read(file);
}

std::vector<Attempt> attempts_in(const std::filesystem::path& folder, std::vector<std::string>* unreadable) {
    const std::vector<std::filesystem::path> files = recordings_in(folder);
    std::vector<std::future<Found>> parts;
    for (std::size_t k = 0; k < readers; ++k)
        parts.push_back(std::async(std::launch::async, [&, k] {
            const std::size_t begin = k * files.size() / readers, end = (k + 1) * files.size() / readers;
            return read_all(std::span(files).subspan(begin, end - begin));
        }));
    Found all;
    for (auto& part : parts) {
        Found found = part.get();
        std::ranges::move(found.attempts, std::back_inserter(all.attempts));
        if (unreadable) std::ranges::move(found.unreadable, std::back_inserter(*unreadable));
    }
    const auto order = [](const Attempt& of) { return std::tie(of.recorded_at, of.file); };
    std::sort(all.attempts.begin(), all.attempts.end(), [&](auto& a, auto& b) { return order(a) < order(b); });
    return std::move(all.attempts);
}

std::vector<Attempt> attempts_at(std::span<const Attempt> attempts, const std::string& key) {
    std::vector<Attempt> found;
    std::copy_if(attempts.begin(), attempts.end(), std::back_inserter(found),
                 [&](const Attempt& attempt) { return attempt.key == key; });
    return found;
}

Summary summary(std::span<const Attempt> attempts) {
    Summary sum;
    for (std::size_t i = 0; i < attempts.size(); ++i) {
        sum.last_at = std::max(sum.last_at, attempts[i].recorded_at);
        if (attempts[i].comparable)
            add(attempts[i].assisted ? sum.assisted : sum.unassisted, attempts, i);
        else
            ++sum.incomparable;
    }
    return sum;
}

std::vector<double> last_values(std::span<const Attempt> attempts, const std::string& item, std::size_t most) {
    std::vector<double> values;
    for (const Attempt& attempt : attempts)
        for (const drill::ScoreItem& found : attempt.items) {
            if (found.name != item) continue;
            double value = 0;
            const char* end = found.value.data() + found.value.size();
            if (std::from_chars(found.value.data(), end, value).ptr == end && !found.value.empty())
                values.push_back(value);
        }
    if (values.size() > most) values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(most));
    return values;
}

}  // namespace scenarios::session
