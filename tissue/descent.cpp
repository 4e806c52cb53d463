// Exact line search along a polynomial: the bracket is doubled until the slope rises, then bisected 40 times. Steps
// back where a hill lies before the lowest point. Cost: some hundred evaluations of a polynomial of degree six.
#include "tissue/descent.hpp"

namespace tissue {

namespace {

double value(const Descent& energy, double s) {
    double sum = 0;
    for (std::size_t k = energy.size(); k-- > 0;) sum = s * (energy[k] + sum);
    return sum;
}

double slope(const Descent& energy, double s) {
    double sum = 0;
    for (std::size_t k = energy.size(); k-- > 0;) sum = s * sum + static_cast<double>(k + 1) * energy[k];
    return sum;
}

}  // namespace

double lowest(const Descent& energy) {
    if (!(energy[0] < 0)) return 0;
    double low = 0, high = 1;
    constexpr double most = 4;
    while (high < most && slope(energy, high) < 0) low = high, high *= 2;
    if (slope(energy, high) < 0) low = high;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings && low < high; ++i) {
        const double middle = 0.5 * (low + high);
        (slope(energy, middle) < 0 ? low : high) = middle;
    }
    constexpr int retreats = 60;  // past a hill: back to where it is lower than at the start
    for (int i = 0; i < retreats && !(value(energy, low) < 0); ++i) low *= 0.5;
    return value(energy, low) < 0 ? low : 0;
}

}  // namespace tissue
