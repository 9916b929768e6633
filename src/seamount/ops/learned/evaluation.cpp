#include "seamount/ops/learned/evaluation.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/ops/learned/feature_map.h"
#include "seamount/ops/learned/plane_rows.h"
#include "seamount/ops/learned/rows.h"

namespace seamount::learned {
namespace {

/// Rows of the map around a tile that its result depends on, rounded up to what all its levels can be cut at: up to 26,
/// counted from `outer` back to `input`.
constexpr int kAround = 32;
/// Levels that are evaluated tile by tile: strides 2 and 4.
constexpr int kFineLevels = 2;
/// Memory that these levels may take before a map is cut.
constexpr int64_t kMostBytes = int64_t{3} << 28;
/// Multiplications of a block: long enough to pay for its scheduling.
constexpr double kBlockWork = 4e6;
/// Scratch memory that a block should keep to: what is in the cache is not fetched again.
constexpr size_t kScratchBytes = size_t{1} << 20;

/// Some rows of a level. `first`: which of the level's rows is the first.
template <class T>
struct Part {
  FeatureMap<T> cells;
  int first = 0;
};

template <class T>
using Buffer = std::vector<T, detail::UninitialisedAllocator<T>>;

template <class T>
T* sized(Buffer<T>& buffer, size_t count) {
  if (buffer.size() < count) {
    buffer.clear();
    buffer.resize(count);
  }
  return buffer.data();
}

/// What one block needs for itself.
template <class T>
struct Scratch {
  PlaneRows planes;
  Buffer<float> blend, inner;
  Buffer<T> in, out;
};

/// Scratch memory for as many blocks as are at work at once.
template <class T>
class ScratchPool {
 public:
  std::unique_ptr<Scratch<T>> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<Scratch<T>>();
    std::unique_ptr<Scratch<T>> taken = std::move(free_.back());
    free_.pop_back();
    return taken;
  }
  void give(std::unique_ptr<Scratch<T>> scratch) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch<T>>> free_;
};

/// Rows of the map: a tile, and what is computed for it.
struct Tile {
  int begin, end;   ///< whose result is wanted
  int first, last;  ///< with those around: [first, last)
};

template <class T>
class Evaluation {
 public:
  Evaluation(const Layers& layers, const Planes& planes, const GridFrame& frame, const RunContext& run, int tile)
      : layers_(layers), planes_(planes), run_(run), levels_(layers.architecture.levels()), result_(frame) {
    const int stride = layers.architecture.stride();
    width_ = (planes.width + stride - 1) / stride * stride;
    height_ = (planes.height + stride - 1) / stride * stride;
    fine_ = std::min(kFineLevels, levels_ - 1);
    tile_ = std::min(tile > 0 ? tile : fitting_tile(stride), height_);
    parts_.resize(levels_);
  }

  ScalarField evaluate() {
    const std::vector<Tile> tiles = cut();
    count_work(static_cast<int>(tiles.size()));
    parts_[fine_].cells = map(fine_, height_ >> (fine_ + 1));
    for (const Tile& tile : tiles) {
      encode(tile);
      down(fine_, tile.begin >> (fine_ + 1), tile.end >> (fine_ + 1));
    }
    const Part<T> coarse = decode_coarse();
    // The last tile comes first: its levels are still there.
    for (size_t t = tiles.size(); t-- > 0;) {
      if (t + 1 < tiles.size()) encode(tiles[t]);
      Part<T> low;
      for (int level = fine_ - 1; level >= 0; --level) low = merge(level, level == fine_ - 1 ? coarse : low);
      head(tiles[t], low);
    }
    run_.report(1.0);
    return std::move(result_);
  }

 private:
  int width_of(int level) const { return width_ >> (level + 1); }
  int channels_of(int level) const { return layers_.architecture.widths[level]; }
  FeatureMap<T> map(int level, int rows) const { return {rows, width_of(level), channels_of(level)}; }

  /// As few tiles as memory allows, all of about the same size.
  int fitting_tile(int stride) const {
    const int64_t cell = channels_of(0) / 4 + (fine_ > 1 ? channels_of(1) / 16 : 0) + 2 * kThinWidth / 4;
    const int64_t bytes = static_cast<int64_t>(sizeof(T)) * width_ * height_ * cell;
    const auto tiles = static_cast<int>(std::min<int64_t>((bytes + kMostBytes - 1) / kMostBytes, height_ / stride));
    return (height_ / stride + tiles - 1) / tiles * stride;
  }

