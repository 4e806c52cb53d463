#include "app/hands/bindings.hpp"

#include <gtest/gtest.h>

#include <set>

#include "app/fault.hpp"

using namespace app::hands;

namespace {

std::string fault_of(const std::string& text) {
    try {
        parse_bindings(text, "keys.json");
    } catch (const app::InputFault& fault) {
        return fault.what();
    }
    return "";
}

}  // namespace

// A row out of the enumeration's order would give every action after it another's key.
TEST(Bindings, HaveEveryActionOnceWithKeysAndHelp) {
    std::set<std::string> names, keys;
    const Bindings bindings;
    std::size_t all = 0;
    for (const ActionRow& row : action_rows()) {
        SCOPED_TRACE(row.name);
        EXPECT_EQ(&row_of(row.action), &row);
        EXPECT_TRUE(names.insert(row.name).second);
        EXPECT_GT(std::string(row.help).size(), 3u);
        for (const std::string& key : bindings.keys_of(row.action)) {
            EXPECT_TRUE(keys.insert(key).second) << key;
            EXPECT_EQ(bindings.action_of(key), row.action) << key;
        }
        ++all;
    }
    EXPECT_EQ(all, static_cast<std::size_t>(Action::note) + 1);
}

TEST(Bindings, AFileChangesWhatItNamesAndIsWrittenAgain) {
    const Bindings bindings =
        parse_bindings(R"({"carrel_keys": 1, "keys": {"swap": "X", "fine": ["Tab", "Ctrl+Shift+Z"]}})", "keys.json");
    EXPECT_EQ(bindings.action_of("X"), Action::swap);
    EXPECT_EQ(bindings.action_of("Tab"), Action::fine);
    EXPECT_FALSE(bindings.action_of("V"));
    EXPECT_EQ(bindings.action_of("B"), Action::pull_both);
    const Bindings again = parse_bindings(bindings.text(), "again");
    for (const ActionRow& row : action_rows()) EXPECT_EQ(again.keys_of(row.action), bindings.keys_of(row.action));
}

TEST(Bindings, AFaultIsOneLineThatSaysWhatWouldBeRight) {
    EXPECT_EQ(fault_of(R"({"carrel_keys": 1, "keys": {"swap": "B"}})"),
              "keys.json: error: /keys/pull_both: 'B' is already swap, expected a key of its own");
    EXPECT_EQ(fault_of(R"({"carrel_keys": 1, "keys": {"swap": "Tabb"}})"),
              "keys.json: error: /keys/swap: unknown key 'Tabb', expected SDL's name of it, as A, 7, F3, Space, "
              "Shift+Tab");
    EXPECT_EQ(fault_of(R"({"carrel_keys": 1, "keys": {"swap": []}})"),
              "keys.json: error: /keys/swap: no key, expected at least one");
    EXPECT_EQ(fault_of(R"({"carrel_keys": 1, "keys": {"swap": 9}})"),
              "keys.json: error: /keys/swap: expected the name of a key, as \"Tab\", or a list of such");
    EXPECT_EQ(fault_of(R"({"carrel_keys": 2})"),
              "keys.json: error: /carrel_keys: expected 1, the version of this format");
    EXPECT_EQ(fault_of(R"({"carrel_keys": 1, "kyes": {}})"),
              "keys.json: error: /kyes: unknown, expected carrel_keys and keys");
    EXPECT_EQ(fault_of("keys"),
              "keys.json: error: no JSON, expected {\"carrel_keys\": 1, \"keys\": {\"swap\": \"Tab\"}}");
    EXPECT_TRUE(fault_of(R"({"carrel_keys": 1, "keys": {"swapp": "X"}})")
                    .starts_with("keys.json: error: /keys/swapp: no such action, expected one of k_left, "));
    EXPECT_THROW(load_bindings("/no/such/keys.json"), app::InputFault);
}

TEST(Bindings, ARefusedChangeLeavesThemAsTheyAre) {
    Bindings bindings;
    EXPECT_THROW(bindings.bind(Action::swap, {"B"}), app::InputFault);
    EXPECT_EQ(bindings.action_of("Tab"), Action::swap);
    bindings.bind(Action::swap, {"X"});
    EXPECT_EQ(bindings.action_of("X"), Action::swap);
}

// Shift goes down while a key is held: the hand would go on for ever if the key's end were looked up anew.
TEST(Keyboard, AnActionEndsWithTheKeyThatBeganIt) {
    Bindings bindings;
    bindings.bind(Action::note, {"Backspace"});
    bindings.bind(Action::restart, {"Shift+Backspace"});
    Keyboard keyboard;
    EXPECT_EQ(keyboard.key(bindings, "Backspace", true)->action, Action::note);
    EXPECT_FALSE(keyboard.key(bindings, "Backspace", true)) << "a key that repeats";
    EXPECT_EQ(keyboard.key(bindings, "Left Shift", true)->action, Action::k_turn);
    EXPECT_EQ(keyboard.key(bindings, "W", true)->action, Action::k_up) << "Shift+W is bound to nothing else";
    const auto end = keyboard.key(bindings, "Backspace", false);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->action, Action::note);
    EXPECT_FALSE(end->down);
    EXPECT_EQ(keyboard.key(bindings, "Backspace", true)->action, Action::restart);
    EXPECT_EQ(keyboard.let_go().size(), 3u);
    EXPECT_FALSE(keyboard.key(bindings, "W", false));
}
