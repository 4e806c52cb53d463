#include "app/hands/bindings.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/fault.hpp"
#include "scenarios/drill/file.hpp"

namespace app::hands {

namespace {

using enum Action;

constexpr std::array rows{
    ActionRow{k_left, "k_left", "A", true, "key hand left; with the turning key: yaws left"},
    ActionRow{k_right, "k_right", "D", true, "key hand right; with the turning key: yaws right"},
    ActionRow{k_up, "k_up", "W", true, "key hand up; with the turning key: pitches up"},
    ActionRow{k_down, "k_down", "S", true, "key hand down; with the turning key: pitches down"},
    ActionRow{k_away, "k_away", "Q", true, "key hand away from you; with the turning key: rolls one way"},
    ActionRow{k_towards, "k_towards", "E", true, "key hand towards you; with the turning key: rolls the other way"},
    ActionRow{k_turn, "k_turn", "Shift", true, "held: the key hand turns instead of moving"},
    ActionRow{k_jaw, "k_jaw", "F", true, "key hand's jaws close and stay; again: open"},
    ActionRow{swap, "swap", "Tab", true, "mouse hand and key hand change instruments"},
    ActionRow{instrument_1, "instrument_1", "1", true, "first instrument to the mouse hand"},
    ActionRow{instrument_2, "instrument_2", "2", true, "second instrument to the mouse hand"},
    ActionRow{instrument_3, "instrument_3", "3", true, "third instrument to the mouse hand"},
    ActionRow{instrument_4, "instrument_4", "4", true, "fourth instrument to the mouse hand"},
    ActionRow{instrument_5, "instrument_5", "5", true, "fifth instrument to the mouse hand"},
    ActionRow{fine, "fine", "V CapsLock", true, "held: both hands move and turn a quarter as far"},
    ActionRow{scale_down, "scale_down", "[", true, "hands move less far: 2, 1, 1/2, 1/3, 1/4"},
    ActionRow{scale_up, "scale_up", "]", true, "hands move farther: 1/4, 1/3, 1/2, 1, 2"},
    ActionRow{free_pointer, "free_pointer", "C Escape", true, "frees the pointer; again: the mouse leads its hand"},
    ActionRow{grasp, "grasp", "G", true, "mouse hand glides to what is lit and takes it"},
    ActionRow{retake, "retake", "R", true, "mouse hand lets go and takes the strand again nearer the knot"},
    ActionRow{needle, "needle", "N", true, "the wheel turns the needle about its circle; again: no longer"},
    ActionRow{pull_both, "pull_both", "B", true, "held: both hands pull apart along the strand; wheel: how fast"},
    ActionRow{pause, "pause", "Space", false, "pauses; again: goes on"},
    ActionRow{slower, "slower", ",", false, "slower: 1, 1/2, 1/4, 1/8 of real time"},
    ActionRow{faster, "faster", ".", false, "faster: 1/8, 1/4, 1/2, 1 of real time"},
    ActionRow{home_view, "home_view", "Home", false, "the drill's own view"},
    ActionRow{view_1, "view_1", "F6", false, "view from the front"},
    ActionRow{view_2, "view_2", "F7", false, "view from above"},
    ActionRow{view_3, "view_3", "F8", false, "view from the left"},
    ActionRow{view_4, "view_4", "F9", false, "view from the right"},
    ActionRow{follow, "follow", "O", false, "the view follows the mouse hand"},
    ActionRow{guide, "guide", "H", false, "shows or hides the guide"},
    ActionRow{ghost, "ghost", "K", false, "shows or hides the ghost"},
    ActionRow{second_camera, "second_camera", "P", false, "shows or hides the second camera"},
    ActionRow{light, "light", "L", false, "light or full drawing"},
    ActionRow{all_keys, "all_keys", "F1", false, "all keys"},
    ActionRow{restart, "restart", "F5", false, "restarts the drill"},
    ActionRow{full_screen, "full_screen", "F11", false, "full screen"},
    ActionRow{picture, "picture", "F12", false, "saves a picture"},
    ActionRow{note, "note", "M", false, "leaves a note at this moment"},
};

constexpr std::array gestures{
    GestureRow{"Move", "mouse hand in the plane of the picture"},
    GestureRow{"Wheel", "mouse hand away from you, towards you"},
    GestureRow{"Left button", "mouse hand's jaws close and stay; again: open"},
    GestureRow{"Shift + wheel", "mouse hand's jaws open and close by tenths"},
    GestureRow{"Right button + move", "turns the mouse hand about its jaws"},
    GestureRow{"Right button + wheel", "rolls the mouse hand about its shaft"},
    GestureRow{"Middle button + move", "turns the view"},
    GestureRow{"Shift + middle button + move", "shifts the view"},
    GestureRow{"Ctrl + wheel", "nearer, farther"},
};

// SDL's scancode names of keys that keyboards have, but for letters, digits and F1 to F12.
constexpr std::array names{
    "Shift",  "Ctrl",     "Alt",      "CapsLock",   "Tab",      "Space",       "Return",      "Escape",   "Backspace",
    "Insert", "Delete",   "Home",     "End",        "PageUp",   "PageDown",    "Left",        "Right",    "Up",
    "Down",   "-",        "=",        "[",          "]",        "\\",          ";",           "'",        "`",
    ",",      ".",        "/",        "Keypad 0",   "Keypad 1", "Keypad 2",    "Keypad 3",    "Keypad 4", "Keypad 5",
    "#",      "Keypad 6", "Keypad 7", "Keypad 8",   "Keypad 9", "Keypad +",    "Keypad -",    "Keypad *", "Keypad /",
    "Pause",  "Keypad .", "Menu",     "ScrollLock", "Numlock",  "PrintScreen", "Keypad Enter"};

bool is_plain_key(const std::string& key) {
    if (key.size() == 1 && ((key[0] >= 'A' && key[0] <= 'Z') || (key[0] >= '0' && key[0] <= '9'))) return true;
    for (int f = 1; f <= 12; ++f)
        if (key == "F" + std::to_string(f)) return true;
    return std::find(names.begin(), names.end(), key) != names.end();
}

bool is_key(std::string key) {
    for (const std::string modifier : {"Ctrl+", "Shift+"})
        if (key.starts_with(modifier)) key.erase(0, modifier.size());
    return is_plain_key(key);
}

std::vector<std::string> keys_in(const std::string& row) {
    std::istringstream words(row);
    return {std::istream_iterator<std::string>(words), {}};
}

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
    throw InputFault(place + ": " + what);
}

const ActionRow& row_named(const std::string& name, const std::string& place) {
    for (const ActionRow& row : rows)
        if (name == row.name) return row;
    std::string known;
    for (const ActionRow& row : rows) known += (known.empty() ? "" : ", ") + std::string(row.name);
    refuse(place, "no such action, expected one of " + known);
}

std::vector<std::string> keys_of_json(const nlohmann::json& value, const std::string& place) {
    std::vector<std::string> keys;
    for (const auto& key : value.is_array() ? value : nlohmann::json::array({value})) {
        if (!key.is_string()) refuse(place, "expected the name of a key, as \"Tab\", or a list of such");
        keys.push_back(key.get<std::string>());
    }
    return keys;
}

nlohmann::json parse(const std::string& text, const std::string& name) try {
    return nlohmann::json::parse(text);
} catch (const nlohmann::json::exception&) {
    refuse(name + ": error", "no JSON, expected {\"carrel_keys\": 1, \"keys\": {\"swap\": \"Tab\"}}");
}

std::string without_side(const std::string& key) {
    for (const std::string modifier : {"Shift", "Ctrl", "Alt"})
        if (key == "Left " + modifier || key == "Right " + modifier) return modifier;
    return key;
}

}  // namespace

