#include "app/window/play_screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/draw/gl.hpp"
#include "app/fault.hpp"
#include "app/files.hpp"
#include "app/play/picture.hpp"
#include "app/window/graphics.hpp"
#include "app/window/hud.hpp"
#include "app/window/keys_page.hpp"
#include "app/window/menu.hpp"
#include "app/window/parts.hpp"
#include "app/window/result_screen.hpp"
#include "app/window/shelf.hpp"
#include "app/window/theme.hpp"
#include "scenarios/session/recordings_folder.hpp"

namespace app::window {

using draw::Vec3;
using hands::Action;

bool FrameMeter::add(double now_s, std::optional<double> latency_s) {
    if (count_++ == 0 && begin_s_ == 0) begin_s_ = now_s;
    if (latency_s) sum_s_ += *latency_s, ++events_;
    if (now_s - begin_s_ < 1) return false;
    frames_ = static_cast<int>(std::lround(count_ / (now_s - begin_s_)));
    latency_ms_ = events_ > 0 ? static_cast<int>(std::lround(1e3 * sum_s_ / events_)) : -1;
    begin_s_ = now_s, sum_s_ = 0, count_ = events_ = 0;
    return true;
}

namespace {

// The second attempt that is to go to one file goes beside it.
std::filesystem::path numbered(std::filesystem::path file, int attempts) {
    if (attempts > 0)
        file.replace_filename(file.stem().string() + "-" + std::to_string(attempts + 1) + file.extension().string());
    return file;
}

std::filesystem::path recording_for(const Shell& shell, const std::filesystem::path& drill) {
    if (!shell.options.record.empty()) return numbered(shell.options.record, shell.attempts);
    const std::string who = who_of(shell.settings);
    if (const auto problem = scenarios::session::problem_with_player(who)) throw InputFault("Who plays: " + *problem);
    return scenarios::session::make_next_recording(shell.where.recordings / who, drill.stem().string());
}

hands::Settings hands_of(const Shell& shell, bool is_exam) {
    const Settings& chosen = shell.settings;
    hands::Settings settings;
    settings.holds_jaw = chosen.holds_jaw;
    settings.left_handed = chosen.left_handed;
    settings.one_handed = chosen.one_handed;
    settings.toggles = chosen.toggles;
    settings.is_exam = is_exam;
    if (!is_exam)
        settings.assists = hands::parse_assists(shell.options.assist.empty() ? chosen.assists : shell.options.assist);
    return settings;
}

PlayerOptions options_for(const Shell& shell, const std::filesystem::path& drill) {
    const bool is_exam = shell.settings.is_exam;
    return {hands_of(shell, is_exam), is_exam, shell.options.pace, shell.settings.who, recording_for(shell, drill)};
}

// The operative field, with room at the edges for what stands there.
draw::Camera home_view(const scenarios::drill::Drill& drill, const View& view, double aspect) {
    draw::Camera camera = camera_of(drill.world, view.scene, aspect);
    camera.position = camera.target + 1.15 * (camera.position - camera.target);
    return camera;
}

}  // namespace

std::unique_ptr<Screen> open_drill(Shell& shell, const std::filesystem::path& drill) try {
    return std::make_unique<PlayScreen>(shell, drill);
} catch (const std::exception& error) {
    shell.notice = error.what();
    return {};
}

PlayScreen::PlayScreen(Shell& shell, const std::filesystem::path& drill)
    : player_(std::make_unique<Player>(drill, options_for(shell, drill))),
      bindings_(load_keys(shell)),
      level_(shell.window.renderer()) {
    pace_ = asked_pace_ = player_->live().pace();
    assists_ = player_->options().hands.assists;
    ++shell.attempts;
    if (is_exam()) shown_ = {false, false, false, false, false};
}

void PlayScreen::close(Shell& shell) {
    shell.window.catch_pointer(false);
    if (!player_->is_finished()) player_->finish();
    shell.shelf.look_again(shell.settings);
}

void PlayScreen::begin(Shell&) {
    state_ = State::playing;
    player_->live().resume();
}

void PlayScreen::pause() {
    if (state_ != State::playing || is_exam()) return;
    input_.let_go(player_->devices());
    player_->live().pause();
    state_ = State::paused;
}

void PlayScreen::go_on() {
    shown_.keys = false;
    if (state_ == State::paused) player_->live().resume(), state_ = State::playing;
}

void PlayScreen::change_pace(double factor) {
    if (is_exam()) return;
    const double most = player_->live().declared_pace();
    pace_ = std::clamp(pace_ * factor, most / 8, most);
}

// Each change is a mark in the recording.
void PlayScreen::ask_pace(double pace) {
    if (is_exam() || pace == asked_pace_) return;
    asked_pace_ = pace;
    player_->live().set_pace(pace);
}

void PlayScreen::restart(Shell& shell) {
    if (is_exam()) return;
    close(shell);
    shell.next = open_drill(shell, player_->file());
    if (!shell.next) shell.next = std::make_unique<Menu>();
}

void PlayScreen::finish(Shell& shell) {
    shell.window.catch_pointer(false);
    auto result = player_->finish();
    shell.next = std::make_unique<ResultScreen>(shell, player_, std::move(result));
}

// Space and Return answer the first page; afterwards keys are the hands' and the window's.
bool PlayScreen::handle(Shell& shell, const SDL_Event& event) {
    const bool is_key = event.type == SDL_KEYDOWN && !event.key.repeat;
    if (state_ == State::before && is_key &&
        (event.key.keysym.scancode == SDL_SCANCODE_SPACE || event.key.keysym.scancode == SDL_SCANCODE_RETURN) &&
        !shown_.keys) {
        begin(shell);
        return true;
    }
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
        if (state_ == State::playing) player_->live().mark("focus", "lost");
        input_.let_go(player_->devices());
        pause();
    }
    lead_camera(event, shell);
    const bool was_caught = shell.window.pointer_is_caught();
    const auto press = input_.take(event, heeds(), player_->devices());
    // Space presses what Tab has reached before it ends a pause.
    const bool is_for_control = press && press->action == Action::pause && state_ != State::playing;
    if (is_for_control && shell.ui.has_focus()) return false;
    if (press && press->down && act(shell, press->action)) return true;
    return was_caught && event.type != SDL_QUIT && event.type != SDL_WINDOWEVENT;
}

