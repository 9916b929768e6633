// Operators are registered with typed ports, and called with their inputs: what a port is named, of which kind it is
// and which C++ type the function gets stand in one place, and disagreement does not compile.
//
//   registry.add(make_operator<BlendParams>(
//       {.name = "terrain.blend", .summary = "..."},
//       inputs(in<kinds::Terrain>("terrain", "heights in metres"), optional_in<kinds::Field>("mask", "where")),
//       outputs(out<kinds::Terrain>("terrain", "heights in metres")),
//       [](const BlendParams& params, const Call& call, const HeightField& terrain, const ScalarField* mask) {
//         return terrain::blend(terrain, mask, params, call.run);
//       }));
//
// A function returns the value of its one output, or a std::tuple of all in their order.
#pragma once

#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "seamount/recipe/kinds.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// Must be connected; the function gets a const K::Type&.
template <class K>
struct In {
  using Argument = const typename K::Type&;
  Port port;
  void add_to(std::vector<Port>& ports) const { ports.push_back(port); }
  Argument fetch(const Values& values) const { return values.find(port.name)->second.template get<K>(); }
};

/// May be left open; the function gets a const K::Type*, nullptr then.
template <class K>
struct OptionalIn {
  using Argument = const typename K::Type*;
  Port port;
  void add_to(std::vector<Port>& ports) const { ports.push_back(port); }
  Argument fetch(const Values& values) const {
    const auto found = values.find(port.name);
    return found == values.end() ? nullptr : &found->second.template get<K>();
  }
};

/// Rows of inputs of the same kinds: "terrain", "labels", "terrain_2", "labels_2", ...; the function gets a
/// std::vector of std::tuple of pointers, a tuple for each row whose first input is connected.
template <class... Ks>
struct InRows {
  using Row = std::tuple<const typename Ks::Type*...>;
  using Argument = std::vector<Row>;
  std::vector<std::tuple<OptionalIn<Ks>...>> rows;
  void add_to(std::vector<Port>& ports) const {
    for (const auto& row : rows) std::apply([&](const auto&... inputs) { (inputs.add_to(ports), ...); }, row);
  }
  Argument fetch(const Values& values) const {
    Argument all;
    for (const auto& row : rows) {
      Row made = std::apply([&](const auto&... inputs) { return Row{inputs.fetch(values)...}; }, row);
      if (std::get<0>(made) != nullptr) all.push_back(made);
    }
    return all;
  }
};

template <class K>
struct Out {
  using Type = typename K::Type;
  Port port;
  Value wrap(Type value) const { return Value::of<K>(std::move(value)); }
};

template <class K>
In<K> in(std::string name, std::string help) {
  return {{std::move(name), &K::kind(), std::move(help), true}};
}

template <class K>
OptionalIn<K> optional_in(std::string name, std::string help) {
  return {{std::move(name), &K::kind(), std::move(help), false}};
}

/// A port that had another name in earlier versions, which is still read with a note.
template <class PortOf>
PortOf formerly(std::string former, PortOf port) {
  port.port.former = std::move(former);
  return port;
}

/// A raster whose cells without a value (NaN) the operator respects.
template <class PortOf>
PortOf with_voids(PortOf port) {
  port.port.voids = true;
  return port;
}

/// An input that keeps its own cells, or of which the place does not count.
template <class PortOf>
PortOf placed(Placing placing, PortOf port) {
  port.port.placing = placing;
  return port;
}

template <class... Ks>
InRows<Ks...> placed(Placing placing, InRows<Ks...> rows) {
  for (auto& row : rows.rows) std::apply([&](auto&... input) { ((input.port.placing = placing), ...); }, row);
  return rows;
}
template <class... Ks>
InRows<Ks...> with_voids(InRows<Ks...> rows) {
  for (auto& row : rows.rows) std::apply([&](auto&... input) { ((input.port.voids = true), ...); }, row);
  return rows;
}

