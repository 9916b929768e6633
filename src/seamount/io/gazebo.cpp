#include "seamount/io/gazebo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gazebo_sdf.h"
#include "seamount/io/gazebo_things.h"
#include "seamount/io/image_file.h"
#include "seamount/io/info.h"
#include "seamount/io/mesh_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/projection.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) { return fs::path(path).replace_extension().string(); }

std::string in_folder(const std::string& path, const char* name) { return folder_of(path) + "/" + name; }

/// Where the middle of a frame lies on the globe, and how far its y is turned from true north, anticlockwise.
std::optional<sdf::GlobePlace> place_of(const GridFrame& frame) {
  if (frame.crs.empty()) return std::nullopt;
  const Vec2 middle{frame.x(0.5 * (frame.width - 1)), frame.y(0.5 * (frame.height - 1))};
  constexpr double kNorth_m = 100.0;
  const std::vector<Vec2> degrees = to_lonlat({middle, {middle.x, middle.y + kNorth_m}}, frame.crs);
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  const double latitude = degrees[0].y * kRadians;
  // Radii of curvature of WGS 84 along the meridian and across, up to a common factor.
  const double squeeze = 1.0 - 0.00669437999014 * std::sin(latitude) * std::sin(latitude);
  const double north = (degrees[1].y - degrees[0].y) * (1.0 - 0.00669437999014) / squeeze;
  const double east = (degrees[1].x - degrees[0].x) * std::cos(latitude);
  return sdf::GlobePlace{degrees[0].y, degrees[0].x, -std::atan2(east, north) / kRadians};
}

void tell_origin(const GridFrame& frame, const std::optional<sdf::GlobePlace>& place, const RunContext& run) {
  const auto tidy = [](double metres) { return std::round(metres * 100) / 100 + 0.0; };
  const double x = tidy(frame.x(0.5 * (frame.width - 1))), y = tidy(frame.y(0.5 * (frame.height - 1)));
  run.say(
      fmt::format("the world's origin is x {:.2f} m, y {:.2f} m of the terrain, at sea level", x, y) +
      (place ? fmt::format(" (latitude {:.6f}, longitude {:.6f})", place->latitude_deg, place->longitude_deg) : ""));
}

void write_model(const sdf::Ground& ground, const std::string& path) {
  const std::string name = fs::path(folder_of(path)).filename().string();
  write_text(in_folder(path, "model.config"), sdf::model_config(name));
  write_text(in_folder(path, "model.sdf"), sdf::model_file(ground, name));
}

void write_world(const sdf::Ground& ground, const GridFrame& frame, double low_m, const std::string& path,
                 const GazeboOptions& options, const RunContext& run) {
  sdf::World world;
  world.name = fs::path(folder_of(path)).filename().string();
  world.place = place_of(frame);
  world.sea = options.water && low_m < 0;
  world.buoyancy = options.buoyancy;
  if (options.things != nullptr) world.things = write_gazebo_things(*options.things, frame, path, options, run);
  write_text(path, sdf::world_file(world, ground));
  tell_origin(frame, world.place, run);
}

/// Codes 0 and 65535 are both used: Gazebo stretches the highest code that it finds to the full height.
HeightRange full_range(HeightRange extremes) {
  return extremes.high_m > extremes.low_m ? extremes : HeightRange{extremes.high_m - 1.0, extremes.high_m};
}

void write_codes8(const HeightField& heights, HeightRange range, const std::string& path) {
  std::vector<uint8_t> codes(heights.size());
  const double scale = 255.0 / (range.high_m - range.low_m);
  std::transform(heights.cells().begin(), heights.cells().end(), codes.begin(), [&](float z) {
    return static_cast<uint8_t>(std::clamp(std::floor((z - range.low_m) * scale + 0.5), 0.0, 255.0));
  });
  write_bytes(path, encode_png8(codes, heights.width(), heights.height(), 1));
}

