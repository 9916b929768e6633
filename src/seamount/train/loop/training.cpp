#include "seamount/train/training.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/io/weights.h"
#include "seamount/train/loop/checkpoint.h"
#include "seamount/train/loop/generator.h"
#include "seamount/train/loop/losses.h"
#include "seamount/train/sample_picture.h"

namespace seamount::train {
namespace {

constexpr int kMostLost = 20;       ///< steps without finite gradients
constexpr double kAverage = 0.998;  ///< of the moving average, a step

/// What one thread computes of a step: samples of its own, with libtorch serial, so that threads meet twice a step
/// only.
struct Shard {
  Batch batch;
  torch::Tensor made;
  std::vector<torch::Tensor> gradients;
  Losses losses;
};

class Trainer {
 public:
  Trainer(const Task& task, const TrainingParams& params, const TrainingFiles& files, Seed seed)
      : task_(task),
        params_(params),
        files_(files),
        architecture_(task.architecture()),
        drawn_(task.drawn_planes()),
        device_(params.device == Device::cuda ? torch::kCUDA : torch::kCPU) {
    state_.generator = files.start.empty() ? random_generator(architecture_, seed.derive("generator"))
                                           : from_weights(architecture_, io::read_weights(files.start));
    state_.average = copy_of(state_.generator);
    state_.critic = Critic::random(kHeightPlanes + static_cast<int>(drawn_.size()), seed.derive("critic"));
    if (!files.start.empty() && std::filesystem::exists(critic_file(files.start)))
      read_critic(critic_file(files.start), state_.critic);
    for (const auto& [name, tensor] : state_.generator) state_.moments.emplace(name, Moments::zeros(tensor));
    for (const auto& [name, tensor] : state_.critic.tensors) state_.moments.emplace(name, Moments::zeros(tensor));
    if (!files.checkpoint.empty() && std::filesystem::exists(files.checkpoint))
      read_checkpoint(files.checkpoint, state_);
    for (Tensors* part : {&state_.generator, &state_.average, &state_.critic.tensors, &state_.critic.norms}) {
      for (auto& [name, tensor] : *part) tensor = tensor.to(device_);
    }
    for (auto& [name, moments] : state_.moments) moments = {moments.first.to(device_), moments.second.to(device_)};
    for (Tensors* part : {&state_.generator, &state_.critic.tensors}) {
      for (auto& [name, tensor] : *part) tensor.set_requires_grad(true);
    }
    type_ = device_.is_cuda() || has_bf16() ? torch::kBFloat16 : torch::kFloat32;
  }

  int64_t samples() const { return state_.samples; }
  const Check& best() const { return state_.best; }
  bool reduced() const { return type_ == torch::kBFloat16; }
  int checks_since_best() const { return state_.checks_since_best; }

  Losses step(const RunContext& run) {
    const double critic_share = critic_strength();
    const int count = device_.is_cuda() ? 1 : std::min(params_.batch, thread_count(run));
    std::vector<Shard> shards(static_cast<size_t>(count));
    const auto side_by_side = [&](const std::function<void(Shard&, size_t)>& work) {
      RunContext quiet;
      quiet.threads = run.threads;
      parallel_blocks(quiet, count, 1, [&](int64_t begin, int64_t) {
        at::init_num_threads();
        work(shards[static_cast<size_t>(begin)], static_cast<size_t>(begin));
      });
    };
    if (critic_share > 0) state_.critic.update_norms();
    side_by_side([&](Shard& shard, size_t index) {
      std::vector<Sample> samples;
      for (int i = static_cast<int>(index); i < params_.batch; i += count)
        samples.push_back(task_.training(static_cast<uint64_t>(state_.samples + i)));
      shard.batch = as_tensors(samples).to(device_);
      shard.made = shard.batch.base + generate(architecture_, state_.generator, shard.batch.planes, type_);
      if (critic_share > 0) shard.gradients = gradients_of(state_.critic.tensors, lesson(shard));
    });
    if (critic_share > 0) learn(state_.critic.tensors, shards, params_.critic_rate * rate_share());
    side_by_side([&](Shard& shard, size_t) {
      torch::Tensor loss = pyramid_loss(shard.made, shard.batch, fine_weight(critic_share), shard.losses);
      if (critic_share > 0) loss = loss + opinion(shard, critic_share);
      shard.gradients = gradients_of(state_.generator, loss);
      shard.made = torch::Tensor();
    });
    learn(state_.generator, shards, params_.rate * rate_share());
    average();
    state_.samples += params_.batch;
    Losses mean;
    for (const Shard& shard : shards) mean += shard.losses;
    return mean / count;
  }

