#include "assets/curve_lines.hpp"

#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <charconv>
#include <map>

#include "assets/formats.hpp"
#include "assets/text.hpp"

namespace assets {

namespace {

// A text vertex takes at least six bytes; a hundred is more than any real one needs, and its edge as many.
void check_length(const std::filesystem::path& file, std::uintmax_t bytes_per_vertex) {
    std::error_code ignored;
    if (std::filesystem::file_size(file, ignored) > bytes_per_vertex * most_curve_vertices)
        fail(file, "more than " + std::to_string(most_curve_vertices) + " vertices; resample the curve to fewer");
}

// Reads vertices and edges first, then walks from end to end.
class ObjLines {
  public:
    explicit ObjLines(const std::filesystem::path& file) : file_(file) {}

    std::vector<CurveComponent> read(std::string_view text) {
        for (int number = 1; !text.empty(); ++number) read_line(next_line(text), number);
        if (order_.empty()) fail(file_, "holds no lines 'l'; expected those of a curve");
        std::vector<CurveComponent> strands;
        for (const int vertex : order_)
            if (!is_passed_[index(vertex)]) strands.push_back(walk(begin_of(vertex)));
        return strands;
    }

  private:
    static std::size_t index(int vertex) { return static_cast<std::size_t>(vertex); }

    void read_line(std::string_view line, int number) {
        const auto words = words_of(line.substr(0, line.find('#')), line.size());
        if (words.empty()) return;
        if (words[0] == "f") fail(file_, "holds faces, not lines; expected a curve", number);
        if (words[0] == "v") add_vertex(words, line, number);
        if (words[0] == "l")
            for (std::size_t i = 2; i < words.size(); ++i)
                add_edge(vertex_named(words[i - 1], number), vertex_named(words[i], number), number);
    }

    // A vertex that lies where an earlier one does is that one.
    void add_vertex(const std::vector<std::string_view>& words, std::string_view line, int number) {
        if (words.size() < 4) fail(file_, "expected 'v x y z' in mm, found " + shown(line), number);
        std::array<double, 3> mm{};
        for (std::size_t i = 0; i < 3; ++i) mm[i] = coordinate_in(words[i + 1], line, file_, number);
        const auto [known, is_new] = at_.try_emplace(mm, static_cast<int>(places_.size()));
        if (is_new) {
            places_.push_back(1e-3 * Vec3(mm[0], mm[1], mm[2]));
            lines_.push_back(number);
            edges_.emplace_back();
            is_passed_.push_back(false);
        }
        vertices_.push_back(known->second);
        if (static_cast<int>(vertices_.size()) > most_curve_vertices)
            fail(file_, "more than " + std::to_string(most_curve_vertices) + " vertices; resample the curve to fewer",
                 number);
    }

    // "7", "7/2" with a texture, "-1" for the last so far.
    int vertex_named(std::string_view word, int number) const {
        const std::string_view digits = word.substr(0, word.find('/'));
        long value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const auto count = static_cast<long>(vertices_.size());
        const long place = value < 0 ? count + value : value - 1;
        if (error != std::errc() || end != digits.data() + digits.size() || place < 0 || place >= count)
            fail(file_,
                 "expected the number of a vertex above, 1 to " + std::to_string(count) + ", found " + shown(word),
                 number);
        return vertices_[static_cast<std::size_t>(place)];
    }

    void add_edge(int a, int b, int number) {
        auto &from_a = edges_[index(a)], &from_b = edges_[index(b)];
        if (a == b || std::find(from_a.begin(), from_a.end(), b) != from_a.end()) return;
        for (const int end : {a, b}) {
            if (edges_[index(end)].size() == 2)
                fail(file_,
                     "a third edge meets the vertex of line " + std::to_string(lines_[index(end)]) +
                         "; expected at most two, as along a strand",
                     number);
            if (edges_[index(end)].empty()) order_.push_back(end);
        }
        from_a.push_back(b), from_b.push_back(a);
    }

    // An end of the strand through a vertex that is named first; where it is closed, the vertex itself.
    int begin_of(int vertex) const {
        int at = vertex, from = vertex;
        while (edges_[index(at)].size() == 2 || at == vertex) {
            const auto& to = edges_[index(at)];
            if (at == vertex && to.size() == 1) return vertex;
            const int next = at == vertex || to[0] != from ? to[0] : to[1];
            from = at, at = next;
            if (at == vertex) break;
        }
        return at;
    }

    CurveComponent walk(int vertex) {
        CurveComponent strand;
        const int first = vertex;
        for (bool goes_on = true; goes_on;) {
            pass(strand, vertex);
            goes_on = false;
            for (const int next : edges_[index(vertex)])
                if (!is_passed_[index(next)]) {
                    vertex = next, goes_on = true;
                    break;
                }
        }
        if (edges_[index(first)].size() == 2) pass(strand, first);  // closed: as a text file repeats its first vertex
        return strand;
    }

    void pass(CurveComponent& strand, int vertex) {
        is_passed_[index(vertex)] = true;
        strand.vertices.push_back(places_[index(vertex)]);
        strand.lines.push_back(lines_[index(vertex)]);
    }

    const std::filesystem::path& file_;
    std::vector<Vec3> places_;             // [m], each once
    std::vector<int> lines_;               // where each stands
    std::vector<std::vector<int>> edges_;  // to which others, at most two
    std::vector<bool> is_passed_;
    std::vector<int> vertices_;                // as they are numbered in the file
    std::vector<int> order_;                   // in which edges name them
    std::map<std::array<double, 3>, int> at_;  // by place in mm
};

Vec3 metres(const aiVector3D& p, const std::filesystem::path& file) {
    const Vec3 v = 1e-3 * Vec3(p.x, p.y, p.z);
    if (!v.allFinite() || v.cwiseAbs().maxCoeff() > 1e6)
        fail(file, "a coordinate is not a finite number within 1e9 mm");
    return v;
}

}  // namespace

std::vector<CurveComponent> read_obj_lines(const std::filesystem::path& file) {
    check_length(file, 200);
    return ObjLines(file).read(bytes_of(file));
}

std::vector<CurveComponent> read_ply_points(const std::filesystem::path& file) {
    check_length(file, 100);
    const std::string bytes = readable_ply(bytes_of(file), file);
    if (bytes.substr(0, bytes.find("end_header")).find("\nelement edge") != std::string::npos)
        fail(file, "edges of a .ply are not read; write its vertices in order and no edges, or use .xyz");
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "ply");
    if (!scene) fail(file, std::string("not readable as a curve: ") + importer.GetErrorString());
    std::vector<CurveComponent> components;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        if (mesh.mNumFaces > 0) fail(file, "holds faces, not lines; expected a curve");
        CurveComponent& strand = components.emplace_back();
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            strand.vertices.push_back(metres(mesh.mVertices[i], file));
            strand.lines.push_back(0);
        }
    }
    return components;
}

}  // namespace assets
