#include "seamount/io/gazebo_things.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>
#include <set>

#include "seamount/io/atomic_file.h"
#include "seamount/io/gazebo_sdf.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;

std::string shape_stem(const Thing& thing) { return fmt::format("shape_{}_lod{}", thing.shape, thing.level); }

/// Mean colour of the triangles from one index to another, 0 to 1.
std::array<double, 3> mean_colour(const ThingMesh& mesh, size_t begin, size_t end) {
  std::array<double, 3> sum{};
  for (size_t i = begin; i < end; ++i) {
    const Colour& c = mesh.colours[mesh.indices[i]];
    sum[0] += c.r, sum[1] += c.g, sum[2] += c.b;
  }
  for (double& s : sum) s /= 255.0 * static_cast<double>(std::max<size_t>(1, end - begin));
  return sum;
}

void write_shape(const ThingMesh& mesh, const std::string& stem) {
  const std::string name = fs::path(stem).filename().string();
  std::string materials;
  const auto material = [&](const char* what, const std::array<double, 3>& c) {
    materials += fmt::format("newmtl {0}\nKa {1:.3f} {2:.3f} {3:.3f}\nKd {1:.3f} {2:.3f} {3:.3f}\nKs 0 0 0\n", what,
                             c[0], c[1], c[2]);
  };
  material("solid", mean_colour(mesh, 0, mesh.solid));
  material("leaves", mean_colour(mesh, mesh.solid, mesh.indices.size()));
  std::string text = "mtllib " + name + ".mtl\n";
  for (size_t i = 0; i < mesh.positions.size(); i += 3)
    text += fmt::format("v {} {} {}\n", mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
  for (size_t i = 0; i < mesh.normals.size(); i += 3)
    text += fmt::format("vn {:.4f} {:.4f} {:.4f}\n", mesh.normals[i], mesh.normals[i + 1], mesh.normals[i + 2]);
  const auto faces = [&](size_t begin, size_t end, bool turned) {
    for (size_t i = begin; i < end; i += 3) {
      const uint32_t a = mesh.indices[i] + 1, b = mesh.indices[i + 1] + 1, c = mesh.indices[i + 2] + 1;
      text += turned ? fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, c, b)
                     : fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
    }
  };
  if (mesh.solid > 0) text += "usemtl solid\n";
  faces(0, mesh.solid, false);
  if (mesh.solid < mesh.indices.size()) text += "usemtl leaves\n";
  faces(mesh.solid, mesh.indices.size(), false);
  faces(mesh.solid, mesh.indices.size(), true);  // leaves have two sides
  write_text(stem + ".obj", text);
  write_text(stem + ".mtl", materials);
}

}  // namespace

std::string write_gazebo_things(const Things& things, const GridFrame& frame, const std::string& path,
                                const GazeboOptions& options, const RunContext& run) {
  const std::string folder = fs::path(path).replace_extension().string();
  const std::string uri = fs::path(folder).filename().string() + "/";
  const double x = frame.west_m + 0.5 * frame.width_m(), y = frame.north_m - 0.5 * frame.height_m();
  std::vector<size_t> largest(things.things.size());
  std::iota(largest.begin(), largest.end(), size_t{0});
  const auto size = [&](size_t i) { return things.things[i].scale * things.shapes[things.things[i].shape].height_m; };
  std::stable_sort(largest.begin(), largest.end(), [&](size_t a, size_t b) { return size(a) > size(b); });
  std::vector<bool> collides(things.things.size(), false);
  for (size_t k = 0; k < largest.size() && k < static_cast<size_t>(options.max_collisions); ++k)
    collides[largest[k]] = true;
  std::string text;
  std::set<std::string> written;
  for (size_t i = 0; i < things.things.size(); ++i) {
    run.check_cancelled();
    const Thing& thing = things.things[i];
    const ThingShape& shape = things.shapes[thing.shape];
    if (written.insert(shape_stem(thing)).second)
      write_shape(shape.levels[thing.level], folder + "/" + shape_stem(thing));
    // Crowns can be flown under, feet cannot be walked through.
    const double wide = thing.scale * std::max<double>(2.0 * shape.foot_m, 0.02 * shape.height_m);
    text += sdf::thing_model({.name = fmt::format("{}_{}", shape.name, i),
                              .mesh = uri + shape_stem(thing) + ".obj",
                              .place = {thing.place.x - x, thing.place.y - y, thing.z_m},
                              .rotation = thing.rotation,
                              .scale = thing.scale,
                              .collides = collides[i],
                              .box = {wide, wide, thing.scale * shape.height_m}});
  }
  if (things.things.size() > static_cast<size_t>(options.max_collisions))
    run.say(fmt::format("max_collisions: the {} largest of {} things can be bumped into, the others are only seen",
                        options.max_collisions, things.things.size()));
  return text;
}

}  // namespace seamount::io
