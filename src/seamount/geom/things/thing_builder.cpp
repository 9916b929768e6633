#include "seamount/geom/things/thing_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace seamount::geom {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

struct Ball {
  std::vector<Point3> directions;
  std::vector<std::array<uint32_t, 3>> triangles;
};

Ball icosahedron() {
  const double a = 0.525731112119133606, b = 0.850650808352039932;
  return {{{-a, 0, b},
           {a, 0, b},
           {-a, 0, -b},
           {a, 0, -b},
           {0, b, a},
           {0, b, -a},
           {0, -b, a},
           {0, -b, -a},
           {b, a, 0},
           {-b, a, 0},
           {b, -a, 0},
           {-b, -a, 0}},
          {{0, 1, 4}, {0, 4, 9},  {9, 4, 5},  {4, 8, 5},  {4, 1, 8},  {8, 1, 10}, {8, 10, 3},
           {5, 8, 3}, {5, 3, 2},  {2, 3, 7},  {7, 3, 10}, {7, 10, 6}, {7, 6, 11}, {11, 6, 0},
           {0, 6, 1}, {6, 10, 1}, {9, 11, 0}, {9, 2, 11}, {9, 5, 2},  {7, 11, 2}}};
}

Ball ball(int fineness) {
  Ball ball = icosahedron();
  for (int i = 0; i < fineness; ++i) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
      const auto key = std::minmax(a, b);
      const auto [found, is_new] = middles.try_emplace({key.first, key.second}, ball.directions.size());
      if (is_new) ball.directions.push_back(unit(ball.directions[a] + ball.directions[b]));
      return found->second;
    };
    std::vector<std::array<uint32_t, 3>> finer;
    for (const auto& [a, b, c] : ball.triangles) {
      const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    ball.triangles = std::move(finer);
  }
  return ball;
}

bool has_area(Point3 a, Point3 b, Point3 c, double size) { return length(cross(b - a, c - a)) > 1e-10 * size * size; }

}  // namespace

/// What a call adds: taken back, but for the room that it takes, while it is missing.
class ThingBuilder::Part {
 public:
  explicit Part(ThingBuilder& b)
      : b_(b),
        places_(b.places_.size()),
        leaves_(b.leaf_places_.size()),
        solid_(b.solid_.size()),
        thin_(b.leaves_.size()) {}
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() {
    if (!b_.missing_) return;
    b_.room_.insert(b_.room_.end(), b_.places_.begin() + static_cast<ptrdiff_t>(places_), b_.places_.end());
    b_.room_.insert(b_.room_.end(), b_.leaf_places_.begin() + static_cast<ptrdiff_t>(leaves_), b_.leaf_places_.end());
    b_.places_.resize(places_);
    b_.tones_.resize(places_);
    b_.leaf_places_.resize(leaves_);
    b_.leaf_normals_.resize(leaves_);
    b_.leaf_tones_.resize(leaves_);
    b_.solid_.resize(solid_);
    b_.leaves_.resize(thin_);
  }

 private:
  ThingBuilder& b_;
  size_t places_, leaves_, solid_, thin_;
};

uint32_t ThingBuilder::vertex(Point3 place, Tone tone) {
  places_.push_back(place);
  tones_.push_back(tone);
  return static_cast<uint32_t>(places_.size() - 1);
}

uint32_t ThingBuilder::leaf_vertex(Point3 place, Point3 normal, Tone tone) {
  leaf_places_.push_back(place);
  leaf_normals_.push_back(unit(normal));
  leaf_tones_.push_back(tone);
  return static_cast<uint32_t>(leaf_places_.size() - 1);
}

