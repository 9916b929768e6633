// The shapes of features, gathered into a drawing in the file's own coordinates. Not part of the public interface.
#pragma once

#include <ogr_geometry.h>

#include <optional>
#include <string>

#include "seamount/io/gdal_call.h"
#include "seamount/model/areas.h"

namespace seamount::io {

/// One feature's numbers, for all of its shapes.
struct FeatureNumbers {
  std::optional<double> value;  ///< absent: a line's or point's own z stands for it
  Attributes attributes;
};

/// How heights are read.
struct HeightRules {
  bool required = false;        ///< a line without one is an error
  double z_unit_m = 1.0;        ///< metres in one unit of z
  std::string fields = "none";  ///< names of the layer's fields, for messages
  std::string field;            ///< the one that is read; empty: none
};

class Collector {
 public:
  explicit Collector(const GdalCall& call) : call_(call) {}

  void set_rules(HeightRules rules) { rules_ = std::move(rules); }
  /// Of the feature whose shapes are added from now on; `id` names it in messages.
  void begin(FeatureNumbers numbers, long long id) { numbers_ = std::move(numbers), id_ = id; }

  /// Throws IoError for collections nested too deeply, too many points, places that are not finite, a missing height.
  void add(const OGRGeometry& geometry, NamedArea& area, int depth = 0);

  Drawing& drawing() { return drawing_; }
  /// Whether some line got a height other than 0 from its z, and whether any got one from z at all.
  bool has_z() const { return lines_by_z_ > 0; }
  bool z_is_level() const { return lines_by_z_ > 1 && !z_differs_; }

 private:
  void count(int points);
  Vec2 finite(Vec2 point) const;
  std::vector<Vec2> points_of(const OGRSimpleCurve& curve);
  Ring ring_of(const OGRLinearRing& from);
  void add_polygon(const OGRPolygon& from, NamedArea& area);
  void add_point(const OGRPoint& from);
  void add_line(const OGRLineString& from);
  double height_of(const OGRLineString& line);
  [[noreturn]] void fail_without_height(const OGRLineString& line) const;

  const GdalCall& call_;
  Drawing drawing_;
  HeightRules rules_;
  FeatureNumbers numbers_;
  long long id_ = 0;
  size_t total_ = 0;
  size_t lines_by_z_ = 0;
  bool z_differs_ = false;
};

}  // namespace seamount::io
