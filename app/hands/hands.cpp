#include "app/hands/hands.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace app::hands {

namespace {

constexpr std::array scales{0.25, 1.0 / 3, 0.5, 1.0, 2.0};

int named(std::span<const scenarios::world::InstrumentDef> instruments, const std::string& name) {
    for (std::size_t i = 0; i < instruments.size(); ++i)
        if (instruments[i].name == name) return static_cast<int>(i);
    return -1;
}

}  // namespace

Hands::Hands(const Settings& settings, std::span<const scenarios::world::InstrumentDef> instruments,
             std::span<const ToolInput> start, Mark mark)
    : settings_(settings), mark_(std::move(mark)) {
    assert(!start.empty() && start.size() == instruments.size() && "an instrument, and a place for each");
    for (const ToolInput& at : start) {
        Helped& tool = tools_.emplace_back();
        tool.at = at, tool.jaw_goal = at.jaw;
        if (!tool.shuts()) tool.opening = at.jaw;
    }
    const int count = static_cast<int>(start.size());
    m_ = named(instruments, settings.left_handed ? "left" : "right");
    if (m_ < 0) m_ = settings.left_handed ? 0 : count - 1;
    k_ = named(instruments, settings.left_handed ? "right" : "left");
    if (k_ < 0 || k_ == m_) k_ = count == 1 ? -1 : (m_ == 0 ? 1 : 0);
    if (settings_.is_exam) settings_.assists = {};
    settings_.toggles |= settings_.one_handed;
}

void Hands::tick(const World& world, const Taken& taken, std::span<ToolInput> inputs) {
    assert(inputs.size() == tools_.size() && "an input for each instrument");
    world_ = &world, sight_ = taken.sight, seconds_ = world.def().tick_s;
    look_round();
    for (const Event& event : taken.events) take(event);
    move();
    help();
    move_jaws();
    answer(inputs);
    publish();
}

// What each jaw would take, and at first how instruments are turned in the picture.
void Hands::look_round() {
    for (int i = 0; i < static_cast<int>(tools_.size()); ++i) {
        tool(i).near.reset();
        if (tool(i).is_open()) tool(i).near = nearest_takeable(*world_, i, bite_of(tool(i).at.pose), Wrist::reach);
        if (begun_) continue;
        tool(i).wrist.keep(tool(i).at.pose.rotation, sight_);
        tool(i).steady.begin(tool(i).at.pose);
    }
    begun_ = true;
}

void Hands::take(const Event& event) {
    std::visit([&](const auto& what) { take(what); }, event.what);
    stamp_s_ = event.stamp_s;
}

void Hands::take(const Motion& motion) {
    if (!free_) mouse_.add(motion, m_turns_, share());
}

void Hands::take(const Wheel& wheel) {
    if (free_) return;
    if (pulls_) return pull_.change_speed(wheel.notches);
    if (wheel.with_shift) {
        Led& led = tool(m_);
        led.jaw_goal = std::clamp(led.jaw_goal + 0.1 * wheel.notches, 0.0, 1.0);
        if (!led.shuts()) led.opening = led.jaw_goal;
        return;
    }
    using enum Mouse::WheelTo;
    // Fine, a notch of depth is a fifth: by a tenth of a millimetre.
    if (m_turns_) return mouse_.add_wheel(wheel.notches, roll, share());
    if (turns_needle_) return mouse_.add_wheel(wheel.notches, needle, share());
    mouse_.add_wheel(wheel.notches, depth, fine_ ? 0.2 : 1);
}

void Hands::take(const Click& click) {
    if (click.button == Button::middle && click.down && settings_.one_handed) return choose(k_);
    if (free_) return;
    if (click.button == Button::left) press_jaw(m_, click.down);
    if (click.button == Button::right) hold(m_turns_, click.down);
}

// A toggle changes as its key goes down; else it is on while that is held.
void Hands::hold(bool& held, bool down) const {
    if (!settings_.toggles)
        held = down;
    else if (down)
        held = !held;
}

void Hands::take(const Press& press) {
    using enum Action;
    keys_.press(press);
    if (press.action == fine) return hold(fine_, press.down);
    if (press.action == k_turn) return hold(k_turns_, press.down);
    if (press.action == k_jaw) return press_jaw(k_, press.down);
    if (press.action == pull_both && has(Assist::pull_both) && k_ >= 0) {
        pull_.begin();
        return hold(pulls_, press.down);
    }
    if (press.down) begin(press.action);
}

void Hands::begin(Action action) {
    using enum Action;
    if (action == swap) choose(k_);
    if (action >= instrument_1 && action <= instrument_5)
        choose(static_cast<int>(action) - static_cast<int>(instrument_1));
    if (action == scale_down) step_scale(-1);
    if (action == scale_up) step_scale(1);
    if (action == needle && has(Assist::needle_wheel)) turns_needle_ = !turns_needle_;
    if (action == grasp && has(Assist::snap)) shut(tool(m_));
    if (action == retake && has(Assist::retake) && !retake_.is_at_work())
        retake_.begin(*world_, retakes_ = m_, tool(m_));
    if (action == free_pointer) {
        free_ = !free_;
        m_turns_ = false;
        mouse_.drop();
    }
}

