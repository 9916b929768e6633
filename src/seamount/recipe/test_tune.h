// A kind of value that Seamount does not have, its file format and two operators, for tests: what it takes to add one
// stands here and nowhere else.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "seamount/io/atomic_file.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {

struct Tune {
  std::vector<int> notes;
};

// ---- the kind

struct TuneKind {
  using Type = Tune;
  static const Kind& kind();
  static void add_formats(Registry& registry);
};

inline Tune read_tune(const FileCall& call) {
  Tune tune;
  for (const uint8_t byte : io::read_file(call.path)) tune.notes.push_back(byte);
  return tune;
}

inline const Kind& TuneKind::kind() {
  static const Kind kind = make_kind<Tune>({
      .name = "tune",
      .about = "notes in their order",
      .files = {".tune"},
      .reads = {".tune"},
      .frame = {},
      .bytes = [](const Tune& tune) { return tune.notes.size() * sizeof(int); },
      .write = [](Writer& writer, const Tune& tune) { writer.list(tune.notes); },
      .read = [](Reader& reader) { return Tune{reader.list<int>()}; },
      .read_file = read_tune,
      .info = [](const std::string& path) -> std::optional<io::FileInfo> {
        if (io::extension_of(path) != ".tune") return std::nullopt;
        return io::FileInfo{{"format", "tune"}};
      },
  });
  return kind;
}

inline void TuneKind::add_formats(Registry& registry) {
  registry.add(make_format<NoParams>({"tune", "a byte for each note", {".tune"}, {".tune"}, {&kind()}},
                                     [](const NoParams&, const OutputCall& call) {
                                       const Tune& tune = call.value.get<TuneKind>();
                                       io::write_text(call.path, std::string(tune.notes.begin(), tune.notes.end()));
                                     }));
}

// ---- its operators

struct TuneScaleParams {
  int count = 5;
  static constexpr auto fields() {
    return std::tuple(field(&TuneScaleParams::count, "count", "", between(1, 99), "number of notes"));
  }
};

/// How often tune.scale was run.
inline int& tune_runs() {
  static int count = 0;
  return count;
}

inline Registry with_tunes() {
  Registry registry = standard_registry();
  registry.add_kind<TuneKind>();
  registry.add(make_operator<TuneScaleParams>({.name = "tune.scale", .summary = "Notes that rise"}, inputs(),
                                              outputs(out<TuneKind>("tune", "the notes")),
                                              [](const TuneScaleParams& params, const Call&) {
                                                ++tune_runs();
                                                Tune tune;
                                                for (int i = 0; i < params.count; ++i) tune.notes.push_back('A' + i);
                                                return tune;
                                              }));
  registry.add(make_operator<NoParams>(
      {.name = "tune.turn", .summary = "Notes backwards"}, inputs(in<TuneKind>("tune", "the notes")),
      outputs(out<TuneKind>("tune", "the notes backwards"), out<kinds::Field>("bars", "a bar for each note")),
      [](const NoParams&, const Call& call, const Tune& tune) {
        ScalarField bars(call.domain, static_cast<float>(tune.notes.size()));
        return std::tuple(Tune{{tune.notes.rbegin(), tune.notes.rend()}}, std::move(bars));
      }));
  return registry;
}

}  // namespace seamount::recipe
