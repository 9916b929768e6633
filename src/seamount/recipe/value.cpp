#include "seamount/recipe/value.h"

namespace seamount::recipe {

std::string_view kind_name(ValueKind kind) { return Choices<ValueKind>::names[static_cast<size_t>(kind)]; }

const GridFrame* Value::frame() const {
  if (const auto* grid = std::get_if<std::shared_ptr<const Grid<float>>>(&data_)) return &(*grid)->frame();
  if (const auto* grid = std::get_if<std::shared_ptr<const LabelMap>>(&data_)) return &(*grid)->frame();
  if (const auto* network = std::get_if<std::shared_ptr<const Tin>>(&data_)) return &(*network)->frame;
  if (const auto* set = std::get_if<std::shared_ptr<const ContourSet>>(&data_)) return &(*set)->frame;
  return nullptr;
}

size_t Value::bytes() const {
  switch (kind_) {
    case ValueKind::terrain:
    case ValueKind::field:
      return heights().size() * sizeof(float);
    case ValueKind::labels:
      return regions().size();
    case ValueKind::image:
      return picture().rgb.size();
    case ValueKind::drawing: {
      size_t points = 0;
      for (const NamedArea& area : shapes().areas) {
        for (const Polygon& part : area.parts) {
          points += part.outer.size();
          for (const Ring& hole : part.holes) points += hole.size();
        }
      }
      for (const ValuedLine& line : shapes().lines) points += line.points.size();
      return (points + shapes().points.size()) * sizeof(Vec2);
    }
    case ValueKind::tin: {
      const Tin& tin = network();
      return tin.nodes.size() * sizeof(Vec2) + tin.triangles.size() * sizeof(tin.triangles[0]) +
             (tin.region.size() + tin.rank.size() + tin.height_m.size()) * sizeof(float);
    }
    case ValueKind::contours: {
      size_t points = 0;
      for (const Contour& contour : contour_set().contours) points += contour.ring.size();
      return points * sizeof(Vec2);
    }
    case ValueKind::report: {
      size_t numbers = 0;
      for (const Descriptor& descriptor : measured().descriptors)
        for (const PlotLine& line : descriptor.plot.lines) numbers += line.x.size() + line.y.size();
      return numbers * sizeof(double);
    }
  }
  return 0;
}

}  // namespace seamount::recipe
