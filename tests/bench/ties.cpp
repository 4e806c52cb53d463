// Seeded ties in as many processes as there are cores: a line for every seed whose knot changed its name or passed through
// itself, and a last line of totals; exit 3 when there was any.
//   ties FIRST_SEED LAST_SEED [all: a line for every seed]
#include <cstdio>
#include <cstdlib>

#include "app/bench/ties.hpp"

int main(int argc, char** argv) {
    if (argc < 3) return std::fprintf(stderr, "usage: ties FIRST_SEED LAST_SEED [all]\n"), 2;
    const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
    int changed = 0, pass_throughs = 0;
    double stretch = 0;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        const app::bench::Tied tied = app::bench::ties(seed);
        changed += tied.changed();
        pass_throughs += tied.pass_throughs;
        stretch = tied.stretch > stretch ? tied.stretch : stretch;
        if (argc == 3 && tied.good()) continue;
        std::puts(app::bench::words(seed, app::bench::tie_of(seed), tied).c_str());
        std::fflush(stdout);
    }
    std::printf("seeds %llu to %llu: %d pass-throughs, %d changed names, stretch at most %.2e\n",
        static_cast<unsigned long long>(first),
                static_cast<unsigned long long>(last), pass_throughs, changed, stretch);
    return changed + pass_throughs > 0 ? 3 : 0;
}
