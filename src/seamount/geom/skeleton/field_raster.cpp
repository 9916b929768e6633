// See field_raster.h.
#include "seamount/geom/skeleton/field_raster.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace seamount::geom {

bool FieldRaster::covers(const Box& box) const {
  const Vec2 low = {origin_.x + column_ * cell_, origin_.y + row_ * cell_};
  return width_ > 1 && height_ > 1 && box.low.x >= low.x && box.low.y >= low.y &&
         box.high.x <= low.x + (width_ - 1) * cell_ && box.high.y <= low.y + (height_ - 1) * cell_;
}

double FieldRaster::size_with(const Box& box) const {
  const Vec2 low = {origin_.x + column_ * cell_, origin_.y + row_ * cell_};
  const Vec2 high = {low.x + width_ * cell_, low.y + height_ * cell_};
  const double width = std::max(box.high.x, high.x) - std::min(box.low.x, low.x);
  const double height = std::max(box.high.y, high.y) - std::min(box.low.y, low.y);
  return (width / cell_ + 2.0) * (height / cell_ + 2.0);
}

void FieldRaster::add_missing(const Box& box, std::vector<Vec2>& places) {
  int left = static_cast<int>(std::floor((box.low.x - origin_.x) / cell_));
  int bottom = static_cast<int>(std::floor((box.low.y - origin_.y) / cell_));
  int right = static_cast<int>(std::ceil((box.high.x - origin_.x) / cell_)) + 1;
  int top = static_cast<int>(std::ceil((box.high.y - origin_.y) / cell_)) + 1;
  if (width_ > 0) {
    left = std::min(left, column_);
    bottom = std::min(bottom, row_);
    right = std::max(right, column_ + width_ - 1);
    top = std::max(top, row_ + height_ - 1);
  }
  const int width = right - left + 1, height = top - bottom + 1;
  std::vector<double> raw(static_cast<size_t>(width) * static_cast<size_t>(height));
  wanted_at_.clear();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const size_t to = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
      const int old_x = left + x - column_, old_y = bottom + y - row_;
      if (old_x >= 0 && old_y >= 0 && old_x < width_ && old_y < height_) {
        raw[to] = raw_[static_cast<size_t>(old_y) * static_cast<size_t>(width_) + static_cast<size_t>(old_x)];
      } else {
        wanted_at_.push_back(static_cast<uint32_t>(to));
        places.push_back(origin_ + cell_ * Vec2{static_cast<double>(left + x), static_cast<double>(bottom + y)});
      }
    }
  }
  raw_.swap(raw);
  column_ = left;
  row_ = bottom;
  width_ = width;
  height_ = height;
  wanted_ = wanted_at_.size();
}

void FieldRaster::fill(std::span<const double> values) {
  for (size_t i = 0; i < wanted_at_.size(); ++i) raw_[wanted_at_[i]] = values[i];
  sum_rows();
}

void FieldRaster::set_floor(double floor) {
  floor_ = floor;
  sum_rows();
}

void FieldRaster::sum_rows() {
  values_ = raw_;
  sums_.assign(raw_.size(), 0.0);
  for (double& value : values_) value = std::isfinite(value) ? value : floor_;
  const size_t width = static_cast<size_t>(width_), middle = static_cast<size_t>(-column_);
  for (size_t row = 0; row < values_.size(); row += width) {
    for (size_t i = row + middle + 1; i < row + width; ++i) {
      sums_[i] = sums_[i - 1] + 0.5 * cell_ * (values_[i - 1] + values_[i]);
    }
    for (size_t i = row + middle; i > row; --i) {
      sums_[i - 1] = sums_[i] - 0.5 * cell_ * (values_[i - 1] + values_[i]);
    }
  }
}

FieldRaster::Spread FieldRaster::spread() const {
  Spread spread;
  spread.lowest = std::numeric_limits<double>::infinity();
  double sum = 0.0, squares = 0.0;
  for (const double value : raw_) {
    if (!std::isfinite(value)) continue;
    ++spread.count;
    sum += value;
    spread.lowest = std::min(spread.lowest, value);
  }
  if (spread.count == 0) return {};
  spread.mean = sum / static_cast<double>(spread.count);
  for (const double value : raw_) {
    if (std::isfinite(value)) squares += (value - spread.mean) * (value - spread.mean);
  }
  spread.deviation = std::sqrt(squares / static_cast<double>(spread.count));
  return spread;
}

FieldRaster::Cell FieldRaster::cell_of(Vec2 p) const {
  const double x = (p.x - origin_.x) / cell_ - column_, y = (p.y - origin_.y) / cell_ - row_;
  const int i = std::clamp(static_cast<int>(x), 0, width_ - 2), j = std::clamp(static_cast<int>(y), 0, height_ - 2);
  return {static_cast<size_t>(j) * static_cast<size_t>(width_) + static_cast<size_t>(i), x - i, y - j};
}

double FieldRaster::at(Vec2 p) const {
  const auto [index, s, t] = cell_of(p);
  const double* south = values_.data() + index;
  const double* north = south + width_;
  return (1.0 - t) * ((1.0 - s) * south[0] + s * south[1]) + t * ((1.0 - s) * north[0] + s * north[1]);
}

bool FieldRaster::fit(Vec2 p) const {
  const size_t index = cell_of(p).index;
  const double* south = raw_.data() + index;
  const double* north = south + width_;
  return std::isfinite(south[0]) && std::isfinite(south[1]) && std::isfinite(north[0]) && std::isfinite(north[1]);
}

double FieldRaster::integral_to(Vec2 p) const {
  const auto [index, s, t] = cell_of(p);
  const auto along = [&, share = s](size_t row_start) {
    const double here = values_[row_start], next = values_[row_start + 1];
    return sums_[row_start] + cell_ * share * (here + 0.5 * share * (next - here));
  };
  return (1.0 - t) * along(index) + t * along(index + static_cast<size_t>(width_));
}

}  // namespace seamount::geom