  std::vector<Tile> cut() const {
    std::vector<Tile> tiles;
    for (int begin = 0; begin < height_; begin += tile_) {
      const int end = std::min(begin + tile_, height_);
      tiles.push_back({begin, end, std::max(0, begin - kAround), std::min(height_, end + kAround)});
    }
    return tiles;
  }

  void count_work(int tiles) {
    total_ = 0.0;
    const auto cells = [this](int level) { return static_cast<double>(height_ >> (level + 1)) * width_of(level); };
    for (int k = 0; k < levels_; ++k) {
      const double again = k < fine_ ? 2.0 - 1.0 / tiles : 1.0;
      total_ += again * cells(k) * (k == 0 ? layers_["input"] : layers_("down", k)).work();
      if (k < levels_ - 1) total_ += cells(k) * layers_("join", k).work() * (layers_.has_deep(k) ? 2.0 : 1.0);
    }
    total_ += cells(levels_ - 1) * layers_["middle"].work() + cells(-1) / 2 * layers_["inner"].work();
  }

  /// The loop of a layer over rows [begin, end): bands(scratch, begin, end), `row_work` multiplications a row; `least`
  /// rows a band where there are enough, since bands compute some rows around them twice, but not many more than fit a
  /// cache at `row_numbers` a row.
  template <class Band>
  void bands(int begin, int end, double row_work, int least, size_t row_numbers, const Band& band) {
    const RunContext part =
        run_.part(std::min(1.0, done_ / total_), std::min(1.0, (done_ + row_work * (end - begin)) / total_));
    done_ += row_work * (end - begin);
    const int rows = std::max(1, static_cast<int>(kBlockWork / row_work));
    const int most = std::max(1, (end - begin + 1) / 2);
    const int fitting = std::max(4, static_cast<int>(kScratchBytes / (row_numbers * sizeof(T))));
    const int enough = std::min(std::clamp((end - begin) / 16, least, 2 * least), fitting);
    parallel_blocks(part, end - begin, std::min(std::max(rows, enough), most), [&](int64_t from, int64_t to) {
      std::unique_ptr<Scratch<T>> scratch = pool_.take();
      band(*scratch, begin + static_cast<int>(from), begin + static_cast<int>(to));
      pool_.give(std::move(scratch));
    });
  }

  /// The fine levels of a tile.
  void encode(const Tile& tile) {
    for (int k = 0; k < fine_; ++k) parts_[k] = {};
    input(tile);
    for (int k = 1; k < fine_; ++k) {
      const int rows = (tile.last - tile.first) >> (k + 1);
      parts_[k] = {map(k, rows), tile.first >> (k + 1)};
      down(k, parts_[k].first, parts_[k].first + rows);
    }
  }

  void input(const Tile& tile) {
    const Convolver& conv = layers_["input"];
    const int rows = (tile.last - tile.first) / 2, width = width_of(0), channels = 4 * planes_.count;
    const size_t stride = static_cast<size_t>(width) * channels;
    parts_[0] = {map(0, rows), tile.first / 2};
    Part<T>& out = parts_[0];
    bands(out.first, out.first + rows, conv.work() * width, 8, stride, [&](Scratch<T>& scratch, int begin, int end) {
      T* in = sized(scratch.in, stride * (end - begin + 2));
      const int from = std::max(begin - 1, 0), to = std::min(end + 1, height_ / 2);
      scratch.planes.fetch(planes_, width_, 2 * from, 2 * to);
      for (int y = begin - 1; y <= end; ++y) {
        T* row = in + stride * (y - begin + 1);
        if (y < from || y >= to) {
          std::fill_n(row, stride, T{});
        } else {
          halve(scratch.planes.row(2 * y), scratch.planes.row(2 * y + 1), width, planes_.count, row);
        }
      }
      conv.run(in, width, end - begin, out.cells.row(begin - out.first));
    });
  }

