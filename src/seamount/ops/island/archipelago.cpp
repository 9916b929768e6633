#include "seamount/ops/island/archipelago.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/sample_rows.h"
#include "seamount/geom/grid/similarity.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"

namespace seamount::island {
namespace {

/// A member with the similarity that carries it to its place.
struct Placed {
  Member member;
  geom::Similarity at;
  float lowest = 0.0F;
  /// Metres from the reef into the lagoon and the land that it shuts in, 0 outside; empty: not known or not needed.
  ScalarField shut_in = {};
};

/// How far from its reef a lagoon takes the reefs of others in, in metres.
constexpr float kMergeReach_m = 150.0F;

ScalarField shut_in_by_reef(const LabelMap& labels, double scale, const RunContext& run) {
  Grid<uint8_t> outside(labels.frame());
  for (size_t c = 0; c < outside.size(); ++c) outside.cells()[c] = labels.cells()[c] >= Region::reef ? 1 : 0;
  ScalarField distance = geom::distance_to(outside, run);
  for (float& d : distance.cells()) d = std::isinf(d) ? 1e7F : d * static_cast<float>(scale);
  return distance;
}

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
  float floor;                          ///< the common floor
  float scale;                          ///< of what stands above the beaches
};

constexpr float kBeachTop_m = 6.0F;

/// Brings a member's heights to the common floor and scales its land. Reefs, lagoons and beaches keep their heights:
/// corals grow to the same depth beside a small island as beside a large one. What is under water fades to the floor
/// along the frame's edge, so that no edge shows on the sea floor.
SEAMOUNT_VECTORISED void settle(const float* __restrict columns, const float* __restrict rows, const Joining join,
                                int count, float* __restrict heights) {
  for (int i = 0; i < count; ++i) {
    const float across = columns[i] < join.last_column - columns[i] ? columns[i] : join.last_column - columns[i];
    const float along = rows[i] < join.last_row - rows[i] ? rows[i] : join.last_row - rows[i];
    const float share = geom::smoothstep((across < along ? across : along) / join.margin);
    const float z = heights[i];
    const float deep = z < join.shallow ? join.shallow + (z - join.shallow) * join.stretch : z;
    const float land = z > kBeachTop_m ? kBeachTop_m + join.scale * (z - kBeachTop_m) : z;
    heights[i] = z < 0.0F ? join.floor + share * (deep - join.floor) : land;
  }
}

/// Cubic interpolation overshoots beside the steep fore reef and would lift the crest out of the water: there it is
/// linear.
SEAMOUNT_VECTORISED void keep_under_water(const float* __restrict plain, int count, float* __restrict cubic) {
  for (int i = 0; i < count; ++i) {
    const float share = geom::smoothstep(plain[i] * 0.2F);
    cubic[i] = plain[i] + share * (cubic[i] - plain[i]);
  }
}

/// One row of the sea as one member fills it.
struct MemberRow : geom::PlacedRow {
  explicit MemberRow(int width) : PlacedRow(width), heights(columns.size()), plain_(columns.size()) {}

  void read(const Placed& p, const GridFrame& frame, float floor, int y) {
    const GridFrame& own = p.member.terrain->frame();
    locate(p.at, own, frame, y);
    if (first >= last) return;
    const auto count = static_cast<size_t>(last - first);
    const auto from = static_cast<size_t>(first);
    geom::sample_bilinear_rows(*p.member.terrain, {&columns[from], count}, {&rows[from], count},
                               {&plain_[from], count});
    std::copy_n(&plain_[from], count, &heights[from]);
    size_t dry = from, end = from + count;  // the part with land, where the interpolation is cubic
    while (dry < end && plain_[dry] <= 0.0F) ++dry;
    while (end > dry && plain_[end - 1] <= 0.0F) --end;
    if (dry < end) {
      geom::sample_bicubic_rows(*p.member.terrain, {&columns[dry], end - dry}, {&rows[dry], end - dry},
                                {&heights[dry], end - dry});
      keep_under_water(&plain_[dry], static_cast<int>(end - dry), &heights[dry]);
    }
    const float shallow = std::max(-60.0F, std::max(0.5F * p.lowest, 0.5F * floor));
    const Joining join{static_cast<float>(own.width - 1),
                       static_cast<float>(own.height - 1),
                       0.08F * static_cast<float>(std::min(own.width, own.height)),
                       shallow,
                       p.lowest < 0.0F ? (floor - shallow) / (p.lowest - shallow) : 1.0F,
                       floor,
                       static_cast<float>(p.at.scale)};
    settle(&columns[from], &rows[from], join, last - first, &heights[from]);
  }

