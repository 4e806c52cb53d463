#pragma once

// How near thread comes to what it touches, as shares of the thread's own sizes.
namespace sim::thread::contact {

constexpr double looked_around = 6;  ///< How far strands look for each other, in radii.

/// Strands keep so much farther apart than they are thick, as a share of that: what passes leave undone is air then,
/// not overlap.
constexpr double margin = 0.045;
/// How far strands may be in each other's margin before tools wait, as a share of the thickness. They then touch by
/// less than a hundredth.
constexpr double strand_limit = 0.05;
/// How far thread may be in tools and walls before tools wait, as a share of the thickness.
constexpr double steel_limit = 0.2;
/// The share of a distance that a node may move: two neighbours that each use theirs keep a tenth.
constexpr double bound_share = 0.45;

}  // namespace sim::thread::contact
