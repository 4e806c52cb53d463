#pragma once
#include "app/draw/picture.hpp"
#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/motion.hpp"

namespace app::window {

/// The reference motion's tools, which show a step again and again.
class Ghost {
  public:
    /// Those that move in this step at a moment of its loop, by a clock [s]; none where the step has no times.
    std::vector<draw::ToolPicture> tools(const scenarios::drill::Drill& drill,
                                         const scenarios::drill::Motion& reference, std::size_t step, double now_s);

  private:
    std::size_t step_ = static_cast<std::size_t>(-1);
    double begin_s_ = 0;
};

}  // namespace app::window
