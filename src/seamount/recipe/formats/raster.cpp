#include "seamount/io/raster.h"

#include "seamount/recipe/format.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

struct RasterParams {
  std::optional<double> low_m;
  std::optional<double> high_m;
  bool cloud_optimised = false;

  static constexpr auto fields() {
    using P = RasterParams;
    return std::tuple(
        field(&P::low_m, "low_m", "m", between(-20000, 20000),
              "16-bit files: height of code 0; the lowest height if absent"),
        field(&P::high_m, "high_m", "m", between(-20000, 20000),
              "16-bit files: height of code 65535; the highest height if absent"),
        field(&P::cloud_optimised, "cloud_optimised", "GeoTIFF with overviews, laid out for reading over the network"));
  }
};

/// Heights beyond the codes of a 16-bit file become its lowest or highest.
void say_clamped(const Value& value, io::HeightRange range, const std::string& path, const RunContext& run) {
  if (io::can_hold_voids(path)) return;
  const Grid<float>& grid = value.is<kinds::Field>() ? value.get<kinds::Field>() : value.get<kinds::Terrain>();
  int64_t below = 0, above = 0;
  for (const float z : grid.cells()) {
    below += z < range.low_m ? 1 : 0;
    above += z > range.high_m ? 1 : 0;
  }
  if (below + above == 0) return;
  run.say(std::to_string(below) + " cells below low_m and " + std::to_string(above) +
          " above high_m are written as these");
}

void write_raster(const RasterParams& params, const OutputCall& call) {
  const io::WriteOptions options{.range = height_range(params.low_m, params.high_m),
                                 .cloud_optimised = params.cloud_optimised,
                                 .provenance = call.provenance};
  if (options.range) say_clamped(call.value, *options.range, call.path, call.run);
  const Value value =
      io::can_hold_voids(call.path) ? call.value : call.value.without_voids(call.value.kind().name, call.run);
  if (value.is<kinds::Field>()) return io::write_field(value.get<kinds::Field>(), call.path, options);
  io::write_heights(value.get<kinds::Terrain>(), call.path, options);
}

}  // namespace

std::optional<io::HeightRange> height_range(const std::optional<double>& low_m, const std::optional<double>& high_m) {
  if (low_m.has_value() != high_m.has_value()) throw InvalidArgument("low_m", "low_m and high_m go together");
  if (!low_m) return std::nullopt;
  if (*low_m >= *high_m)
    throw InvalidArgument("low_m", format_number(*low_m) + " is not below high_m = " + format_number(*high_m));
  return io::HeightRange{*low_m, *high_m};
}

void add_raster_format(Registry& registry) {
  const std::vector<std::string> files = {".tif", ".asc", ".png", ".exr", ".r16", ".raw", ".r32", ".npy"};
  OutputFormat format =
      make_format<RasterParams>({"raster",
                                 "heights or another scalar: GeoTIFF, ASC, 16-bit PNG, EXR, R16, R32, NPY",
                                 files,
                                 files,
                                 {&kinds::Terrain::kind(), &kinds::Field::kind()}},
                                write_raster);
  format.files = [](const Json&, const Kind&, const std::string& path) { return io::written_files(path); };
  registry.add(std::move(format));
}

}  // namespace seamount::recipe
