#include "seamount/ops/island/archipelago.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/sample_rows.h"
#include "seamount/geom/grid/similarity.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::island {
namespace {

/// A member with the similarity that carries it to its place.
struct Placed {
  Member member;
  geom::Similarity at;
  float lowest = 0.0F;
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
    placed.push_back({member,
                      {.place = params.places.empty() ? Vec2{} : params.places[i],
                       .cosine = std::cos(turn),
                       .sine = std::sin(turn),
                       .scale = i < params.scales.size() ? params.scales[i] : 1.0},
                      *std::min_element(member.terrain->cells().begin(), member.terrain->cells().end())});
  }
  return placed;
}

/// How a member joins the common sea floor.
struct Joining {
  float last_column, last_row, margin;  ///< of its own frame, in cells
  float shallow;                        ///< depth down to which it stays as it is: reefs and lagoons
  float stretch;                        ///< of what lies deeper, so that its sea floor comes to lie on the common one
  float floor;                          ///< the common floor before scaling
  float scale;
};

/// Brings a member's heights to the common floor and scales them. What is under water fades to the floor along the
/// frame's edge, so that no edge shows on the sea floor.
SEAMOUNT_VECTORISED void settle(const float* __restrict columns, const float* __restrict rows, const Joining join,
                                int count, float* __restrict heights) {
  for (int i = 0; i < count; ++i) {
    const float across = columns[i] < join.last_column - columns[i] ? columns[i] : join.last_column - columns[i];
    const float along = rows[i] < join.last_row - rows[i] ? rows[i] : join.last_row - rows[i];
    const float share = geom::smoothstep((across < along ? across : along) / join.margin);
    const float z = heights[i];
    const float deep = z < join.shallow ? join.shallow + (z - join.shallow) * join.stretch : z;
    heights[i] = join.scale * (z < 0.0F ? join.floor + share * (deep - join.floor) : z);
  }
}

/// One row of the sea as one member fills it.
struct MemberRow : geom::PlacedRow {
  explicit MemberRow(int width) : PlacedRow(width), heights(columns.size()) {}

  void read(const Placed& p, const GridFrame& frame, float floor, int y) {
    const GridFrame& own = p.member.terrain->frame();
    locate(p.at, own, frame, y);
    if (first >= last) return;
    const auto count = static_cast<size_t>(last - first);
    const auto from = static_cast<size_t>(first);
    geom::sample_bicubic_rows(*p.member.terrain, {&columns[from], count}, {&rows[from], count},
                              {&heights[from], count});
    const float own_floor = floor / static_cast<float>(p.at.scale);
    const float shallow = std::max(-150.0F, 0.5F * p.lowest);
    const Joining join{static_cast<float>(own.width - 1),
                       static_cast<float>(own.height - 1),
                       0.08F * static_cast<float>(std::min(own.width, own.height)),
                       shallow,
                       p.lowest < 0.0F ? (own_floor - shallow) / (p.lowest - shallow) : 1.0F,
                       own_floor,
                       static_cast<float>(p.at.scale)};
    settle(&columns[from], &rows[from], join, last - first, &heights[from]);
  }

  std::vector<float> heights;
};

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
  float floor = placed.front().lowest * static_cast<float>(placed.front().at.scale);
  for (const Placed& p : placed) floor = std::min(floor, p.lowest * static_cast<float>(p.at.scale));
  const auto k = static_cast<float>(0.5 / params.blend_m);
  Archipelago out{HeightField(frame), labelled ? LabelMap(frame) : LabelMap()};
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    MemberRow member(frame.width);
    for (int y = begin; y < end; ++y) {
      const auto heights = out.terrain.row(y);
      std::fill(heights.begin(), heights.end(), floor);
      if (labelled) std::fill(out.labels.row(y).begin(), out.labels.row(y).end(), Region::abyss);
      for (const Placed& p : placed) {
        member.read(p, frame, floor, y);
        for (int x = member.first; x < member.last; ++x) {
          const auto i = static_cast<size_t>(x);
          heights[i] = blend(heights[i], member.heights[i], floor, k);
          if (!labelled) continue;
          const int column = static_cast<int>(member.columns[i] + 0.5F);
          const int row = static_cast<int>(member.rows[i] + 0.5F);
          out.labels(x, y) = prior_label(out.labels(x, y), p.member.labels->clamped(column, row));
        }
      }
    }
  });
  return out;
}

}  // namespace seamount::island
