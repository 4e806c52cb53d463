#include <png.h>

#include "app/draw/picture.hpp"

namespace app::draw {

std::vector<unsigned char> encode_png(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.pixels.size() != 3u * image.width * image.height)
        throw DrawError("an image of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                        " pixels does not hold " + std::to_string(image.pixels.size()) + " bytes");
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = image.width;
    png.height = image.height;
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<unsigned char> bytes(size);
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
        throw DrawError(std::string("cannot encode a PNG: ") + png.message);
    bytes.resize(size);
    return bytes;
}

}  // namespace app::draw