Heeds PlayScreen::heeds() const {
    if (state_ != State::playing || shown_.keys) return Heeds::window;
    return player_->hands().is_free ? Heeds::free : Heeds::hands;
}

void PlayScreen::lead_camera(const SDL_Event& event, const Shell& shell) {
    if (!orbit_) return;
    const SDL_Keymod held = SDL_GetModState();
    if (event.type == SDL_MOUSEWHEEL && held & KMOD_CTRL) orbit_->zoom(static_cast<double>(event.wheel.preciseY));
    if (event.type != SDL_MOUSEMOTION || !input_.leads_camera()) return;
    const double right = event.motion.xrel, down = event.motion.yrel;
    if (held & KMOD_SHIFT)
        orbit_->shift(right, down, shell.window.height());
    else
        orbit_->turn(right, down);
}

// Whether the key asked for something that was done.
bool PlayScreen::act(Shell& shell, Action action) {
    const bool helps = !is_exam();
    switch (action) {
        case Action::pause:
            if (state_ == State::paused)
                go_on();
            else
                pause();
            return true;
        case Action::slower:
            return change_pace(0.5), true;
        case Action::faster:
            return change_pace(2), true;
        case Action::restart:
            return restart(shell), true;
        case Action::home_view:
            return orbit_->go_home(), true;
        case Action::view_1:
            return orbit_->look_from({0, -1, 0.25}), true;
        case Action::view_2:
            return orbit_->look_from({0, -0.12, 1}), true;
        case Action::view_3:
            return orbit_->look_from({-1, -0.1, 0.3}), true;
        case Action::view_4:
            return orbit_->look_from({1, -0.1, 0.3}), true;
        case Action::follow:
            return shown_.follow = !shown_.follow, true;
        case Action::guide:
            return shown_.guide = helps && !shown_.guide, true;
        case Action::ghost:
            return shown_.ghost = helps && !shown_.ghost, true;
        case Action::second_camera:
            return shown_.second_camera = helps && !shown_.second_camera, true;
        case Action::light:
            return level_.toggle(), true;
        case Action::full_screen:
            return shell.window.toggle_full_screen(), true;
        case Action::note:
            return player_->live().mark("note", "here"), true;
        case Action::picture:
            return wants_picture_ = true, true;
        case Action::all_keys:
            shown_.keys = !shown_.keys;
            if (shown_.keys) pause();
            return true;
        default:
            return false;
    }
}