void ThingBuilder::tube(std::span<const Ring3> rings, int sides, const std::function<double(size_t, double)>& bulge) {
  const Part part(*this);
  const auto n = static_cast<uint32_t>(sides);
  const Point3 start = unit(rings[1].centre - rings[0].centre);
  Point3 u = beside(start);
  const uint32_t first = static_cast<uint32_t>(places_.size());
  for (size_t i = 0; i < rings.size(); ++i) {
    const Point3 axis = unit(rings[std::min(i + 1, rings.size() - 1)].centre - rings[i == 0 ? 0 : i - 1].centre);
    u = unit(u - dot(u, axis) * axis);  // carried along without twist
    const Point3 v = cross(axis, u);
    for (uint32_t k = 0; k < n; ++k) {
      const double angle = kTurn * k / n, r = rings[i].radius * (bulge ? bulge(i, angle) : 1.0);
      vertex(rings[i].centre + (r * std::cos(angle)) * u + (r * std::sin(angle)) * v, rings[i].tone);
    }
  }
  for (uint32_t i = 0; i + 1 < rings.size(); ++i) {
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t a = first + i * n + k, b = first + i * n + (k + 1) % n, c = a + n, d = b + n;
      solid_.insert(solid_.end(), {a, b, d, a, d, c});
    }
  }
  const Ring3 &low = rings.front(), &high = rings.back();
  const Point3 end = unit(high.centre - rings[rings.size() - 2].centre);
  const uint32_t foot = vertex(low.centre - (0.3 * low.radius) * start, low.tone);
  const uint32_t tip = vertex(high.centre + (0.6 * high.radius) * end, high.tone);
  const uint32_t last = first + n * static_cast<uint32_t>(rings.size() - 1);
  for (uint32_t k = 0; k < n; ++k) {
    solid_.insert(solid_.end(), {first + (k + 1) % n, first + k, foot});
    solid_.insert(solid_.end(), {last + k, last + (k + 1) % n, tip});
  }
}

void ThingBuilder::blob(int fineness, const std::function<Point3(Point3)>& place,
                        const std::function<Tone(Point3)>& colour) {
  const Part part(*this);
  const Ball sphere = ball(fineness);
  const auto first = static_cast<uint32_t>(places_.size());
  for (const Point3& direction : sphere.directions) vertex(place(direction), colour(direction));
  for (const auto& [a, b, c] : sphere.triangles) solid_.insert(solid_.end(), {first + a, first + b, first + c});
}

void ThingBuilder::lathe(Point3 lower, Point3 upper, int rows, int sectors,
                         const std::function<Point3(int, double)>& place, const std::function<Tone(Point3)>& colour) {
  const Part part(*this);
  const auto n = static_cast<uint32_t>(sectors);
  const uint32_t bottom = vertex(lower, colour(lower)), top = vertex(upper, colour(upper));
  const uint32_t first = top + 1;
  for (int row = 0; row < rows; ++row) {
    for (uint32_t k = 0; k < n; ++k) {
      const Point3 p = place(row, kTurn * k / n);
      vertex(p, colour(p));
    }
  }
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t next = (k + 1) % n, last = first + n * static_cast<uint32_t>(rows - 1);
    solid_.insert(solid_.end(), {bottom, first + next, first + k, top, last + k, last + next});
    for (uint32_t row = 0; row + 1 < static_cast<uint32_t>(rows); ++row) {
      const uint32_t a = first + row * n + k, b = first + row * n + next;
      solid_.insert(solid_.end(), {a, b, b + n, a, b + n, a + n});
    }
  }
}

void ThingBuilder::spike(Point3 base, Point3 tip, double radius, double turn, Tone low, Tone high) {
  const Part part(*this);
  const Point3 axis = unit(tip - base), u = beside(axis), v = cross(axis, u);
  std::array<uint32_t, 3> corners{};
  for (uint32_t k = 0; k < 3; ++k) {
    const double angle = turn + kTurn * k / 3.0;
    corners[k] = vertex(base + (radius * std::cos(angle)) * u + (radius * std::sin(angle)) * v, low);
  }
  const uint32_t top = vertex(tip, high);
  const auto [a, b, c] = corners;
  solid_.insert(solid_.end(), {a, c, b, a, b, top, b, c, top, c, a, top});
}

void ThingBuilder::sheet(int across, int along, const std::function<Point3(double, double)>& place,
                         const std::function<Tone(double, double)>& colour, Point3 lean, double leaning) {
  const Part part(*this);
  const auto first = static_cast<uint32_t>(leaf_places_.size());
  constexpr double kStep = 0.02;
  const auto own_normal = [&](double u, double v) {
    return unit(cross(place(u + kStep, v) - place(u - kStep, v), place(u, v + kStep) - place(u, v - kStep)));
  };
  const bool turn = leaning > 0.0 && dot(own_normal(0.5, 0.5), lean) < 0.0;
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i <= across; ++i) {
      const double u = static_cast<double>(i) / across, v = static_cast<double>(j) / along;
      const Point3 normal = turn ? -1.0 * own_normal(u, v) : own_normal(u, v);
      leaf_vertex(place(u, v), mix(normal, lean, leaning), colour(u, v));
    }
  }
  const auto row = static_cast<uint32_t>(across + 1);
  for (uint32_t j = 0; j < static_cast<uint32_t>(along); ++j) {
    for (uint32_t i = 0; i < static_cast<uint32_t>(across); ++i) {
      const uint32_t a = first + j * row + i;
      if (turn)
        leaves_.insert(leaves_.end(), {a, a + row + 1, a + 1, a, a + row, a + row + 1});
      else
        leaves_.insert(leaves_.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
    }
  }
}

