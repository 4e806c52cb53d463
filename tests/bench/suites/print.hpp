#pragma once
#include <ostream>
#include <string>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// Where the figures come from, for whoever compares them.
struct Origin {
    std::string machine, build;
};

/// One line a row, for people.
void print_table(std::ostream& out, const lab::Suite& suite, const Origin& origin);

/// One JSON object, for programs. What is no number, or not given, is null.
void print_json(std::ostream& out, const lab::Suite& suite, const Origin& origin);

/// Ids of the rows that miss their bounds, "a, b"; empty when none does.
std::string missed(const lab::Suite& suite);

}  // namespace bench::suites
