#include "seamount/ops/ecosystem/materials.h"

#include <algorithm>

#include "seamount/base/parallel.h"
#include "seamount/geom/solve/transport.h"
#include "seamount/ops/ecosystem/deposits.h"

namespace seamount::ecosystem {
namespace {

bool moves(const Material& material) { return material.density != 0.0 || material.flow_coupling != 0.0; }

/// Adds what another material turns into this one.
void add_turned(const ScalarField& from, double rate, ScalarField& source) {
  if (source.empty()) source = ScalarField(from.frame(), 0.0F);
  const auto share = static_cast<float>(rate);
  for (size_t i = 0; i < source.size(); ++i) source.cells()[i] += share * from.cells()[i];
}

/// Materials that are solved side by side, round after round: each as soon as those that turn into it are at rest, but
/// for those that nothing waits for, which fill up the rounds in which the fewest are. So no core waits long, and a
/// chain of transformations takes as many rounds as it is long.
std::vector<std::vector<int>> rounds(const Rules& rules) {
  const size_t count = rules.material_order.size();
  std::vector<size_t> first(count, 0), chain(count, 0);  // rounds before it, and after it
  for (const int m : rules.material_order)
    for (const auto& [from, to] : rules.turns)
      if (to == m)
        first[static_cast<size_t>(m)] = std::max(first[static_cast<size_t>(m)], first[static_cast<size_t>(from)] + 1);
  for (size_t i = count; i-- > 0;) {
    const int m = rules.material_order[i];
    for (const auto& [from, to] : rules.turns)
      if (from == m)
        chain[static_cast<size_t>(m)] = std::max(chain[static_cast<size_t>(m)], chain[static_cast<size_t>(to)] + 1);
  }
  std::vector<std::vector<int>> made;
  for (size_t m = 0; m < count; ++m) made.resize(std::max(made.size(), first[m] + 1));
  for (size_t m = 0; m < count; ++m)
    if (chain[m] > 0) made[first[m]].push_back(static_cast<int>(m));
  for (size_t m = 0; m < count; ++m) {
    if (chain[m] > 0) continue;
    const auto least = std::min_element(made.begin() + static_cast<std::ptrdiff_t>(first[m]), made.end(),
                                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
    least->push_back(static_cast<int>(m));
  }
  return made;
}

}  // namespace

VectorField carrying_flow(const Material& material, const Environment& environment, const RunContext& run) {
  const GridFrame& frame = environment.frame;
  VectorField flow{ScalarField(frame), ScalarField(frame)};
  const auto density = static_cast<float>(material.density);
  const auto coupling = static_cast<float>(material.flow_coupling);
  const ScalarField& height = environment.height;
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const int above = std::max(0, y - 1), below = std::min(frame.height - 1, y + 1);
      const float per_row = below > above ? density / static_cast<float>((below - above) * frame.cell_m) : 0.0F;
      for (int x = 0; x < frame.width; ++x) {
        const int left = std::max(0, x - 1), right = std::min(frame.width - 1, x + 1);
        const float per_column = right > left ? density / static_cast<float>((right - left) * frame.cell_m) : 0.0F;
        flow.x(x, y) = coupling * environment.current.x(x, y) - per_column * (height(right, y) - height(left, y));
        flow.y(x, y) = coupling * environment.current.y(x, y) - per_row * (height(x, above) - height(x, below));
      }
    }
  });
  return flow;
}

void bring_to_rest(const Scene& scene, const Rules& rules, int window, Environment& before, Environment& environment,
                   const RunContext& run) {
  const std::vector<Material>& materials = scene.catalogue.materials;
  const bool known = before.materials.size() == materials.size() && before.sources.size() == materials.size();
  std::vector<ScalarField>& sources = environment.sources;
  std::vector<ScalarField>& rest = environment.materials;
  sources = material_sources(scene, rules, environment.frame, window, run);
  rest.resize(materials.size());
  for (const std::vector<int>& round : rounds(rules)) {
    std::vector<VectorField> flows(materials.size());
    std::vector<size_t> asked;
    std::vector<geom::Transport> transports;
    for (const int number : round) {
      const auto m = static_cast<size_t>(number);
      double decay = materials[m].decay_1_s;
      for (size_t t = 0; t < rules.turns.size(); ++t) {
        const Transformation& turn = scene.catalogue.transformations[t];
        if (rules.turns[t].first == number) decay += turn.rate_1_s;
        if (rules.turns[t].second == number)
          add_turned(rest[static_cast<size_t>(rules.turns[t].first)], turn.rate_1_s * turn.yield, sources[m]);
      }
      if (sources[m].empty()) sources[m] = ScalarField(environment.frame, 0.0F);
      if (known && sources[m] == before.sources[m]) {
        rest[m] = std::move(before.materials[m]);
        continue;
      }
      if (moves(materials[m])) flows[m] = carrying_flow(materials[m], environment, run);
      geom::Transport transport;
      transport.source = &sources[m];
      transport.flow = flows[m].empty() ? nullptr : &flows[m];
      transport.around = environment.around ? &environment.around->materials[m] : nullptr;
      transport.diffusivity_m2_s = materials[m].diffusivity_m2_s;
      transport.decay_per_s = decay;
      transports.push_back(transport);
      asked.push_back(m);
    }
    std::vector<ScalarField> solved = geom::steady_states(transports, run);
    for (size_t i = 0; i < asked.size(); ++i) rest[asked[i]] = std::move(solved[i]);
  }
}

}  // namespace seamount::ecosystem
