#include "sim/thread/ftl/band.hpp"

namespace sim::thread::ftl {

void Band::clear() {
    rows_.clear();
    entries_.clear();
}

void Band::reserve(std::size_t rows) {
    constexpr std::size_t width = 6;  // a length and a contact on either side and here
    rows_.reserve(rows);
    entries_.reserve(width * rows);
}

void Band::add_row(std::size_t first, std::size_t end) {
    rows_.push_back({first, end, entries_.size()});
    entries_.resize(entries_.size() + end - first, 0.0);
}

// Gaussian elimination; what it fills lies within the stretches.
void Band::solve(std::vector<double>& x) {
    Band& a = *this;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (std::size_t j = first(i); j < i; ++j) {
            const double share = a(i, j) / a(j, j);
            if (share == 0) continue;
            for (std::size_t k = j + 1; k < end(j); ++k) a(i, k) -= share * a(j, k);
            x[i] -= share * x[j];
        }
    for (std::size_t i = rows_.size(); i-- > 0;) {
        for (std::size_t j = i + 1; j < end(i); ++j) x[i] -= a(i, j) * x[j];
        x[i] /= a(i, i);
    }
}

}  // namespace sim::thread::ftl
