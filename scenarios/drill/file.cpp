#include "scenarios/drill/file.hpp"

#include <openssl/evp.h>

#include <array>
#include <fstream>

namespace scenarios::drill {

void fail(const std::string& place, const std::string& what) {
    std::string line = place + ": error: " + what;
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    throw FileError(line);
}

std::string read_text(const std::filesystem::path& file, std::size_t most_bytes) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) fail(file.string(), "no such file");
    if (std::filesystem::is_directory(status)) fail(file.string(), "is a directory, expected a file");
    if (!std::filesystem::is_regular_file(status)) fail(file.string(), "is not a regular file");
    const auto size = std::filesystem::file_size(file, error);
    if (error) fail(file.string(), "cannot be read");
    if (size > most_bytes)
        fail(file.string(), "has " + std::to_string(size) + " bytes, expected at most " + std::to_string(most_bytes));
    std::string text(size, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (!stream) fail(file.string(), "cannot be read");
    return text;
}

std::string without_mark(std::string text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.erase(0, mark.size());
    return text;
}

std::string sha256(const std::string& bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int size = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
        throw std::logic_error("SHA-256 is not available in libcrypto");
    std::string hex;
    for (unsigned int i = 0; i < size; ++i)
        for (const int digit : {digest[i] >> 4, digest[i] & 15}) hex += "0123456789abcdef"[digit];
    return hex;
}

}  // namespace scenarios::drill
