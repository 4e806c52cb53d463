#include "assets/curve.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace assets {

namespace {

constexpr double millimetre = 1e-3;

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) : file_(file) {}

    std::vector<Curve> read() {
        std::ifstream in = open();
        for (std::string line; std::getline(in, line);) {
            ++line_;
            read_line(line);
        }
        if (in.bad()) fail_in_file("cannot be read");
        finish_component();
        if (curves_.empty()) fail_in_file("no vertices, at least 2 lines 'x y z' are needed");
        return curves_;
    }

  private:
    [[noreturn]] void fail(int line, const std::string& what) const {
        throw AssetError(file_.string() + ":" + std::to_string(line) + ": error: " + what);
    }

    [[noreturn]] void fail_in_file(const std::string& what) const {
        throw AssetError(file_.string() + ": error: " + what);
    }

    std::ifstream open() const {
        std::error_code ignored;
        if (!std::filesystem::exists(file_, ignored)) fail_in_file("no such file");
        if (!std::filesystem::is_regular_file(file_, ignored))
            fail_in_file("is no file, a .csv, .xyz or .txt is needed");
        const std::string type = file_.extension().string();
        if (type != ".csv" && type != ".xyz" && type != ".txt")
            fail_in_file("'" + type + "' is not a known kind of curve, .csv, .xyz or .txt is needed");
        std::ifstream in(file_, std::ios::binary);
        if (!in) fail_in_file("cannot be read");
        return in;
    }

    void read_line(const std::string& line) {
        const size_t comment = line.find('#');
        const std::string text = line.substr(0, comment);
        if (text.find_first_not_of(" \t\r") != std::string::npos) {
            if (vertices_.empty()) first_line_ = line_;
            vertices_.push_back(vertex(text));
        } else if (comment == std::string::npos) {
            finish_component();
        }
    }

    // Never quotes the line: it may be anything.
    Vec3 vertex(const std::string& text) const {
        Vec3 result;
        const char *at = text.data(), *end = at + text.size();
        const auto skip_blanks = [&] {
            while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
        };
        for (int axis = 0; axis < 3; ++axis) {
            skip_blanks();
            if (axis > 0 && at != end && *at == ',') ++at;
            skip_blanks();
            if (at != end && *at == '+') ++at;
            const auto [next, problem] = std::from_chars(at, end, result[axis]);
            if (problem != std::errc() ||
                (next != end && std::string_view(" \t\r,").find(*next) == std::string_view::npos))
                fail(line_, "not a vertex, three numbers 'x y z' are needed");
            at = next;
        }
        skip_blanks();
        if (at != end) fail(line_, "more than three numbers, a vertex is 'x y z'");
        if (!result.allFinite()) fail(line_, "a coordinate is not finite");
        return millimetre * result;
    }

    void finish_component() {
        if (vertices_.empty()) return;
        Curve curve{std::move(vertices_), false};
        vertices_.clear();
        const Vec3 first = curve.vertices.front();
        const auto same = [&](const Vec3& v) { return v == first; };
        if (std::all_of(curve.vertices.begin(), curve.vertices.end(), same))
            fail(first_line_, "a curve of one place, at least 2 different vertices are needed");
        if (curve.vertices.size() > 3 && same(curve.vertices.back())) {
            curve.vertices.pop_back();
            curve.closed = true;
        }
        curves_.push_back(std::move(curve));
    }

    const std::filesystem::path& file_;
    int line_ = 0, first_line_ = 0;
    std::vector<Vec3> vertices_;
    std::vector<Curve> curves_;
};

}  // namespace

std::vector<Curve> load_curves(const std::filesystem::path& file) {
    return Reader(file).read();
}

}  // namespace assets
