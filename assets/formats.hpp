#pragma once
#include <filesystem>
#include <string>

// Mesh files as programs write them, made fit for assimp 5.2, which is strict about their form and says little of what
// is wrong with it.
namespace assets {

/// An .stl file's bytes as assimp reads them: text in small letters from its first 'solid' to its last 'endsolid',
/// or binary that ends with its last triangle. Throws AssetError where the file is cut off. Cost: linear.
std::string readable_stl(std::string bytes, const std::filesystem::path& file);

/// A .ply file's bytes as assimp reads them: without comments in its header. Throws AssetError where the header has no
/// end or the file is cut off. Cost: linear.
std::string readable_ply(const std::string& bytes, const std::filesystem::path& file);

}  // namespace assets
