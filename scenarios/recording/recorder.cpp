#include <algorithm>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "scenarios/recording/format.hpp"
#include "scenarios/recording/writer.hpp"

// Whoever adds fills one batch. It is cut off when it is due and queued; a thread of its own writes what is queued, so
// that nobody waits for the disk. What could not be written stays queued and is tried again with the next batch.
namespace scenarios::recording {

namespace {

constexpr double flush_s = 0.5;  ///< Of simulated time and of wall clock; half of the second that may be lost.

// A mistyped --record must not cost somebody a file of another kind.
void make_room(const std::filesystem::path& file) {
    const auto refuse = [&](const char* what) {
        throw RecordingError(file.string() + ": error: " + what + ", expected a new file or an earlier recording");
    };
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return;
    if (!std::filesystem::is_regular_file(file, error)) refuse("is not a regular file");
    if (std::filesystem::file_size(file, error) > 0 && !is_recording(file)) refuse("holds something else");
    std::filesystem::remove(file.string() + "-journal", error);
    std::filesystem::remove(file, error);
}

std::size_t ticks_of_a_batch(double tick_s) {
    return static_cast<std::size_t>(std::clamp(flush_s / tick_s, 1.0, static_cast<double>(most_ticks)));
}

}  // namespace

double wall_clock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Recorder::Impl {
    Writer writer;  ///< Of the thread, once that runs.
    const std::string file;
    const std::size_t tools, most_inputs;
    const double tick_s;
    const Clock clock;
    const bool may_wait;

    std::mutex mutex;  ///< Of what follows.
    std::condition_variable work, written;
    Batch open;  ///< What is added goes here.
    std::deque<Batch> queue;
    std::uint64_t cut = 0, tried = 0;  ///< How many batches were queued; how many of these somebody tried to write.
    double cut_s;
    std::string trouble;
    bool ends = false;
    std::thread thread;

    Impl(const std::filesystem::path& path, const Head& head, RecorderOptions options)
        : writer(path, head),
          file(path.string()),
          tools(head.instruments.size()),
          most_inputs(ticks_of_a_batch(head.tick_s) * tools),
          tick_s(head.tick_s),
          clock(options.clock),
          may_wait(options.may_wait),
          cut_s(options.clock()),
          thread([this] { write_until_end(); }) {}

    ~Impl() {
        {
            const std::lock_guard lock(mutex);
            cut_off();
            ends = true;
        }
        work.notify_one();
        thread.join();
    }

    void cut_off() {
        cut_s = clock();
        if (open.is_empty()) return;
        queue.push_back(std::exchange(open, {}));
        ++cut;
        work.notify_one();
    }

    void cut_off_when_due() {
        if (open.inputs.size() >= most_inputs || clock() - cut_s >= flush_s) cut_off();
    }

    /// Until all that was cut off so far is on disk, or could not be written.
    void wait(std::unique_lock<std::mutex>& lock) {
        written.wait(lock, [this, until = cut] { return tried >= until; });
    }

    void write_until_end() {
        using namespace std::chrono_literals;
        std::unique_lock lock(mutex);
        while (!ends || tried < cut) {
            work.wait_for(lock, 100ms, [this] { return ends || tried < cut; });
            if (clock() - cut_s >= flush_s) cut_off();  // a tick that hangs must not keep its inputs from the disk
            if (tried < cut) write_queue(lock);
        }
    }

    void write_queue(std::unique_lock<std::mutex>& lock) {
        std::vector<Batch> batches(std::make_move_iterator(queue.begin()), std::make_move_iterator(queue.end()));
        queue.clear();
        const std::uint64_t until = cut;
        lock.unlock();
        const std::string problem = problem_in_writing(batches);
        lock.lock();
        if (!problem.empty())
            queue.insert(queue.begin(), std::make_move_iterator(batches.begin()),
                         std::make_move_iterator(batches.end()));
        trouble = problem;
        tried = until;
        written.notify_all();
    }

    std::string problem_in_writing(std::span<const Batch> batches) try {
        writer.write(batches);
        return "";
    } catch (const std::exception& error) {
        return file + ": cannot be written (" + error.what() + "); the first " +
               std::to_string(static_cast<double>(writer.saved_ticks()) * tick_s) + " s are safe on disk";
    }
};

Recorder::Recorder(const std::filesystem::path& file, const Head& head, RecorderOptions options) {
    make_room(file);
    try {
        impl_ = std::make_unique<Impl>(file, head, options);
    } catch (const DatabaseError& error) {
        throw RecordingError(file.string() + ": error: cannot be written (" + error.what() + ")");
    }
}

Recorder::~Recorder() = default;
Recorder::Recorder(Recorder&&) noexcept = default;
Recorder& Recorder::operator=(Recorder&&) noexcept = default;

// Where it may wait, one batch is filled while one is written, so that no more than these two can be lost.
void Recorder::add_tick(std::span<const instruments::ToolInput> inputs) {
    assert(inputs.size() == impl_->tools && "one input per instrument");
    std::unique_lock lock(impl_->mutex);
    if (impl_->may_wait && impl_->open.inputs.size() + inputs.size() >= impl_->most_inputs) impl_->wait(lock);
    impl_->open.inputs.insert(impl_->open.inputs.end(), inputs.begin(), inputs.end());
    impl_->cut_off_when_due();
}

void Recorder::add_hash(std::uint64_t tick, std::uint64_t hash) {
    const std::lock_guard lock(impl_->mutex);
    impl_->open.hashes.push_back({tick, hash});
}

void Recorder::add_event(const world::Event& event) {
    const std::lock_guard lock(impl_->mutex);
    impl_->open.events.push_back(event);
}

void Recorder::add_mark(const Mark& mark) {
    const std::lock_guard lock(impl_->mutex);
    impl_->open.marks.push_back(mark);
}

void Recorder::add_pace(const PaceRow& row) {
    const std::lock_guard lock(impl_->mutex);
    impl_->open.pace.push_back(row);
}

std::optional<std::string> Recorder::trouble() const {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->trouble.empty()) return {};
    return impl_->trouble;
}

void Recorder::set_scores(const std::vector<drill::ScoreItem>& items) {
    const std::lock_guard lock(impl_->mutex);
    impl_->open.scores = items;
}

void Recorder::finish() {
    std::unique_lock lock(impl_->mutex);
    impl_->open.finishes = true;
    impl_->cut_off();
    impl_->wait(lock);
    if (!impl_->trouble.empty()) throw std::runtime_error(impl_->trouble);
}

}  // namespace scenarios::recording
