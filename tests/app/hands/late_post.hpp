#pragma once
#include <algorithm>
#include <deque>
#include <random>
#include <vector>

#include "app/hands/devices.hpp"

namespace app::hands {

/// Brings events in their order, each somewhat late, as a busy computer does.
class LatePost {
  public:
    /// Each is late by 0 to `most_s`.
    LatePost(double most_s, unsigned seed) : late_(0, most_s), random_(seed) {}
    /// Takes events that a person makes now.
    void send(const std::vector<Event>& events, double now_s) {
        for (const Event& event : events) {
            last_s_ = std::max(last_s_, now_s + late_(random_));
            queue_.push_back({last_s_, event});
        }
    }
    /// Hands over what has arrived by now.
    void deliver(double now_s, std::vector<Event>& to) {
        for (; !queue_.empty() && queue_.front().first <= now_s; queue_.pop_front())
            to.push_back(queue_.front().second);
    }

  private:
    std::uniform_real_distribution<double> late_;
    std::mt19937 random_;
    std::deque<std::pair<double, Event>> queue_;
    double last_s_ = 0;
};

}  // namespace app::hands