std::span<const ActionRow> action_rows() {
    return rows;
}

const ActionRow& row_of(Action action) {
    return rows[static_cast<std::size_t>(action)];
}

std::span<const GestureRow> gesture_rows() {
    return gestures;
}

Bindings::Bindings() {
    for (const ActionRow& row : rows) keys_[row.action] = keys_in(row.key);
}

std::optional<Action> Bindings::action_of(const std::string& key) const {
    for (const auto& [action, keys] : keys_)
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) return action;
    return {};
}

const std::vector<std::string>& Bindings::keys_of(Action action) const {
    return keys_.at(action);
}

void Bindings::check(const std::string& place) const {
    std::map<std::string, Action> owner;
    for (const auto& [action, keys] : keys_) {
        const std::string at = place + "/" + row_of(action).name;
        if (keys.empty()) refuse(at, "no key, expected at least one");
        for (const std::string& key : keys) {
            if (!is_key(key))
                refuse(at, "unknown key '" + key + "', expected SDL's name of it, as A, 7, F3, Space, Shift+Tab");
            if (const auto [at_key, is_new] = owner.insert({key, action}); !is_new)
                refuse(at, "'" + key + "' is already " + row_of(at_key->second).name + ", expected a key of its own");
        }
    }
}

void Bindings::bind(Action action, std::vector<std::string> keys, const std::string& place) {
    Bindings next = *this;
    next.keys_[action] = std::move(keys);
    next.check(place);
    *this = std::move(next);
}

