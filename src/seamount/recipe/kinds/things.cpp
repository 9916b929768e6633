// things: instances of models on a terrain.
#include <algorithm>
#include <cmath>

#include "seamount/io/reproject.h"
#include "seamount/io/things_info.h"
#include "seamount/recipe/formats/formats.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

void write_things(Writer& writer, const seamount::Things& things) {
  writer.plain(static_cast<uint64_t>(things.shapes.size()));
  for (const ThingShape& shape : things.shapes) {
    writer.text(shape.name);
    writer.plain(shape.height_m);
    writer.plain(shape.radius_m);
    writer.plain(shape.foot_m);
    writer.plain(static_cast<uint64_t>(shape.levels.size()));
    for (const ThingMesh& mesh : shape.levels) {
      writer.list(mesh.positions);
      writer.list(mesh.normals);
      writer.list(mesh.colours);
      writer.list(mesh.indices);
      writer.plain(static_cast<uint64_t>(mesh.solid));
    }
  }
  writer.plain(static_cast<uint64_t>(things.things.size()));
  for (const Thing& thing : things.things) {
    writer.plain(thing.place);
    writer.plain(thing.z_m);
    writer.plain(thing.rotation);
    writer.plain(thing.scale);
    writer.plain(thing.health);
    writer.plain(thing.tint);
    writer.plain(thing.shape);
    writer.plain(thing.level);
  }
  writer.text(things.crs);
  writer.plain(static_cast<uint8_t>(things.ground.empty() ? 0 : 1));
  if (!things.ground.empty()) write_grid(writer, things.ground);
}

ThingMesh read_mesh(Reader& reader) {
  ThingMesh mesh;
  mesh.positions = reader.list<float>();
  mesh.normals = reader.list<float>();
  mesh.colours = reader.list<Colour>();
  mesh.indices = reader.list<uint32_t>();
  mesh.solid = reader.plain<uint64_t>();
  const bool fits = mesh.normals.size() == mesh.positions.size() && mesh.colours.size() == mesh.vertex_count() &&
                    mesh.solid <= mesh.indices.size();
  if (!fits || std::any_of(mesh.indices.begin(), mesh.indices.end(),
                           [&](uint32_t index) { return index >= mesh.vertex_count(); }))
    throw Damaged();
  return mesh;
}

seamount::Things read_things(Reader& reader) {
  seamount::Things things;
  things.shapes.resize(reader.count(24));
  for (ThingShape& shape : things.shapes) {
    shape.name = reader.text();
    shape.height_m = reader.plain<float>();
    shape.radius_m = reader.plain<float>();
    shape.foot_m = reader.plain<float>();
    const auto levels = reader.count(40);
    for (uint64_t i = 0; i < levels; ++i) shape.levels.push_back(read_mesh(reader));
  }
  things.things.resize(reader.count(60));
  for (Thing& thing : things.things) {
    thing.place = reader.plain<Vec2>();
    thing.z_m = reader.plain<double>();
    thing.rotation = reader.plain<std::array<float, 4>>();
    thing.scale = reader.plain<float>();
    thing.health = reader.plain<float>();
    thing.tint = reader.plain<float>();
    thing.shape = reader.plain<uint32_t>();
    thing.level = reader.plain<uint32_t>();
    if (thing.shape >= things.shapes.size() || thing.level >= things.shapes[thing.shape].levels.size()) throw Damaged();
  }
  things.crs = reader.text();
  if (reader.plain<uint8_t>() != 0) things.ground = read_grid<float>(reader);
  return things;
}

size_t size_of(const seamount::Things& things) {
  size_t bytes = things.things.size() * sizeof(Thing) + things.ground.size() * sizeof(float);
  for (const ThingShape& shape : things.shapes)
    for (const ThingMesh& mesh : shape.levels) bytes += mesh.vertex_count() * 27 + mesh.indices.size() * 4;
  return bytes;
}

std::optional<Extent> extent_of(const seamount::Things& things) {
  std::optional<Extent> extent;
  for (const Thing& thing : things.things) {
    const Extent place{things.crs, thing.place.x, thing.place.y, thing.place.x, thing.place.y};
    if (extent)
      extent->include(place);
    else
      extent = place;
  }
  return extent;
}

/// Places and ground in another system; how things are turned stays, as heights do.
seamount::Things bring(const seamount::Things& things, const Destination& to) {
  if (to.frame.crs.empty() || to.frame.crs == things.crs) return things;
  seamount::Drawing places;
  places.crs = things.crs;
  for (const Thing& thing : things.things) places.points.push_back({thing.place});
  places = io::in_system(std::move(places), to.frame.crs);
  seamount::Things moved = things;
  moved.crs = to.frame.crs;
  for (size_t i = 0; i < moved.things.size(); ++i) moved.things[i].place = places.points[i].place;
  if (!moved.ground.empty()) moved.ground = io::in_system(things.ground, to.frame.crs, to.run);
  return moved;
}

}  // namespace

const Kind& kinds::Things::kind() {
  static const Kind kind = make_kind<seamount::Things>({
      .name = "things",
      .about = "models of trees, corals, rocks ... and where they stand on a terrain",
      .files = {".glb"},
      .reads = {},
      .frame = {},
      .extent = extent_of,
      .bring = bring,
      .bytes = size_of,
      .write = write_things,
      .read = read_things,
      .read_file = {},
      .info = io::describe_placements,
  });
  return kind;
}

void kinds::Things::add_formats(Registry& registry) { add_things_formats(registry); }

}  // namespace seamount::recipe
