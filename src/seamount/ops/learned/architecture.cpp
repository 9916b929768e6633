#include "seamount/ops/learned/architecture.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::learned {
namespace {

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

int number_in(std::string_view text, const char* field, int low, int high) {
  const std::optional<int> value = whole_number(text);
  if (!value || *value < low || *value > high) {
    throw InvalidArgument(field, "\"" + std::string(text.substr(0, 40)) + "\" is no number in [" + std::to_string(low) +
                                     ", " + std::to_string(high) + "]");
  }
  return *value;
}

const std::string& said(const Weights& weights, const char* what) {
  const auto found = weights.about.find(what);
  if (found == weights.about.end()) throw InvalidArgument(what, "is not said in the weights: they are of no network");
  return found->second;
}

void check_tensor(const Weights& weights, const std::string& name, const std::vector<int64_t>& shape) {
  const auto found = weights.tensors.find(name);
  if (found == weights.tensors.end()) throw InvalidArgument(name, "is missing");
  if (found->second.shape != shape) throw InvalidArgument(name, "has another shape than the network needs");
  size_t count = 1;
  for (const int64_t side : shape) count *= static_cast<size_t>(side);
  if (found->second.values.size() != count) throw InvalidArgument(name, "has fewer or more numbers than its shape");
  for (const float value : found->second.values) {
    if (!std::isfinite(value)) throw InvalidArgument(name, "holds a number that is not finite");
  }
}

}  // namespace

std::vector<Convolution> convolutions(const Architecture& architecture) {
  const std::vector<int>& widths = architecture.widths;
  const int last = architecture.levels() - 1;
  std::vector<Convolution> out = {{"input", 4 * architecture.planes, widths[0], 3, 1}};
  for (int k = 1; k <= last; ++k) out.push_back({"down" + std::to_string(k), widths[k - 1], widths[k], 3, 2});
  out.push_back({"middle", widths[last], widths[last], 3, 1});
  for (int k = last - 1; k >= 0; --k) {
    out.push_back({"lift" + std::to_string(k), widths[k + 1], widths[k], 1, 1});
    out.push_back({"join" + std::to_string(k), widths[k], widths[k], 3, 1});
    if (widths[k] >= kDeepWidth) out.push_back({"deep" + std::to_string(k), widths[k], widths[k], 3, 1});
  }
  out.push_back({"thin", widths[0], kThinWidth, 1, 1});
  out.push_back({"inner", kThinWidth + architecture.planes, kInnerWidth, 3, 1});
  out.push_back({"outer", kInnerWidth, 1, 3, 1});
  return out;
}

Architecture architecture_of(const Weights& weights) {
  Architecture architecture;
  architecture.planes = number_in(said(weights, "planes"), "planes", 1, 32);
  architecture.widths.clear();
  std::string_view rest = said(weights, "widths");
  while (true) {
    const size_t comma = rest.find(',');
    architecture.widths.push_back(number_in(rest.substr(0, comma), "widths", 8, 512));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
    if (architecture.levels() == 8) throw InvalidArgument("widths", "more than 8 levels");
  }
  if (architecture.levels() < 2) throw InvalidArgument("widths", "fewer than 2 levels");
  for (const Convolution& c : convolutions(architecture)) {
    check_tensor(weights, c.name + ".weight", {c.out, c.in, c.kernel, c.kernel});
    check_tensor(weights, c.name + ".bias", {c.out});
  }
  return architecture;
}

void describe(const Architecture& architecture, Weights& weights) {
  weights.about["planes"] = std::to_string(architecture.planes);
  std::string& widths = weights.about["widths"];
  widths.clear();
  for (const int width : architecture.widths) widths += (widths.empty() ? "" : ",") + std::to_string(width);
}

}  // namespace seamount::learned
