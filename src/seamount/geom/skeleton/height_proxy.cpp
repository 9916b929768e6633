// See height_proxy.h.
#include "seamount/geom/skeleton/height_proxy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::geom {
namespace {

constexpr int kTile = 32;
constexpr int kBlock = 8;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarApart = 22.0;
/// A shape that counts less than this does not count.
constexpr double kLeastWeight = 1e-7;
constexpr size_t kManyEdges = 24;
constexpr int64_t kPlacesPerBlock = 1024;

/// Smooth maximum with its excess in float, which is exact to 1e-6 blend; none at all where it is below 1e-8 blend.
double smooth_max(double a, double b, double blend) {
  const double gap = std::abs(a - b);
  if (gap > kFarApart * blend) return std::max(a, b);
  return std::max(a, b) + blend * static_cast<double>(detail::bernoulli(static_cast<float>(gap / blend)));
}

/// Heights at one place while shapes join there.
struct Joined {
  double ground;                ///< the terrain itself
  double grounded;              ///< G so far
  double altitude = kInfinity;  ///< A so far
  double blend = 0.0;           ///< of A with G
  double weight = 0.0;          ///< of A
  double surface = 0.0;

  void add(const ProxyProfile& profile, double distance, Vec2 place) {
    if (distance >= profile.end()) return;
    distance = profile.roughened(distance, place);
    const double height = profile.height(distance);
    if (profile.group() == HeightGroup::surface) {
      surface += height;
      return;
    }
    const double w = profile.weight(distance), own = profile.blend();
    if (w < kLeastWeight) return;
    if (profile.group() == HeightGroup::altitude) return join_altitude(height, w, own);
    const double faded = w < 1.0 ? ground + w * (height - ground) : height;
    if (faded < grounded - kFarApart * own) return;  // and the weight would take it further down
    grounded = smooth_max(grounded, w < 1.0 ? faded - own * (1.0 / w - 1.0) : faded, own);
  }

  /// As chances join: both there, the one without the other.
  void join_altitude(double height, double w, double own) {
    if (weight == 0.0) {
      altitude = height;
      blend = own;
      weight = w;
      return;
    }
    const double lower = -smooth_max(-altitude, -height, own);
    // The lower of two says how softly the ground joins; both where they are equal.
    const double gap = altitude - height;
    const double lower_blend = blend + 0.5 * (1.0 + gap / (std::abs(gap) + blend + own)) * (own - blend);
    const double both = weight * w, old = weight - both, fresh = w - both, any = both + old + fresh;
    altitude = (both * lower + old * altitude + fresh * height) / any;
    blend = (both * lower_blend + old * blend + fresh * own) / any;
    weight = any;
  }

  double result() const {
    if (weight == 0.0) return grounded + surface;
    return grounded + weight * (smooth_max(grounded, altitude, blend) - grounded) + surface;
  }
};

}  // namespace

HeightProxies::HeightProxies(std::span<const Skeleton> skeletons, std::span<const HeightEffect> effects,
                             const ProxyGround& ground) {
  std::vector<Box> boxes;
  objects_.reserve(skeletons.size());
  for (size_t i = 0; i < skeletons.size(); ++i) {
    const Skeleton& skeleton = skeletons[i];
    const ProxyProfile profile(effects[i], skeleton.kind, ground);
    if (profile.is_nothing() || skeleton.points.empty()) continue;
    Object object = {profile, {}, nullptr, nullptr, {}};
    const size_t n = skeleton.points.size();
    const bool region = skeleton.kind == SkeletonKind::region && n >= 3;
    if (n == 1) object.edges.push_back(PointEdge::between(skeleton.points[0], skeleton.points[0]));
    for (size_t k = 0; k + 1 < n + (region ? 1 : 0); ++k) {
      object.edges.push_back(PointEdge::between(skeleton.points[k], skeleton.points[(k + 1) % n]));
    }
    if (region && (profile.is_signed() || profile.is_filled())) {
      object.rows = std::make_shared<const RingRows>(skeleton.points);
    }
    if (object.edges.size() > kManyEdges) {
      const int32_t owner = 0;
      object.search = std::make_shared<const SkeletonIndex>(std::span(&skeleton, 1), std::span(&owner, 1));
    }
    const Box box = bounding_box(skeleton.points);
    const Vec2 end = {profile.end(), profile.end()};
    object.reach = {box.low - end, box.high + end};
    boxes.push_back(object.reach);
    objects_.push_back(std::move(object));
  }
  tree_ = BoxTree(boxes);
}

double HeightProxies::distance(const Object& object, Vec2 place) const {
  double distance = kInfinity;
  if (object.search) {
    distance = object.search->nearest(place).distance;
  } else {
    for (const PointEdge& edge : object.edges) distance = std::min(distance, edge.squared_distance(place));
    distance = std::sqrt(distance);
  }
  if (object.rows && object.rows->contains(place)) return object.profile.is_signed() ? -distance : 0.0;
  return distance;
}

