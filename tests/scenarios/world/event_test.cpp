// What files call an event is read back as that event.
#include "scenarios/world/event.hpp"

#include <gtest/gtest.h>

#include <set>

namespace events {

using namespace scenarios::world;

// A kind added to the enumeration and not to the table, or in another place, would be written under a wrong name.
TEST(EventTable, HasEachKindOnceInItsPlaceUnderANameOfItsOwn) {
    std::set<std::string> names;
    for (std::size_t k = 0; k < event_words.size(); ++k) {
        const EventWords& words = event_words[k];
        EXPECT_EQ(static_cast<std::size_t>(words.kind), k) << words.name;
        EXPECT_TRUE(names.insert(words.name).second) << words.name;
        EXPECT_EQ(event_kind(words.name), words.kind);
        EXPECT_EQ(&words_of(words.kind), &words);
    }
    EXPECT_EQ(static_cast<std::size_t>(EventKind::wall_crossed) + 1, names.size()) << "wall_crossed is the last";
    EXPECT_EQ(event_kind("Grasp"), std::nullopt);
    EXPECT_EQ(event_kind(""), std::nullopt);
}

// Recordings and hard cases that were written earlier are read by these names.
TEST(EventTable, KeepsTheNamesOfFiles) {
    const std::pair<EventKind, std::string> known[] = {
        {EventKind::input_dropped, "input_dropped"},
        {EventKind::held_up, "held_up"},
        {EventKind::grasp, "grasp"},
        {EventKind::release, "release"},
        {EventKind::slip, "slip"},
        {EventKind::wall_grasp, "wall_grasp"},
        {EventKind::wall_release, "wall_release"},
        {EventKind::needle_grasp, "needle_grasp"},
        {EventKind::needle_release, "needle_release"},
        {EventKind::needle_bent, "needle_bent"},
        {EventKind::pierced, "pierced"},
        {EventKind::through, "through"},
        {EventKind::back_in, "back_in"},
        {EventKind::withdrawn, "withdrawn"},
        {EventKind::drawn, "drawn"},
        {EventKind::torn, "torn"},
        {EventKind::slipped, "slipped"},
        {EventKind::cut, "cut"},
        {EventKind::broken, "break"},
        {EventKind::knot, "knot"},
        {EventKind::pass_through, "pass_through"},
        {EventKind::wall_crossed, "wall_crossed"},
    };
    EXPECT_EQ(std::size(known), event_words.size());
    for (const auto& [kind, name] : known) EXPECT_EQ(words_of(kind).name, name);
}

}  // namespace events
