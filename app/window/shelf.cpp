#include "app/window/shelf.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/play/output.hpp"
#include "app/window/texture.hpp"
#include "scenarios/drill/history_key.hpp"
#include "scenarios/session/history.hpp"
#include "scenarios/session/script.hpp"

namespace app::window {

namespace fs = std::filesystem;

fs::path shipped_drills(const fs::path& named) {
    std::error_code ignored;
    if (!named.empty() && !fs::is_directory(named, ignored))
        throw InputFault(named.string() + ": error: --drills: expected a folder of drill files");
    const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const fs::path& folder :
         {named, here.parent_path() / "scenarios/drills", here.parent_path() / "share/carrel/drills"})
        if (!folder.empty() && fs::is_directory(folder, ignored)) return folder;
    return {};
}

namespace {

std::vector<fs::path> drill_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

ShelfDrill read_drill(const fs::path& file) try {
    const auto drill = scenarios::drill::load_drill(file);
    ShelfDrill read{.file = file, .title = drill.title, .goal = drill.description};
    if (drill.motion.empty()) read.problem = "it names no motion to start from";
    read.level = 10 * static_cast<int>(drill.world.instruments.size()) + (drill.goals.empty() ? 0 : 1);
    read.key = scenarios::drill::history_key(drill);
    return read;
} catch (const std::exception& error) {
    return {.file = file, .title = file.filename().string(), .problem = error.what()};
}

std::string day_of(std::int64_t s_since_1970) {
    const std::time_t time = s_since_1970;
    char text[40];
    std::strftime(text, sizeof text, "%d %b %H:%M", std::localtime(&time));
    return text;
}

std::string words_of(const scenarios::session::Attempt& best) {
    char time[30];
    std::snprintf(time, sizeof time, "%.1f s", best.duration_s);
    return best.passed ? std::string("passed in ") + time : std::to_string(best.missed()) + " missed in " + time;
}

std::string words_of(const scenarios::session::Tally& tally) {
    std::string text = std::to_string(tally.passes) + " of " + std::to_string(tally.tries) + " passed";
    if (tally.passes_in_a_row > 1) text += ", the last " + std::to_string(tally.passes_in_a_row) + " in a row";
    return text;
}

// Attempts with help are told apart, and stand in for a best one only where there is no other.
void tell(const std::vector<scenarios::session::Attempt>& attempts, ShelfDrill& drill) {
    drill.best = drill.tries = "";
    if (attempts.empty()) return;
    const auto summary = scenarios::session::summary(attempts);
    if (summary.unassisted.best)
        drill.best = "Best: " + words_of(attempts[*summary.unassisted.best]);
    else if (summary.assisted.best)
        drill.best = "Best with assists: " + words_of(attempts[*summary.assisted.best]);
    else
        drill.best = "No attempt yet that counts";
    if (summary.unassisted.tries > 0) drill.tries = words_of(summary.unassisted) + " · ";
    if (summary.assisted.tries > 0) drill.tries += "with assists " + words_of(summary.assisted) + " · ";
    if (summary.incomparable > 0) drill.tries += std::to_string(summary.incomparable) + " too slow to count · ";
    drill.tries += "last " + day_of(summary.last_at);
}

std::vector<unsigned char> draw_start(const fs::path& file) {
    const scenarios::session::Script script(file);
    const Session session(script.drill, script.inputs(0));
    return picture_of(session, session.snapshot(""));
}

// Drawn once for each text of a drill; a drill that cannot be drawn has no picture and says why when it is played.
std::shared_ptr<draw::Image> picture_in(const fs::path& cache, const fs::path& file) try {
    const std::string text = scenarios::drill::read_text(file, 256 << 20);
    const fs::path kept = cache / ("start-" + scenarios::drill::sha256(text).substr(0, 32) + ".png");
    if (auto image = read_png(kept)) return std::make_shared<draw::Image>(std::move(*image));
    const auto png = draw_start(file);
    fs::create_directories(cache);
    const fs::path fresh = kept.string() + ".part";
    write_file(fresh, {reinterpret_cast<const char*>(png.data()), png.size()});
    fs::rename(fresh, kept);
    auto image = read_png(kept);
    return image ? std::make_shared<draw::Image>(std::move(*image)) : nullptr;
} catch (const std::exception&) {
    return nullptr;
}

}  // namespace

Shelf::Shelf(const Places& where, const Settings& settings, const fs::path& drills)
    : cache_(where.cache), recordings_(where.recordings), shipped_(shipped_drills(drills)), settings_(settings) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Shelf::~Shelf() = default;

void Shelf::look_again(const Settings& settings) {
    const std::scoped_lock lock(mutex_);
    settings_ = settings;
    is_wanted_ = true;
    changed_.notify_all();
}

std::vector<ShelfDrill> Shelf::drills() const {
    const std::scoped_lock lock(mutex_);
    return drills_;
}

bool Shelf::is_read() const {
    const std::scoped_lock lock(mutex_);
    return is_read_;
}

void Shelf::pause(bool is_paused) {
    const std::scoped_lock lock(mutex_);
    is_paused_ = is_paused;
    changed_.notify_all();
}

void Shelf::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::vector<fs::path> folders{shipped_};
        std::string who;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [&] { return is_wanted_; })) return;
            is_wanted_ = false;
            who = who_of(settings_);
            folders.insert(folders.end(), settings_.folders.begin(), settings_.folders.end());
        }
        read(folders, stop);
        read_history(who);
        draw(stop);
    }
}

void Shelf::read(const std::vector<fs::path>& folders, const std::stop_token& stop) {
    std::vector<ShelfDrill> all;
    for (const fs::path& folder : folders) {
        std::vector<ShelfDrill> in_folder;
        for (const fs::path& file : drill_files(folder)) {
            if (stop.stop_requested()) return;
            in_folder.push_back(read_drill(file));
        }
        std::stable_sort(in_folder.begin(), in_folder.end(),
                         [](const auto& a, const auto& b) { return a.level < b.level; });
        std::move(in_folder.begin(), in_folder.end(), std::back_inserter(all));
    }
    const std::scoped_lock lock(mutex_);
    for (ShelfDrill& drill : all)  // what was drawn before is shown until it is looked at again
        for (const ShelfDrill& old : drills_)
            if (old.file == drill.file) drill.image = old.image, drill.best = old.best, drill.tries = old.tries;
    drills_ = std::move(all);
    is_read_ = true;
}

void Shelf::read_history(const std::string& who) {
    const auto attempts = scenarios::session::attempts_in(recordings_ / who);
    std::vector<ShelfDrill> all = drills();
    for (ShelfDrill& drill : all) tell(scenarios::session::attempts_at(attempts, drill.key), drill);
    const std::scoped_lock lock(mutex_);
    drills_ = std::move(all);
}

bool Shelf::wait_to_draw(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    return changed_.wait(lock, stop, [&] { return !is_paused_; }) && !is_wanted_;
}

void Shelf::draw(const std::stop_token& stop) {
    const std::vector<ShelfDrill> all = drills();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].problem.empty()) continue;
        if (!wait_to_draw(stop)) return;
        auto image = picture_in(cache_, all[i].file);
        const std::scoped_lock lock(mutex_);
        drills_[i].image = std::move(image);
    }
}

}  // namespace app::window
