// The tools of contour.edit and their parameters (P2 sec. 5 and 6.6). An editing session is a list of them.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/contour/edit/selection.h"

namespace seamount::contour {

/// P2 sec. 5.2, appendices A and B. Each step of the drag is one to one while step_m <= the bound of displacement.h.
struct WarpTool {
  static constexpr std::string_view kTool = "warp";
  static constexpr std::string_view kAbout = "drags contours along a stroke: ridges, valleys, spurs";
  Polyline stroke;
  double radius_m = 500.0;
  double strength = 1.0;
  int k = 2;
  Curve profile;
  std::optional<double> step_m;

  static constexpr auto fields() {
    using P = WarpTool;
    return std::tuple(
        field(&P::stroke, "stroke", "points of the stroke, at least two; a spline runs through them"),
        field(&P::radius_m, "radius_m", "m", between(0.1, 1e6), "radius of the disc that is dragged along the stroke"),
        field(&P::strength, "strength", "", between(0, 1),
              "1 carries what lies at the stroke's beginning to its end, 0 moves nothing"),
        field(&P::k, "k", "", between(1, 16), "how narrow the drag is across the disc: (4x(1-x))^k"),
        field(&P::profile, "profile", "", between(0, 1),
              "drag across the disc from rim (0) to rim (1), in place of k: 0 at both, above 0 in the middle"),
        field(&P::step_m, "step_m", "m", between(1e-3, 1e6),
              "length of the steps of the drag; at most 0.5, 0.64, 0.58 radii for k = 1, 2, 3; half that if derived"));
  }
};

/// P2 sec. 5.3.
struct SlopeTool {
  static constexpr std::string_view kTool = "slope";
  static constexpr std::string_view kAbout = "draws contours towards a curve or pushes them off: steeper, gentler";
  Polyline stroke;
  double radius_m = 500.0;
  double strength = 0.5;
  int k = 1;

  static constexpr auto fields() {
    using P = SlopeTool;
    return std::tuple(
        field(&P::stroke, "stroke", "points of the curve; one alone works about a point"),
        field(&P::radius_m, "radius_m", "m", between(0.1, 1e6), "reach on both sides of the curve"),
        field(&P::strength, "strength", "", between(-1, 1), "above 0 steeper along the curve, below 0 gentler"),
        field(&P::k, "k", "", between(1, 16), "how narrow the ring is that gives way: (4x(1-x))^k"));
  }
};

/// P2 sec. 5.1.
struct SmoothTool {
  static constexpr std::string_view kTool = "smooth";
  static constexpr std::string_view kAbout = "rounds contours off; closed loops keep their area";
  Selection select;
  double radius_m = 100.0;
  double strength = 1.0;
  int rounds = 2;

  static constexpr auto fields() {
    using P = SmoothTool;
    return std::tuple(field(&P::select, "select", "the contours to smooth; all unless said"),
                      field(&P::radius_m, "radius_m", "m", between(0.01, 1e6), "arc to either side that is averaged"),
                      field(&P::strength, "strength", "", between(0, 1), "share of the way to the mean"),
                      field(&P::rounds, "rounds", "", between(1, 100), "how often"));
  }
};

/// P2 sec. 6.6.
struct FractalizeTool {
  static constexpr std::string_view kTool = "fractalize";
  static constexpr std::string_view kAbout = "roughens contours, neighbours alike, by one field of noise";
  std::vector<Polygon> within;
  double amplitude_m = 60.0;
  double wavelength_m = 800.0;
  int octaves = 5;
  double gain = 0.5;
  double fade_m = 300.0;

  static constexpr auto fields() {
    using P = FractalizeTool;
    return std::tuple(
        field(&P::within, "within", "where; everywhere unless said"),
        field(&P::amplitude_m, "amplitude_m", "m", between(0, 1e5), "displacement by the longest wavelength"),
        field(&P::wavelength_m, "wavelength_m", "m", between(1, 1e6), "longest wavelength; each octave halves it"),
        field(&P::octaves, "octaves", "", between(1, 12), "how many wavelengths"),
        field(&P::gain, "gain", "", between(0, 1), "displacement by an octave over that by the one before"),
        field(&P::fade_m, "fade_m", "m", between(0.1, 1e6), "over which it fades to nothing at the border"));
  }
};

struct DeleteTool {
  static constexpr std::string_view kTool = "delete";
  static constexpr std::string_view kAbout = "removes contours";
  Selection select;

