#include "seamount/geom/mesh/water_sheet.h"

#include <algorithm>
#include <vector>

namespace seamount::geom {
namespace {

/// Squares of columns [x0, x1) and rows [y0, y1), between the cells at their ends.
struct Squares {
  int x0, x1, y0, y1;
};

std::vector<Squares> cover(const Grid<uint8_t>* hollows, const CellBox& box) {
  if (hollows == nullptr) return {{box.first.x, box.last.x, box.first.y, box.last.y}};
  const auto is_wet = [&](int x, int y) {
    return (*hollows)(x, y) == 0 && (*hollows)(x + 1, y) == 0 && (*hollows)(x, y + 1) == 0 &&
           (*hollows)(x + 1, y + 1) == 0;
  };
  std::vector<Squares> done, open, here;
  for (int y = box.first.y; y < box.last.y; ++y) {
    here.clear();
    for (int x = box.first.x; x < box.last.x; ++x) {
      if (!is_wet(x, y)) continue;
      const int x0 = x;
      while (x < box.last.x && is_wet(x, y)) ++x;
      const auto above =
          std::find_if(open.begin(), open.end(), [&](const Squares& s) { return s.x0 == x0 && s.x1 == x; });
      here.push_back({x0, x, above != open.end() ? above->y0 : y, y + 1});
      if (above != open.end()) open.erase(above);
    }
    done.insert(done.end(), open.begin(), open.end());  // what did not go on
    open.swap(here);
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

}  // namespace

std::optional<MeshPart> water_sheet(const HeightField& heights, const Grid<uint8_t>* hollows, const CellPlaces& places,
                                    const CellBox& box, Vec2 offset) {
  bool sea = false;
  for (int y = box.first.y; y <= box.last.y && !sea; ++y)
    for (int x = box.first.x; x <= box.last.x && !sea; ++x)
      sea = heights(x, y) < 0.0F && (hollows == nullptr || (*hollows)(x, y) == 0);
  if (!sea) return std::nullopt;
  MeshPart part{.material = MeshMaterial::water, .positions = {}, .normals = {}, .uvs = {}, .indices = {}};
  for (const Squares& s : cover(hollows, box)) {
    const auto west = static_cast<float>(places.x(s.x0) - offset.x),
               east = static_cast<float>(places.x(s.x1) - offset.x);
    const auto north = static_cast<float>(places.y(s.y0) - offset.y);
    const auto south = static_cast<float>(places.y(s.y1) - offset.y);
    const auto first = static_cast<uint32_t>(part.positions.size() / 3);
    part.positions.insert(part.positions.end(), {west, north, 0, west, south, 0, east, south, 0, east, north, 0});
    for (int corner = 0; corner < 4; ++corner) part.normals.insert(part.normals.end(), {0, 0, 1});
    for (const uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) part.indices.push_back(first + corner);
  }
  return part;
}

}  // namespace seamount::geom
