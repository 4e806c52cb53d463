#include "scenarios/drill/materials.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace scenarios::drill {

namespace {

constexpr std::array<Size, 8> all_sizes = {{{"3-0", 0.225, 9.4},
                                            {"4-0", 0.175, 5.88},
                                            {"5-0", 0.125, 3.92},
                                            {"6-0", 0.085, 1.96},
                                            {"7-0", 0.06, 1.08},
                                            {"8-0", 0.045, 0.59},
                                            {"9-0", 0.035, 0.42},
                                            {"10-0", 0.025, 0.19}}};

constexpr std::array<Material, 4> all_materials = {{{"polypropylene", 2800, 2800, 905, 4},
                                                    {"nylon", 2000, 2000, 1140, 0},
                                                    {"silk", 8700, 500, 1300, 0},
                                                    {"polyglactin", 9000, 500, 1500, 0}}};

template <typename Table>
const auto& named(const Table& table, const std::string& name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.name == name; });
    assert(found != table.end() && "the name was checked against this table");
    return *found;
}

}  // namespace

std::span<const Size> sizes() {
    return all_sizes;
}
std::span<const Material> materials() {
    return all_materials;
}
const Size& size_named(const std::string& name) {
    return named(all_sizes, name);
}
const Material& material_named(const std::string& name) {
    return named(all_materials, name);
}

}  // namespace scenarios::drill