/// `count` rows of inputs; the first input of the first row is required. `help` holds for the first row, `more_help`
/// for the others.
template <class... Ks>
InRows<Ks...> in_rows(int count, const std::array<std::string, sizeof...(Ks)>& names,
                      const std::array<std::string, sizeof...(Ks)>& help,
                      const std::array<std::string, sizeof...(Ks)>& more_help) {
  InRows<Ks...> made;
  for (int i = 0; i < count; ++i) {
    const std::string number = i == 0 ? "" : "_" + std::to_string(i + 1);
    size_t k = 0;
    const auto next = [&](const Kind& kind) {
      Port port{names[k] + number, &kind, i == 0 ? help[k] : more_help[k], i == 0 && k == 0};
      ++k;
      return port;
    };
    made.rows.push_back(std::tuple<OptionalIn<Ks>...>{OptionalIn<Ks>{next(Ks::kind())}...});
  }
  return made;
}

template <class K>
Out<K> out(std::string name, std::string help) {
  return {{std::move(name), &K::kind(), std::move(help), true}};
}

template <class... Inputs>
std::tuple<Inputs...> inputs(Inputs... given) {
  return {std::move(given)...};
}

template <class... Ks>
std::tuple<Out<Ks>...> outputs(Out<Ks>... given) {
  return {std::move(given)...};
}

/// `row` with its ports, parameters and function filled in.
template <class Params, class... Inputs, class... Ks, class Function>
Operator make_operator(Operator row, std::tuple<Inputs...> ins, std::tuple<Out<Ks>...> outs, Function function) {
  static_assert(std::is_invocable_v<Function, const Params&, const Call&, typename Inputs::Argument...>,
                "the function takes (const Params&, const Call&, inputs...) as the ports say");
  std::apply([&](const auto&... input) { (input.add_to(row.in), ...); }, ins);
  std::apply([&](const auto&... output) { (row.out.push_back(output.port), ...); }, outs);
  row.params = describe_params<Params>();
  row.former = describe_former_names<Params>();
  row.complete = [](const Json& given, const ReadPlace& place) {
    return write_params(read_params<Params>(given, place));
  };
  row.run = [ins, outs, function](const Json& complete_params, const Values& in, const Call& call) {
    Diagnostics diagnostics;
    const auto params = read_params<Params>(complete_params, {"", diagnostics});
    if (!diagnostics.empty()) throw RecipeError("parameters", diagnostics.items());
    auto made = std::apply([&](const auto&... input) { return function(params, call, input.fetch(in)...); }, ins);
    Values values;
    if constexpr (sizeof...(Ks) == 1) {
      const auto& output = std::get<0>(outs);
      values.emplace(output.port.name, output.wrap(std::move(made)));
    } else {
      const auto wrap_all = [&]<size_t... i>(std::index_sequence<i...>) {
        (values.emplace(std::get<i>(outs).port.name, std::get<i>(outs).wrap(std::move(std::get<i>(made)))), ...);
      };
      wrap_all(std::index_sequence_for<Ks...>());
    }
    return values;
  };
  return row;
}

/// The same for an operator that can be run window by window: `reach(params, cell_m)` says how far it looks.
template <class Params, class... Inputs, class... Ks, class Function, class ReachOf>
Operator make_operator(Operator row, std::tuple<Inputs...> ins, std::tuple<Out<Ks>...> outs, Function function,
                       ReachOf reach) {
  Operator made = make_operator<Params>(std::move(row), std::move(ins), std::move(outs), std::move(function));
  made.reach = [reach](const Json& complete_params, double cell_m) -> Reach {
    Diagnostics diagnostics;
    return reach(read_params<Params>(complete_params, {"", diagnostics}), cell_m);
  };
  return made;
}

/// An operator whose parameters say all of the whole, once settle(params, lowest, highest) has told them of the lowest
/// and the highest cell of its first raster.
template <class Params, class Settle>
Operator settled_by_relief(Operator made, Settle settle) {
  made.settled = [settle](const Json& complete_params, float lowest, float highest) -> Json {
    Diagnostics diagnostics;
    return write_params(settle(read_params<Params>(complete_params, {"", diagnostics}), lowest, highest));
  };
  return made;
}

}  // namespace seamount::recipe
