#include "sim/knot/loosen.hpp"

#include "sim/knot/reroute.hpp"

namespace sim::knot {

bool loosen(Diagram& diagram, Work& work) {
    constexpr std::size_t most = 60;
    std::vector<Diagram> reached{diagram};
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (Diagram& next : laid_elsewhere(reached[i])) {
            Diagram simpler = next;
            work.spend_on_simplifying(simpler);
            simplify(simpler);
            if (simpler.crossings() < diagram.crossings()) {
                diagram = std::move(simpler);
                return true;
            }
            if (work.is_spent() || reached.size() >= most) return false;
            reached.push_back(std::move(next));
        }
    return false;
}

}  // namespace sim::knot
