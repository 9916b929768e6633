#include "seamount/train/loop/generator.h"

#include <cmath>
#include <cstring>

#include "seamount/base/error.h"

namespace seamount::train {
namespace {

constexpr int kCriticWidths[] = {48, 96, 160};

torch::Tensor random_tensor(const std::vector<int64_t>& shape, double deviation, Seed seed) {
  torch::Tensor out = torch::empty(shape);
  Rng rng(seed);
  float* const values = out.data_ptr<float>();
  for (int64_t i = 0; i < out.numel(); ++i) values[i] = static_cast<float>(deviation * rng.normal());
  return out;
}

torch::Tensor convolve(const torch::Tensor& x, const Tensors& t, const std::string& name, int64_t stride, int64_t pad,
                       torch::ScalarType type) {
  const torch::Tensor& weight = t.at(name + ".weight");
  return torch::conv2d(x.to(type).contiguous(torch::MemoryFormat::ChannelsLast), weight.to(type),
                       t.at(name + ".bias").to(type), stride, pad);
}

}  // namespace

Tensors random_generator(const learned::Architecture& architecture, Seed seed) {
  Tensors out;
  for (const learned::Convolution& c : learned::convolutions(architecture)) {
    double deviation = std::sqrt(2.0 / (c.in * c.kernel * c.kernel));
    if (c.name == "outer") deviation = 0;
    if (c.name.rfind("deep", 0) == 0 || c.name == "middle") deviation *= 0.3;  // residual branches begin small
    out[c.name + ".weight"] = random_tensor({c.out, c.in, c.kernel, c.kernel}, deviation, seed.derive(c.name));
    out[c.name + ".bias"] = torch::zeros({c.out});
  }
  return out;
}

Tensors from_weights(const learned::Architecture& architecture, const Weights& weights) {
  if (learned::architecture_of(weights) != architecture)
    throw InvalidArgument("--from", "the weights are of another network than this task's");
  Tensors out;
  for (const auto& [name, tensor] : weights.tensors) {
    torch::Tensor t = torch::empty(tensor.shape);
    std::memcpy(t.data_ptr<float>(), tensor.values.data(), tensor.values.size() * sizeof(float));
    out[name] = t;
  }
  return out;
}

Weights to_weights(const learned::Architecture& architecture, const Tensors& tensors) {
  Weights out;
  learned::describe(architecture, out);
  for (const auto& [name, tensor] : tensors) {
    const torch::Tensor flat = tensor.detach().to(torch::kCPU).to(torch::kFloat32).contiguous();
    Tensor& to = out.tensors[name];
    to.shape.assign(flat.sizes().begin(), flat.sizes().end());
    to.values.assign(flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel());
  }
  return out;
}

torch::Tensor doubled(const torch::Tensor& x) {
  return torch::upsample_bilinear2d(x, {2 * x.size(2), 2 * x.size(3)}, false);
}

torch::Tensor generate(const learned::Architecture& architecture, const Tensors& t, const torch::Tensor& planes,
                       torch::ScalarType type) {
  const torch::Tensor x = planes.to(type);
  std::vector<torch::Tensor> e = {torch::relu(convolve(torch::pixel_unshuffle(x, 2), t, "input", 1, 1, type))};
  for (int k = 1; k < architecture.levels(); ++k)
    e.push_back(torch::relu(convolve(e.back(), t, "down" + std::to_string(k), 2, 1, type)));
  torch::Tensor d = torch::relu(e.back() + convolve(e.back(), t, "middle", 1, 1, type));
  for (int k = architecture.levels() - 2; k >= 0; --k) {
    const std::string level = std::to_string(k);
    d = torch::relu(doubled(convolve(d, t, "lift" + level, 1, 0, type)) + e[static_cast<size_t>(k)]);
    d = torch::relu(convolve(d, t, "join" + level, 1, 1, type));
    if (architecture.widths[static_cast<size_t>(k)] >= learned::kDeepWidth)
      d = torch::relu(d + convolve(d, t, "deep" + level, 1, 1, type));
  }
  const torch::Tensor full = torch::cat({doubled(convolve(d, t, "thin", 1, 0, type)), x}, 1);
  const torch::Tensor inner = torch::relu(convolve(full, t, "inner", 1, 1, type));
  return convolve(inner, t, "outer", 1, 1, torch::kFloat32);
}

Critic Critic::random(int planes, Seed seed) {
  Critic out;
  int in = 4 * planes, k = 0;
  const auto add = [&](int width) {
    const std::string name = "critic" + std::to_string(k++);
    out.tensors[name + ".weight"] = random_tensor({width, in, 3, 3}, std::sqrt(2.0 / (9.0 * in)), seed.derive(name));
    out.tensors[name + ".bias"] = torch::zeros({width});
    out.norms[name] = random_tensor({width}, 1, seed.derive(name + " norm"));
    in = width;
  };
  for (const int width : kCriticWidths) add(width);
  add(1);
  return out;
}

std::vector<torch::Tensor> Critic::judge(const torch::Tensor& seen, torch::ScalarType type) const {
  std::vector<torch::Tensor> features;
  torch::Tensor x = torch::pixel_unshuffle(seen.to(type), 2).contiguous(torch::MemoryFormat::ChannelsLast);
  const int last = static_cast<int>(std::size(kCriticWidths));
  for (int k = 0; k <= last; ++k) {
    const std::string name = "critic" + std::to_string(k);
    const torch::Tensor& weight = tensors.at(name + ".weight");
    const torch::Tensor matrix = weight.view({weight.size(0), -1});
    torch::Tensor v;
    {
      const torch::NoGradGuard no_gradients;
      v = torch::mv(matrix.t(), norms.at(name));
      v = v / (v.norm() + 1e-12);
    }
    const torch::Tensor sigma = torch::dot(norms.at(name), torch::mv(matrix, v));
    const int64_t stride = k == 0 || k == last ? 1 : 2;
    x = torch::conv2d(x, (weight / sigma).to(type), tensors.at(name + ".bias").to(type), stride, 1);
    if (k < last) x = torch::leaky_relu(x, 0.2);
    features.push_back(x);
  }
  return features;
}

void Critic::update_norms() {
  const torch::NoGradGuard no_gradients;
  for (auto& [name, u] : norms) {
    const torch::Tensor& weight = tensors.at(name + ".weight");
    const torch::Tensor matrix = weight.view({weight.size(0), -1});
    torch::Tensor v = torch::mv(matrix.t(), u);
    v = v / (v.norm() + 1e-12);
    u = torch::mv(matrix, v);
    u = u / (u.norm() + 1e-12);
  }
}

}  // namespace seamount::train
