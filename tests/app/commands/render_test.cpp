#include <png.h>

#include <set>

#include "tests/app/commands/still.hpp"
#include "tests/program.hpp"

namespace {

struct Pixels {
    unsigned width = 0, height = 0;
    std::vector<unsigned char> rgb;
};

/// As any other program reads it; nothing where it is no PNG.
Pixels decoded(const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, file.c_str())) return {};
    image.format = PNG_FORMAT_RGB;
    Pixels pixels{image.width, image.height, std::vector<unsigned char>(PNG_IMAGE_SIZE(image))};
    if (!png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr)) return {};
    return pixels;
}

}  // namespace

// What a teacher gets who asks a recording for its moment: a whole picture of that moment, the same one each time.
TEST(RenderCommand, DrawsARecordingAtATime) {
    const program::Folder folder;
    const std::string recording = folder.path("s.carrel");
    // The left tool comes 8 mm nearer in 0.2 s.
    std::string motion = still::motion("0.2");
    motion.replace(motion.find("37", motion.find("0.2,left")), 2, "29");
    ASSERT_EQ(program::run({"run", still::drill, "--input", folder.write("m.csv", motion), "--record", recording}).exit,
              0);
    const auto rendered = [&](const std::string& name, const std::string& seconds) {
        const auto ending = program::run({"render", recording, "--at", seconds, "--out", folder.path(name)});
        EXPECT_EQ(ending.exit, 0);
        EXPECT_EQ(ending.out + ending.said, "");
        return decoded(folder.path(name));
    };
    const Pixels begin = rendered("begin.png", "0"), end = rendered("end.png", "0.2");
    EXPECT_EQ(begin.width, 960u);
    EXPECT_EQ(begin.height, 640u);
    ASSERT_EQ(begin.rgb.size(), 3u * 960 * 640);
    std::set<std::array<unsigned char, 3>> colors;
    for (std::size_t i = 0; i < begin.rgb.size(); i += 3)
        colors.insert({begin.rgb[i], begin.rgb[i + 1], begin.rgb[i + 2]});
    EXPECT_GT(colors.size(), 1000u);  // lit steel and tissue; an empty scene has a few dozen greys
    EXPECT_NE(begin.rgb, end.rgb);
    EXPECT_EQ(program::read(folder.path("begin.png")),
              (rendered("again.png", "0"), program::read(folder.path("again.png"))));
    // A drill's start is the same scene as that of the recording of it, whatever is written before it.
    ASSERT_EQ(program::run({"render", still::drill, "--out", folder.path("drill.png")}).exit, 0);
    EXPECT_EQ(decoded(folder.path("drill.png")).rgb, begin.rgb);
}

// A wrong moment or a mistyped path is the person's, not the program's: one line, exit 2, and soon.
TEST(RenderCommand, RefusesWhatCannotBeDrawn) {
    const program::Folder folder;
    const std::string png = folder.path("x.png");
    const auto expect_refused = [&](const std::string& blamed, const std::vector<std::string>& options) {
        std::vector<std::string> call{"render", still::drill};
        call.insert(call.end(), options.begin(), options.end());
        SCOPED_TRACE(testing::PrintToString(options));
        program::expect_one_line_naming(blamed, program::run(call));
        EXPECT_FALSE(std::filesystem::exists(png)) << "a picture was begun";
    };
    for (const char* moment : {"-1", "1e9", "nan", "inf", "soon"})
        expect_refused("--at", {"--at", moment, "--out", png});
    expect_refused("--close", {"--close", "--out", png});  // nothing is tied yet
    expect_refused("--size", {"--size", "9", "--out", png});
    expect_refused("--out", {});
    for (const std::string& path : {folder.path(""), folder.path("nowhere/x.png"), std::string("/proc/x.png")})
        expect_refused(path, {"--out", path});
}