/// The picture and its side-car.
void write_height_map(const HeightField& heights, HeightRange range, const sdf::Ground& ground, const std::string& path,
                      const GazeboOptions& options) {
  if (options.bits == 8) {
    write_codes8(heights, range, path);
  } else {
    write_codes(to_codes(heights, range), path);
  }
  const HeightRange extremes = finite_range(heights);
  Sidecar sidecar;
  sidecar.frame = heights.frame();
  sidecar.min_m = extremes.low_m;
  sidecar.max_m = extremes.high_m;
  sidecar.range = range;
  sidecar.target = "gazebo";
  sidecar.import = {{"size", sdf::heightmap_size(ground)}, {"pos", sdf::heightmap_pos(ground)}};
  sidecar.provenance = options.provenance;
  write_sidecar(sidecar, path);
}

}  // namespace

const std::vector<int>& gazebo_sizes() {
  static const std::vector<int> kSizes = {33, 65, 129, 257, 513, 1025, 2049, 4097};
  return kSizes;
}

std::vector<std::string> gazebo_files(const std::string& path, bool mesh, bool texture, bool things) {
  std::vector<std::string> files = {path, in_folder(path, "model.config"), in_folder(path, "model.sdf")};
  const auto add = [&](const char* name) { files.push_back(in_folder(path, name)); };
  if (mesh) {
    add("ground.obj"), add("ground.mtl");
    if (texture) add("ground.png");
    if (things) add("shape_*_lod*.obj"), add("shape_*_lod*.mtl");
    return files;
  }
  add("height.png"), add("height.png.json");
  if (texture) add("ground.png"), add("flat_normal.png");
  return files;
}

void write_gazebo(const HeightField& heights, const std::string& path, const GazeboOptions& options,
                  const RunContext& run) {
  const auto& sizes = gazebo_sizes();
  if (heights.width() != heights.height() || std::find(sizes.begin(), sizes.end(), heights.width()) == sizes.end())
    throw InvalidArgument("size", fmt::format("{} x {} is not a size that Gazebo reads; allowed are squares of: {}",
                                              heights.width(), heights.height(), fmt::join(sizes, ", ")));
  if (options.bits != 8 && options.bits != 16)
    throw InvalidArgument("bits", fmt::format("{} is neither 8 nor 16", options.bits));
  const HeightRange extremes = finite_range(heights), range = full_range(extremes);
  sdf::Ground ground;
  ground.size_m = heights.cell_m() * (heights.width() - 1);
  ground.low_m = range.low_m;
  ground.range_m = range.high_m - range.low_m;
  ground.textured = options.texture != nullptr;
  ground.folder = fs::path(folder_of(path)).filename().string();
  write_height_map(heights, range, ground, in_folder(path, "height.png"), options);
  if (options.bits == 8)
    run.say(fmt::format("heights in 8 bits are in steps of {} m", short_number(ground.range_m / 255)));
  if (options.texture != nullptr) {
    write_png(*options.texture, in_folder(path, "ground.png"));
    write_png(Image(4, 4, {127, 127, 255}), in_folder(path, "flat_normal.png"));
  }
  write_model(ground, path);
  write_world(ground, heights.frame(), extremes.low_m, path, options, run);
}

void write_gazebo(const Mesh& mesh, const GridFrame& frame, const std::string& path, const GazeboOptions& options,
                  const RunContext& run) {
  write_mesh(mesh, in_folder(path, "ground.obj"), {.texture = options.texture, .provenance = options.provenance});
  sdf::Ground ground;
  ground.mesh = true;
  ground.size_m = std::max(frame.width_m(), frame.height_m());
  ground.folder = fs::path(folder_of(path)).filename().string();
  float low_m = 0;
  const std::vector<float>& positions = mesh.parts[0].positions;
  for (size_t i = 2; i < positions.size(); i += 3) low_m = std::min(low_m, positions[i]);
  write_model(ground, path);
  write_world(ground, frame, low_m, path, options, run);
}

}  // namespace seamount::io