std::string Bindings::text() const {
    nlohmann::json file = {{"carrel_keys", 1}, {"keys", nlohmann::json::object()}};
    for (const ActionRow& row : rows)
        if (const auto& keys = keys_of(row.action); keys != keys_in(row.key)) file["keys"][row.name] = keys;
    return file.dump(2) + "\n";
}

Bindings parse_bindings(const std::string& text, const std::string& name) {
    const nlohmann::json file = parse(text, name);
    const std::string place = name + ": error: ";
    if (!file.is_object() || file.value("carrel_keys", nlohmann::json()) != 1)
        refuse(place + "/carrel_keys", "expected 1, the version of this format");
    for (const auto& [key, value] : file.items())
        if (key != "carrel_keys" && key != "keys") refuse(place + "/" + key, "unknown, expected carrel_keys and keys");
    Bindings bindings;
    const nlohmann::json keys = file.value("keys", nlohmann::json::object());
    if (!keys.is_object()) refuse(place + "/keys", "expected an object, as {\"swap\": \"Tab\"}");
    for (const auto& [action, value] : keys.items()) {
        const std::string at = place + "/keys/" + action;
        bindings.keys_[row_named(action, at).action] = keys_of_json(value, at);
    }
    bindings.check(place + "/keys");
    return bindings;
}

Bindings load_bindings(const std::filesystem::path& file) try {
    constexpr std::size_t most_bytes = 1 << 20;
    return parse_bindings(scenarios::drill::without_mark(scenarios::drill::read_text(file, most_bytes)), file.string());
} catch (const scenarios::drill::FileError& error) {
    throw InputFault(error.what());
}

std::optional<Press> Keyboard::key(const Bindings& bindings, const std::string& name, bool down) {
    const std::string plain = without_side(name);
    if (!down) {
        const auto held = held_.extract(plain);
        if (!held || !held.mapped()) return {};
        return Press{*held.mapped(), false};
    }
    if (held_.contains(plain)) return {};
    std::optional<Action> action;
    if (held_.contains("Ctrl")) action = bindings.action_of("Ctrl+" + plain);
    if (!action && held_.contains("Shift")) action = bindings.action_of("Shift+" + plain);
    if (!action) action = bindings.action_of(plain);
    held_[plain] = action;
    if (!action) return {};
    return Press{*action, true};
}

std::vector<Press> Keyboard::let_go() {
    std::vector<Press> ended;
    for (const auto& [key, action] : std::exchange(held_, {}))
        if (action) ended.push_back({*action, false});
    return ended;
}

}  // namespace app::hands
