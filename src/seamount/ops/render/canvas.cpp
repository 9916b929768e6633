#include "seamount/ops/render/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamount::render {

void blend(Image& image, int x, int y, Colour colour, float share) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height || share <= 0.0F) return;
  uint8_t* pixel = image.pixel(x, y);
  const auto mixed = [&](uint8_t from, uint8_t to) {
    return static_cast<uint8_t>(static_cast<float>(from) + share * (static_cast<float>(to) - static_cast<float>(from)) +
                                0.5F);
  };
  pixel[0] = mixed(pixel[0], colour.r);
  pixel[1] = mixed(pixel[1], colour.g);
  pixel[2] = mixed(pixel[2], colour.b);
}

void fill_box(Image& image, double x0, double y0, double x1, double y1, Colour colour) {
  const auto overlap = [](int cell, double from, double to) {
    return std::max(0.0, std::min(to, cell + 1.0) - std::max(from, static_cast<double>(cell)));
  };
  for (int y = static_cast<int>(std::floor(y0)); y < y1; ++y) {
    for (int x = static_cast<int>(std::floor(x0)); x < x1; ++x) {
      blend(image, x, y, colour, static_cast<float>(overlap(x, x0, x1) * overlap(y, y0, y1)));
    }
  }
}

void frame_box(Image& image, double x0, double y0, double x1, double y1, double width, Colour colour) {
  fill_box(image, x0, y0, x1, y0 + width, colour);
  fill_box(image, x0, y1 - width, x1, y1, colour);
  fill_box(image, x0, y0 + width, x0 + width, y1 - width, colour);
  fill_box(image, x1 - width, y0 + width, x1, y1 - width, colour);
}

void fill_polygon(Image& image, const std::vector<Vec2>& corners, Colour colour) {
  if (corners.size() < 3) return;
  constexpr int kSide = 4;
  Vec2 low = corners[0], high = low;
  for (const Vec2& p : corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto inside = [&](double x, double y) {
    bool odd = false;
    for (size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
      const Vec2 &a = corners[i], &b = corners[j];
      if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y)) odd = !odd;
    }
    return odd;
  };
  for (int y = static_cast<int>(std::floor(low.y)); y <= high.y; ++y) {
    for (int x = static_cast<int>(std::floor(low.x)); x <= high.x; ++x) {
      int covered = 0;
      for (int s = 0; s < kSide * kSide; ++s) {
        const int column = s % kSide, row = s / kSide;
        covered += inside(x + (column + 0.5) / kSide, y + (row + 0.5) / kSide) ? 1 : 0;
      }
      blend(image, x, y, colour, static_cast<float>(covered) / (kSide * kSide));
    }
  }
}

void fill_disc(Image& image, Vec2 middle, double radius, Colour colour) {
  const double reach = radius + 0.5, most = std::min(1.0, std::numbers::pi * radius * radius);
  for (int y = static_cast<int>(std::floor(middle.y - reach)); y <= middle.y + reach; ++y) {
    for (int x = static_cast<int>(std::floor(middle.x - reach)); x <= middle.x + reach; ++x) {
      const double distance = std::hypot(x + 0.5 - middle.x, y + 0.5 - middle.y);
      blend(image, x, y, colour, static_cast<float>(std::clamp(reach - distance, 0.0, most)));
    }
  }
}

LineLayer::LineLayer(int width, int height) : coverage_(GridFrame{width, height, 1.0, 0.0, 0.0, {}}, 0.0F) {}

void LineLayer::add(const Polyline& line, double width) {
  const double reach = 0.5 * width + 0.5;
  for (size_t i = 1; i < line.size(); ++i) {
    const Vec2 a = line[i - 1], b = line[i], along = b - a;
    const double length2 = dot(along, along);
    const int x0 = std::max(0, static_cast<int>(std::floor(std::min(a.x, b.x) - reach)));
    const int x1 = std::min(coverage_.width() - 1, static_cast<int>(std::max(a.x, b.x) + reach));
    const int y0 = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - reach)));
    const int y1 = std::min(coverage_.height() - 1, static_cast<int>(std::max(a.y, b.y) + reach));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const Vec2 to = Vec2{x + 0.5, y + 0.5} - a;
        const double t = length2 > 0.0 ? std::clamp(dot(to, along) / length2, 0.0, 1.0) : 0.0;
        const Vec2 off = to - t * along;
        const double share = std::clamp(reach - std::sqrt(dot(off, off)), 0.0, std::min(1.0, width));
        coverage_(x, y) = std::max(coverage_(x, y), static_cast<float>(share));
      }
    }
  }
}

void LineLayer::draw(Image& image, int x, int y, Colour colour, float opacity) const {
  for (int row = 0; row < coverage_.height(); ++row) {
    for (int column = 0; column < coverage_.width(); ++column) {
      blend(image, x + column, y + row, colour, opacity * coverage_(column, row));
    }
  }
}

}  // namespace seamount::render
