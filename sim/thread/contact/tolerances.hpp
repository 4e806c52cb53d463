#pragma once

// How near thread comes to what it touches, as shares of the thread's own sizes.
namespace sim::thread::contact {

constexpr double looked_around = 6;  ///< Radii: how far strands look for each other.

/// Strands keep so much farther apart than they are thick, as a share of that: what passes leave undone is air then,
/// not overlap.
constexpr double margin = 0.045;
constexpr double strand_limit = 0.05;  ///< Of the thickness: how far strands may be in each other's margin; beyond,
                                       ///< tools wait. They then touch by less than a hundredth.
constexpr double steel_limit = 0.2;    ///< Of the thickness: how far thread may be in tools and walls; then tools wait.
constexpr double bound_share = 0.45;   ///< Of a distance: two neighbours that each use it keep a tenth.

}  // namespace sim::thread::contact
