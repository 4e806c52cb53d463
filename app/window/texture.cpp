#include "app/window/texture.hpp"

#include <GL/glcorearb.h>
#include <SDL.h>
#include <png.h>

namespace app::window {

namespace {

struct Functions {
    PFNGLGENTEXTURESPROC generate;
    PFNGLDELETETEXTURESPROC remove;
    PFNGLBINDTEXTUREPROC bind;
    PFNGLTEXIMAGE2DPROC image;
    PFNGLTEXPARAMETERIPROC parameter;
    PFNGLPIXELSTOREIPROC pixels;
    PFNGLGENERATEMIPMAPPROC smaller_ones;
};

const Functions& gl() {
    static const auto load = [](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(SDL_GL_GetProcAddress(name));
    };
    static const Functions functions = [] {
        Functions all{};
        load(all.generate, "glGenTextures");
        load(all.remove, "glDeleteTextures");
        load(all.bind, "glBindTexture");
        load(all.image, "glTexImage2D");
        load(all.parameter, "glTexParameteri");
        load(all.pixels, "glPixelStorei");
        load(all.smaller_ones, "glGenerateMipmap");
        return all;
    }();
    return functions;
}

}  // namespace

Texture::Texture(const draw::Image& image) : size_{static_cast<float>(image.width), static_cast<float>(image.height)} {
    gl().generate(1, &id_);
    gl().bind(GL_TEXTURE_2D, id_);
    gl().pixels(GL_UNPACK_ALIGNMENT, 1);
    gl().image(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
    gl().smaller_ones(GL_TEXTURE_2D);
    gl().parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl().parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl().parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl().parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl().pixels(GL_UNPACK_ALIGNMENT, 4);
}

Texture::~Texture() {
    if (id_) gl().remove(1, &id_);
}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(size_, other.size_);
    return *this;
}

std::optional<draw::Image> read_png(const std::filesystem::path& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, file.c_str())) return {};
    png.format = PNG_FORMAT_RGB;
    draw::Image image{static_cast<int>(png.width), static_cast<int>(png.height),
                      std::vector<unsigned char>(PNG_IMAGE_SIZE(png))};
    if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr)) return {};
    return image;
}

}  // namespace app::window
