#include "scenarios/recording/pace.hpp"

#include <algorithm>
#include <vector>

namespace scenarios::recording {

bool is_comparable(std::span<const PaceRow> rows, double declared) {
    constexpr double least_share = 0.95;
    if (rows.empty()) return true;
    std::vector<double> rates;
    for (const PaceRow& row : rows) rates.push_back(row.rate);
    std::sort(rates.begin(), rates.end());
    return rates[rates.size() / 20] >= least_share * declared;
}

}  // namespace scenarios::recording
