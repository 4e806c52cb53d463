#pragma once
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include "assets/mesh.hpp"

// Mesh files as programs write them, made of a mesh.
namespace made {

using assets::Mesh;
using assets::Vec3;

inline Mesh moved(Mesh mesh, const Vec3& by) {
    for (Vec3& p : mesh.vertices) p += by;
    return mesh;
}

inline Mesh turned_around(Mesh mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

inline std::string text_stl(const Mesh& mesh) {
    std::string text = "solid tube\n";
    char line[120];
    for (const auto& t : mesh.soup()) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const Vec3& p : {t.a, t.b, t.c}) {
            std::snprintf(line, sizeof line, "   vertex %.6e %.6e %.6e\n", 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z());
            text += line;
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid tube\n";
}

inline std::string bytes_of(float value) {
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &value, 4);
    return bytes;
}

inline std::string bytes_of(std::uint32_t value) {
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &value, 4);
    return bytes;
}

inline std::string binary_stl(const Mesh& mesh, std::string header = "binary") {
    header.resize(80, ' ');
    std::string bytes = header + bytes_of(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.soup()) {
        bytes += std::string(12, '\0');
        for (const Vec3& p : {t.a, t.b, t.c})
            for (int k = 0; k < 3; ++k) bytes += bytes_of(static_cast<float>(1e3 * p[k]));
        bytes += std::string(2, '\0');
    }
    return bytes;
}

/// `format`: "ascii", "binary_little_endian" or "binary_big_endian"; `between` goes behind every line of the header.
inline std::string ply(const Mesh& mesh, const std::string& format = "ascii", const std::string& between = "") {
    std::string text = "ply\n";
    const auto say = [&](const std::string& line) { text += line + "\n" + between; };
    say("format " + format + " 1.0"), say("element vertex " + std::to_string(mesh.vertices.size()));
    for (const char* axis : {"x", "y", "z"}) say("property float " + std::string(axis));
    say("element face " + std::to_string(mesh.triangles.size()));
    say("property list uchar int vertex_indices");
    text += "end_header\n";
    const auto put = [&](std::string bytes) {
        text += format == "binary_big_endian" ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
    };
    char line[120];
    for (const Vec3& p : mesh.vertices) {
        std::snprintf(line, sizeof line, "%.6f %.6f %.6f\n", 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z());
        if (format == "ascii") text += line;
        if (format != "ascii")
            for (int k = 0; k < 3; ++k) put(bytes_of(static_cast<float>(1e3 * p[k])));
    }
    for (const auto& t : mesh.triangles) {
        if (format == "ascii") text += "3";
        if (format != "ascii") text += '\3';
        for (const int corner : t)
            if (format == "ascii")
                text += " " + std::to_string(corner);
            else
                put(bytes_of(static_cast<std::uint32_t>(corner)));
        if (format == "ascii") text += "\n";
    }
    return text;
}

}  // namespace made
