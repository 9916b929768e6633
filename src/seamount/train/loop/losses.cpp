#include "seamount/train/loop/losses.h"

#include <cmath>
#include <cstring>

namespace seamount::train {
namespace {

constexpr double kSlopeScale = 12.0;  ///< slopes in relief per cell are small

torch::Tensor plane(const std::vector<Sample>& samples, std::vector<float> Sample::*part) {
  const int64_t size = samples[0].size;
  torch::Tensor out = torch::empty({static_cast<int64_t>(samples.size()), 1, size, size});
  for (size_t i = 0; i < samples.size(); ++i)
    std::memcpy(out[static_cast<int64_t>(i)].data_ptr<float>(), (samples[i].*part).data(),
                sizeof(float) * static_cast<size_t>(size * size));
  return out;
}

torch::Tensor east(const torch::Tensor& z) { return z.slice(3, 1) - z.slice(3, 0, -1); }
torch::Tensor south(const torch::Tensor& z) { return z.slice(2, 1) - z.slice(2, 0, -1); }

torch::Tensor meaned(const torch::Tensor& x, int64_t cells) {
  return cells == 1 ? x : torch::avg_pool2d(x, {cells, cells});
}

}  // namespace

Losses& Losses::operator+=(const Losses& other) {
  l1 += other.l1;
  slopes += other.slopes;
  critic += other.critic;
  judgement += other.judgement;
  features += other.features;
  return *this;
}

Losses Losses::operator/(int count) const {
  return {l1 / count, slopes / count, critic / count, judgement / count, features / count};
}

Batch as_tensors(const std::vector<Sample>& samples) {
  const int64_t size = samples[0].size;
  const int64_t planes = static_cast<int64_t>(samples[0].planes.size()) / (size * size);
  torch::Tensor seen = torch::empty({static_cast<int64_t>(samples.size()), size, size, planes});
  for (size_t i = 0; i < samples.size(); ++i)
    std::memcpy(seen[static_cast<int64_t>(i)].data_ptr<float>(), samples[i].planes.data(),
                sizeof(float) * samples[i].planes.size());
  return {seen.permute({0, 3, 1, 2}), plane(samples, &Sample::base), plane(samples, &Sample::target),
          plane(samples, &Sample::weight)};
}

torch::Tensor pyramid_loss(const torch::Tensor& made, const Batch& batch, double fine, Losses& losses) {
  const torch::Tensor error = (made - batch.target) * batch.weight;
  torch::Tensor loss = fine * error.abs().mean();
  losses.l1 = error.abs().mean().item<double>();
  for (const int64_t cells : {2, 4, 8, 16, 32}) {
    if (error.size(2) % cells != 0) break;
    loss = loss + (cells < 16 ? fine : 1.0) * meaned(error, cells).abs().mean();
  }
  const torch::Tensor slopes = (east(made) - east(batch.target)).mul(batch.weight.slice(3, 1)).abs().mean() +
                               (south(made) - south(batch.target)).mul(batch.weight.slice(2, 1)).abs().mean();
  losses.slopes = slopes.item<double>();
  return loss + fine * 2.0 * slopes;
}

torch::Tensor critic_view(const torch::Tensor& z, const torch::Tensor& planes, const std::vector<int>& drawn) {
  std::vector<torch::Tensor> parts = {2 * (z - 0.4), torch::constant_pad_nd(east(z), {0, 1, 0, 0}) * kSlopeScale,
                                      torch::constant_pad_nd(south(z), {0, 0, 0, 1}) * kSlopeScale};
  for (const int index : drawn) parts.push_back(planes.slice(1, index, index + 1));
  return torch::cat(parts, 1);
}

double Spectrum::distance() const {
  double sum = 0;
  for (size_t i = 0; i < made.size(); ++i) sum += std::abs(std::log((made[i] + 1e-12) / (real[i] + 1e-12)));
  return sum / static_cast<double>(made.size());
}

void measure(const torch::Tensor& made, const Batch& batch, Check& check, Spectrum& spectrum) {
  const torch::Tensor error = (made - batch.target) * batch.weight;
  const auto count = static_cast<double>(made.size(0));
  check.error += count * error.abs().mean().item<double>();
  check.coarse_error += count * meaned(error, 8).abs().mean().item<double>();
  torch::Tensor a = made * batch.weight, b = batch.target * batch.weight;
  for (size_t octave = 0; octave < spectrum.made.size(); ++octave) {
    const auto band = [&](const torch::Tensor& z) {
      const torch::Tensor mean = torch::avg_pool2d(z, {2, 2});
      return (z - torch::upsample_nearest2d(mean, {z.size(2), z.size(3)})).pow(2).mean().item<double>();
    };
    spectrum.made[octave] += band(a);
    spectrum.real[octave] += band(b);
    a = meaned(a, 2);
    b = meaned(b, 2);
  }
}

}  // namespace seamount::train
