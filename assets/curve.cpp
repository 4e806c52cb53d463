#include "assets/curve.hpp"

#include <array>
#include <cmath>
#include <fstream>

#include "assets/curve_lines.hpp"
#include "assets/text.hpp"

namespace assets {

namespace {

Vec3 vertex_in(std::string_view line, const std::filesystem::path& file, int number) {
    const auto words = words_of(line, 5);
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < std::min<std::size_t>(3, words.size()); ++i)
        x[i] = coordinate_in(words[i], line, file, number);
    if (words.size() != 3)
        fail(file,
             "expected three numbers 'x y z' in mm, found " +
                 (words.size() > 4 ? "more than four" : std::to_string(words.size())),
             number);
    return 1e-3 * Vec3(x[0], x[1], x[2]);
}

std::vector<CurveComponent> read_text(std::istream& in, const std::filesystem::path& file) {
    std::vector<CurveComponent> components;
    int number = 0, vertices = 0;
    bool new_component = true;
    // No line of three numbers is near this long; a file without line ends must not be read whole.
    constexpr std::streamsize longest_line = 4096;
    std::array<char, longest_line> buffer;
    while (in.getline(buffer.data(), longest_line) || in.gcount() > 0) {
        ++number;
        if (in.fail() && !in.eof()) fail(file, "a line of more than 4000 characters is not a vertex 'x y z'", number);
        std::string_view line(buffer.data(), static_cast<std::size_t>(in.gcount() - (in.eof() ? 0 : 1)));
        if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
        const std::size_t comment = line.find('#');
        const bool commented = comment != std::string_view::npos;
        line = line.substr(0, comment);
        if (words_of(line, 1).empty()) {
            new_component = new_component || !commented;
            continue;
        }
        if (++vertices > most_curve_vertices)
            fail(file, "more than " + std::to_string(most_curve_vertices) + " vertices; resample the curve to fewer",
                 number);
        if (new_component) components.emplace_back();
        new_component = false;
        components.back().vertices.push_back(vertex_in(line, file, number));
        components.back().lines.push_back(number);
    }
    return components;
}

bool in_one_place(const CurveComponent& component) {
    constexpr double least = 1e-12;  // [m], a hundredth of an atom; squares of what is far smaller vanish
    for (const Vec3& p : component.vertices)
        if ((p - component.vertices.front()).cwiseAbs().maxCoeff() > least) return false;
    return true;
}

}  // namespace

std::string Curve::place(int component, int vertex) const {
    const int line = components[static_cast<std::size_t>(component)].lines[static_cast<std::size_t>(vertex)];
    return file.string() + (line > 0 ? ":" + std::to_string(line) : ": vertex " + std::to_string(vertex + 1));
}

static Curve checked(Curve curve) {
    const std::filesystem::path& file = curve.file;
    if (curve.components.empty()) fail(file, "holds no vertices; expected one 'x y z' in mm a line");
    for (CurveComponent& component : curve.components) {
        if (component.vertices.size() < 2)
            fail(file,
                 curve.components.size() == 1
                     ? "a curve of one vertex; expected at least two"
                     : "one vertex between empty lines, which end a curve; expected at least two, or no empty line",
                 component.lines.front());
        if (in_one_place(component))
            fail(file, "all vertices of this component are in one place; expected a curve", component.lines.front());
        while (component.vertices.front() == component.vertices.back()) {
            component.closed = true;
            component.vertices.pop_back();
            component.lines.pop_back();
        }
    }
    return curve;
}

Curve load_curve(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) fail(file, "no such file");
    if (!std::filesystem::is_regular_file(file, ignored))
        fail(file, "not a file; expected a curve of vertices 'x y z'");
    const std::string ending = ending_of(file);
    if (ending == ".obj") return checked({file, read_obj_lines(file)});
    if (ending == ".ply") return checked({file, read_ply_points(file)});
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, "cannot be opened");
    return read_curve(in, file);
}

Curve read_curve(std::istream& in, const std::filesystem::path& name) {
    return checked({name, read_text(in, name)});
}

}  // namespace assets
