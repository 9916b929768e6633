#include "seamount/ops/island/archipelago.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/geom/blend.h"
#include "seamount/geom/resample.h"

namespace seamount::island {
namespace {

/// A member with the similarity that carries it to its place.
struct Placed {
  Member member;
  Vec2 place;
  double cosine = 1.0;
  double sine = 0.0;
  double scale = 1.0;
  float lowest = 0.0F;

  /// The point of the member's own frame that comes to lie at p.
  Vec2 source(Vec2 p) const {
    const Vec2 d = (1.0 / scale) * (p - place);
    return {cosine * d.x + sine * d.y, -sine * d.x + cosine * d.y};
  }
};

std::vector<Placed> place_members(const std::vector<Member>& members, const ArchipelagoParams& params) {
  if (members.empty()) throw InvalidArgument("terrain", "an archipelago needs an island");
  const size_t count = params.places.empty() ? members.size() : params.places.size();
  if (members.size() != 1 && count != members.size()) {
    throw InvalidArgument("places", fmt::format("{} places for {} islands", count, members.size()));
  }
  std::vector<Placed> placed;
  for (size_t i = 0; i < count; ++i) {
    const Member& member = members[members.size() == 1 ? 0 : i];
    const double turn = i < params.turns_deg.size() ? params.turns_deg[i] * std::numbers::pi / 180.0 : 0.0;
    placed.push_back({member, params.places.empty() ? Vec2{} : params.places[i], std::cos(turn), std::sin(turn),
                      i < params.scales.size() ? params.scales[i] : 1.0,
                      *std::min_element(member.terrain->cells().begin(), member.terrain->cells().end())});
  }
  return placed;
}

/// Height of a member at a place of its own frame. What is under water fades to its lowest height along the frame's
/// edge, so that no edge shows on the sea floor.
float member_height(const Placed& p, double column, double row) {
  const GridFrame& own = p.member.terrain->frame();
  const float z = geom::sample_bicubic(*p.member.terrain, column, row);
  if (z >= 0.0F) return z;
  const double margin = 0.08 * std::min(own.width, own.height);
  const double inside = std::min({column, row, own.width - 1 - column, own.height - 1 - row});
  return p.lowest + static_cast<float>(geom::smoothstep(inside / margin)) * (z - p.lowest);
}

/// The sea floor does not rise where two floors meet: only what stands above them both is blended.
float blend(float a, float b, float floor, float k) {
  if (a <= floor) return b;
  if (b <= floor) return a;
  return geom::smax(a, b, k);
}

}  // namespace

Region prior_label(Region a, Region b) {
  constexpr std::array<int, kRegionCount> kPriority = {4, 3, 1, 2, 0};  // mountain, beach, lagoon, reef, abyss
  return kPriority[static_cast<size_t>(a)] >= kPriority[static_cast<size_t>(b)] ? a : b;
}

Archipelago archipelago(const std::vector<Member>& members, const ArchipelagoParams& params, const GridFrame& frame,
                        const RunContext& run) {
  check_params(params);
  const std::vector<Placed> placed = place_members(members, params);
  const bool labelled =
      std::all_of(members.begin(), members.end(), [](const Member& m) { return m.labels != nullptr; });
  float floor = placed.front().lowest * static_cast<float>(placed.front().scale);
  for (const Placed& p : placed) floor = std::min(floor, p.lowest * static_cast<float>(p.scale));
  const auto k = static_cast<float>(0.5 / params.blend_m);
  Archipelago out{HeightField(frame), labelled ? LabelMap(frame) : LabelMap()};
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        float height = floor;
        Region label = Region::abyss;
        for (const Placed& p : placed) {
          const GridFrame& own = p.member.terrain->frame();
          const Vec2 source = p.source({frame.x(x), frame.y(y)});
          const double column = own.column(source.x);
          const double row = own.row(source.y);
          if (column < -0.5 || row < -0.5 || column > own.width - 0.5 || row > own.height - 0.5) continue;
          height = blend(height, static_cast<float>(p.scale) * member_height(p, column, row), floor, k);
          if (labelled) {
            label = prior_label(label, p.member.labels->clamped(static_cast<int>(std::lround(column)),
                                                                static_cast<int>(std::lround(row))));
          }
        }
        out.terrain(x, y) = height;
        if (labelled) out.labels(x, y) = label;
      }
    }
  });
  return out;
}

}  // namespace seamount::island
