#include "seamount/ops/contour/edit/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/marching_open_triangles.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/edit/patch_border.h"
#include "seamount/ops/contour/move/places.h"

namespace seamount::contour {
namespace {

/// The patch as triangles about the squares' middles, with the border's cuts as corners.
class PatchMesh {
 public:
  PatchMesh(const Patch& patch, const ScalarField& heights, const std::vector<double>& levels, const CutContours& cut,
            const RunContext& run)
      : patch_(patch), levels_(levels), cut_(cut), nodes_(patch.nodes, -1), cut_node_(cut.cuts.size(), -1) {
    tiny_ = std::numeric_limits<double>::infinity();
    for (size_t i = 1; i < levels.size(); ++i) tiny_ = std::min(tiny_, levels[i] - levels[i - 1]);
    if (!std::isfinite(tiny_)) tiny_ = 1.0;
    gap_ = tiny_;
    tiny_ *= 1e-3;
    add_nodes(heights);
    for (int y = 0; y < patch.squares.height(); ++y) {
      run.check_cancelled();
      for (int x = 0; x < patch.squares.width(); ++x) {
        if (patch.has(x, y)) add_square(x, y);
      }
    }
  }

  const geom::HeightMesh& mesh() const { return mesh_; }
  /// The cut at a node of the mesh, or -1.
  int cut_at(int32_t node) const { return node >= 0 ? cut_of_node_[static_cast<size_t>(node)] : -1; }

 private:
  int32_t add_node(Vec2 at, double height, int cut = -1) {
    mesh_.nodes.push_back(at);
    mesh_.height_m.push_back(height);
    cut_of_node_.push_back(cut);
    return static_cast<int32_t>(mesh_.nodes.size()) - 1;
  }

  /// A height a little off every level, on its own side of it: lines of two levels keep apart, and none passes through
  /// a node.
  double off_levels(double height) const {
    const auto level = std::lower_bound(levels_.begin(), levels_.end(), height - tiny_);
    if (level == levels_.end() || std::abs(*level - height) >= tiny_) return height;
    return height >= *level ? *level + tiny_ : *level - tiny_;
  }

  void add_nodes(const ScalarField& heights) {
    for (int y = 0; y < patch_.nodes.height; ++y) {
      for (int x = 0; x < patch_.nodes.width; ++x) {
        if (!patch_.has(x - 1, y - 1) && !patch_.has(x, y - 1) && !patch_.has(x - 1, y) && !patch_.has(x, y)) continue;
        double height = off_levels(static_cast<double>(heights(x, y)));
        if (patch_.at_border(x, y)) height = within_cuts(x, y, height);
        nodes_(x, y) = add_node({patch_.nodes.x(x), patch_.nodes.y(y)}, height);
      }
    }
  }

  /// A border node's height on the right side of the cuts next to it.
  double within_cuts(int x, int y, double height) const {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    const auto look = [&](int64_t edge, bool node_is_first) {
      const auto found = cut_.on_edge.find(edge);
      if (found == cut_.on_edge.end()) return;
      const BorderCut& cut = cut_.cuts[node_is_first ? found->second.front() : found->second.back()];
      if (cut.first_higher == node_is_first) {
        low = std::max(low, cut.height_m);
      } else {
        high = std::min(high, cut.height_m);
      }
    };
    look(edge_key(patch_, x, y, false), true);
    look(edge_key(patch_, x - 1, y, false), false);
    look(edge_key(patch_, x, y, true), true);
    look(edge_key(patch_, x, y - 1, true), false);
    const double room = std::min(0.25 * gap_, 0.25 * (high - low));
    return std::clamp(height, low + room, std::max(low + room, high - room));
  }

  void add_square(int x, int y) {
    std::vector<int32_t> ring;
    add_side(x, y + 1, false, false, !patch_.has(x, y + 1), ring);  // south, eastwards
    add_side(x + 1, y, true, true, !patch_.has(x + 1, y), ring);    // east, northwards
    add_side(x, y, false, true, !patch_.has(x, y - 1), ring);       // north, westwards
    add_side(x, y, true, false, !patch_.has(x - 1, y), ring);       // west, southwards
    double sum = 0.0;
    for (const int32_t node : {nodes_(x, y), nodes_(x + 1, y), nodes_(x, y + 1), nodes_(x + 1, y + 1)})
      sum += mesh_.height_m[static_cast<size_t>(node)];
    const int32_t middle = add_node({patch_.nodes.x(x + 0.5), patch_.nodes.y(y + 0.5)}, off_levels(0.25 * sum));
    for (size_t i = 0; i < ring.size(); ++i) mesh_.triangles.push_back({middle, ring[i], ring[(i + 1) % ring.size()]});
  }

  /// The first node of a side of a square and its cuts; `back`: the side runs against the edge's own direction.
  void add_side(int x, int y, bool south, bool back, bool border, std::vector<int32_t>& ring) {
    const int32_t first = nodes_(x, y);
    const int32_t last = south ? nodes_(x, y + 1) : nodes_(x + 1, y);
    ring.push_back(back ? last : first);
    if (!border) return;
    const auto found = cut_.on_edge.find(edge_key(patch_, x, y, south));
    if (found == cut_.on_edge.end()) return;
    std::vector<int32_t> between;
    for (size_t i = 0; i < found->second.size(); ++i) {
      const size_t c = found->second[i];
      const BorderCut& cut = cut_.cuts[c];
      if (i > 0) between.push_back(add_middle(cut_.cuts[found->second[i - 1]], cut));
      cut_node_[c] = add_node(cut.at, cut.height_m, static_cast<int>(c));
      between.push_back(cut_node_[c]);
    }
    if (back) std::reverse(between.begin(), between.end());
    ring.insert(ring.end(), between.begin(), between.end());
  }

