#include "seamount/ops/learned/network.h"

#include <string>
#include <utility>

#include "seamount/ops/learned/evaluation.h"

namespace seamount::learned {
namespace {

bool wants_bf16(Precision precision) {
  if (precision == Precision::bf16 && !has_bf16())
    throw InvalidArgument("precision", "bf16: this processor cannot multiply it; f32 and automatic are for any");
  return precision != Precision::f32 && has_bf16();
}

}  // namespace

struct Network::Prepared {
  Layers layers;
};

Network::Network(const Weights& weights, Precision precision)
    : prepared_(new Prepared{make_layers(weights, wants_bf16(precision))}) {}
Network::Network(Network&&) noexcept = default;
Network& Network::operator=(Network&&) noexcept = default;
Network::~Network() = default;

const Architecture& Network::architecture() const { return prepared_->layers.architecture; }
Precision Network::precision() const { return prepared_->layers.bf16 ? Precision::bf16 : Precision::f32; }

ScalarField Network::evaluate(const Planes& planes, const GridFrame& frame, const RunContext& run, int tile) const {
  if (planes.count != architecture().planes) {
    throw IncompatibleInputs("the network reads " + std::to_string(architecture().planes) + " planes, and is given " +
                             std::to_string(planes.count));
  }
  if (planes.width != frame.width || planes.height != frame.height || planes.width < 1 || planes.height < 1) {
    throw IncompatibleInputs("planes of " + std::to_string(planes.width) + " x " + std::to_string(planes.height) +
                             " cells are not of a map of " + std::to_string(frame.width) + " x " +
                             std::to_string(frame.height));
  }
  if (tile < 0 || tile % architecture().stride() != 0)
    throw InvalidArgument("tile",
                          std::to_string(tile) + " is no multiple of " + std::to_string(architecture().stride()));
  return learned::evaluate(prepared_->layers, planes, frame, run, tile);
}

}  // namespace seamount::learned
