// tin: a triangulated network, with or without heights.
#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/text.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/polygon/frame_around.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/projection.h"
#include "seamount/io/reproject.h"
#include "seamount/io/tin_file.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

void write_tin(Writer& writer, const Tin& tin) {
  write_frame(writer, tin.frame);
  writer.list(tin.nodes);
  writer.list(tin.triangles);
  writer.plain(static_cast<uint64_t>(tin.regions.size()));
  for (const TinRegion& region : tin.regions) {
    writer.text(region.name);
    writer.plain(region.parent);
    writer.list(region.outline);
    writer.plain(static_cast<uint8_t>(region.height_m.has_value()));
    writer.plain(region.height_m.value_or(0.0));
    writer.plain(static_cast<uint8_t>(region.basin));
    writer.plain(static_cast<uint8_t>(region.peak_m.has_value()));
    writer.plain(region.peak_m.value_or(0.0));
  }
  writer.list(tin.region);
  writer.list(tin.rank);
  writer.list(tin.bed_m);
  writer.list(tin.height_m);
}

Tin read_tin(Reader& reader) {
  Tin tin;
  tin.frame = read_frame(reader);
  tin.nodes = reader.list<Vec2>();
  tin.triangles = reader.list<std::array<int32_t, 3>>();
  tin.regions.resize(reader.count(8));
  for (TinRegion& region : tin.regions) {
    region.name = reader.text();
    region.parent = reader.plain<int>();
    region.outline = reader.list<Vec2>();
    const bool has_height = reader.plain<uint8_t>() != 0;
    const auto height = reader.plain<double>();
    if (has_height) region.height_m = height;
    region.basin = reader.plain<uint8_t>() != 0;
    const bool has_peak = reader.plain<uint8_t>() != 0;
    const auto peak = reader.plain<double>();
    if (has_peak) region.peak_m = peak;
  }
  tin.region = reader.list<int32_t>();
  tin.rank = reader.list<float>();
  tin.bed_m = reader.list<float>();
  tin.height_m = reader.list<float>();
  return tin;
}

size_t size_of(const Tin& tin) {
  return tin.nodes.size() * sizeof(Vec2) + tin.triangles.size() * sizeof(tin.triangles[0]) +
         (tin.region.size() + tin.rank.size() + tin.height_m.size()) * sizeof(float);
}

/// A network without a frame of its own lies in the call's, or around its nodes.
Tin read_tin_file(const FileCall& call) {
  Tin tin = io::read_tin(call.path);
  if (tin.frame.cells() == 0) {
    const std::string crs = tin.frame.crs;
    tin.frame = geom::frame_around(tin.nodes, call.frame);
    if (!crs.empty()) tin.frame.crs = crs;
  }
  if (const auto defect = geom::find_tin_defect(tin)) throw IoError(call.path, *defect);
  return tin;
}

/// Where the nodes lie.
void describe_place(io::FileInfo& info, const Tin& tin) {
  if (!tin.nodes.empty()) {
    Vec2 low = tin.nodes[0], high = low;
    for (const Vec2& node : tin.nodes) {
      low = {std::min(low.x, node.x), std::min(low.y, node.y)};
      high = {std::max(high.x, node.x), std::max(high.y, node.y)};
    }
    const auto between = [](double from, double to) {
      const auto shown = [](double metres) { return format_number(std::round(100 * metres) / 100); };
      return shown(from) + " to " + shown(to) + " m";
    };
    info.emplace_back("extent", io::short_number(high.x - low.x) + " m x " + io::short_number(high.y - low.y) + " m");
    info.emplace_back("x", between(low.x, high.x));
    info.emplace_back("y", between(low.y, high.y));
  }
  info.emplace_back("coordinate system", tin.frame.crs.empty() ? "none (local metres)" : io::crs_name(tin.frame.crs));
}

std::optional<io::FileInfo> describe(const std::string& path) {
  if (io::extension_of(path) != ".ply") return std::nullopt;
  const Tin tin = io::read_tin(path);
  io::FileInfo info{{"format", "network"},
                    {"nodes", std::to_string(tin.nodes.size())},
                    {"triangles", std::to_string(tin.triangles.size())}};
  if (!tin.regions.empty()) info.emplace_back("regions", std::to_string(tin.regions.size()));
  if (tin.height_m.empty()) {
    info.emplace_back("heights", "none");
  } else {
    const auto [low, high] = std::minmax_element(tin.height_m.begin(), tin.height_m.end());
    info.emplace_back("heights", io::short_number(*low) + " m to " + io::short_number(*high) + " m");
  }
  describe_place(info, tin);
  return info;
}

}  // namespace

const Kind& kinds::Tin::kind() {
  static const Kind kind = make_kind<seamount::Tin>({
      .name = "tin",
      .about = "a triangulated network, its nodes with region, rank and height",
      .files = {".ply"},
      .reads = {".ply"},
      .frame = [](const seamount::Tin& tin) { return &tin.frame; },
      .bring = [](const seamount::Tin& tin, const Destination& to) { return io::in_system(tin, to.frame.crs); },
      .bytes = size_of,
      .write = write_tin,
      .read = read_tin,
      .read_file = read_tin_file,
      .info = describe,
  });
  return kind;
}

void kinds::Tin::add_formats(Registry& registry) {
  registry.add(make_format<NoParams>(
      {"network", "a network as PLY: x, y, z, and of each node its region and rank", {".ply"}, {".ply"}, {&kind()}},
      [](const NoParams&, const OutputCall& call) { io::write_tin(call.value.get<Tin>(), call.path); }));
}

}  // namespace seamount::recipe