/// Shapes over the cells of a tile, in their order.
class HeightProxies::Tile {
 public:
  Tile(const HeightField& ground, int left, int top)
      : frame_(ground.frame()),
        left_(left),
        top_(top),
        width_(std::min(kTile, ground.width() - left)),
        height_(std::min(kTile, ground.height() - top)) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const double z = static_cast<double>(ground(left + x, top + y));
        cells_[index(x, y)] = Joined{z, z};
      }
    }
  }

  void add(const Object& object) {
    if (object.edges.size() == 1 && object.edges[0].inverse == 0.0) return add_point(object);
    for (int y = 0; y < height_; y += kBlock) {
      for (int x = 0; x < width_; x += kBlock) add_block(object, x, y);
    }
  }

  void write(HeightField& result) const {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        result(left_ + x, top_ + y) = static_cast<float>(cells_[index(x, y)].result());
      }
    }
  }

 private:
  static size_t index(int x, int y) { return static_cast<size_t>(y * kTile + x); }
  Vec2 place(int x, int y) const { return {frame_.x(left_ + x), frame_.y(top_ + y)}; }

  void add_point(const Object& object) {
    const PointEdge& point = object.edges[0];
    const double end = object.profile.end(), column = frame_.column(point.a.x) - left_;
    const double row = frame_.row(point.a.y) - top_, reach = end / frame_.cell_m + 1e-6;
    const int first = static_cast<int>(std::clamp(std::ceil(column - reach), 0.0, width_ * 1.0));
    const int last = static_cast<int>(std::clamp(std::floor(column + reach), -1.0, width_ - 1.0));
    const int from = static_cast<int>(std::clamp(std::ceil(row - reach), 0.0, height_ * 1.0));
    const int to = static_cast<int>(std::clamp(std::floor(row + reach), -1.0, height_ - 1.0));
    for (int y = from; y <= to; ++y) {
      for (int x = first; x <= last; ++x) {
        const double squared = point.squared_distance(place(x, y));
        if (squared < end * end) cells_[index(x, y)].add(object.profile, std::sqrt(squared), place(x, y));
      }
    }
  }

  /// Only the edges that can be nearest somewhere in a block are asked at its cells.
  void add_block(const Object& object, int left, int top) {
    const int right = std::min(left + kBlock, width_), bottom = std::min(top + kBlock, height_);
    const Vec2 low = place(left, bottom - 1), high = place(right - 1, top), middle = 0.5 * (low + high);
    if (high.x < object.reach.low.x || low.x > object.reach.high.x || high.y < object.reach.low.y ||
        low.y > object.reach.high.y) {
      return;
    }
    const double radius = 0.5 * std::hypot(high.x - low.x, high.y - low.y);
    squares_.resize(object.edges.size());
    double nearest = kInfinity;
    for (size_t i = 0; i < squares_.size(); ++i) {
      squares_[i] = object.edges[i].squared_distance(middle);
      nearest = std::min(nearest, squares_[i]);
    }
    nearest = std::sqrt(nearest);
    if (!object.rows && nearest - radius > object.profile.end()) return;
    const double most = (nearest + 2.0 * radius) * (1.0 + 1e-9);
    near_.clear();
    for (size_t i = 0; i < squares_.size(); ++i) {
      if (squares_[i] <= most * most) near_.push_back(object.edges[i]);
    }
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Vec2 p = place(x, y);
        double squared = kInfinity;
        for (const PointEdge& edge : near_) squared = std::min(squared, edge.squared_distance(p));
        double distance = std::sqrt(squared);
        if (object.rows && object.rows->contains(p)) distance = object.profile.is_signed() ? -distance : 0.0;
        cells_[index(x, y)].add(object.profile, distance, p);
      }
    }
  }

  const GridFrame& frame_;
  int left_, top_, width_, height_;
  std::array<Joined, static_cast<size_t>(kTile) * kTile> cells_;
  std::vector<double> squares_;
  std::vector<PointEdge> near_;
};

HeightField HeightProxies::over(const HeightField& ground, const RunContext& run) const {
  const GridFrame& frame = ground.frame();
  const int across = (frame.width + kTile - 1) / kTile, down = (frame.height + kTile - 1) / kTile;
  std::vector<std::vector<uint32_t>> of_tile(static_cast<size_t>(across) * static_cast<size_t>(down));
  const auto tile_of = [](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell / kTile), -1.0, static_cast<double>(count)));
  };
  for (size_t i = 0; i < objects_.size(); ++i) {
    const Box& box = objects_[i].reach;
    const int left = std::max(0, tile_of(frame.column(box.low.x) - 1.0, across));
    const int right = std::min(across - 1, tile_of(frame.column(box.high.x) + 1.0, across));
    const int bottom = std::min(down - 1, tile_of(frame.row(box.low.y) + 1.0, down));
    for (int y = std::max(0, tile_of(frame.row(box.high.y) - 1.0, down)); y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        of_tile[static_cast<size_t>(y) * static_cast<size_t>(across) + static_cast<size_t>(x)].push_back(
            static_cast<uint32_t>(i));
      }
    }
  }
  HeightField result(frame);
  parallel_blocks(run, static_cast<int64_t>(of_tile.size()), 1, [&](int64_t begin, int64_t end) {
    for (int64_t t = begin; t < end; ++t) {
      const auto tile =
          std::make_unique<Tile>(ground, static_cast<int>(t % across) * kTile, static_cast<int>(t / across) * kTile);
      for (const uint32_t i : of_tile[static_cast<size_t>(t)]) tile->add(objects_[i]);
      tile->write(result);
    }
  });
  return result;
}

void HeightProxies::over(std::span<const Vec2> places, std::span<double> heights, const RunContext& run) const {
  parallel_blocks(run, static_cast<int64_t>(places.size()), kPlacesPerBlock, [&](int64_t begin, int64_t end) {
    std::vector<uint32_t> near;
    for (int64_t k = begin; k < end; ++k) {
      const Vec2 place = places[static_cast<size_t>(k)];
      near.clear();
      tree_.for_each_at(place, [&](uint32_t i) { near.push_back(i); });
      std::sort(near.begin(), near.end());
      double& height = heights[static_cast<size_t>(k)];
      Joined joined{height, height};
      for (const uint32_t i : near) joined.add(objects_[i].profile, distance(objects_[i], place), place);
      height = joined.result();
    }
  });
}

}  // namespace seamount::geom
