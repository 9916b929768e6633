#include "seamount/ops/island/archipelago.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/blend.h"
#include "seamount/geom/sample_rows.h"

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

SEAMOUNT_VECTORISED void along_line(float start, float step, int count, float* __restrict out) {
  for (int i = 0; i < count; ++i) out[i] = start + static_cast<float>(i) * step;
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

/// One row of the sea as one member fills it: cells [first, last) lie on the member's own frame.
struct MemberRow {
  explicit MemberRow(int width) : columns(static_cast<size_t>(width)), rows(columns.size()), heights(columns.size()) {}

  void read(const Placed& p, const GridFrame& frame, float floor, int y) {
    const GridFrame& own = p.member.terrain->frame();
    const Vec2 start = p.source({frame.x(0), frame.y(y)});
    const Vec2 next = p.source({frame.x(1), frame.y(y)});
    const double column = own.column(start.x), row = own.row(start.y);
    const double column_step = own.column(next.x) - column, row_step = own.row(next.y) - row;
    double low = 0, high = frame.width - 1;
    clip(column, column_step, own.width, low, high);
    clip(row, row_step, own.height, low, high);
    first = static_cast<int>(std::ceil(low));
    last = std::max(first, static_cast<int>(std::floor(high)) + 1);
    if (first >= last) return;
    const auto count = static_cast<size_t>(last - first);
    const auto from = static_cast<size_t>(first);
    along_line(static_cast<float>(column + first * column_step), static_cast<float>(column_step), last - first,
               &columns[from]);
    along_line(static_cast<float>(row + first * row_step), static_cast<float>(row_step), last - first, &rows[from]);
    geom::sample_bicubic_rows(*p.member.terrain, {&columns[from], count}, {&rows[from], count},
                              {&heights[from], count});
    const float own_floor = floor / static_cast<float>(p.scale);
    const float shallow = std::max(-150.0F, 0.5F * p.lowest);
    const Joining join{static_cast<float>(own.width - 1),
                       static_cast<float>(own.height - 1),
                       0.08F * static_cast<float>(std::min(own.width, own.height)),
                       shallow,
                       p.lowest < 0.0F ? (own_floor - shallow) / (p.lowest - shallow) : 1.0F,
                       own_floor,
                       static_cast<float>(p.scale)};
    settle(&columns[from], &rows[from], join, last - first, &heights[from]);
  }

  /// Keeps the i in [low, high] with -1/2 <= start + i step <= size - 1/2.
  static void clip(double start, double step, int size, double& low, double& high) {
    if (std::abs(step) < 1e-12) {
      if (start < -0.5 || start > size - 0.5) high = low - 1;
      return;
    }
    const double a = (-0.5 - start) / step, b = (size - 0.5 - start) / step;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }

  std::vector<float> columns, rows, heights;
  int first = 0, last = 0;
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
  float floor = placed.front().lowest * static_cast<float>(placed.front().scale);
  for (const Placed& p : placed) floor = std::min(floor, p.lowest * static_cast<float>(p.scale));
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
