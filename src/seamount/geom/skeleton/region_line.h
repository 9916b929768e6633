// One region (region_snake.h) while it is fitted: its raster, its energy, its steps.
#pragma once

#include <vector>

#include "seamount/geom/skeleton/elastic_line.h"
#include "seamount/geom/skeleton/field_raster.h"
#include "seamount/geom/skeleton/region_snake.h"
#include "seamount/geom/skeleton/step_care.h"

namespace seamount::geom {

class RegionLine {
 public:
  /// area_m2: the target, 0 for none; unit_m2: A of region_snake.h. least_raster_m: of the raster unless it is
  /// given; vertices are no nearer than least_spacing_m.
  RegionLine(const RegionOptions& options, double area_m2, double unit_m2, Vec2 middle, double least_raster_m,
             double least_spacing_m);

  std::vector<Vec2> points;
  std::vector<float> hold;  ///< as many as points
  std::vector<RegionFit::Step> steps;
  FieldRaster raster;

  bool rests() const { return care_.rests; }
  bool has_target() const { return target_m2_ > 0.0; }
  double target() const { return target_m2_; }
  double spacing_m() const { return spacing_m_; }
  double radius_m() const;
  double area() const { return signed_area(points); }
  double mean_field() const;
  /// What the raster must cover for the next step of `line`.
  Box reach_of(std::span<const Vec2> line) const;
  /// Takes the unit of Gamma and its floor from the raster as it is.
  void measure(double field_unit);
  /// A disc around a place, as large as fits, at most of a quarter of the target's radius. Counter-clockwise.
  bool seed(Vec2 at);
  /// Vertices about spacing_m() apart along the outline, those that are held among them.
  void spread();
  bool is_uneven() const;
  /// A descent towards an area between the one it has and the target: at most `growth` times as large or small.
  void start(double growth);
  const std::vector<Vec2>& propose();
  /// Goes there if that lowers the energy, else is more careful from now on; rests where the raster does not reach.
  void judge(double least_gain);

 private:
  struct Measures {
    double area = 0.0, length = 0.0, inside = 0.0, border = 0.0;
  };
  Measures measure(std::span<const Vec2> line) const;
  double energy(std::span<const Vec2> line, double aim_m2) const;
  double shape_energy(double area, double aim_m2) const;
  std::vector<Vec2> slope_of_energy(std::vector<Vec2>& slope_of_area) const;
  bool keep_fit(std::vector<char>& moved);

  ElasticLine elastic_;
  double inside_, border_, shape_, target_m2_, unit_m2_, spacing_m_;
  double aim_m2_ = 0.0;
  double field_unit_ = 1.0;
  int quadrature_ = 1;  ///< pieces of an edge
  StepCare care_;
  std::vector<Vec2> proposal_;
};

}  // namespace seamount::geom
