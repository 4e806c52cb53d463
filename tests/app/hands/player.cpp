#include "tests/app/hands/player.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/hands/rate_keys.hpp"

namespace app::hands {

namespace {

std::vector<Vec3> places(std::span<const ToolInput> tools) {
    std::vector<Vec3> at;
    for (const ToolInput& tool : tools) at.push_back(tool.pose.position);
    return at;
}

Vec3 on_thread(const Seen& seen, double along) {
    std::size_t k = 1;
    while (k + 1 < seen.along.size() && seen.along[k] < along) ++k;
    const double share = (along - seen.along[k - 1]) / (seen.along[k] - seen.along[k - 1]);
    return seen.thread[k - 1] + share * (seen.thread[k] - seen.thread[k - 1]);
}

// From the last goal before the jaws opened to the one at which they shut, the tool is led by what it takes: so it
// comes at it from where the motion comes.
void aim(std::vector<Goal>& goals, std::size_t shuts, const Take& take, const Vec3& pointing) {
    constexpr double tip_beyond = 1.1e-3, comes_from = 3.5e-3;
    const auto i = static_cast<std::size_t>(take.instrument);
    const Vec3 taken = *goals[shuts].at[i] - tip_beyond * pointing;
    std::size_t first = shuts;
    while (first > 0 && !goals[first - 1].shut[i]) --first;
    if (first > 0) --first;
    for (std::size_t k = first; k <= shuts; ++k) {
        Vec3 beside = *goals[k].at[i] - taken;
        if (k + 1 < shuts) beside *= std::min(1.0, comes_from / beside.norm());
        goals[k].aims[i] = Aim{take.along, beside};
    }
}

}  // namespace

std::vector<Goal> goals_of(const scenarios::drill::Motion& motion, std::vector<Take> takes) {
    std::set<double> times;
    for (const auto& keys : motion.keys())
        for (const auto& key : keys) times.insert(key.t_s);
    std::vector<ToolInput> tools(motion.keys().size());
    std::vector<Goal> goals;
    for (const double t : times) {
        motion.at(t, tools);
        Goal goal{{}, std::vector<std::optional<Aim>>(tools.size()), {}};
        for (const ToolInput& tool : tools) goal.at.push_back(tool.pose.position);
        for (const ToolInput& tool : tools) goal.shut.push_back(tool.jaw < shut_below);
        goals.push_back(goal);
    }
    for (std::size_t k = 1; k < goals.size(); ++k)
        for (std::size_t i = 0; i < tools.size(); ++i) {
            if (takes.empty() || static_cast<int>(i) != takes.front().instrument) continue;
            if (!goals[k].shut[i] || goals[k - 1].shut[i]) continue;
            if (takes.front().along >= 0) aim(goals, k, takes.front(), tools[i].pose.rotation * Vec3::UnitZ());
            takes.erase(takes.begin());
        }
    return goals;
}

Player::Player(std::vector<Goal> goals, int mouse, int keys, const Skill& skill, unsigned seed)
    : goals_(std::move(goals)), mouse_(mouse), keys_(keys), skill_(skill), random_(seed) {}

Vec3 Player::place(const Seen& seen, int instrument) const {
    const auto i = static_cast<std::size_t>(instrument);
    const Goal& goal = goals_[next_];
    return goal.aims[i] ? Vec3(on_thread(seen, goal.aims[i]->along) + goal.aims[i]->beside)
                        : goal.at[i].value_or(from_[i]);
}

Vec3 Player::carrot(const Seen& seen, int instrument) const {
    const Vec3& from = from_[static_cast<std::size_t>(instrument)];
    return from + share_ * (place(seen, instrument) - from);
}

void Player::begin(const Seen& seen) {
    begun_ = true;
    from_ = places(seen.tools);
    share_ = 0;
    std::uniform_real_distribution<double> error(-skill_.mouse_error, skill_.mouse_error);
    beside_ = {error(random_), error(random_), 0};
    clicked_s_ = -1;
    began_s_ = rests_s_ = seen.t_s;
    notches_ = 0;
    turned_ = seen.tools[static_cast<std::size_t>(keys_)].pose.rotation;
}

bool Player::is_there(const Seen& seen) const {
    const auto off = [&](int instrument) {
        const Vec3& at = seen.tools[static_cast<std::size_t>(instrument)].pose.position;
        return goes(instrument) ? (place(seen, instrument) - at).norm() : 0;
    };
    const double error = skill_.mouse_error * seen.sight.metres_per_pixel(place(seen, mouse_));
    if (goals_[next_].pulls && pulled_) return true;
    const bool arrived =
        share_ >= 1 && off(mouse_) < skill_.mouse_near + 1.5 * error && off(keys_) < near_share() * skill_.keys_near;
    return arrived;
}

std::vector<Event> Player::play(const Seen& seen) {
    std::vector<Event> events;
    if (is_done()) return events;
    elapsed_s_ = seen.t_s - last_s_, last_s_ = seen.t_s;
    if (!begun_) begin(seen);
    if (!do_deed(seen, events)) return events;
    ++next_, begun_ = false;
    if (is_done() || goals_[next_].deed != Deed::go) stop_keys(events);
    return events;
}

bool Player::do_deed(const Seen& seen, std::vector<Event>& events) {
    switch (goals_[next_].deed) {
        case Deed::pull_both:
            return pull_both(seen, events);
        case Deed::turn_needle:
            return turn_needle(seen, events);
        case Deed::roll:
            return roll(seen, events);
        case Deed::swap:
            press(Action::swap, true, events), press(Action::swap, false, events);
            std::swap(mouse_, keys_);
            return true;
        default:
            return go(seen, events);
    }
}

bool Player::go(const Seen& seen, std::vector<Event>& events) {
    pulled_ = goals_[next_].pulls && (pulled_ || seen.tension_N > skill_.enough_N);
    press(Action::fine, goals_[next_].is_fine, events);
    if (is_there(seen)) click_jaws(seen, events);
    if (is_there(seen) && has_jaws_right(seen, mouse_) && has_jaws_right(seen, keys_) && !takes_again(seen))
        return true;
    if (pulled_)
        stop_keys(events);
    else
        lead(seen, events);
    return false;
}

// Jaws that took nothing, or a fold of the thread, open again and take it a little farther on.
bool Player::takes_again(const Seen& seen) {
    constexpr double farther = 2e-3;
    const auto i = static_cast<std::size_t>(mouse_);
    Goal& goal = goals_[next_];
    if (!goal.aims[i] || !goal.shut[i] || goals_[next_ - 1].shut[i] || seen.strands[i] == 1) return false;
    for (const std::size_t k : {next_ - 1, next_}) goals_[k].aims[i]->along += farther;
    --next_, begun_ = false;
    return true;
}

void Player::lead(const Seen& seen, std::vector<Event>& events) {
    double longest = 0, behind = 0;
    for (const int i : {mouse_, keys_}) {
        if (!goes(i)) continue;
        longest = std::max(longest, (place(seen, i) - from_[static_cast<std::size_t>(i)]).norm());
        behind = std::max(behind, (carrot(seen, i) - seen.tools[static_cast<std::size_t>(i)].pose.position).norm());
    }
    // Open jaws catch on thread: she goes slowly with these.
    const bool is_open = seen.tools[static_cast<std::size_t>(mouse_)].jaw > shut_below;
    const double careful = std::min(is_open ? 0.4 : 1, goals_[next_].care);
    if (behind < std::max(careful * skill_.lead, 1.8e-3))
        share_ = longest > 0 ? std::min(1.0, share_ + careful * skill_.speed * elapsed_s_ / longest) : 1;
    if (goes(mouse_)) lead_mouse(seen, events);
    if (goes(keys_))
        lead_keys(seen, events);
    else
        stop_keys(events);
}

bool Player::goes(int instrument) const {
    const auto i = static_cast<std::size_t>(instrument);
    return goals_[next_].at[i] || goals_[next_].aims[i];
}

// Until hands have come to rest, as far as an eye sees that.
bool Player::pull_both(const Seen& seen, std::vector<Event>& events) {
    constexpr double rests_s = 0.25, begins_s = 1, seen_to_move = 0.2e-3, patience_s = 4;
    press(Action::pull_both, true, events);
    if ((seen.tools[0].pose.position - from_[0]).norm() > seen_to_move) {
        from_[0] = seen.tools[0].pose.position;
        rests_s_ = seen.t_s;
    }
    const bool has_moved = rests_s_ > began_s_;
    if (seen.t_s < rests_s_ + (has_moved ? rests_s : begins_s) && seen.t_s < began_s_ + patience_s) return false;
    press(Action::pull_both, false, events);
    return true;
}

// Some fifteen notches a second; then she looks where it is.
bool Player::turn_needle(const Seen& seen, std::vector<Event>& events) {
    constexpr double notch_s = 0.066, looks_s = 0.4;
    if (notches_ == 0) press(Action::needle, true, events), press(Action::needle, false, events);
    const bool is_turned = notches_ * skill_.notch >= goals_[next_].turn - skill_.notch / 2;
    if (!is_turned && seen.t_s >= began_s_ + notches_ * notch_s) {
        events.push_back({Wheel{1}, seen.t_s});
        ++notches_;
    }
    if (!is_turned || seen.t_s < began_s_ + notches_ * notch_s + looks_s) return false;
    press(Action::needle, true, events), press(Action::needle, false, events);
    return true;
}

// Finely, for the key goes up a little late.
bool Player::roll(const Seen& seen, std::vector<Event>& events) {
    const Quat& now = seen.tools[static_cast<std::size_t>(keys_)].pose.rotation;
    const Quat turn = turned_.conjugate() * now;
    const bool goes_on = 2 * std::atan2(std::abs(turn.z()), std::abs(turn.w())) < goals_[next_].turn;
    for (const Action key : {Action::fine, Action::k_turn, Action::k_towards}) press(key, goes_on, events);
    return !goes_on;
}

// The hand closes a share of what it sees to be left at each report of the mouse: less than what would swing, by an
// eye and a hand that are some 60 ms late.
void Player::lead_mouse(const Seen& seen, std::vector<Event>& events) {
    constexpr double turns_after = 0.3e-3, notch = 0.5e-3, notch_s = 0.025;
    const Vec3& tool = seen.tools[static_cast<std::size_t>(mouse_)].pose.position;
    const Vec3 goal = carrot(seen, mouse_);
    const Vec3 way = seen.sight.project(goal) + beside_ - seen.sight.project(tool);
    left_ += std::min(1.0, skill_.gain * elapsed_s_) * Eigen::Vector2d(way.x(), -way.y());
    const Eigen::Vector2d whole = left_.array().round();
    if (whole.norm() > 0) events.push_back({Motion{whole.x(), whole.y()}, seen.t_s});
    left_ -= whole;
    const double deeper = (goal - seen.sight.eye).norm() - (tool - seen.sight.eye).norm();
    if (std::abs(deeper) > turns_after && seen.t_s >= wheel_s_) {
        events.push_back({Wheel{deeper > 0 ? 1.0 : -1.0}, seen.t_s});
        wheel_s_ = seen.t_s + (std::abs(deeper) > 4 * notch ? notch_s : 4 * notch_s);
    }
}

void Player::press(Action action, bool down, std::vector<Event>& events) {
    bool& is_down = down_[static_cast<std::size_t>(action)];
    if (is_down == down) return;
    is_down = down;
    events.push_back({Press{action, down}, 0});
}

void Player::stop_keys(std::vector<Event>& events) {
    for (std::size_t key = 0; key < down_.size(); ++key) press(static_cast<Action>(key), false, events);
}

constexpr std::array<std::array<Action, 2>, 3> key_pairs{
    {{Action::k_left, Action::k_right}, {Action::k_down, Action::k_up}, {Action::k_away, Action::k_towards}}};

// A key goes down where its direction lacks much, and up as soon as nearly nothing is left.
void Player::hold_keys(int axis, double lack, std::vector<Event>& events) {
    const double much = near_share() * 0.7e-3, little = near_share() * 0.2e-3;
    for (const int side : {-1, 1}) {
        const Action key = key_pairs[static_cast<std::size_t>(axis)][side > 0];
        if (side * lack > much) press(key, true, events);
        if (side * lack < little) press(key, false, events);
    }
}

// Where pictures come late a held key would go too far: she taps it for as long as the way takes, by feel (a hand of
// keys begins at 20 mm/s and gains 80 mm/s in a second), and looks.
void Player::tap_key(int axis, double lack, const Seen& seen, std::vector<Event>& events) {
    constexpr double much = 0.9e-3, slow = RateKeys::slow, longest_s = 0.3;
    constexpr double gain = (RateKeys::fast - RateKeys::slow) / RateKeys::rise_s;
    double& looked_s = looked_s_[static_cast<std::size_t>(axis)];
    if (std::abs(lack) < much || seen.t_s < looked_s) return;
    const Action key = key_pairs[static_cast<std::size_t>(axis)][lack > 0];
    const double takes_s = std::min(longest_s, (std::sqrt(slow * slow + 2 * gain * std::abs(lack)) - slow) / gain);
    events.push_back({Press{key, true}, seen.t_s});
    events.push_back({Press{key, false}, seen.t_s + takes_s});
    looked_s = seen.t_s + takes_s + skill_.looks_s;
}

void Player::lead_keys(const Seen& seen, std::vector<Event>& events) {
    const Vec3& tool = seen.tools[static_cast<std::size_t>(keys_)].pose.position;
    Eigen::Matrix3d axes;  // right, up, towards the eye
    axes << seen.sight.turned * Vec3::UnitX(), seen.sight.turned * Vec3::UnitY(), (seen.sight.eye - tool).normalized();
    const Vec3 lacks = axes.inverse() * (carrot(seen, keys_) - tool);
    for (int axis = 0; axis < 3; ++axis)
        skill_.looks_s > 0 ? tap_key(axis, lacks[axis], seen, events) : hold_keys(axis, lacks[axis], events);
}

// Far enough either way that a new click does what it is meant to.
bool Player::has_jaws_right(const Seen& seen, int instrument) const {
    constexpr double shut = 0.1, open = 0.45;
    const auto i = static_cast<std::size_t>(instrument);
    return goals_[next_].shut[i] ? seen.tools[i].jaw < shut : seen.tools[i].jaw > open;
}

// Once for a goal, and again when after a second nothing came of it.
void Player::click_jaws(const Seen& seen, std::vector<Event>& events) {
    if (clicked_s_ >= 0 && seen.t_s < clicked_s_ + 1) return;
    clicked_s_ = seen.t_s;
    for (const bool down : {true, false}) {
        if (!has_jaws_right(seen, mouse_)) events.push_back({Click{Button::left, down}, seen.t_s});
        if (!has_jaws_right(seen, keys_)) events.push_back({Press{Action::k_jaw, down}, seen.t_s});
    }
}

}  // namespace app::hands
