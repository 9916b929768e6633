#include "seamount/ops/render/map_objects.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/skeleton/skeleton_index.h"
#include "seamount/ops/render/canvas.h"

namespace seamount::render {
namespace {

constexpr float kTint = 0.28F, kCasing = 0.6F;

geom::Box box_of(const GridFrame& frame, double margin_m) {
  return {{frame.west_m - margin_m, frame.north_m - frame.height_m() - margin_m},
          {frame.west_m + frame.width_m() + margin_m, frame.north_m + margin_m}};
}

bool holds(const geom::Box& box, Vec2 p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

/// The part of a line from a to b in a box (Liang and Barsky 1984).
std::optional<std::pair<Vec2, Vec2>> clipped(Vec2 a, Vec2 b, const geom::Box& box) {
  double from = 0.0, to = 1.0;
  const auto narrow = [&](double start, double along, double low, double high) {
    if (along == 0.0) {
      if (!(start >= low && start <= high)) to = -1.0;
      return;
    }
    from = std::max(from, ((along > 0.0 ? low : high) - start) / along);
    to = std::min(to, ((along > 0.0 ? high : low) - start) / along);
  };
  narrow(a.x, b.x - a.x, box.low.x, box.high.x);
  narrow(a.y, b.y - a.y, box.low.y, box.high.y);
  if (!(from <= to)) return std::nullopt;
  return std::pair(a + from * (b - a), a + to * (b - a));
}

bool is_shown(const Skeleton& skeleton, const geom::Box& box) {
  const Polyline& points = skeleton.points;
  switch (skeleton.kind) {
    case SkeletonKind::point:
      return !points.empty() && holds(box, points.front());
    case SkeletonKind::curve:
      for (size_t i = 1; i < points.size(); ++i)
        if (clipped(points[i - 1], points[i], box)) return true;
      return false;
    default:
      return std::abs(geom::signed_area(geom::clip_to_box(points, box))) > 0.0;
  }
}

/// Draws into a picture of the map's box alone.
class Painter {
 public:
  Painter(Image& sheet, const GridFrame& frame, double unit, const RunContext& run)
      : sheet_(sheet), pixels_(frame), pen_(map_pen(unit)), run_(run) {
    pixels_.width = sheet.width;
    pixels_.height = sheet.height;
    pixels_.cell_m = frame.width_m() / sheet.width;
    around_ = box_of(pixels_, 16.0 * pen_ * pixels_.cell_m);
  }

  void draw(const ShownClass& shown) {
    run_.check_cancelled();
    switch (shown.of_class->skeleton) {
      case SkeletonKind::region:
        draw_regions(shown);
        break;
      case SkeletonKind::curve:
        draw_curves(shown);
        break;
      case SkeletonKind::point:
        draw_points(shown);
        break;
    }
  }

 private:
  Vec2 pixel(Vec2 place) const {
    return {(place.x - pixels_.west_m) / pixels_.cell_m, (pixels_.north_m - place.y) / pixels_.cell_m};
  }

  void add_line(LineLayer& layer, const Polyline& points, bool closed, double width) const {
    for (size_t i = closed ? 0 : 1; i < points.size(); ++i) {
      const Vec2 before = points[i > 0 ? i - 1 : points.size() - 1];
      if (const auto part = clipped(before, points[i], around_))
        layer.add({pixel(part->first), pixel(part->second)}, width);
    }
  }

  void draw_regions(const ShownClass& shown) {
    std::vector<Polygon> areas;
    LineLayer outline(sheet_.width, sheet_.height), casing(outline);
    for (const SceneObject* object : shown.objects) {
      areas.push_back({object->skeleton.points, {}});
      add_line(outline, object->skeleton.points, true, 1.6 * pen_);
      add_line(casing, object->skeleton.points, true, 3.2 * pen_);
    }
    const Grid<uint8_t> inside = geom::rasterise(areas, pixels_);
    for (int y = 0; y < sheet_.height; ++y) {
      for (int x = 0; x < sheet_.width; ++x)
        if (inside(x, y) != 0) blend(sheet_, x, y, shown.of_class->colour, kTint);
    }
    casing.draw(sheet_, 0, 0, kInk, 0.5F * kCasing);
    outline.draw(sheet_, 0, 0, shown.of_class->colour, 0.95F);
  }

  void draw_curves(const ShownClass& shown) {
    LineLayer lines(sheet_.width, sheet_.height), casing(lines);
    for (const SceneObject* object : shown.objects) {
      add_line(lines, object->skeleton.points, false, 2.4 * pen_);
      add_line(casing, object->skeleton.points, false, 4.0 * pen_);
    }
    casing.draw(sheet_, 0, 0, edge_colour(shown.of_class->colour), kCasing);
    lines.draw(sheet_, 0, 0, shown.of_class->colour, 1.0F);
  }

  /// The largest first, so that none hides a smaller one whole.
  void draw_points(const ShownClass& shown) {
    std::vector<std::pair<double, Vec2>> symbols;
    for (const SceneObject* object : shown.objects) {
      const double radius = symbol_radius(*shown.of_class, *object, pixels_.cell_m, pen_);
      symbols.emplace_back(shown.dot_px > 0.0 ? shown.dot_px : std::max(pen_, radius * shown.shrink),
                           pixel(object->skeleton.points.front()));
    }
    std::stable_sort(symbols.begin(), symbols.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [radius, place] : symbols) {
      if (shown.dot_px > 0.0) {
        fill_disc(sheet_, place, radius, shown.of_class->colour);
      } else {
        draw_symbol(sheet_, place, radius, shown.symbol, shown.of_class->colour, 0.8 * pen_);
      }
    }
  }

  Image& sheet_;
  GridFrame pixels_;
  geom::Box around_;
  double pen_;
  const RunContext& run_;
};

}  // namespace

std::vector<ShownClass> shown_classes(const seamount::Scene& scene, const GridFrame& frame) {
  if (!scene.frame.crs.empty() && !frame.crs.empty() && scene.frame.crs != frame.crs)
    throw IncompatibleInputs("the terrain and the objects over it are in different coordinate systems");
  const std::vector<ObjectClass>& classes = scene.catalogue.classes;
  std::vector<ShownClass> of_class(classes.size());
  int points = 0;
  for (size_t i = 0; i < classes.size(); ++i) {
    of_class[i].of_class = &classes[i];
    if (classes[i].skeleton == SkeletonKind::point) of_class[i].symbol = symbol_of(points++);
  }
  const geom::Box box = box_of(frame, 0.0);
  for (const SceneObject& object : scene.objects)
    if (is_shown(object.skeleton, box)) of_class[static_cast<size_t>(object.of_class)].objects.push_back(&object);
  std::vector<ShownClass> shown;
  for (const SkeletonKind kind : {SkeletonKind::region, SkeletonKind::curve, SkeletonKind::point}) {
    for (ShownClass& one : of_class)
      if (one.of_class->skeleton == kind && !one.objects.empty()) shown.push_back(std::move(one));
  }
  return shown;
}

double map_pen(double unit) { return std::max({0.5, std::min(1.0, unit / 14.5), unit / 20.0}); }

double symbol_radius(const ObjectClass& of_class, const SceneObject& object, double pixel_m, double pen) {
  return std::clamp(0.5 * of_class.shape.size_m * object.size / pixel_m, 2.0 * pen, 9.0 * pen);
}

void draw_objects(Image& image, const Box& box, const GridFrame& frame, std::span<const ShownClass> shown, double unit,
                  const RunContext& run) {
  Image sheet(box.width, box.height);
  const auto row_bytes = 3 * static_cast<std::ptrdiff_t>(box.width);
  for (int y = 0; y < box.height; ++y) std::copy_n(image.pixel(box.x, box.y + y), row_bytes, sheet.pixel(0, y));
  Painter painter(sheet, frame, unit, run);
  for (const ShownClass& one : shown) painter.draw(one);
  for (int y = 0; y < box.height; ++y) std::copy_n(sheet.pixel(0, y), row_bytes, image.pixel(box.x, box.y + y));
}

void draw_class_sign(Image& image, Vec2 middle, const ShownClass& shown, double unit) {
  const double pen = map_pen(unit), half = 0.55 * unit;
  const Colour colour = shown.of_class->colour;
  if (shown.of_class->skeleton == SkeletonKind::region) {
    Image tinted(1, 1, kPaperColour);
    blend(tinted, 0, 0, colour, 2.0F * kTint);
    fill_box(image, middle.x - half, middle.y - half, middle.x + half, middle.y + half, tinted.colour(0, 0));
    frame_box(image, middle.x - half, middle.y - half, middle.x + half, middle.y + half, 1.6 * pen, colour);
  } else if (shown.of_class->skeleton == SkeletonKind::curve) {
    LineLayer line(image.width, image.height), casing(line);
    const Polyline points = {middle - Vec2{0.8 * unit, 0.0}, middle + Vec2{0.8 * unit, 0.0}};
    line.add(points, 2.4 * pen);
    casing.add(points, 4.0 * pen);
    casing.draw(image, 0, 0, edge_colour(colour), kCasing);
    line.draw(image, 0, 0, colour, 1.0F);
  } else if (shown.dot_px > 0.0) {
    for (const Vec2 at : {Vec2{-0.42, 0.28}, Vec2{0.0, -0.34}, Vec2{0.42, 0.28}})
      fill_disc(image, middle + unit * at, std::max(0.2 * unit, shown.dot_px), colour);
  } else {
    draw_symbol(image, middle, 0.42 * unit, shown.symbol, colour, 0.8 * pen);
  }
}

}  // namespace seamount::render
