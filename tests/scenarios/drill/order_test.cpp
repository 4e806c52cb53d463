#include "scenarios/drill/order.hpp"

#include <gtest/gtest.h>

namespace {

using namespace scenarios::drill;

ScoreItem item(const std::string& name, const std::string& value, const std::string& band, bool passed,
               const std::string& unit = "mm") {
    return {name, name, value, unit, band, passed, 0, passed ? "" : "Why."};
}

std::string order_of(const std::vector<ScoreItem>& items) {
    std::string names;
    for (const Placed& placed : by_importance(items)) names += (names.empty() ? "" : " ") + items[placed.item].name;
    return names;
}

Standing standing_of(const ScoreItem& one) {
    return by_importance({&one, 1}).front().standing;
}

}  // namespace

// A resident reads from the top: the first line is what to work on first.
TEST(Order, WhatMattersComesFirst) {
    EXPECT_EQ(order_of({item("shown", "3", "", true), item("well", "10", "at most 60", true),
                        item("edge", "58", "at most 60", true), item("edge2", "59", "at most 60", true),
                        item("a_little", "61", "at most 60", false), item("far", "120", "at most 60", false),
                        item("kind", "granny", "square", false, ""), item("well2", "5", "3 to 8", true)}),
              "kind far a_little edge2 edge well well2 shown");
}

// Half a millimetre of a band of one matters more than ten of a thousand.
TEST(Order, MissesCountInSizesOfTheirBands) {
    EXPECT_EQ(order_of({item("path", "1510", "at most 1500", false), item("bite", "2.5", "1 to 2", false),
                        item("tail", "1", "3 to 120", false), item("bites", "1", "2", false, ""),
                        item("pull", "0.01", "at least 0.1", false), item("passed_through", "1", "at most 0", false)}),
              "passed_through pull bite bites tail path");
}

TEST(Order, StandingIsCloseWithinATenthOfTheBand) {
    EXPECT_EQ(standing_of(item("a", "7.4", "3 to 8", true)), Standing::passed);
    EXPECT_EQ(standing_of(item("a", "7.6", "3 to 8", true)), Standing::close);
    EXPECT_EQ(standing_of(item("a", "3.2", "3 to 8", true)), Standing::close);
    EXPECT_EQ(standing_of(item("a", "0", "at most 6", true)), Standing::passed) << "0 is no edge";
    EXPECT_EQ(standing_of(item("a", "2", "2", true)), Standing::passed) << "as many as asked, which is no edge either";
    EXPECT_EQ(standing_of(item("a", "90", "70 to 90", true, "degrees")), Standing::passed) << "square to the wire";
    EXPECT_EQ(standing_of(item("a", "71", "70 to 90", true, "degrees")), Standing::close);
    EXPECT_EQ(standing_of(item("a", "square", "square", true)), Standing::passed);
    EXPECT_EQ(standing_of(item("a", "9", "", true)), Standing::unjudged);
    EXPECT_EQ(standing_of(item("a", "3e9", "at most x", false)), Standing::missed) << "of a file by somebody else";
}

TEST(Order, SaysByHowMuchInTheItemsUnit) {
    EXPECT_EQ(missed_by(item("a", "12.3", "at most 12", false)), "0.3 mm too much");
    EXPECT_EQ(missed_by(item("a", "1", "2", false, "")), "1 too little");
    EXPECT_EQ(missed_by(item("a", "2.75", "3 to 8", false)), "0.25 mm too little");
    EXPECT_EQ(missed_by(item("a", "granny", "square", false)), "");
    EXPECT_EQ(missed_by(item("a", "11", "at most 12", true)), "");
    EXPECT_EQ(missed_by(item("a", "120.0", "at most 120", false, "s")), "") << "ended by its limit";
}