  /// Rows [begin, end) of a level from the one before.
  void down(int level, int begin, int end) {
    const Convolver& conv = layers_("down", level);
    const Part<T>& in = parts_[level - 1];
    Part<T>& out = parts_[level];
    bands(begin, end, conv.work() * width_of(level), 1, 1, [&](Scratch<T>&, int from, int to) {
      conv.run(in.cells.row(2 * from - 1 - in.first), in.cells.width(), to - from, out.cells.row(from - out.first));
    });
  }

  /// The 1x1 convolution that follows a level on the way back.
  const Convolver& narrow(int level) const { return level == 0 ? layers_["thin"] : layers_("lift", level - 1); }

  Part<T> decode_coarse() {
    for (int k = fine_ + 1; k < levels_; ++k) {
      const int rows = height_ >> (k + 1);
      parts_[k].cells = map(k, rows);
      down(k, 0, rows);
    }
    Part<T> low = finish(levels_ - 1, parts_[levels_ - 1], layers_["middle"]);
    parts_[levels_ - 1] = {};
    for (int k = levels_ - 2; k >= fine_; --k) low = merge(k, low);
    return low;
  }

  /// narrow(relu(in + conv(in))).
  Part<T> finish(int level, const Part<T>& in, const Convolver& conv) {
    const Convolver& after = narrow(level);
    const FeatureMap<T>& cells = in.cells;
    Part<T> out{{cells.rows(), cells.width(), after.out_channels()}, in.first};
    bands(0, cells.rows(), conv.work() * cells.width(), 1, 1, [&](Scratch<T>& scratch, int begin, int end) {
      T* sum = sized(scratch.out, cells.row_size() * (end - begin));
      std::copy(cells.row(begin), cells.row(end), sum);
      conv.run(cells.row(begin - 1), cells.width(), end - begin, sum);
      after.run(sum, cells.width(), end - begin, out.cells.row(begin));
    });
    return out;
  }

  /// narrow(d) of a level from the lifted level below it; its skip is used up.
  Part<T> merge(int level, const Part<T>& low) {
    const Convolver &join = layers_("join", level), &after = narrow(level);
    const Part<T> skip = std::move(parts_[level]);
    parts_[level] = {};
    const int rows = skip.cells.rows(), width = skip.cells.width();
    const size_t stride = skip.cells.row_size();
    const bool deep = layers_.has_deep(level);
    Part<T> out{{rows, width, deep ? channels_of(level) : after.out_channels()}, skip.first};
    bands(0, rows, join.work() * width, 8, stride, [&](Scratch<T>& scratch, int begin, int end) {
      T* sum = sized(scratch.in, stride * (end - begin + 2));
      for (int y = begin - 1; y <= end; ++y) merge_row(low, skip, y, scratch, sum + stride * (y - begin + 1));
      T* joined = deep ? out.cells.row(begin) : sized(scratch.out, stride * (end - begin));
      join.run(sum, width, end - begin, joined);
      if (!deep) after.run(joined, width, end - begin, out.cells.row(begin));
    });
    return deep ? finish(level, out, layers_("deep", level)) : std::move(out);
  }

  /// The two rows of `low` that a row of twice the size lies between, the nearer first.
  static std::pair<const T*, const T*> rows_below(const Part<T>& low, int y) {
    const auto row = [&](int at) { return low.cells.row(std::clamp(at - low.first, 0, low.cells.rows() - 1)); };
    return {row(y / 2), row(y % 2 == 0 ? y / 2 - 1 : y / 2 + 1)};
  }

  /// relu(up2(low) + skip), or zeros beyond the skip's rows.
  void merge_row(const Part<T>& low, const Part<T>& skip, int y, Scratch<T>& scratch, T* out) const {
    const size_t stride = skip.cells.row_size();
    if (y < 0 || y >= skip.cells.rows()) {
      std::fill_n(out, stride, T{});
      return;
    }
    const auto [near, far] = rows_below(low, y + skip.first);
    upsample_add_relu(near, far, skip.cells.row(y), low.cells.width(), skip.cells.channels(),
                      sized(scratch.blend, low.cells.row_size()), out);
  }

