#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace scenarios::world {

/// What can happen in a scene that is worth a line in a recording or a report; event_words says what each means.
enum class EventKind {
    input_dropped,   ///< A device's or a file's pose was unusable.
    held_up,         ///< A tool fell behind its hand.
    grasp,           ///< Jaws closed on thread.
    release,         ///< Jaws let thread go.
    slip,            ///< Thread slides between jaws.
    wall_grasp,      ///< Jaws closed on a vessel.
    wall_release,    ///< Jaws let a vessel go.
    needle_grasp,    ///< Jaws closed on a needle.
    needle_release,  ///< Jaws let a needle go.
    needle_bent,     ///< Walls pushed a needle harder than its wire bears.
    pierced,         ///< A needle's tip went into a wall.
    through,         ///< A needle's tip came out of a wall.
    back_in,         ///< A needle goes back, its tip in the wall again.
    withdrawn,       ///< A needle left a wall as it came.
    drawn,           ///< A whole needle is through a wall.
    torn,            ///< A bite tore out of its wall.
    slipped,         ///< A needle's tip slipped off an edge.
    cut,             ///< Blades cut thread.
    broken,          ///< Thread broke.
    knot,            ///< The knot took another name.
    pass_through,    ///< Thread passed through something: a fault of the simulation.
    wall_crossed,    ///< A tool was led through a wall that gave way.
};

/// A kind of event in words.
struct EventWords {
    EventKind kind;       ///< Which it is.
    const char* name;     ///< In recordings, in result.json and in hard cases.
    const char* unit;     ///< Of Event::value; empty where the value says nothing.
    const char* meaning;  ///< What happened, what Event::what names and what the value is.
};

/// Every kind once, in the order of the enumeration.
inline constexpr std::array event_words{
    EventWords{EventKind::input_dropped, "input_dropped", "", "an instrument's input was no usable pose; it stayed"},
    EventWords{EventKind::held_up, "held_up", "mm", "an instrument fell behind its hand, by whom; how far behind"},
    EventWords{EventKind::grasp, "grasp", "mm", "an instrument's jaws closed on thread; how far along the thread"},
    EventWords{EventKind::release, "release", "", "an instrument let a strand of thread go, or lost it"},
    EventWords{EventKind::slip, "slip", "N", "thread began to slide between an instrument's jaws; their grip"},
    EventWords{EventKind::wall_grasp, "wall_grasp", "points", "an instrument's jaws closed on a vessel; points held"},
    EventWords{EventKind::wall_release, "wall_release", "", "an instrument let vessels go"},
    EventWords{EventKind::needle_grasp, "needle_grasp", "mm", "an instrument took a needle; how far from its tail"},
    EventWords{EventKind::needle_release, "needle_release", "", "an instrument let a needle go"},
    EventWords{EventKind::needle_bent, "needle_bent", "N", "walls bent the needle in an instrument; their force"},
    EventWords{EventKind::pierced, "pierced", "N", "a needle went into a vessel's wall; the force that it took"},
    EventWords{EventKind::through, "through", "N", "a needle came out of a vessel's wall; the force that it took"},
    EventWords{EventKind::back_in, "back_in", "", "a needle went back until its tip was in a vessel's wall again"},
    EventWords{EventKind::withdrawn, "withdrawn", "", "a needle left a vessel's wall the way it came"},
    EventWords{EventKind::drawn, "drawn", "", "all of a needle is through a vessel's wall"},
    EventWords{EventKind::torn, "torn", "N", "a bite tore out of a vessel's wall; the pull that tore it"},
    EventWords{EventKind::slipped, "slipped", "N", "a needle's tip slipped off a vessel's edge; what it pressed with"},
    EventWords{EventKind::cut, "cut", "mm", "an instrument's blades cut the thread; how far along the thread"},
    EventWords{EventKind::broken, "break", "mm", "the thread broke, at what pull; how far along the thread"},
    EventWords{EventKind::knot, "knot", "", "the thread's knot took this name"},
    EventWords{EventKind::pass_through, "pass_through", "times", "the thread passed through something; how often"},
    EventWords{EventKind::wall_crossed, "wall_crossed", "", "an instrument was led through a vessel's wall"},
};

/// The words of one kind.
constexpr const EventWords& words_of(EventKind kind) {
    return event_words[static_cast<std::size_t>(kind)];
}

/// The kind of this name; none where no kind has it.
inline std::optional<EventKind> event_kind(std::string_view name) {
    for (const EventWords& words : event_words)
        if (words.name == name) return words.kind;
    return {};
}

/// One moment worth telling.
struct Event {
    double t_s;        ///< When, since the scene began [s].
    EventKind kind;    ///< What happened.
    std::string what;  ///< To whom or by whom, such as "right", a vessel's name, a knot's name or "right by left".
    double value = 0;  ///< In the unit of words_of(kind).

    bool operator==(const Event&) const = default;            ///< Bit for bit, but for the sign of zero.
    const char* name() const { return words_of(kind).name; }  ///< As in files.
};

}  // namespace scenarios::world
