// Trains a network on a task: a conditional GAN with losses beside it (P1 sec. 4.1, Isola et al. 2017), in pieces that
// go on after a kill. The loop is a library of its own (train/loop), built where libtorch is found.
//
// Losses on the sum z of base and network: L1 of means over 1, 2, 4 ... 32 cells, L1 of slopes, and a critic of patches
// of about 46 cells (hinge loss, spectral norm; Miyato et al. 2018) that sees z, its slopes and what was drawn; the L1
// of its features between real and made ground steadies it (Wang et al. 2018). As the critic sets in, L1 below 16 cells
// is weakened, which else makes ground blunt and noise ignored. The network kept is the moving average of the one
// trained.
#pragma once

#include <functional>
#include <string>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/train/sample.h"

namespace seamount::train {

enum class Device { cpu, cuda };

struct TrainingParams {
  int samples = 100000;
  int batch = 4;
  double rate = 4e-4;
  double critic_rate = 4e-4;
  int critic_from = 20000;
  double critic_weight = 0.05;
  double feature_weight = 0.15;
  double fine_weight = 0.25;
  int check_every = 2500;
  int checks = 48;
  int patience = 0;
  Device device = Device::cpu;

  static constexpr auto fields() {
    using P = TrainingParams;
    return std::tuple(
        field(&P::samples, "samples", "", between(1, 1e9), "samples to train with, those of earlier runs included"),
        field(&P::batch, "batch", "", between(1, 256), "samples a step"),
        field(&P::rate, "rate", "", between(1e-7, 0.1), "learning rate (Adam); falls to 0 over the last third"),
        field(&P::critic_rate, "critic_rate", "", between(1e-7, 0.1), "that of the critic"),
        field(&P::critic_from, "critic_from", "", between(0, 1e9), "samples after which the critic sets in"),
        field(&P::critic_weight, "critic_weight", "", between(0, 100),
              "weight of the critic's judgement; 0: no critic"),
        field(&P::feature_weight, "feature_weight", "", between(0, 100), "weight of the critic's features"),
        field(&P::fine_weight, "fine_weight", "", between(0, 10),
              "what is left of L1 below 16 cells once the critic is there"),
        field(&P::check_every, "check_every", "", between(1, 1e9),
              "samples between checks on held-out ground; each keeps a checkpoint"),
        field(&P::checks, "checks", "", between(1, 4096), "held-out samples of a check"),
        field(&P::patience, "patience", "", between(0, 1000),
              "checks without a better network after which to stop; 0: none"),
        field(&P::device, "device", "what computes"));
  }
};

/// How good the averaged network is on held-out samples.
struct Check {
  int64_t samples = 0;      ///< trained with
  double error = 0;         ///< mean |dz|, in the unit of the target
  double coarse_error = 0;  ///< of means over 8 cells
  double roughness = 0;     ///< mean |ln(energy made / energy real)| over octaves of 2 to 32 cells
  double score = 0;         ///< coarse_error + 0.02 roughness: the lowest is kept
};

struct TrainingFiles {
  std::string weights;     ///< best network so far, safetensors (io/weights.h)
  std::string checkpoint;  ///< everything needed to go on; read where it exists
  std::string pictures;    ///< folder of sample pictures; empty: none
  std::string start;       ///< weights to start from where there is no checkpoint; empty: random
};

/// False where the part of the program that knows libtorch was not built.
bool can_train();

/// Trains until params.samples; `say` gets a line per check and per minute. Throws Error where can_train() is false;
/// IoError, WriteError for files; InvalidArgument for params; Cancelled, after writing a checkpoint. The same samples
/// and seed give about the same network, not the same bits.
Check train_network(const Task& task, const TrainingParams& params, const TrainingFiles& files, Seed seed,
                    const std::function<void(const std::string&)>& say, const RunContext& run);

}  // namespace seamount::train

template <>
struct seamount::Choices<seamount::train::Device> {
  static constexpr std::array<std::string_view, 2> names = {"cpu", "cuda"};
};