  /// The full size: up2(thin) and the planes, inner, outer.
  void head(const Tile& tile, const Part<T>& thin) {
    const Convolver& inner = layers_["inner"];
    // A cell of zeros left and right of each row, and two cells side by side at once (layers.h).
    const size_t in_cell = static_cast<size_t>(kThinWidth + planes_.count), in_stride = (width_ + 2) * in_cell;
    const size_t inner_stride = static_cast<size_t>(width_) * kInnerWidth;
    const int end_row = std::min(tile.end, planes_.height);
    if (tile.begin >= end_row) return;
    bands(tile.begin, end_row, inner.work() * width_ / 2, 16, in_stride, [&](Scratch<T>& scratch, int begin, int end) {
      T* in = sized(scratch.in, in_stride * (end - begin + 4));
      float* middle = sized(scratch.inner, inner_stride * (end - begin + 2));
      const int from = std::max(begin - 2, 0), to = std::min(end + 2, height_);
      scratch.planes.fetch(planes_, width_, from, to);
      for (int y = begin - 2; y < end + 2; ++y) {
        T* row = in + in_stride * (y - begin + 2);
        if (y < from || y >= to) {
          std::fill_n(row, in_stride, T{});
          continue;
        }
        const auto [near, far] = rows_below(thin, y);
        std::fill_n(row, in_cell, T{});
        std::fill_n(row + in_stride - in_cell, in_cell, T{});
        upsample_concat(near, far, scratch.planes.row(y), width_ / 2, planes_.count,
                        sized(scratch.blend, thin.cells.row_size()), row + in_cell);
      }
      inner.run(in, width_ / 2 + 1, end - begin + 2, middle);
      if (begin == 0) std::fill_n(middle, inner_stride, 0.0F);
      if (end == height_) std::fill_n(middle + inner_stride * (end - begin + 1), inner_stride, 0.0F);
      for (int y = begin; y < end; ++y) {
        const float* above = middle + inner_stride * (y - begin);
        const float* const around[3] = {above, above + inner_stride, above + 2 * inner_stride};
        outer_row(around, layers_.outer_weight.data(), layers_.outer_bias, width_, planes_.width,
                  result_.row(y).data());
      }
    });
  }

  const Layers& layers_;
  const Planes& planes_;
  const RunContext& run_;
  int levels_, fine_ = 0, width_ = 0, height_ = 0, tile_ = 0;
  double done_ = 0.0, total_ = 1.0;
  std::vector<Part<T>> parts_;  ///< of the encoder, by level
  ScratchPool<T> pool_;
  ScalarField result_;
};

/// Planes of all rows, made once: the network reads them twice, and bands some rows more.
class KeptPlanes {
 public:
  KeptPlanes(const Planes& planes, const RunContext& run)
      : row_(static_cast<size_t>(planes.width) * static_cast<size_t>(planes.count)),
        values_(row_ * static_cast<size_t>(planes.height)),
        planes_{planes.width, planes.height, planes.count, [this](int begin, int end, std::span<float> values) {
                  std::copy_n(row(begin), row_ * static_cast<size_t>(end - begin), values.data());
                }} {
    constexpr int kRows = 8;
    parallel_blocks(run, planes.height, kRows, [&](int64_t begin, int64_t end) {
      const std::span<float> values(row(begin), row_ * static_cast<size_t>(end - begin));
      planes.fill(static_cast<int>(begin), static_cast<int>(end), values);
    });
  }
  KeptPlanes(const KeptPlanes&) = delete;
  KeptPlanes& operator=(const KeptPlanes&) = delete;

  const Planes& planes() const { return planes_; }

 private:
  float* row(int64_t y) { return values_.data() + row_ * static_cast<size_t>(y); }

  size_t row_;
  Buffer<float> values_;
  Planes planes_;
};

/// What is kept of them stays in the cache or near it.
constexpr int64_t kMostKept = 6 << 20;

}  // namespace

ScalarField evaluate(const Layers& layers, const Planes& planes, const GridFrame& frame, const RunContext& run,
                     int tile) {
  if (static_cast<int64_t>(planes.width) * planes.height * planes.count <= kMostKept && !planes.kept) {
    KeptPlanes kept(planes, run.part(0, 0.05));
    Planes again = kept.planes();
    again.kept = true;
    return evaluate(layers, again, frame, run.part(0.05, 1), tile);
  }
  if (layers.bf16) return Evaluation<Bf16>(layers, planes, frame, run, tile).evaluate();
  return Evaluation<float>(layers, planes, frame, run, tile).evaluate();
}

}  // namespace seamount::learned
