#include "seamount/train/sample_picture.h"

#include <algorithm>
#include <cmath>

#include "seamount/io/image_file.h"
#include "seamount/model/image.h"

namespace seamount::train {
namespace {

constexpr int kGap = 4;

/// Light from the north-west on heights in shares of the relief, at a vertical scale that shows detail.
void shade(const std::vector<float>& z, int size, int left, int top, Image& image) {
  const float steep = static_cast<float>(size) * 0.35F;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const auto at = [&](int u, int v) {
        return z[static_cast<size_t>(std::clamp(v, 0, size - 1) * size + std::clamp(u, 0, size - 1))];
      };
      const float dx = steep * 0.5F * (at(x + 1, y) - at(x - 1, y)), dy = steep * 0.5F * (at(x, y + 1) - at(x, y - 1));
      const float light = (0.55F * dx + 0.55F * dy + 0.63F) / std::sqrt(1 + dx * dx + dy * dy);
      const float tint = std::clamp(at(x, y), 0.0F, 1.2F);
      const auto grey =
          static_cast<uint8_t>(std::clamp(255 * (0.15F + 0.95F * light) * (0.75F + 0.25F * tint), 0.0F, 255.0F));
      std::fill_n(image.pixel(left + x, top + y), 3, grey);
    }
  }
}

}  // namespace

void write_sample_picture(const std::vector<Sample>& samples, bool sketched,
                          const std::vector<std::vector<float>>& made, const std::string& path) {
  if (samples.empty()) return;
  const int size = samples[0].size, columns = 4, rows = (static_cast<int>(samples.size()) + columns - 1) / columns;
  Image image(columns * (size + kGap), rows * 3 * (size + kGap), Colour{255, 255, 255});
  for (size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const int left = static_cast<int>(i) % columns * (size + kGap),
              top = static_cast<int>(i) / columns * 3 * (size + kGap);
    shade(sample.base, size, left, top, image);
    const size_t planes = sample.planes.size() / sample.base.size();
    for (size_t cell = 0; cell < sample.base.size() && sketched; ++cell) {
      const float* const p = sample.planes.data() + cell * planes;
      uint8_t* const pixel = image.pixel(left + static_cast<int>(cell) % size, top + static_cast<int>(cell) / size);
      Colour colour = {pixel[0], pixel[1], pixel[2]};
      if (p[6] != 0)
        colour = {static_cast<uint8_t>(colour.r / 2 + (p[6] > 0 ? 120 : 40)), static_cast<uint8_t>(colour.g / 2 + 60),
                  colour.b};
      if (p[0] > 0.7F) colour = {40, 80, 255};
      if (p[2] > 0.7F) colour = {235, 40, 30};
      if (p[4] > 0.6F) colour = {30, 200, 60};
      pixel[0] = colour.r;
      pixel[1] = colour.g;
      pixel[2] = colour.b;
    }
    shade(made[i], size, left, top + size + kGap, image);
    shade(sample.target, size, left, top + 2 * (size + kGap), image);
  }
  io::write_picture(image, path);
}

}  // namespace seamount::train
