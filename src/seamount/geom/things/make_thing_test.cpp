// Laws of every kind of thing, for many seeds, all levels and several healths.
#include "seamount/geom/things/make_thing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "seamount/geom/things/point3.h"
#include "seamount/geom/things/tone.h"

namespace seamount::geom {
namespace {

constexpr int kForms = static_cast<int>(Choices<ThingForm>::names.size()) - 1;  // without files
constexpr int kSeeds = 50;

std::string_view name_of(int form) { return Choices<ThingForm>::names[static_cast<size_t>(form)]; }

ThingParams params_of(int form) {
  ThingParams params;
  params.shape = static_cast<ThingForm>(form);
  return params;
}

Point3 at(const std::vector<float>& values, uint32_t i) {
  return {values[3 * size_t{i}], values[3 * size_t{i} + 1], values[3 * size_t{i} + 2]};
}

/// What is wrong with a mesh; empty: nothing.
std::string defect(const ThingMesh& mesh, double size) {
  if (mesh.triangle_count() == 0) return "no triangles";
  if (mesh.normals.size() != mesh.positions.size() || mesh.colours.size() != mesh.vertex_count()) return "sizes differ";
  if (mesh.solid % 3 != 0 || mesh.solid > mesh.indices.size()) return "solid part";
  for (const float v : mesh.positions)
    if (!std::isfinite(v)) return "a position is no number";
  for (uint32_t i = 0; i < mesh.vertex_count(); ++i)
    if (!(std::abs(length(at(mesh.normals, i)) - 1.0) < 1e-4)) return "a normal is not of unit length";
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k)
      if (mesh.indices[i + k] >= mesh.vertex_count()) return "an index leads nowhere";
    const Point3 a = at(mesh.positions, mesh.indices[i]), b = at(mesh.positions, mesh.indices[i + 1]),
                 c = at(mesh.positions, mesh.indices[i + 2]);
    if (!(length(cross(b - a, c - a)) > 1e-11 * size * size)) return "a triangle has no area";
  }
  return "";
}

/// Closed parts: each edge is run once in each direction, and encloses a positive volume.
std::string open_defect(const ThingMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  std::vector<uint32_t> group(mesh.vertex_count());
  for (uint32_t i = 0; i < group.size(); ++i) group[i] = i;
  const auto root = [&](uint32_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (size_t i = 0; i < mesh.solid; i += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = mesh.indices[i + k], b = mesh.indices[i + (k + 1) % 3];
      if (++edges[{a, b}] > 1) return "an edge is run twice in one direction";
      group[root(a)] = root(b);
    }
  }
  for (const auto& [edge, count] : edges)
    if (!edges.contains({edge.second, edge.first})) return "an edge has one side";
  std::map<uint32_t, double> volumes;
  for (size_t i = 0; i < mesh.solid; i += 3) {
    const uint32_t r = root(mesh.indices[i]);
    const Point3 o = at(mesh.positions, r);
    volumes[r] += dot(at(mesh.positions, mesh.indices[i]) - o,
                      cross(at(mesh.positions, mesh.indices[i + 1]) - o, at(mesh.positions, mesh.indices[i + 2]) - o));
  }
  for (const auto& [part, volume] : volumes)
    if (!(volume > 0.0)) return "a part is inside out";
  return "";
}

struct Box {
  double low = 1e30, high = -1e30, wide = 0.0;
};
Box box_of(const ThingMesh& mesh) {
  Box box;
  for (uint32_t i = 0; i < mesh.vertex_count(); ++i) {
    const Point3 p = at(mesh.positions, i);
    box.low = std::min(box.low, p.z);
    box.high = std::max(box.high, p.z);
    box.wide = std::max({box.wide, 2.0 * std::abs(p.x), 2.0 * std::abs(p.y)});
  }
  return box;
}

TEST(MakeThing, MeshesAreValidForManySeedsAndLevels) {
  for (int form = 0; form < kForms; ++form) {
    const ThingParams params = params_of(form);
    const ThingSize size = size_of(params);
    for (int seed = 0; seed < kSeeds; ++seed) {
      for (int level = 0; level < 3; ++level) {
        const double health = seed % 3 == 0 ? 1.0 : seed % 3 == 1 ? 0.5 : 0.0;
        const ThingMesh mesh = make_thing_mesh(params, {static_cast<uint64_t>(seed)}, seed % 7, health, level);
        const std::string where =
            std::string(name_of(form)) + " seed " + std::to_string(seed) + " level " + std::to_string(level);
        ASSERT_EQ(defect(mesh, std::max(size.height_m, size.width_m)), "") << where;
        ASSERT_EQ(open_defect(mesh), "") << where;
      }
    }
  }
}

