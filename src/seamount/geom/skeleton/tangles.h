// Where a line would cross itself, and moves that do not let it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seamount/model/drawn.h"

namespace seamount::geom {

/// Pairs of edges of a chain or ring that cross or touch (neighbours: that run back over each other), exactly decided.
/// About linear for edges of like length.
std::vector<std::pair<size_t, size_t>> find_tangles(std::span<const Vec2> points, bool closed);

/// Takes vertices at crossings back to where they were, for as long as that helps, so that a line which moved from
/// `before` to `after` has no crossing. False, if one is left. moved[i] becomes false for vertices taken back.
bool undo_tangles(std::span<const Vec2> before, std::span<Vec2> after, bool closed, std::vector<char>& moved);

}  // namespace seamount::geom
