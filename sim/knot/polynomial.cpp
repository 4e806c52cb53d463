#include "sim/knot/polynomial.hpp"

#include <algorithm>
#include <cassert>

namespace sim::knot {

Polynomial sum(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    result.reserve(a.size() + b.size());
    auto i = a.begin(), j = b.begin();
    while (i != a.end() || j != b.end()) {
        if (j == b.end() || (i != a.end() && i->before(*j))) {
            result.push_back(*i++);
        } else if (i == a.end() || j->before(*i)) {
            result.push_back(*j++);
        } else {
            const std::int64_t coefficient = i->coefficient + j->coefficient;
            if (coefficient != 0) result.push_back({i->v, i->z, coefficient});
            ++i, ++j;
        }
    }
    return result;
}

Polynomial scaled(const Polynomial& p, Term factor) {
    Polynomial result = p;
    for (Term& t : result) t = {t.v + factor.v, t.z + factor.z, t.coefficient * factor.coefficient};
    return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    for (const Term& t : a) result = sum(result, scaled(b, t));
    return result;
}

Polynomial mirrored(const Polynomial& p) {
    Polynomial result = p;
    for (Term& t : result) t = {-t.v, t.z, t.z % 2 == 0 ? t.coefficient : -t.coefficient};
    std::sort(result.begin(), result.end(), [](const Term& a, const Term& b) { return a.before(b); });
    return result;
}

Polynomial unlink(int n) {
    assert(n >= 1 && "a circle at least");
    Polynomial result{{0, 0, 1}};
    for (int i = 1; i < n; ++i) result = product(result, {{-1, -1, 1}, {1, -1, -1}});
    return result;
}

}  // namespace sim::knot
