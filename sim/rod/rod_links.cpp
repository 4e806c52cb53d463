#include <cassert>

#include "sim/rod/rod.hpp"

// Links that come and go between steps; nothing moves.
namespace sim::rod {

void Rod::split(std::size_t link, double share) {
    assert(link < rest_length_.size() && share > 0 && share < 1 && "a place inside a link");
    const auto place = static_cast<std::ptrdiff_t>(link);
    for (auto* of_nodes : {&now_.nodes, &now_.velocity}) {
        const Vec3 between = (1 - share) * (*of_nodes)[link] + share * (*of_nodes)[link + 1];
        of_nodes->insert(of_nodes->begin() + place + 1, between);
    }
    natural_.insert(natural_.begin() + place + 1, 0.0);
    for (auto* of_links : {&rest_length_, &now_.tension})
        of_links->insert(of_links->begin() + place, (*of_links)[link]);
    rest_length_[link] *= share;
    rest_length_[link + 1] *= 1 - share;
}

void Rod::leave_out(std::size_t first, std::size_t second) {
    assert(first < second && second < now_.nodes.size() && "two nodes of the rod, in order");
    const auto from = static_cast<std::ptrdiff_t>(first) + 1, to = static_cast<std::ptrdiff_t>(second);
    for (auto* of_nodes : {&now_.nodes, &now_.velocity})
        of_nodes->erase(of_nodes->begin() + from, of_nodes->begin() + to);
    natural_.erase(natural_.begin() + from, natural_.begin() + to);
    for (auto* of_links : {&rest_length_, &now_.tension}) {
        (*of_links)[first] = 0;
        of_links->erase(of_links->begin() + from, of_links->begin() + to);
    }
}

// By the law of the lever, so that all but the two links between lie as they would have lain.
void Rod::hand_on_natural_bend(std::size_t node) {
    const double before = rest_length_[node - 1], after = rest_length_[node];
    natural_[node - 1] += after / (before + after) * natural_[node];
    natural_[node + 1] += before / (before + after) * natural_[node];
}

void Rod::join_at(std::size_t node) {
    assert(node > 0 && node < rest_length_.size() && "a node between two links");
    if (def_.yield_strain > 0) hand_on_natural_bend(node);
    rest_length_[node - 1] += rest_length_[node];
    for (auto* of_nodes : {&now_.nodes, &now_.velocity})
        of_nodes->erase(of_nodes->begin() + static_cast<std::ptrdiff_t>(node));
    natural_.erase(natural_.begin() + static_cast<std::ptrdiff_t>(node));
    for (auto* of_links : {&rest_length_, &now_.tension})
        of_links->erase(of_links->begin() + static_cast<std::ptrdiff_t>(node));
}

}  // namespace sim::rod
