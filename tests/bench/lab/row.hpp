#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bench::lab {

enum class Must { be_at_most, be_at_least };

/// One figure: what was measured, and what it must be.
struct Row {
    std::string id;    ///< Unique in its suite, a-z 0-9 and '-'; scripts look for it.
    std::string what;  ///< In words, for a reader.
    double value = 0;
    std::string unit;             ///< "us", "ratio", "share", "D" (thread diameters), "count" ...
    std::optional<double> bound;  ///< None: the figure is only told.
    Must must = Must::be_at_most;
    std::optional<double> error;  ///< Spread or error of `value`, same unit, where it is known.
    double seconds = 0;           ///< Wall time that measuring took.

    bool pass() const { return !bound || (must == Must::be_at_most ? value <= *bound : value >= *bound); }
};

/// What `carrel bench SUITE` prints.
struct Suite {
    std::string name;  ///< "speed", "stability".
    std::vector<Row> rows;
};

/// How the suites report what they are at; one line each, to stderr.
using Progress = std::function<void(const std::string&)>;

}  // namespace bench::lab
