#pragma once
#include <imgui.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "app/draw/picture.hpp"

namespace app::window {

/// A picture that OpenGL holds, for ImGui to draw.
class Texture {
  public:
    explicit Texture(const draw::Image& image);
    ~Texture();
    Texture(Texture&& other) noexcept : id_(std::exchange(other.id_, 0)), size_(other.size_) {}
    Texture& operator=(Texture&& other) noexcept;

    ImTextureID id() const { return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(id_)); }  ///< For ImGui.
    ImVec2 size() const { return size_; }                                                              ///< In pixels.

  private:
    unsigned id_ = 0;
    ImVec2 size_;
};

/// A PNG file as a picture; none where it cannot be read.
std::optional<draw::Image> read_png(const std::filesystem::path& file);

}  // namespace app::window