// The frame before this one has been shown by now.
void PlayScreen::note_frame() {
    const double now = now_s();
    std::optional<double> latency;
    if (drawn_device_s_ && drawn_device_s_ != shown_device_s_) {
        latency = now - *drawn_device_s_;
        player_->live().note_shown(*latency);
        shown_device_s_ = drawn_device_s_;
    }
    if (frames_.add(now, latency)) level_.add_second(frames_.frames_per_s());
}

// What a hand did since the last frame is used by the next tick, and seen some ms later: a picture that does not wait
// for it would show it a whole frame later. A device's frame is 8 ms, and 120 views a second are published. Views that
// it passes over take their events with them, of which this screen shows none.
void PlayScreen::await_hands() {
    constexpr double most_s = 0.012;
    if (state_ != State::playing) return;
    const double until_s = now_s() + most_s;
    while (player_->live().view().device_s.value_or(0) < input_.newest_s() && now_s() < until_s) SDL_Delay(1);
}

void PlayScreen::draw(Shell& shell) {
    note_frame();
    await_hands();
    const View& view = player_->live().view();
    const hands::HandsView hands = player_->hands();
    drawn_device_s_ = view.device_s;
    ask_pace(std::min(pace_, hands.pace * player_->live().declared_pace()));
    shell.window.catch_pointer(state_ == State::playing && !hands.is_free && !shown_.keys);
    draw_scene(shell, view, hands);
    draw_panels(shell, view, hands);
    if (shown_.keys)
        draw_paused(shell);
    else if (state_ == State::before)
        draw_before(shell);
    else if (state_ == State::paused)
        draw_paused(shell);
    else if (hands.is_free)
        draw_actions(shell);
    if (player_->live().has_ended() && !shell.next) finish(shell);
}

// Depth on a flat screen: lines and shadows below the jaws, a ring at those that are about to close.
draw::Picture PlayScreen::picture_of(const View& view, const hands::HandsView& hands, int width, int height) {
    draw::Picture picture = app::picture_of(player_->drill().world, view.scene, orbit_->camera(), width, height);
    if (is_exam()) return picture;
    if (shown_.ghost && state_ != State::paused)
        picture.ghosts = ghost_.tools(player_->drill(), player_->reference(), player_->guide().step, now_s());
    if (const auto& steps = player_->drill().steps; shown_.guide && player_->guide().step < steps.size())
        for (const auto& near : steps[player_->guide().step].done.near)
            picture.helps.places.push_back({near.place, near.within});
    picture.helps.plumb = picture.helps.contact = picture.helps.strand = true;
    const auto mouse = static_cast<std::size_t>(hands.mouse);
    if (hands.mouse >= 0 && view.tools[mouse].held.empty()) picture.helps.ring_tool = hands.mouse;
    const double most = std::min(player_->drill().bands.tension_N.value_or(scenarios::drill::Band{0, 2}).high, 10.0);
    picture.helps.tension = std::clamp(view.tension_N / most, 0.0, 1.0);
    if (hands.lit) picture.helps.candidate = {*hands.lit};
    return picture;
}

