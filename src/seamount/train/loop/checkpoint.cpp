#include "seamount/train/loop/checkpoint.h"

#include <charconv>
#include <cstring>
#include <functional>

#include "seamount/base/error.h"
#include "seamount/io/weights.h"

namespace seamount::train {
namespace {

void put(const torch::Tensor& tensor, Tensor& to) {
  const torch::Tensor flat = tensor.detach().to(torch::kCPU).contiguous();
  to.shape.assign(flat.sizes().begin(), flat.sizes().end());
  to.values.assign(flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel());
}

void take(const Weights& weights, const std::string& name, const std::string& path, torch::Tensor& tensor) {
  const auto found = weights.tensors.find(name);
  if (found == weights.tensors.end()) throw IoError(path, "no checkpoint of this task: \"" + name + "\" is missing");
  const std::vector<int64_t> shape(tensor.sizes().begin(), tensor.sizes().end());
  if (found->second.shape != shape)
    throw IoError(path, "no checkpoint of this task: \"" + name + "\" has another shape");
  tensor = torch::empty(shape);
  std::memcpy(tensor.data_ptr<float>(), found->second.values.data(), found->second.values.size() * sizeof(float));
}

/// Every tensor of a state under a name of its own.
void for_each_tensor(TrainingState& state, const std::function<void(const std::string&, torch::Tensor&)>& visit) {
  for (auto& [name, tensor] : state.generator) visit("generator." + name, tensor);
  for (auto& [name, tensor] : state.average) visit("average." + name, tensor);
  for (auto& [name, tensor] : state.critic.tensors) visit("critic." + name, tensor);
  for (auto& [name, tensor] : state.critic.norms) visit("norm." + name, tensor);
  for (auto& [name, moments] : state.moments) {
    visit("first." + name, moments.first);
    visit("second." + name, moments.second);
  }
}

double number(const Weights& weights, const std::string& name, const std::string& path) {
  const auto found = weights.about.find(name);
  double value = 0;
  if (found == weights.about.end() ||
      std::from_chars(found->second.data(), found->second.data() + found->second.size(), value).ec != std::errc())
    throw IoError(path, "no checkpoint of a training: \"" + name + "\" is missing");
  return value;
}

}  // namespace

bool has_bf16() { return __builtin_cpu_supports("avx512bf16"); }

void write_checkpoint(const TrainingState& state, const std::string& path) {
  Weights weights;
  TrainingState copy = state;  // tensors are shared
  for_each_tensor(copy, [&](const std::string& name, torch::Tensor& tensor) { put(tensor, weights.tensors[name]); });
  weights.about["samples"] = std::to_string(state.samples);
  weights.about["checks_since_best"] = std::to_string(state.checks_since_best);
  weights.about["best_samples"] = std::to_string(state.best.samples);
  weights.about["best_error"] = std::to_string(state.best.error);
  weights.about["best_coarse_error"] = std::to_string(state.best.coarse_error);
  weights.about["best_roughness"] = std::to_string(state.best.roughness);
  weights.about["best_score"] = std::to_string(state.best.score);
  io::write_weights(weights, path, io::WeightType::f32);
}

void read_checkpoint(const std::string& path, TrainingState& state) {
  const Weights weights = io::read_weights(path);
  for_each_tensor(state, [&](const std::string& name, torch::Tensor& tensor) { take(weights, name, path, tensor); });
  state.samples = static_cast<int64_t>(number(weights, "samples", path));
  state.checks_since_best = static_cast<int>(number(weights, "checks_since_best", path));
  state.best.samples = static_cast<int64_t>(number(weights, "best_samples", path));
  state.best.error = number(weights, "best_error", path);
  state.best.coarse_error = number(weights, "best_coarse_error", path);
  state.best.roughness = number(weights, "best_roughness", path);
  state.best.score = number(weights, "best_score", path);
}

std::string critic_file(const std::string& weights_file) {
  const std::string ending = ".safetensors";
  const bool has = weights_file.size() > ending.size() &&
                   weights_file.compare(weights_file.size() - ending.size(), ending.size(), ending) == 0;
  return (has ? weights_file.substr(0, weights_file.size() - ending.size()) : weights_file) + ".critic" + ending;
}

Weights critic_weights(const Critic& critic) {
  Weights weights;
  for (const auto& [name, tensor] : critic.tensors) put(tensor, weights.tensors[name]);
  for (const auto& [name, tensor] : critic.norms) put(tensor, weights.tensors["norm." + name]);
  return weights;
}

void read_critic(const std::string& path, Critic& critic) {
  const Weights weights = io::read_weights(path);
  for (auto& [name, tensor] : critic.tensors) take(weights, name, path, tensor);
  for (auto& [name, tensor] : critic.norms) take(weights, "norm." + name, path, tensor);
}

}  // namespace seamount::train
