#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace app::hands {

/// What a key can ask for. M is the hand that the mouse leads, K the one that keys lead.
enum class Action {
    k_left,
    k_right,
    k_up,
    k_down,
    k_away,
    k_towards,
    k_turn,
    k_jaw,
    swap,
    instrument_1,
    instrument_2,
    instrument_3,
    instrument_4,
    instrument_5,
    fine,
    scale_down,
    scale_up,
    free_pointer,
    grasp,
    retake,
    needle,
    pull_both,
    pause,
    slower,
    faster,
    home_view,
    view_1,
    view_2,
    view_3,
    view_4,
    follow,
    guide,
    ghost,
    second_camera,
    light,
    all_keys,
    restart,
    full_screen,
    picture,
    note,
};

/// One row of the table of keys.
struct ActionRow {
    Action action;     ///< Which it is.
    const char* name;  ///< In files of keys.
    const char* key;   ///< Unless somebody maps it to another; several with a space between.
    bool of_hands;     ///< The hands do it, so it goes to them; else the window does.
    const char* help;  ///< What it does, for people.
};

/// Every action once, in the order of the enumeration.
std::span<const ActionRow> action_rows();

/// The row of one action.
const ActionRow& row_of(Action action);

/// What the mouse does, which nobody remaps: gesture and help, for the page of all keys.
struct GestureRow {
    const char* gesture;  ///< As "Right button + wheel".
    const char* help;     ///< What it does.
};

/// Every gesture of the mouse.
std::span<const GestureRow> gesture_rows();

/// Which key asks for what. A key has SDL's scancode name; "Shift" and "Ctrl" stand for either side's, and before a key
/// with "+" between for that key while they are held. No key is bound twice.
class Bindings {
  public:
    /// As action_rows() has them.
    Bindings();

    /// The action of a key, with its modifiers as "Shift+A"; none: nobody asked for it.
    std::optional<Action> action_of(const std::string& key) const;
    /// The keys of an action, at least one.
    const std::vector<std::string>& keys_of(Action action) const;
    /// Gives an action these keys instead of its own. Throws InputFault, and changes nothing: no key, an unknown key,
    /// or one that another action has; `place` is what the message begins with.
    void bind(Action action, std::vector<std::string> keys, const std::string& place = "keys");
    /// A file for load_bindings() with whatever is not as action_rows() has it.
    std::string text() const;

  private:
    friend Bindings parse_bindings(const std::string& text, const std::string& name);
    void check(const std::string& place) const;
    std::map<Action, std::vector<std::string>> keys_;
};

/// Reads {"carrel_keys": 1, "keys": {"swap": "Tab", "fine": ["V", "CapsLock"]}}; what is not named stays as it is in
/// action_rows(). Throws InputFault with file and place.
Bindings load_bindings(const std::filesystem::path& file);
/// Reads the text of such a file, which messages call `name`; the rest as load_bindings().
Bindings parse_bindings(const std::string& text, const std::string& name);

/// An action begins or ends.
struct Press {
    Action action;  ///< Which it is.
    bool down;      ///< It begins.
};

/// Turns keys into actions. An action ends with the key that began it, whatever became of modifiers and of bindings.
class Keyboard {
  public:
    /// A key that goes down or up, by SDL's scancode name; none: it asks for nothing, or only repeats.
    std::optional<Press> key(const Bindings& bindings, const std::string& name, bool down);
    /// Ends all that is held, as when the window loses the keyboard.
    std::vector<Press> let_go();

  private:
    std::map<std::string, std::optional<Action>> held_;
};

}  // namespace app::hands
