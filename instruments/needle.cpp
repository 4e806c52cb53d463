#include "instruments/needle.hpp"

namespace instruments {

Arc into_tool(const Arc& needle, const Pose& tool) {
    const Quat back = tool.rotation.conjugate();
    Arc seen = needle;
    seen.centre = back * (needle.centre - tool.position);
    seen.to_tail = back * needle.to_tail;
    seen.onwards = back * needle.onwards;
    return seen;
}

Arc out_of_tool(const Arc& needle, const Pose& tool) {
    Arc seen = needle;
    seen.centre = tool.position + tool.rotation * needle.centre;
    seen.to_tail = tool.rotation * needle.to_tail;
    seen.onwards = tool.rotation * needle.onwards;
    return seen;
}

double yield_moment(double wire) {
    constexpr double yield = 1.8e9, quarter_pi = 0.78539816339744831;  // [Pa]
    return yield * quarter_pi * wire * wire * wire;
}

std::array<Capsule, needle_parts> parts_of(const Arc& needle) {
    std::array<Capsule, needle_parts> parts;
    const double piece = (needle.length() - needle.wire) / needle_parts;
    Vec3 from = needle.at(needle.wire);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Vec3 to = needle.at(needle.wire + piece * static_cast<double>(k + 1));
        parts[k] = {from, to, needle.wire};
        from = to;
    }
    return parts;
}

}  // namespace instruments
