#include "assets/curve_lines.hpp"

#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <fstream>

namespace assets {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
    throw AssetError(file.string() + ": error: " + what);
}

Vec3 metres(const aiVector3D& p, const std::filesystem::path& file) {
    const Vec3 v = 1e-3 * Vec3(p.x, p.y, p.z);
    if (!v.allFinite() || v.cwiseAbs().maxCoeff() > 1e6)
        fail(file, "a coordinate is not a finite number within 1e9 mm");
    return v;
}

void append(CurveComponent& component, const Vec3& p) {
    component.vertices.push_back(p);
    component.lines.push_back(0);
}

// assimp gives each line as separate pieces of two vertices; they belong together where one ends as the next begins.
void append_piece(std::vector<CurveComponent>& components, const Vec3& a, const Vec3& b) {
    if (components.empty() || components.back().vertices.back() != a) append(components.emplace_back(), a);
    append(components.back(), b);
}

bool has_edges(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    for (std::string line; std::getline(in, line) && !line.starts_with("end_header");)
        if (line.starts_with("element edge")) return true;
    return false;
}

}  // namespace

std::vector<CurveComponent> read_lines(const std::filesystem::path& file) {
    // A text vertex takes at least six bytes; a hundred is more than any real one needs.
    std::error_code ignored;
    if (std::filesystem::file_size(file, ignored) > 100ull * most_curve_vertices)
        fail(file, "more than " + std::to_string(most_curve_vertices) + " vertices; resample the curve to fewer");
    if (file.extension() == ".ply" && has_edges(file))
        fail(file, "edges of a .ply are not read; write its vertices in order and no edges, or use .xyz");
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (!scene) fail(file, std::string("not readable as lines: ") + importer.GetErrorString());
    std::vector<CurveComponent> components;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        if (mesh.mNumFaces == 0) {
            components.emplace_back();
            for (unsigned i = 0; i < mesh.mNumVertices; ++i) append(components.back(), metres(mesh.mVertices[i], file));
        }
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices > 2) fail(file, "holds faces, not lines; expected a curve");
            for (unsigned i = 1; i < face.mNumIndices; ++i)
                append_piece(components, metres(mesh.mVertices[face.mIndices[i - 1]], file),
                             metres(mesh.mVertices[face.mIndices[i]], file));
        }
    }
    return components;
}

}  // namespace assets