  /// On held-out samples, with the averaged network.
  Check check() {
    const torch::NoGradGuard no_gradients;
    Check out;
    out.samples = state_.samples;
    std::vector<Sample> shown;
    std::vector<std::vector<float>> results;
    Spectrum spectrum;
    for (int first = 0; first < params_.checks; first += params_.batch) {
      std::vector<Sample> samples;
      for (int i = first; i < std::min(first + params_.batch, params_.checks); ++i)
        samples.push_back(task_.held_out(static_cast<uint64_t>(i)));
      const Batch batch = as_tensors(samples).to(device_);
      const torch::Tensor made =
          (batch.base + generate(architecture_, state_.average, batch.planes, type_)).to(torch::kCPU);
      const Batch cpu = batch.to(torch::kCPU);
      measure(made, cpu, out, spectrum);
      for (size_t i = 0; i < samples.size() && shown.size() < 8; ++i) {
        const torch::Tensor one = made[static_cast<int64_t>(i)].contiguous();
        results.emplace_back(one.data_ptr<float>(), one.data_ptr<float>() + one.numel());
        shown.push_back(std::move(samples[i]));
      }
    }
    out.error /= params_.checks;
    out.coarse_error /= params_.checks;
    out.roughness = spectrum.distance();
    out.score = out.coarse_error + 0.02 * out.roughness;
    if (!files_.pictures.empty())
      write_sample_picture(shown, task_.name() == "sketch", results,
                           files_.pictures + "/" + task_.name() + "_" + std::to_string(state_.samples) + ".jpg");
    const bool better = state_.best.samples == 0 || out.score < state_.best.score ||
                        (critic_strength() > 0 && state_.best.samples <= params_.critic_from);
    state_.checks_since_best = better ? 0 : state_.checks_since_best + 1;
    if (better) state_.best = out;
    save(better);
    return out;
  }

  void save(bool network) {
    if (network) {
      Weights weights = to_weights(architecture_, state_.average);
      weights.about["network"] = task_.name();
      weights.about["samples"] = std::to_string(state_.samples);
      io::write_weights(weights, files_.weights, io::WeightType::f16);
      if (critic_strength() > 0)
        io::write_weights(critic_weights(state_.critic), critic_file(files_.weights), io::WeightType::f16);
    }
    if (!files_.checkpoint.empty()) write_checkpoint(state_, files_.checkpoint);
  }

 private:
  static Tensors copy_of(const Tensors& tensors) {
    Tensors out;
    for (const auto& [name, tensor] : tensors) out[name] = tensor.detach().clone();
    return out;
  }

  double rate_share() const {
    const double done = static_cast<double>(state_.samples) / params_.samples;
    const double warm = std::min(1.0, static_cast<double>(state_.samples) / 400.0 + 0.05);
    return warm * std::clamp((1 - done) * 3, 0.02, 1.0);
  }

  double critic_strength() const {
    if (params_.critic_weight == 0 || state_.samples < params_.critic_from) return 0;
    return std::min(1.0, 0.1 + static_cast<double>(state_.samples - params_.critic_from) / 3000.0);
  }

  double fine_weight(double critic_share) const { return 1 + critic_share * (params_.fine_weight - 1); }

  torch::Tensor seen(const Batch& batch, const torch::Tensor& z) const { return critic_view(z, batch.planes, drawn_); }

  /// What the critic has to learn: real ground from made.
  torch::Tensor lesson(Shard& shard) {
    const Batch& batch = shard.batch;
    const torch::Tensor beyond = batch.base * (1 - batch.weight);
    const auto judged = [&](const torch::Tensor& z) {
      return state_.critic.judge(seen(batch, z * batch.weight + beyond), type_).back().to(torch::kFloat32);
    };
    const torch::Tensor loss =
        torch::relu(1 - judged(batch.target)).mean() + torch::relu(1 + judged(shard.made.detach())).mean();
    shard.losses.critic = loss.item<double>();
    return loss;
  }

  torch::Tensor opinion(Shard& shard, double share) {
    const Batch& batch = shard.batch;
    const torch::Tensor beyond = batch.base * (1 - batch.weight);
    std::vector<torch::Tensor> real;
    {
      const torch::NoGradGuard no_gradients;
      real = state_.critic.judge(seen(batch, batch.target * batch.weight + beyond), type_);
    }
    const std::vector<torch::Tensor> fake = state_.critic.judge(seen(batch, shard.made * batch.weight + beyond), type_);
    torch::Tensor features = torch::zeros({}, fake[0].options().dtype(torch::kFloat32));
    for (size_t k = 0; k + 1 < fake.size(); ++k)
      features = features + (fake[k] - real[k]).abs().mean().to(torch::kFloat32);
    const torch::Tensor judgement = -fake.back().to(torch::kFloat32).mean();
    shard.losses.judgement = judgement.item<double>();
    shard.losses.features = features.item<double>();
    return share * (params_.critic_weight * judgement + params_.feature_weight * features);
  }

  static std::vector<torch::Tensor> gradients_of(const Tensors& tensors, const torch::Tensor& loss) {
    std::vector<torch::Tensor> leaves;
    for (const auto& [name, tensor] : tensors) leaves.push_back(tensor);
    return torch::autograd::grad({loss}, leaves);
  }