void PlayScreen::draw_scene(Shell& shell, const View& view, const hands::HandsView& hands) {
    const int width = shell.window.width(), height = shell.window.height();
    if (!orbit_) orbit_.emplace(home_view(player_->drill(), view, static_cast<double>(width) / height));
    if (shown_.follow && hands.mouse >= 0)
        orbit_->look_at(view.scene.tools[static_cast<std::size_t>(hands.mouse)].pose.position);
    const draw::Picture picture = picture_of(view, hands, width, height);
    draw::draw(shell.graphics.canvas(), picture, level_.is_full() ? draw::Level::full : draw::Level::light, {});
    if (std::exchange(wants_picture_, false)) save_picture(shell, picture, view.t_s);
    const draw::Camera& camera = picture.camera;
    const auto sight = hands::look_at(camera.position, camera.target, camera.up, camera.field_of_view, height);
    player_->devices().look(sight);
    shell.scene_dump.write(view, hands, sight);
    draw_marks(shell, picture, view, hands);
}

// Beside the recording, named after its moment.
void PlayScreen::save_picture(Shell& shell, const draw::Picture& picture, double t_s) {
    char name[60];
    std::snprintf(name, sizeof name, "-at-%.1f-s.png", t_s);
    const std::filesystem::path& recording = player_->options().recording;
    const auto png = draw::encode_png(draw::render(shell.graphics.canvas(), picture));
    try {
        write_file(recording.parent_path() / (recording.stem().string() + name),
                   {reinterpret_cast<const char*>(png.data()), png.size()});
    } catch (const std::exception& error) {
        shell.notice = error.what();
    }
    shell.graphics.context().gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void PlayScreen::draw_inset(Shell& shell, const View& view) {
    if (!inset_) inset_ = std::make_unique<Inset>(shell.graphics.context(), 300, 200);
    if (const double now = now_s(); inset_->is_due(now)) {
        draw::Picture picture = app::picture_of(player_->drill().world, view.scene, orbit_->from_aside(),
                                                inset_->width(), inset_->height());
        inset_->draw(shell.graphics.canvas(), picture, now);
    }
    const float edge = 0.6f * ImGui::GetFontSize(), wide = static_cast<float>(inset_->width());
    const ImVec2 most{static_cast<float>(shell.window.width()) - edge, edge + static_cast<float>(inset_->height())};
    const ImVec2 least{most.x - wide, edge};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddImageRounded(inset_->id(), least, most, {0, 1}, {1, 0}, IM_COL32_WHITE, 8);
    list.AddRect(least, most, theme::line, 8);
    const ImFont& font = *shell.window.fonts().small;
    list.AddText(&font, font.FontSize, {least.x + 8, most.y - font.FontSize - 6}, theme::background, "from the side");
}

void PlayScreen::draw_panels(Shell& shell, const View& view, const hands::HandsView& hands) {
    if (shown_.second_camera && orbit_) draw_inset(shell, view);
    const float down =
        shown_.second_camera && inset_ ? static_cast<float>(inset_->height()) + 0.6f * ImGui::GetFontSize() : 0;
    if (shown_.guide) draw_guide(shell, player_->drill(), player_->guide());
    draw_status(shell,
                {view.t_s, player_->drill().time_limit_s, view.pace, player_->live().pace(), frames_.frames_per_s(),
                 frames_.latency_ms(), is_exam(), state_ != State::playing, player_->live().trouble()},
                down);
    const float high = draw_tools(shell, view, hands);
    draw_tension(shell, view, player_->drill(), is_wide(shell) ? 0 : high + 0.3f * ImGui::GetFontSize());
}

}  // namespace app::window
