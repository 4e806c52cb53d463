#pragma once
#include <imgui.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace app::window {

/// How much a button wants to be pressed.
enum class Look { plain, primary, chosen };

/// What a screen's controls are made with: Dear ImGui's, each with a label by which a test or a screen reader finds it,
/// all of them reached by Tab. Main thread only.
class Ui {
  public:
    /// dump: a file that gets a line of JSON whenever labels or rectangles have changed; empty: none.
    /// Throws std::runtime_error: it cannot be written.
    explicit Ui(const std::filesystem::path& dump);

    /// Begins a frame of a screen of this name and size [pixels].
    void begin(const std::string& screen, int width, int height);
    /// Ends it and writes the dump.
    void end();
    /// Moves the focus to the next control (1) or the one before (-1).
    void move_focus(int by) { move_ = by; }
    /// Whether a control had it in the last frame.
    bool has_focus() const { return had_focus_; }
    /// Puts the focus nowhere; for a new screen.
    void forget_focus();

    /// A button; a size of 0 fits its label. `name` is what the dump calls it, where that is more than its label.
    bool button(const std::string& label, Look look = Look::plain, ImVec2 size = {}, const std::string& name = "");
    /// A button that is pressed in as long as `is_on`.
    bool choice(const std::string& label, bool is_on) { return button(label, is_on ? Look::chosen : Look::plain); }
    /// A box to tick.
    bool checkbox(const std::string& label, bool& is_on);
    /// One line of text; `label` is drawn before it.
    bool text_field(const std::string& label, std::string& text, float width, const char* hint = "");
    /// A number between two.
    bool slider(const std::string& label, double& value, double least, double most, const char* format);
    /// Notes the control that was made last.
    void note(const std::string& label, const char* kind);
    /// Notes what the screen says in words, for tests: the newest replaces the one of this name.
    void say(const std::string& name, const std::string& words) { said_[name] = words; }
    /// The same of points on the screen [pixels].
    void say(const std::string& name, double x, double y);

  private:
    struct Control {
        std::string label, kind;
        ImVec2 least, most;
        ImGuiID id;
        bool is_focused, is_whole, is_enabled;
    };
    void write();
    std::string as_json() const;

    std::ofstream dump_;
    std::string screen_, last_;
    ImVec2 size_;
    std::vector<Control> controls_;
    std::map<std::string, std::string> said_;
    ImGuiID wanted_ = 0;
    int move_ = 0;
    bool had_focus_ = false;
};

}  // namespace app::window