  static constexpr auto fields() {
    return std::tuple(field(&DeleteTool::select, "select", "the contours to remove; something must be said"));
  }
};

/// The contours within an outline, for `paste`.
struct CopyTool {
  static constexpr std::string_view kTool = "copy";
  static constexpr std::string_view kAbout = "takes the contours within an outline up for the next paste";
  std::vector<Polygon> within;
  Selection select;

  static constexpr auto fields() {
    using P = CopyTool;
    return std::tuple(field(&P::within, "within", "the outline: one polygon"),
                      field(&P::select, "select", "in place of it: one contour, with all that lies inside it"));
  }
};

struct CutTool : CopyTool {
  static constexpr std::string_view kTool = "cut";
  static constexpr std::string_view kAbout = "copies, then removes what lies inside and closes the ground over it";
};

/// What a pattern is laid on where no place is given.
enum class PasteOn { middle, highest };

struct PasteTool {
  static constexpr std::string_view kTool = "paste";
  static constexpr std::string_view kAbout = "lays a pattern over the contours and blends it in";
  FilePath file;
  std::optional<Vec2> at;
  PasteOn on = PasteOn::middle;
  std::optional<double> longitude_deg;
  std::optional<double> latitude_deg;
  double rotation_deg = 0.0;
  double scale = 1.0;
  double height_scale = 1.0;
  double raise_m = 0.0;
  std::optional<double> blend_m;

  static constexpr auto fields() {
    using P = PasteTool;
    return std::tuple(
        field(&P::file, "file", "pattern to paste, as contour.pattern makes it; else what was copied, else the input"),
        field(&P::at, "at", "where the middle of the pattern comes to lie, in metres; the other ways to say it follow"),
        field(&P::on, "on", "without a place: the middle of the domain, or within the highest contour"),
        field(&P::longitude_deg, "longitude_deg", "deg", between(-540, 540),
              "with latitude_deg: where, on WGS 84; the contours must have a coordinate system"),
        field(&P::latitude_deg, "latitude_deg", "deg", between(-90, 90), "with longitude_deg: where"),
        field(&P::rotation_deg, "rotation_deg", "deg", between(-360, 360), "turn, counter-clockwise"),
        field(&P::scale, "scale", "", between(0.001, 1000), "horizontal scale"),
        field(&P::height_scale, "height_scale", "", between(-1000, 1000), "vertical scale; below 0: hollows for hills"),
        field(&P::raise_m, "raise_m", "m", between(-9000, 9000), "added to the pattern's heights"),
        field(&P::blend_m, "blend_m", "m", between(0, 1e6),
              "width of the ring in which the two grounds blend; two fifths of the way to the middle if derived"));
  }
};

struct FillTool {
  static constexpr std::string_view kTool = "fill";
  static constexpr std::string_view kAbout = "makes the inside of an outline anew, like its surroundings";
  std::vector<Polygon> within;
  Selection select;
  std::vector<FilePath> files;
  double relief = 1.0;
  double wavelength_m = 1000.0;

  static constexpr auto fields() {
    using P = FillTool;
    return std::tuple(
        field(&P::within, "within", "the outline: one polygon"),
        field(&P::select, "select", "in place of it: one contour, whose inside is made anew"),
        field(&P::files, "files",
              "patterns to choose from for a polygon, as contour.pattern makes them; else these contours"),
        field(&P::relief, "relief", "", between(0, 10), "range of heights over that of the surroundings"),
        field(&P::wavelength_m, "wavelength_m", "m", between(1, 1e6), "size of the largest landforms"));
  }
};

using Edit =
    std::variant<WarpTool, SlopeTool, SmoothTool, FractalizeTool, DeleteTool, CopyTool, CutTool, PasteTool, FillTool>;

}  // namespace seamount::contour

template <>
struct seamount::Choices<seamount::contour::PasteOn> {
  static constexpr std::array<std::string_view, 2> names = {"middle", "highest"};
};