// What an assist leaves is where the hand goes on: nothing jumps as it is switched.
void Hands::take(const Switch& change) {
    if (settings_.is_exam || has(change.assist) == change.on) return;
    settings_.assists.set(change.assist, change.on);
    if (mark_) mark_("assist", std::string(name_of(change.assist)) + (change.on ? " on" : " off"));
    if (change.assist == Assist::pull_both) pulls_ = false;
    if (change.assist == Assist::needle_wheel) turns_needle_ = false;
    for (Helped& led : tools_) {
        if (change.assist == Assist::wrist) led.wrist.keep(led.at.pose.rotation, sight_);
        if (change.assist == Assist::snap) led.waits = false;
        if (change.assist == Assist::steady && change.on) led.steady.begin(led.at.pose);
        if (change.assist == Assist::steady && !change.on) led.at.pose = led.steady.now();
    }
}

void Hands::take(const LetGo&) {
    keys_.let_go();
    mouse_.drop();
    fine_ = k_turns_ = m_turns_ = pulls_ = false;
}

// The one that has the instrument gets the mouse hand's in its place.
void Hands::choose(int instrument) {
    if (instrument < 0 || instrument >= static_cast<int>(tools_.size()) || instrument == m_) return;
    if (instrument == k_) k_ = m_;
    m_ = instrument;
    mouse_.drop();
}

void Hands::step_scale(int by) {
    const auto next = std::find(scales.begin(), scales.end(), settings_.scale);
    const auto index = next == scales.end() ? 3 : next - scales.begin();
    settings_.scale = scales[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index + by, 0, scales.size() - 1))];
}

void Hands::press_jaw(int instrument, bool down) {
    if (instrument < 0 || (!down && !settings_.holds_jaw)) return;
    Helped& led = tool(instrument);
    if (settings_.holds_jaw ? down : !led.shuts())
        shut(led);
    else
        led.jaw_goal = led.opening;
}

void Hands::shut(Helped& tool) {
    tool.jaw_goal = 0;
    if (!has(Assist::snap) || !tool.near || tool.near->distance > Snap::reach) return;
    // Jaws about a wall are to take that.
    if (tool.near->distance < distance_to_wall(*world_, bite_of(tool.at.pose))) tool.snap.begin(tool);
}

void Hands::move() {
    Helped& m = tool(m_);
    const Mouse::Out out = mouse_.next(seconds_, settings_, sight_, m.at.pose.position);
    m.at.pose = turned_about_needle(*world_, m_, moved(m.at.pose, out.step, sight_, settings_.scale), out.needle);
    m.wrist.turn(out.step, sight_);
    if (out.needle != 0) m.wrist.keep(m.at.pose.rotation, sight_);
    if (k_ < 0) return;
    if (pulls_) {
        constexpr double steps_a_second = 4;
        return pull_.change_speed(steps_a_second * seconds_ * keys_.up());
    }
    const Step step = keys_.next(seconds_, k_turns_, share());
    tool(k_).at.pose = moved(tool(k_).at.pose, step, sight_, settings_.scale);
    tool(k_).wrist.turn(step, sight_);
}

void Hands::help() {
    if (pulls_) pull_.tick(*world_, m_, k_, tool(m_), tool(k_), settings_.pull_stop_N, seconds_);
    if (retake_.is_at_work()) retake_.tick(*world_, retakes_, tool(retakes_), seconds_);
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        Helped& led = tools_[i];
        const auto& shape = world_->tools()[i].shape;
        led.snap.tick(led, shape, led.near, seconds_);
        if (has(Assist::wrist)) led.wrist.tick(led, led.near, sight_, seconds_);
    }
}

// From open to shut in 0.3 s, as fingers close forceps.
void Hands::move_jaws() {
    const double most = seconds_ / 0.3;
    for (Led& led : tools_)
        if (led.at.jaw != led.jaw_goal && !led.waits) led.at.jaw += std::clamp(led.jaw_goal - led.at.jaw, -most, most);
}

void Hands::answer(std::span<ToolInput> inputs) {
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        inputs[i] = tools_[i].at;
        if (has(Assist::steady))
            inputs[i].pose = tools_[i].steady.next(tools_[i].at.pose, seconds_, settings_.steady_s);
    }
}

void Hands::publish() {
    const std::scoped_lock lock(mutex_);
    const std::size_t count = tools_.size();
    view_.mouse = m_, view_.keys = k_;
    view_.is_free = free_, view_.is_fine = fine_, view_.scale = settings_.scale;
    view_.assists = settings_.assists;
    view_.pulls = pulls_, view_.turns_needle = turns_needle_;
    view_.pace = has(Assist::slow_motion) ? 0.5 : 1;
    view_.jaw.resize(count), view_.closing.resize(count), view_.gap.assign(count, -1);
    const double radius = world_->def().thread.diameter / 2;
    for (std::size_t i = 0; i < count; ++i) {
        const Helped& led = tools_[i];
        view_.jaw[i] = led.at.jaw, view_.closing[i] = led.shuts() && led.is_open();
        if (led.near && led.is_open()) view_.gap[i] = std::max(0.0, led.near->distance - radius);
    }
    const Helped& m = tool(m_);
    const bool is_lit = has(Assist::snap) && m.is_open() && m.near && m.near->distance <= Snap::reach;
    view_.lit = is_lit ? std::optional(m.near->at) : std::nullopt;
    view_.stamp_s = stamp_s_;
}

HandsView Hands::view() const {
    const std::scoped_lock lock(mutex_);
    return view_;
}

}  // namespace app::hands