  /// A node between two cuts of an edge, in the band that both bound.
  int32_t add_middle(const BorderCut& a, const BorderCut& b) {
    double height = 0.5 * (a.height_m + b.height_m);
    if (!a.first_higher && b.first_higher) height = std::max(a.height_m, b.height_m) + 0.25 * gap_;
    if (a.first_higher && !b.first_higher) height = std::min(a.height_m, b.height_m) - 0.25 * gap_;
    return add_node(0.5 * (a.at + b.at), height);
  }

  const Patch& patch_;
  const std::vector<double>& levels_;
  const CutContours& cut_;
  Grid<int32_t> nodes_;
  std::vector<int32_t> cut_node_;
  std::vector<int> cut_of_node_;
  geom::HeightMesh mesh_;
  double tiny_ = 0.0, gap_ = 0.0;
};

/// Fewer points on the same line, its ends among them.
Polyline thinned(const Polyline& points, double tolerance_m) { return geom::simplify_line(points, tolerance_m); }

/// Joins outer pieces through the chains between them.
void join_pieces(const CutContours& cut, const std::vector<const geom::LevelChain*>& chain_from, const PatchMesh& mesh,
                 double tolerance_m, const std::string& name, std::vector<Contour>& contours) {
  std::vector<int> piece_from(cut.cuts.size(), -1);
  for (size_t i = 0; i < cut.pieces.size(); ++i) piece_from[cut.pieces[i].from] = static_cast<int>(i);
  std::vector<char> used(cut.pieces.size(), 0);
  const auto fail = [&](size_t c) {
    throw InvalidArgument(name, "the contour of " + format_number(cut.cuts[c].height_m) + " m that comes in at " +
                                    place_text(cut.cuts[c].at) +
                                    " cannot be joined: contours beside it miss the levels between");
  };
  for (size_t start = 0; start < cut.pieces.size(); ++start) {
    if (used[start] != 0) continue;
    Contour made{cut.cuts[cut.pieces[start].from].height_m, {}, -1};
    for (size_t i = start; used[i] == 0;) {
      used[i] = 1;
      const OuterPiece& piece = cut.pieces[i];
      made.ring.insert(made.ring.end(), piece.between.begin(), piece.between.end());
      const geom::LevelChain* chain = chain_from[piece.to];
      if (chain == nullptr) fail(piece.to);
      const int leaves = mesh.cut_at(chain->last_node);
      if (leaves < 0 || piece_from[static_cast<size_t>(leaves)] < 0) fail(piece.to);
      const Polyline inner = thinned(chain->points, tolerance_m);
      made.ring.insert(made.ring.end(), inner.begin(), inner.end());
      i = static_cast<size_t>(piece_from[static_cast<size_t>(leaves)]);
    }
    contours.push_back(std::move(made));
  }
}

}  // namespace

Patch::Patch(const GridFrame& frame) : nodes(frame) {
  GridFrame between = frame;
  between.width = frame.width - 1;
  between.height = frame.height - 1;
  between.west_m += 0.5 * frame.cell_m;
  between.north_m -= 0.5 * frame.cell_m;
  squares = Grid<uint8_t>(between, 0);
}

bool Patch::at_border(int x, int y) const {
  const int around = static_cast<int>(has(x - 1, y - 1)) + static_cast<int>(has(x, y - 1)) +
                     static_cast<int>(has(x - 1, y)) + static_cast<int>(has(x, y));
  return around > 0 && around < 4;
}

bool is_clear(const Patch& patch, const ContourSet& set, const RunContext& run) {
  return cut_contours(set, patch, run).has_value();
}

void replace_patch(ContourSet& set, const Patch& patch, const ScalarField& heights, const std::vector<double>& levels,
                   const std::string& name, const RunContext& run) {
  const std::optional<CutContours> cut = cut_contours(set, patch, run);
  if (!cut) throw Error(name + ": a contour passes through a corner of the patch");
  run.check_cancelled();
  const PatchMesh mesh(patch, heights, levels, *cut, run);
  const std::vector<geom::LevelChain> chains = geom::march_open_triangles(mesh.mesh(), levels, run);
  run.check_cancelled();
  const double tolerance = 0.03 * patch.nodes.cell_m;
  // What a few nodes more or less would make come and go is no landform.
  const double least_area = 2.0 * patch.nodes.cell_m * patch.nodes.cell_m;
  std::vector<Contour> contours = cut->whole;
  std::vector<const geom::LevelChain*> chain_from(cut->cuts.size(), nullptr);
  for (const geom::LevelChain& chain : chains) {
    run.check_cancelled();
    if (chain.closed) {
      Ring ring = geom::simplify(chain.points, tolerance);
      if (ring.size() >= 3 && std::abs(geom::signed_area(ring)) >= least_area)
        contours.push_back({chain.height_m, std::move(ring), -1});
    } else if (const int c = mesh.cut_at(chain.first_node); c >= 0) {
      chain_from[static_cast<size_t>(c)] = &chain;
    }
  }
  join_pieces(*cut, chain_from, mesh, tolerance, name, contours);
  if (const auto crossing = geom::find_contour_crossing(contours, run))
    throw Error(name + ": contours would cross at " + place_text(crossing->at) + "; move the outline a little");
  geom::nest_contours(contours, run);
  set.contours = std::move(contours);
}

}  // namespace seamount::contour