void ThingBuilder::leaf(Point3 base, Point3 tip, Point3 side, Point3 normal, Tone low, Tone high) {
  const Part part(*this);
  const Point3 middle = mix(base, tip, 0.45);
  if (dot(cross(side, tip - base), normal) < 0.0) side = -1.0 * side;
  const uint32_t a = leaf_vertex(base, normal, low), b = leaf_vertex(middle + side, normal, mix(low, high, 0.5)),
                 c = leaf_vertex(tip, normal, high), d = leaf_vertex(middle - side, normal, mix(low, high, 0.5));
  leaves_.insert(leaves_.end(), {a, b, c, a, c, d});
}

void ThingBuilder::blade(Point3 base, Point3 tip, Point3 side, Point3 normal, Tone low, Tone high) {
  const Part part(*this);
  if (dot(cross(side, tip - base), normal) < 0.0) side = -1.0 * side;
  const uint32_t a = leaf_vertex(base - side, normal, low), b = leaf_vertex(base + side, normal, low),
                 c = leaf_vertex(tip, normal, high);
  leaves_.insert(leaves_.end(), {a, b, c});
}

std::vector<Point3> ThingBuilder::solid_normals() const {
  std::vector<Point3> normals(places_.size());
  for (size_t i = 0; i < solid_.size(); i += 3) {
    const Point3 a = places_[solid_[i]], n = cross(places_[solid_[i + 1]] - a, places_[solid_[i + 2]] - a);
    for (size_t k = 0; k < 3; ++k) normals[solid_[i + k]] = normals[solid_[i + k]] + n;
  }
  for (Point3& n : normals) n = unit(n);
  return normals;
}

ThingMesh ThingBuilder::finish(double height_m, double width_m) {
  constexpr double kFar = 1e30;
  double low = kFar, high = -kFar, wide_x = 0.0, wide_y = 0.0;
  for (const auto* all : {&places_, &leaf_places_, &room_}) {
    for (const Point3& p : *all) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
      wide_x = std::max(wide_x, std::abs(p.x));
      wide_y = std::max(wide_y, std::abs(p.y));
    }
  }
  const double up = height_m / std::max(high - low, 1e-9), out = 0.5 * width_m / std::max({wide_x, wide_y, 1e-9});
  const auto fit = [&](Point3& p) { p = {out * p.x, out * p.y, up * (p.z - low)}; };
  for (Point3& p : places_) fit(p);
  for (Point3& p : leaf_places_) fit(p);
  for (Point3& n : leaf_normals_) n = unit({n.x / out, n.y / out, n.z / up});

  ThingMesh mesh;
  const auto put = [&](const std::vector<Point3>& places, const std::vector<Point3>& normals,
                       const std::vector<Tone>& tones) {
    for (size_t i = 0; i < places.size(); ++i) {
      for (const double value : {places[i].x, places[i].y, places[i].z})
        mesh.positions.push_back(static_cast<float>(value));
      for (const double value : {normals[i].x, normals[i].y, normals[i].z})
        mesh.normals.push_back(static_cast<float>(value));
      mesh.colours.push_back(srgb(tones[i]));
    }
  };
  put(places_, solid_normals(), tones_);
  const auto leaves_from = static_cast<uint32_t>(places_.size());
  put(leaf_places_, leaf_normals_, leaf_tones_);
  mesh.indices = solid_;
  mesh.solid = solid_.size();
  const double size = std::max(height_m, width_m);
  for (size_t i = 0; i < leaves_.size(); i += 3) {
    const uint32_t a = leaves_[i], b = leaves_[i + 1], c = leaves_[i + 2];
    if (!has_area(leaf_places_[a], leaf_places_[b], leaf_places_[c], size)) continue;
    mesh.indices.insert(mesh.indices.end(), {leaves_from + a, leaves_from + b, leaves_from + c});
  }
  *this = {};
  return mesh;
}

}  // namespace seamount::geom
