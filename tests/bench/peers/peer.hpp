#pragma once
#include <optional>
#include <string>

#include "tests/bench/lab/pull.hpp"

namespace bench::peers {

/// Another simulator's rope, pulled by a program of its own that is built with the tests.
class Peer {
  public:
    /// `name`: "ode" or "bullet".
    explicit Peer(const std::string& name);

    /// Whether its program was built.
    bool there() const;
    /// Throws std::runtime_error when the program fails.
    lab::PullFigures pull(int links, double speed) const;

  private:
    std::string program_;
};

}  // namespace bench::peers
