#include "app/hands/hands.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace app::hands {

namespace {

constexpr std::array scales{0.25, 1.0 / 3, 0.5, 1.0, 2.0};
constexpr double shut_below = 0.25;  // jaws whose goal is below this count as shut, as the world has it

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
    for (const ToolInput& at : start) led_.push_back({at, at.jaw, at.jaw < shut_below ? Led().opening : at.jaw});
    const int count = static_cast<int>(start.size());
    m_ = named(instruments, settings.left_handed ? "left" : "right");
    if (m_ < 0) m_ = settings.left_handed ? 0 : count - 1;
    k_ = named(instruments, settings.left_handed ? "right" : "left");
    if (k_ < 0 || k_ == m_) k_ = count == 1 ? -1 : (m_ == 0 ? 1 : 0);
    if (settings_.is_exam) settings_.assists = {};
    settings_.toggles |= settings_.one_handed;
}

void Hands::tick(const World& world, const Taken& taken, std::span<ToolInput> inputs) {
    assert(inputs.size() == led_.size() && "an input for each instrument");
    for (const Event& event : taken.events) take(event);
    const double seconds = world.def().tick_s;
    move(seconds, taken.sight);
    move_jaws(seconds);
    for (std::size_t i = 0; i < led_.size(); ++i) inputs[i] = led_[i].at;
    publish(world);
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
    if (wheel.with_shift) {
        Led& tool = led(m_);
        tool.jaw_goal = std::clamp(tool.jaw_goal + 0.1 * wheel.notches, 0.0, 1.0);
        if (tool.jaw_goal >= shut_below) tool.opening = tool.jaw_goal;
        return;
    }
    // Fine, a notch of depth is a fifth: by a tenth of a millimetre.
    const double fine = fine_ && !m_turns_ ? 0.2 : share();
    mouse_.add_wheel(wheel.notches, m_turns_ ? Mouse::WheelTo::roll : Mouse::WheelTo::depth, fine);
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
    if (press.action == pull_both) return hold(pulls_, press.down);
    if (press.action == k_jaw) return press_jaw(k_, press.down);
    if (!press.down) return;
    if (press.action == swap) choose(k_);
    if (press.action >= instrument_1 && press.action <= instrument_5)
        choose(static_cast<int>(press.action) - static_cast<int>(instrument_1));
    if (press.action == scale_down) step_scale(-1);
    if (press.action == scale_up) step_scale(1);
    if (press.action == free_pointer) {
        free_ = !free_;
        m_turns_ = false;
        mouse_.drop();
    }
}

void Hands::take(const Switch& change) {
    if (settings_.is_exam || settings_.assists.has(change.assist) == change.on) return;
    settings_.assists.set(change.assist, change.on);
    if (mark_) mark_("assist", std::string(name_of(change.assist)) + (change.on ? " on" : " off"));
}

void Hands::take(const LetGo&) {
    keys_.let_go();
    mouse_.drop();
    fine_ = k_turns_ = m_turns_ = pulls_ = false;
}

// The one that has the instrument gets the mouse hand's in its place.
void Hands::choose(int instrument) {
    if (instrument < 0 || instrument >= static_cast<int>(led_.size()) || instrument == m_) return;
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
    Led& tool = led(instrument);
    const bool shuts = settings_.holds_jaw ? down : tool.jaw_goal >= shut_below;
    tool.jaw_goal = shuts ? 0 : tool.opening;
}

void Hands::move(double seconds, const Sight& sight) {
    Pose& mouse_tool = led(m_).at.pose;
    const Mouse::Out out = mouse_.next(seconds, settings_, sight, mouse_tool.position);
    mouse_tool = moved(mouse_tool, out.step, sight, settings_.scale);
    const Step step = keys_.next(seconds, k_turns_, share());
    if (k_ >= 0) led(k_).at.pose = moved(led(k_).at.pose, step, sight, settings_.scale);
}

// From open to shut in 0.3 s, as fingers close forceps.
void Hands::move_jaws(double seconds) {
    const double most = seconds / 0.3;
    for (Led& tool : led_)
        if (tool.at.jaw != tool.jaw_goal) tool.at.jaw += std::clamp(tool.jaw_goal - tool.at.jaw, -most, most);
}

void Hands::publish(const World&) {
    const std::scoped_lock lock(mutex_);
    view_.mouse = m_, view_.keys = k_;
    view_.is_free = free_, view_.is_fine = fine_, view_.scale = settings_.scale;
    view_.assists = settings_.assists;
    view_.pulls = pulls_, view_.turns_needle = turns_needle_;
    view_.pace = settings_.assists.has(Assist::slow_motion) ? 0.5 : 1;
    view_.jaw.resize(led_.size()), view_.closing.resize(led_.size()), view_.gap.assign(led_.size(), -1);
    for (std::size_t i = 0; i < led_.size(); ++i)
        view_.jaw[i] = led_[i].at.jaw, view_.closing[i] = led_[i].jaw_goal < led_[i].at.jaw;
    view_.stamp_s = stamp_s_;
}

HandsView Hands::view() const {
    const std::scoped_lock lock(mutex_);
    return view_;
}

}  // namespace app::hands
