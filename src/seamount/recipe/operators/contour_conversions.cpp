// Registration of what leads from files and terrains to contours and back.
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/recipe/contour_file.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

constexpr const char* const kLayerHelp = "layer of a file with several; empty: the first that fits";
constexpr const char* const kFeatureHelp = "only the features of this name, in any letter case; empty: all";
constexpr const char* const kHeightHelp = "field with the heights; empty: one named like a height, else z";
constexpr const char* const kCrsHelp =
    "coordinate system of a file that says none or a wrong one: EPSG:32627, or local for metres on no map";

// drawing.import and contour.import have no algorithm of their own: they are the vector reader with its options as
// parameters.
struct VectorImportParams {
  FilePath file;
  std::string layer;
  std::string feature;
  std::string height_field;
  std::string crs;

  static constexpr auto fields() {
    using P = VectorImportParams;
    return std::tuple(field(&P::file, "file", "GeoJSON, GeoPackage, Shapefile or SVG file"),
                      field(&P::layer, "layer", kLayerHelp), field(&P::feature, "feature", kFeatureHelp),
                      field(&P::height_field, "height_field", kHeightHelp), field(&P::crs, "crs", kCrsHelp));
  }
};

std::pair<std::string, io::VectorOptions> file_and_options(const VectorImportParams& params, const Call& call) {
  if (params.file.path.empty()) throw InvalidArgument("file", "is missing");
  return {call.resolve(params.file),
          {.feature = params.feature, .layer = params.layer, .height_field = params.height_field, .crs = params.crs}};
}

Drawing import_drawing(const VectorImportParams& params, const Call& call) {
  const auto [path, options] = file_and_options(params, call);
  return io::read_drawing(path, options, call.run);
}

ContourSet import_contours(const VectorImportParams& params, const Call& call) {
  const auto [path, options] = file_and_options(params, call);
  return contours_of_file(path, options, call.domain, call.run);
}

void add_imports(Registry& registry) {
  registry.add(make_operator<VectorImportParams>(
      {.name = "drawing.import", .summary = "Areas, lines and points from a file, in metres"}, inputs(),
      outputs(out<kinds::Drawing>("drawing", "areas, lines and points")), import_drawing));
  registry.add(make_operator<VectorImportParams>(
      {.name = "contour.import",
       .summary = "Contours from a file of lines with heights, open ones closed at the sheet's border"},
      inputs(), outputs(out<kinds::Contours>("contours", "nested closed contours")), import_contours));
}

}  // namespace

void add_contour_conversions(Registry& registry) {
  add_imports(registry);
  registry.add(make_operator<contour::ExtractParams>(
      {.name = "contour.extract",
       .summary = "The contours of a network or of a terrain, closed and nested",
       .source = "P2 sec. 4.4",
       .needs_one = true},
      inputs(optional_in<kinds::Tin>("tin", "a network with heights"),
             with_voids(optional_in<kinds::Terrain>("terrain", "or heights in metres"))),
      outputs(out<kinds::Contours>("contours", "nested closed contours")),
      [](const contour::ExtractParams& params, const Call& call, const Tin* tin, const HeightField* terrain) {
        return contour::extract(tin, terrain, params, call.run);
      }));
  registry.add(make_operator<contour::ReconstructParams>(
      {.name = "contour.reconstruct",
       .revision = 4,
       .summary = "A terrain from its contours or from a network, at any resolution",
       .source = "P2 sec. 3.2",
       .needs_one = true},
      inputs(optional_in<kinds::Contours>("contours", "nested closed contours"),
             optional_in<kinds::Tin>("tin", "or a network with heights")),
      outputs(out<kinds::Terrain>("terrain", "heights in metres")),
      [](const contour::ReconstructParams& params, const Call& call, const ContourSet* contours, const Tin* tin) {
        return contour::reconstruct(contours, tin, params, call.run);
      }));
}

}  // namespace seamount::recipe
