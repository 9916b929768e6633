// Networks that are ready to be evaluated, so that a stroke in the studio does not read and arrange weights anew.
#pragma once

#include <memory>
#include <string>

#include "seamount/ops/learned/network.h"

namespace seamount::recipe {

/// The network of a file of weights. The last few stay in memory for the whole program, told apart by what their files
/// hold: one that was written to is read again. Throws what io::read_weights() and learned::Network() throw. May be
/// called from any thread.
std::shared_ptr<const learned::Network> loaded_network(const std::string& path, learned::Precision precision);

}  // namespace seamount::recipe