  /// One step of Adam (Kingma and Ba 2015), beta 0.5 and 0.99, gradients clipped to a norm of 1.
  void learn(Tensors& tensors, const std::vector<Shard>& shards, double rate) {
    const torch::NoGradGuard no_gradients;
    std::vector<torch::Tensor> gradients;
    double norm = 0;
    for (size_t i = 0; i < tensors.size(); ++i) {
      torch::Tensor sum = shards[0].gradients[i].to(torch::kFloat32) / static_cast<double>(shards.size());
      for (size_t k = 1; k < shards.size(); ++k)
        sum = sum + shards[k].gradients[i].to(torch::kFloat32) / static_cast<double>(shards.size());
      norm += sum.pow(2).sum().item<double>();
      gradients.push_back(sum);
    }
    norm = std::sqrt(norm);
    if (!std::isfinite(norm)) {
      if (++lost_ == kMostLost) throw Error("the training diverged: gradients are not finite; a lower rate may help");
      return;
    }
    lost_ = 0;
    const double shrink = std::min(1.0, 1.0 / (norm + 1e-12));
    size_t i = 0;
    for (auto& [name, tensor] : tensors) {
      Moments& m = state_.moments.at(name);
      const torch::Tensor gradient = gradients[i++] * shrink;
      m.first.mul_(0.5).add_(gradient, 0.5);
      m.second.mul_(0.99).addcmul_(gradient, gradient, 0.01);
      tensor.addcdiv_(m.first, m.second.sqrt().add_(1e-8), -rate);
    }
  }

  void average() {
    const torch::NoGradGuard no_gradients;
    const double keep = std::min(kAverage, 1 - 1 / (1 + static_cast<double>(state_.samples) / params_.batch / 4));
    for (auto& [name, tensor] : state_.average) tensor.mul_(keep).add_(state_.generator.at(name), 1 - keep);
  }

  const Task& task_;
  TrainingParams params_;
  TrainingFiles files_;
  learned::Architecture architecture_;
  std::vector<int> drawn_;
  torch::Device device_;
  torch::ScalarType type_ = torch::kFloat32;
  TrainingState state_;
  int lost_ = 0;  ///< steps in a row without finite gradients
};

std::string line_of(const Check& c) {
  char text[200];
  std::snprintf(text, sizeof text, "check at %lld: error %.4f, coarse %.4f, roughness %.3f, score %.4f",
                static_cast<long long>(c.samples), c.error, c.coarse_error, c.roughness, c.score);
  return text;
}

}  // namespace

}  // namespace seamount::train

using namespace seamount;
using namespace seamount::train;

/// train_network() of training.h.
extern "C" Check seamount_train_network(const Task& task, const TrainingParams& params, const TrainingFiles& files,
                                        Seed seed, const std::function<void(const std::string&)>& say,
                                        const RunContext& run) {
  check_params(params);
  if (params.device == Device::cuda && !torch::cuda::is_available())
    throw InvalidArgument("device", "this libtorch finds no CUDA device");
  torch::set_num_threads(1);  // threads are ours: shards of a batch
  if (!files.pictures.empty()) std::filesystem::create_directories(files.pictures);
  Trainer trainer(task, params, files, seed);
  say(std::string("convolutions in ") + (trainer.reduced() ? "bf16" : "f32") + ", from sample " +
      std::to_string(trainer.samples()));
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  Clock::time_point said = begun;
  const int64_t first = trainer.samples();
  Losses sum;
  int steps = 0;
  while (trainer.samples() < params.samples) {
    if (run.cancelled != nullptr && run.cancelled->load()) {
      trainer.save(false);
      throw Cancelled();
    }
    const int64_t before = trainer.samples();
    sum += trainer.step(run);
    ++steps;
    run.report(static_cast<double>(trainer.samples()) / params.samples);
    const Clock::time_point now = Clock::now();
    if (now - said > std::chrono::seconds(30)) {
      const double rate =
          static_cast<double>(trainer.samples() - first) / std::chrono::duration<double>(now - begun).count();
      char text[300];
      std::snprintf(text, sizeof text,
                    "%lld samples, %.1f a second, %.0f min to go: L1 %.4f, slopes %.4f, critic %.3f, judgement %.3f, "
                    "features %.3f",
                    static_cast<long long>(trainer.samples()), rate,
                    static_cast<double>(params.samples - trainer.samples()) / rate / 60, sum.l1 / steps,
                    sum.slopes / steps, sum.critic / steps, sum.judgement / steps, sum.features / steps);
      say(text);
      said = now;
      sum = {};
      steps = 0;
    }
    if (before / params.check_every != trainer.samples() / params.check_every || trainer.samples() >= params.samples) {
      say(line_of(trainer.check()));
      if (params.patience > 0 && trainer.checks_since_best() >= params.patience) break;
    }
  }
  return trainer.best();
}
