#include "scenarios/recording/format.hpp"

#include <sqlite3.h>
#include <zstd.h>

#include <array>
#include <bit>
#include <memory>
#include <stdexcept>

#include "scenarios/recording/recording.hpp"

namespace scenarios::recording {

using instruments::ToolInput;

static_assert(std::endian::native == std::endian::little, "doubles are stored as they lie in memory");

namespace {

std::array<double, numbers_per_tool> numbers_of(const ToolInput& tool) {
    const auto& [p, q] = tool.pose;
    return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), tool.jaw};
}

ToolInput tool_of(const std::array<double, numbers_per_tool>& n) {
    return {{{n[0], n[1], n[2]}, instruments::Quat(n[3], n[4], n[5], n[6])}, n[7]};
}

}  // namespace

std::string library_versions() {
    return std::string("SQLite ") + sqlite3_libversion() + ", zstd " + ZSTD_versionString();
}

std::vector<char> pack(std::span<const ToolInput> inputs, std::size_t tools) {
    const std::size_t ticks = inputs.size() / tools;
    std::vector<double> columns(inputs.size() * numbers_per_tool);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto numbers = numbers_of(inputs[i]);
        for (std::size_t k = 0; k < numbers_per_tool; ++k)
            columns[((i % tools) * numbers_per_tool + k) * ticks + i / tools] = numbers[k];
    }
    const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    const std::size_t size = columns.size() * sizeof(double);
    std::vector<char> packed(ZSTD_compressBound(size));
    const std::size_t used = ZSTD_compress2(context.get(), packed.data(), packed.size(), columns.data(), size);
    if (ZSTD_isError(used)) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(used));
    packed.resize(used);
    return packed;
}

std::vector<ToolInput> unpack(std::span<const char> bytes, std::size_t ticks, std::size_t tools) {
    const std::size_t size = ticks * tools * numbers_per_tool * sizeof(double);
    if (ZSTD_getFrameContentSize(bytes.data(), bytes.size()) != size) return {};
    std::vector<double> columns(size / sizeof(double));
    if (ZSTD_decompress(columns.data(), size, bytes.data(), bytes.size()) != size) return {};
    std::vector<ToolInput> inputs(ticks * tools);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        std::array<double, numbers_per_tool> numbers;
        for (std::size_t k = 0; k < numbers_per_tool; ++k)
            numbers[k] = columns[((i % tools) * numbers_per_tool + k) * ticks + i / tools];
        inputs[i] = tool_of(numbers);
    }
    return inputs;
}

}  // namespace scenarios::recording
