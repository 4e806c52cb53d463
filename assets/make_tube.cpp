// make_tube OUTER_MM WALL_MM LENGTH_MM AROUND ALONG: writes a closed tube along x as .obj to standard output.
#include <cstdlib>
#include <iostream>

#include "assets/mesh.hpp"

static double number(const char* text) {
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    return *end == '\0' && end != text ? value : -1;
}

int main(int argc, char** argv) {
    double value[5]{};
    for (int i = 0; i < 5 && i + 1 < argc; ++i) value[i] = number(argv[i + 1]);
    const auto [outer, wall, length, around, along] = value;
    const auto count = [](double v, double least) { return v >= least && v <= 1000 && v == static_cast<int>(v); };
    if (argc != 6 || !(wall > 0 && wall < outer / 2 && outer <= 1000 && length > 0 && length <= 1000) ||
        !count(around, 3) || !count(along, 1)) {
        std::cerr
            << "make_tube: error: wanted OUTER_MM WALL_MM LENGTH_MM AROUND ALONG with 0 < WALL_MM < OUTER_MM / 2, "
               "sizes up to 1000 mm, AROUND 3 to 1000 and ALONG 1 to 1000\n";
        return 2;
    }
    std::string comment = "Tube in mm: make_tube";
    for (int i = 1; i < argc; ++i) comment += std::string(" ") + argv[i];
    const auto tube =
        assets::make_tube(outer * 1e-3, wall * 1e-3, length * 1e-3, static_cast<int>(around), static_cast<int>(along));
    assets::write_obj(tube, comment, std::cout);
    return std::cout.flush() ? 0 : 1;
}