TEST(MakeThing, SizesAreThoseThatAreAskedFor) {
  for (int form = 0; form < kForms; ++form) {
    ThingParams params = params_of(form);
    params.height_m = 3.0;
    params.width_m = 2.0;
    for (int seed = 0; seed < kSeeds; ++seed) {
      for (int level = 0; level < 3; ++level) {
        for (const double health : {1.0, 0.3}) {
          const Box box = box_of(make_thing_mesh(params, {static_cast<uint64_t>(seed)}, 0, health, level));
          const std::string where =
              std::string(name_of(form)) + " seed " + std::to_string(seed) + " level " + std::to_string(level);
          EXPECT_NEAR(box.low, 0.0, health == 1.0 ? 1e-5 : 1.0) << where;
          EXPECT_LE(box.high, 3.3) << where;
          EXPECT_LE(box.wide, 2.2) << where;
          if (health < 1.0) continue;
          EXPECT_GE(box.high, 2.7) << where;
          EXPECT_GE(box.wide, 1.8) << where;
        }
      }
    }
  }
}

TEST(MakeThing, LevelsHaveFewerAndFewerTriangles) {
  for (int form = 0; form < kForms; ++form) {
    for (int variant = 0; variant < 5; ++variant) {
      const ThingShape shape = make_thing_shape(params_of(form), "x", {7}, variant, 1.0);
      ASSERT_EQ(shape.levels.size(), 3U);
      const size_t fine = shape.levels[0].triangle_count(), middle = shape.levels[1].triangle_count(),
                   coarse = shape.levels[2].triangle_count();
      EXPECT_GE(fine, 700U) << name_of(form);
      EXPECT_LE(fine, 2400U) << name_of(form);
      EXPECT_GE(middle, 90U) << name_of(form);
      EXPECT_LE(middle, 620U) << name_of(form);
      EXPECT_GE(coarse, 8U) << name_of(form);
      EXPECT_LE(coarse, 80U) << name_of(form);
    }
  }
}

TEST(MakeThing, VariantsDifferAndRepeat) {
  for (int form = 0; form < kForms; ++form) {
    const ThingMesh a = make_thing_mesh(params_of(form), {1}, 0, 1.0, 0);
    EXPECT_EQ(a, make_thing_mesh(params_of(form), {1}, 0, 1.0, 0));
    EXPECT_NE(a.positions, make_thing_mesh(params_of(form), {1}, 1, 1.0, 0).positions) << name_of(form);
    EXPECT_NE(a.positions, make_thing_mesh(params_of(form), {2}, 0, 1.0, 0).positions) << name_of(form);
  }
}

/// Area of all triangles, and the mean of the colours' least channel, weighted by area: how pale it is.
std::array<double, 2> substance(const ThingMesh& mesh) {
  double area = 0.0, pale = 0.0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Point3 a = at(mesh.positions, mesh.indices[i]), b = at(mesh.positions, mesh.indices[i + 1]),
                 c = at(mesh.positions, mesh.indices[i + 2]);
    const double piece = 0.5 * length(cross(b - a, c - a));
    const Tone t = tone(mesh.colours[mesh.indices[i]]);
    area += piece;
    pale += piece * std::min({t.r, t.g, t.b});
  }
  return {area, pale / area};
}

TEST(MakeThing, AilingThingsHaveLessOrArePaler) {
  for (int form = static_cast<int>(ThingForm::branching_coral); form < kForms; ++form) {
    const bool coral = form <= static_cast<int>(ThingForm::sponge);
    for (int seed = 0; seed < 10; ++seed) {
      std::array<double, 2> before{};
      for (const double health : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const auto now = substance(make_thing_mesh(params_of(form), {static_cast<uint64_t>(seed)}, 0, health, 0));
        if (health > 0.0) {
          const std::string where = std::string(name_of(form)) + " " + std::to_string(health);
          if (coral) {
            EXPECT_LT(now[1], before[1]) << where;
          }
          if (form != static_cast<int>(ThingForm::massive_coral)) {
            EXPECT_GE(now[0], before[0]) << where;
          }
        }
        before = now;
      }
    }
  }
}

TEST(MakeThing, ColoursAreMuted) {
  for (int form = 0; form < kForms; ++form) {
    for (int variant = 0; variant < 5; ++variant) {
      for (const Colour& c : make_thing_mesh(params_of(form), {3}, variant, 1.0, 0).colours) {
        EXPECT_LT(c.g, 1.35 * std::max(c.r, c.b) + 12) << name_of(form) << ": no saturated greens";
        EXPECT_LT(std::max({c.r, c.g, c.b}), 245) << name_of(form);
      }
    }
  }
}

TEST(MakeThing, OwnMeshesAreFittedAndThinned) {
  ThingParams params = params_of(static_cast<int>(ThingForm::broadleaf));
  const ThingMesh tree = make_thing_mesh(params, {4}, 0, 1.0, 0);
  params.shape = ThingForm::file;
  params.height_m = 5.0;
  const ThingShape shape = shape_of_mesh(tree, params, "mine", 1.0);
  EXPECT_NEAR(shape.height_m, 5.0, 1e-4);
  ASSERT_EQ(shape.levels.size(), 3U);
  for (const ThingMesh& mesh : shape.levels) EXPECT_EQ(defect(mesh, 13.0), "");
  EXPECT_LE(shape.levels[1].triangle_count(), 300U);
  EXPECT_LE(shape.levels[2].triangle_count(), 40U);
  EXPECT_GE(shape.levels[2].triangle_count(), 8U);
  EXPECT_THROW(shape_of_mesh({}, params, "none", 1.0), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