  /// How much the lagoon of this member takes in the reef of another at cell x, in [0, 1].
  float takes_in(const Placed& p, int x) const {
    if (p.shut_in.empty() || x < first || x >= last) return 0.0F;
    const auto i = static_cast<size_t>(x);
    const float d = geom::sample_bilinear(p.shut_in, static_cast<double>(columns[i]), static_cast<double>(rows[i]));
    return geom::smoothstep(d / kMergeReach_m);
  }

  Region label(const Placed& p, int x) const {
    const auto i = static_cast<size_t>(x);
    return p.member.labels->clamped(static_cast<int>(columns[i] + 0.5F), static_cast<int>(rows[i] + 0.5F));
  }

  std::vector<float> heights;

 private:
  std::vector<float> plain_;
};

/// Where the lagoon of one member reaches over the reef of another, the reef ends: both lie in one lagoon.
void merge_lagoons(const std::vector<Placed>& placed, std::vector<MemberRow>& rows,
                   std::vector<std::vector<Region>>& labels) {
  std::vector<std::vector<float>> lowered;
  lowered.reserve(rows.size());
  for (const MemberRow& row : rows) lowered.push_back(row.heights);
  std::vector<std::vector<Region>> merged = labels;
  for (size_t a = 0; a < rows.size(); ++a) {
    for (int x = rows[a].first; x < rows[a].last; ++x) {
      const auto i = static_cast<size_t>(x);
      if (labels[a][i] < Region::reef) continue;
      for (size_t b = 0; b < rows.size(); ++b) {
        const float share = b == a ? 0.0F : rows[b].takes_in(placed[b], x);
        if (share <= 0.0F || rows[b].heights[i] >= lowered[a][i]) continue;
        lowered[a][i] += share * (rows[b].heights[i] - lowered[a][i]);
        if (share > 0.5F && merged[a][i] == Region::reef) merged[a][i] = Region::lagoon;
      }
    }
  }
  for (size_t a = 0; a < rows.size(); ++a) rows[a].heights = std::move(lowered[a]);
  labels = std::move(merged);
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

LabelMap placed_labels(const LabelMap& labels, Vec2 place, double turn_deg, double scale, const GridFrame& frame,
                       const RunContext& run) {
  const double turn = turn_deg * std::numbers::pi / 180.0;
  const geom::Similarity at{.place = place, .cosine = std::cos(turn), .sine = std::sin(turn), .scale = scale};
  LabelMap out(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    geom::PlacedRow row(frame.width);
    for (int y = begin; y < end; ++y) {
      std::fill(out.row(y).begin(), out.row(y).end(), Region::abyss);
      row.locate(at, labels.frame(), frame, y);
      for (int x = row.first; x < row.last; ++x) {
        const auto i = static_cast<size_t>(x);
        out(x, y) = labels.clamped(static_cast<int>(row.columns[i] + 0.5F), static_cast<int>(row.rows[i] + 0.5F));
      }
    }
  });
  return out;
}

Archipelago archipelago(const std::vector<Member>& members, const ArchipelagoParams& params, const GridFrame& frame,
                        const RunContext& run) {
  check_params(params);
  std::vector<Placed> placed = place_members(members, params);
  const bool labelled =
      std::all_of(members.begin(), members.end(), [](const Member& m) { return m.labels != nullptr; });
  float floor = placed.front().lowest;
  for (const Placed& p : placed) floor = std::min(floor, p.lowest);
  const bool merging = labelled && placed.size() > 1;
  for (Placed& p : placed) {
    if (merging) p.shut_in = shut_in_by_reef(*p.member.labels, p.at.scale, run);
  }
  const auto k = static_cast<float>(0.5 / params.blend_m);
  Archipelago out{HeightField(frame), labelled ? LabelMap(frame) : LabelMap()};
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<MemberRow> rows(placed.size(), MemberRow(frame.width));
    std::vector<std::vector<Region>> regions(placed.size(),
                                             std::vector<Region>(static_cast<size_t>(frame.width), Region::abyss));
    for (int y = begin; y < end; ++y) {
      const auto heights = out.terrain.row(y);
      std::fill(heights.begin(), heights.end(), floor);
      for (size_t m = 0; m < placed.size(); ++m) {
        rows[m].read(placed[m], frame, floor, y);
        for (int x = rows[m].first; labelled && x < rows[m].last; ++x)
          regions[m][static_cast<size_t>(x)] = rows[m].label(placed[m], x);
      }
      if (merging) merge_lagoons(placed, rows, regions);
      if (labelled) std::fill(out.labels.row(y).begin(), out.labels.row(y).end(), Region::abyss);
      for (size_t m = 0; m < placed.size(); ++m) {
        for (int x = rows[m].first; x < rows[m].last; ++x) {
          const auto i = static_cast<size_t>(x);
          heights[i] = blend(heights[i], rows[m].heights[i], floor, k);
          if (labelled) out.labels(x, y) = prior_label(out.labels(x, y), regions[m][i]);
        }
      }
    }
  });
  return out;
}

}  // namespace seamount::island
