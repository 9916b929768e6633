#include "seamount/tiles/windows.h"

#include <algorithm>
#include <cmath>

#include "seamount/recipe/kinds.h"

namespace seamount::tiles {
namespace {

using recipe::Kind, recipe::Value;
namespace kinds = recipe::kinds;

template <class K>
Value cut(const Value& value, const Rect& rect) {
  const auto& whole = value.get<K>();
  typename K::Type part(whole.frame().window(rect.column, rect.row, rect.width, rect.height));
  for (int y = 0; y < rect.height; ++y) {
    const auto row = whole.row(rect.row + y).subspan(static_cast<size_t>(rect.column), static_cast<size_t>(rect.width));
    std::copy(row.begin(), row.end(), part.row(y).begin());
  }
  return Value::of<K>(std::move(part));
}

template <class K>
Blank blank(const GridFrame& frame) {
  auto grid = std::make_shared<typename K::Type>(frame);
  void* cells = grid->data();
  return {Value(K::kind(), std::move(grid)), cells};
}

template <class K>
bool any_unknown(const Value& value) {
  const auto cells = value.get<K>().cells();
  return std::any_of(cells.begin(), cells.end(), [](float z) { return std::isnan(z); });
}

}  // namespace

bool is_raster(const Kind& kind) {
  return &kind == &kinds::Terrain::kind() || &kind == &kinds::Field::kind() || &kind == &kinds::Labels::kind();
}

size_t cell_bytes(const Kind& kind) { return &kind == &kinds::Labels::kind() ? sizeof(Region) : sizeof(float); }

Value window_of(const Value& value, const Rect& rect) {
  const GridFrame& frame = *value.frame();
  if (rect == Rect{0, 0, frame.width, frame.height}) return value;
  if (value.is<kinds::Terrain>()) return cut<kinds::Terrain>(value, rect);
  if (value.is<kinds::Field>()) return cut<kinds::Field>(value, rect);
  return cut<kinds::Labels>(value, rect);
}

Blank blank_raster(const Kind& kind, const GridFrame& frame) {
  if (&kind == &kinds::Terrain::kind()) return blank<kinds::Terrain>(frame);
  if (&kind == &kinds::Field::kind()) return blank<kinds::Field>(frame);
  return blank<kinds::Labels>(frame);
}

const void* cells_of(const Value& value) {
  if (value.is<kinds::Terrain>()) return value.get<kinds::Terrain>().data();
  if (value.is<kinds::Field>()) return value.get<kinds::Field>().data();
  return value.get<kinds::Labels>().data();
}

bool has_unknown(const Value& value) {
  if (value.is<kinds::Terrain>()) return any_unknown<kinds::Terrain>(value);
  if (value.is<kinds::Field>()) return any_unknown<kinds::Field>(value);
  return false;
}

}  // namespace seamount::tiles
