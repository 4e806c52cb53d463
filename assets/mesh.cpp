#include "assets/mesh.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "assets/formats.hpp"
#include "assets/slivers.hpp"
#include "assets/text.hpp"

namespace assets {

using sim::geometry::Triangle;

std::vector<Triangle> Mesh::soup() const {
    std::vector<Triangle> result;
    result.reserve(triangles.size());
    const auto at = [&](int i) -> const Vec3& { return vertices[static_cast<std::size_t>(i)]; };
    for (const auto& [a, b, c] : triangles) result.push_back({at(a), at(b), at(c)});
    return result;
}

double volume(const Mesh& mesh) {
    if (mesh.vertices.empty()) return 0;
    const Vec3& origin = mesh.vertices.front();  // near, so that nothing is lost where the mesh lies far away
    double six = 0;
    for (const Triangle& t : mesh.soup()) six += (t.a - origin).dot((t.b - origin).cross(t.c - origin));
    return six / 6;
}

namespace {

// With each rim drawn together to its middle; `next`: corner along the rims, with the surface to their right.
double filled_volume(const Mesh& mesh, std::map<int, int> next) {
    Mesh filled = mesh;
    while (!next.empty()) {
        const int middle = static_cast<int>(filled.vertices.size());
        Vec3 sum = Vec3::Zero();
        int corners = 0;
        for (auto at = next.begin(); at != next.end();
             next.erase(at), at = next.find(filled.triangles.back()[1]), ++corners) {
            sum += mesh.vertices[static_cast<std::size_t>(at->first)];
            filled.triangles.push_back({at->first, at->second, middle});
        }
        filled.vertices.push_back(sum / corners);
    }
    return volume(filled);
}

struct Reader {
    const std::filesystem::path& file;

    [[noreturn]] void fail(const std::string& what) const { assets::fail(file, what); }

    void check_file() const {
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored)) fail("no such file");
        if (std::filesystem::is_directory(file, ignored)) fail("is a directory, a .obj, .ply or .stl file is needed");
        if (!std::filesystem::is_regular_file(file, ignored)) fail("is no file, a .obj, .ply or .stl file is needed");
        const std::string type = ending_of(file);
        if (type != ".obj" && type != ".ply" && type != ".stl")
            fail("'" + type + "' is not a known kind of mesh, .obj, .ply or .stl is needed");
    }

    // What is fit for assimp.
    std::string readable() const {
        const std::string type = ending_of(file);
        if (type == ".stl") return readable_stl(bytes_of(file), file);
        return type == ".ply" ? readable_ply(bytes_of(file), file) : bytes_of(file);
    }

    Mesh read() const {
        Assimp::Importer importer;
        const std::string bytes = readable();
        const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate,
                                                           ending_of(file).substr(1).c_str());
        if (!scene) {
            std::string why = importer.GetErrorString();
            std::replace(why.begin(), why.end(), '\n', ' ');
            fail("cannot be read as a mesh: " + why);
        }
        Mesh mesh;
        std::map<std::array<float, 3>, int> known;
        for (const aiMesh* part : std::vector<aiMesh*>(scene->mMeshes, scene->mMeshes + scene->mNumMeshes))
            for (unsigned f = 0; f < part->mNumFaces; ++f) {
                const aiFace& face = part->mFaces[f];
                if (face.mNumIndices != 3) continue;  // loose points and lines
                std::array<int, 3> triangle{};
                for (unsigned i = 0; i < 3; ++i) {
                    if (face.mIndices[i] >= part->mNumVertices)
                        fail(name(mesh.triangles.size()) + " has a corner that does not exist");
                    const aiVector3D& p = part->mVertices[face.mIndices[i]];
                    const Vec3 corner(p.x, p.y, p.z);
                    if (!corner.allFinite())
                        fail(name(mesh.triangles.size()) + " has a corner that is not a finite number");
                    const auto [place, is_new] =
                        known.try_emplace({p.x, p.y, p.z}, static_cast<int>(mesh.vertices.size()));
                    if (is_new) mesh.vertices.push_back(corner * 1e-3);
                    triangle[i] = place->second;
                }
                mesh.triangles.push_back(triangle);
            }
        if (mesh.triangles.empty()) fail("has no triangles");
        return mesh;
    }

    static std::string name(std::size_t triangle) { return "triangle " + std::to_string(triangle + 1); }

    static double size_of(const Mesh& mesh) {
        sim::geometry::Box box;
        for (const Vec3& p : mesh.vertices) box.include(p);
        return (box.high - box.low).maxCoeff();
    }

    void check_size(double size) const {
        const std::string across = "is " + std::to_string(size * 1e3) + " mm across, ";
        if (size > 1) fail(across + "at most 1000 mm is right; is it written in mm?");
        if (size < 0.1e-3) fail(across + "at least 0.1 mm is right; is it written in mm?");
    }

    void check_triangles(const Mesh& mesh) const {
        std::set<std::array<int, 3>> seen;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            auto corners = mesh.triangles[i];
            std::sort(corners.begin(), corners.end());
            if (!seen.insert(corners).second) fail(name(i) + " is there twice, remove one");
        }
    }

    /// Next corner along the rims, with the surface to their right.
    std::map<int, int> check_edges(const Mesh& mesh) const {
        std::map<std::array<int, 2>, std::array<int, 2>> uses;  // of an edge, low vertex first: upwards, downwards
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const int from = mesh.triangles[i][k], to = mesh.triangles[i][(k + 1) % 3];
                auto& [up, down] = uses[{std::min(from, to), std::max(from, to)}];
                ++(from < to ? up : down);
                if (up + down > 2) fail(name(i) + " has an edge of more than two triangles, a surface has at most two");
                if (up == 2 || down == 2) fail(name(i) + " faces the other way than its neighbour, turn one around");
            }
        std::map<int, int> next;
        for (const auto& [edge, times] : uses)
            if (times[0] + times[1] == 1) next[edge[times[0]]] = edge[times[1]];
        return next;
    }

    // By a share of the mesh's own size, so that it is the same mesh wherever it lies: far beyond the rounding of its
    // corners, which come as float, and far below what a thread feels.
    void mend_slivers(Mesh& mesh) const {
        constexpr double share = 1e-5;
        const double tolerance = share * size_of(mesh);
        const int slivers = take_out_slivers(mesh, tolerance);
        if (mesh.triangles.empty()) fail("has no triangle with an area");
        if (slivers > 0)
            mesh.mended.push_back("lost " + std::to_string(slivers) + (slivers == 1 ? " sliver" : " slivers") +
                                  ", triangles that have no area");
    }

    // A sheet that is all but flat has no inside.
    bool faces_inwards(const Mesh& mesh, const std::map<int, int>& rims) const {
        constexpr double flat =
            0.02;  // of what a sphere of that area holds; a tube a hundred times as long as wide holds 0.05
        double area = 0;
        for (const Triangle& t : mesh.soup()) area += 0.5 * (t.b - t.a).cross(t.c - t.a).norm();
        const double sphere = area * std::sqrt(area / (36 * std::numbers::pi));
        return filled_volume(mesh, rims) < -flat * sphere;
    }
};

}  // namespace

Mesh load_mesh(const std::filesystem::path& file) {
    const Reader reader{file};
    reader.check_file();
    Mesh mesh = reader.read();
    reader.check_size(Reader::size_of(mesh));
    reader.mend_slivers(mesh);
    reader.check_triangles(mesh);
    if (reader.faces_inwards(mesh, reader.check_edges(mesh))) {
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        mesh.mended.push_back("faced inwards everywhere: its triangles were turned around");
    }
    return mesh;
}

}  // namespace assets
