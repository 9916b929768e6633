#include "seamount/train/dictionary.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/halve_cells.h"
#include "seamount/ops/amplify/sparse.h"
#include "seamount/train/dictionary_pieces.h"

namespace seamount::train {
namespace {

using amplify::Detail, amplify::Features;

constexpr int kRounds = 8;
constexpr int64_t kPiecesTogether = 2048;
constexpr size_t kLeastPieces = 16;

/// The nearest of the centres for each piece.
std::vector<amplify::AtomTable::Match> assign(const std::vector<Features>& shapes, const std::vector<Features>& centres,
                                              const RunContext& run) {
  const amplify::AtomTable table(centres);
  std::vector<amplify::AtomTable::Match> matches(shapes.size());
  parallel_blocks(run, static_cast<int64_t>(shapes.size()), kPiecesTogether, [&](int64_t begin, int64_t end) {
    const auto n = static_cast<size_t>(end - begin);
    table.find(std::span(shapes).subspan(begin, n), std::span(matches).subspan(begin, n));
  });
  return matches;
}

/// Means of the shapes of each group, of length one; groups without any keep their centre.
void move_centres(const std::vector<Features>& shapes, const std::vector<amplify::AtomTable::Match>& matches,
                  std::vector<Features>& centres) {
  std::vector<std::array<double, amplify::kFeatures>> sums(centres.size());
  for (size_t i = 0; i < shapes.size(); ++i)
    for (size_t f = 0; f < amplify::kFeatures; ++f) sums[matches[i].atom][f] += shapes[i][f];
  for (size_t c = 0; c < centres.size(); ++c) {
    double squares = 0.0;
    for (const double sum : sums[c]) squares += sum * sum;
    if (squares <= 0.0) continue;
    for (size_t f = 0; f < amplify::kFeatures; ++f) centres[c][f] = static_cast<float>(sums[c][f] / std::sqrt(squares));
  }
}

/// Of a group the piece that stands for it.
const Piece& typical(const std::vector<Piece>& pieces, const std::vector<amplify::AtomTable::Match>& matches,
                     std::vector<size_t> group) {
  double squares = 0.0;
  for (const size_t i : group) squares += static_cast<double>(pieces[i].strength) * pieces[i].strength;
  const double strength = std::sqrt(squares / static_cast<double>(group.size()));
  const auto nearer = [&](size_t a, size_t b) {
    return matches[a].cosine != matches[b].cosine ? matches[a].cosine > matches[b].cosine : a < b;
  };
  std::sort(group.begin(), group.end(), nearer);
  group.resize((group.size() + 1) / 2);
  const auto off = [&](size_t i) { return std::abs(std::log(pieces[i].strength / strength)); };
  return pieces[*std::min_element(group.begin(), group.end(), [&](size_t a, size_t b) { return off(a) < off(b); })];
}

amplify::Dictionary stand_ins(const std::vector<Piece>& pieces, const std::vector<Features>& shapes, int atoms,
                              const RunContext& run) {
  std::vector<Features> centres(shapes.begin(), shapes.begin() + std::min(shapes.size(), static_cast<size_t>(atoms)));
  std::vector<amplify::AtomTable::Match> matches;
  for (int round = 0; round < kRounds; ++round) {
    matches = assign(shapes, centres, run.part(static_cast<double>(round) / kRounds, (round + 1.0) / kRounds));
    if (round + 1 < kRounds) move_centres(shapes, matches, centres);
  }
  std::vector<std::vector<size_t>> groups(centres.size());
  for (size_t i = 0; i < shapes.size(); ++i) groups[matches[i].atom].push_back(i);
  amplify::Dictionary dictionary;
  for (const std::vector<size_t>& group : groups) {
    if (group.empty()) continue;
    const Piece& piece = typical(pieces, matches, group);
    dictionary.shapes.push_back(piece.shape);
    dictionary.details.push_back(piece.detail);
  }
  return dictionary;
}

/// Sums of squares of what the ground has over its coarse cells, and of what the dictionary gives them back.
struct Strengths {
  double real = 0.0, made = 0.0;
};

Strengths compare_strength(const HeightField& ground, const amplify::Dictionary& dictionary, const RunContext& run) {
  GridFrame frame = ground.frame();
  frame.width &= ~1;
  frame.height &= ~1;
  HeightField fine(frame);
  for (int y = 0; y < frame.height; ++y) std::copy_n(ground.row(y).begin(), frame.width, fine.row(y).begin());
  const HeightField coarse = geom::means_of_four(fine, run.part(0.0, 0.0));
  const amplify::SparseParams doubling{.factor = amplify::Factor::x2};
  const HeightField made = amplify::sparse(coarse, dictionary, doubling, run.part(0.0, 0.9));
  const HeightField plain = amplify::sparse(coarse, {{Features{}}, {Detail{}}}, doubling, run.part(0.9, 1.0));
  Strengths sums;
  for (size_t i = 0; i < fine.size(); ++i) {
    const double z = fine.data()[i], base = plain.data()[i];
    if (!(z > 0.0) || std::isnan(base)) continue;
    sums.real += (z - base) * (z - base);
    sums.made += std::pow(made.data()[i] - base, 2);
  }
  return sums;
}

}  // namespace

LearnedDictionary learn_dictionary(std::span<const HeightField> grounds, const DictionaryParams& params, Seed seed,
                                   const RunContext& run) {
  check_params(params);
  const std::vector<Piece> pieces =
      draw_pieces(grounds, params.pieces, params.least_detail_m, seed, run.part(0.0, 0.2));
  if (pieces.size() < kLeastPieces)
    throw Error("only " + std::to_string(pieces.size()) + " of " + std::to_string(params.pieces) +
                " places are land with detail; nothing can be learned from that");
  std::vector<Features> shapes;
  for (const Piece& piece : pieces) shapes.push_back(piece.shape);
  LearnedDictionary learned{stand_ins(pieces, shapes, params.atoms, run.part(0.2, 0.6)),
                            static_cast<int64_t>(pieces.size()), 1.0};
  Strengths sums;
  for (size_t i = 0; i < grounds.size(); ++i) {
    const double n = static_cast<double>(grounds.size());
    const Strengths of = compare_strength(grounds[i], learned.dictionary,
                                          run.part(0.6 + 0.4 * static_cast<double>(i) / n, 0.6 + 0.4 * (i + 1.0) / n));
    sums.real += of.real;
    sums.made += of.made;
  }
  if (sums.made > 0.0) learned.scale = std::sqrt(sums.real / sums.made);
  for (Detail& detail : learned.dictionary.details)
    for (float& z : detail) z *= static_cast<float>(learned.scale);
  return learned;
}

}  // namespace seamount::train
