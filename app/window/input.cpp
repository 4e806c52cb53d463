#include "app/window/input.hpp"

#include "app/window/player.hpp"

namespace app::window {

namespace {

bool is_mouse(const SDL_Event& event) {
    return event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP ||
           event.type == SDL_MOUSEWHEEL;
}

std::optional<hands::Button> button_of(const SDL_Event& event) {
    switch (event.button.button) {
        case SDL_BUTTON_LEFT:
            return hands::Button::left;
        case SDL_BUTTON_RIGHT:
            return hands::Button::right;
        case SDL_BUTTON_MIDDLE:
            return hands::Button::middle;
        default:
            return {};
    }
}

}  // namespace

std::optional<hands::Press> Input::take(const SDL_Event& event, Heeds heeds, hands::Devices& devices) {
    if (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP) return take_key(event, heeds, devices);
    if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_MIDDLE) leads_camera_ = true;
    if (event.type == SDL_MOUSEBUTTONUP && event.button.button == SDL_BUTTON_MIDDLE) leads_camera_ = false;
    if (is_mouse(event) && heeds == Heeds::hands && !(leads_camera_ && event.type == SDL_MOUSEMOTION))
        take_mouse(event, devices);
    return {};
}

std::optional<hands::Press> Input::take_key(const SDL_Event& event, Heeds heeds, hands::Devices& devices) {
    if (event.key.repeat) return {};
    const char* name = SDL_GetScancodeName(event.key.keysym.scancode);
    const auto press = keyboard_.key(bindings_, name, event.type == SDL_KEYDOWN);
    if (!press) return {};
    if (!hands::row_of(press->action).of_hands) return press;
    const bool is_heeded =
        heeds == Heeds::hands || !press->down || (heeds == Heeds::free && press->action == hands::Action::free_pointer);
    if (is_heeded) post(devices, *press);
    return {};
}

void Input::take_mouse(const SDL_Event& event, hands::Devices& devices) {
    const SDL_Keymod held = SDL_GetModState();
    if (event.type == SDL_MOUSEMOTION)
        post(devices, hands::Motion{static_cast<double>(event.motion.xrel), static_cast<double>(event.motion.yrel)});
    else if (event.type == SDL_MOUSEWHEEL && !(held & KMOD_CTRL))
        post(devices, hands::Wheel{static_cast<double>(event.wheel.preciseY), (held & KMOD_SHIFT) != 0});
    else if (const auto button = button_of(event);
             button && (event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP))
        post(devices, hands::Click{*button, event.type == SDL_MOUSEBUTTONDOWN});
}

void Input::post(hands::Devices& devices, decltype(hands::Event::what) what) {
    newest_s_ = now_s();
    devices.post({what, newest_s_});
}

void Input::let_go(hands::Devices& devices) {
    keyboard_.let_go();
    devices.post({hands::LetGo{}, now_s()});
    leads_camera_ = false;
}

}  // namespace app::window
