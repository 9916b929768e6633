// A kind of value: all that recipes, the cache, the command line and the reference need to know about values of one
// type. Each kind is one file in kinds/ that makes a Kind by make_kind(), and a line in kinds.h.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/io/info.h"
#include "seamount/model/extent.h"
#include "seamount/model/grid.h"
#include "seamount/recipe/value_stream.h"

namespace seamount::recipe {

class Value;

/// What a kind is told when it reads a file.
struct FileCall {
  std::string path;
  const GridFrame& frame;  ///< what lies nowhere by itself is laid over it; what is in degrees comes into its system
  bool joins;              ///< the value joins others that lie there: all of it counts, up to its edges
  const RunContext& run;
};

/// Where a value is brought to before an operator sees it.
struct Destination {
  const GridFrame& frame;
  bool cells = false;  ///< rasters come onto the very cells of the frame; else only its system counts
  const RunContext& run;
};

/// A kind without its C++ type. Made by make_kind(); lives as long as the program.
struct Kind {
  std::string name;                ///< "terrain": the contract
  std::string about;               ///< one line, no full stop
  std::vector<std::string> files;  ///< what an operator's command writes it to: {".tif"}, the first is the main one
  std::vector<std::string> reads;  ///< extensions of the files that it is read from

  std::function<const GridFrame*(const void*)> frame;
  std::function<std::optional<Extent>(const void*)> extent;
  std::function<std::shared_ptr<const void>(const void*, const Destination&)> bring;
  std::function<std::shared_ptr<const void>(const void*, const std::string& name, const RunContext&)> without_voids;
  std::function<size_t(const void*)> bytes;
  std::function<void(Writer&, const void*)> write;
  std::function<std::shared_ptr<const void>(Reader&)> read;
  std::function<std::shared_ptr<const void>(const FileCall&)> read_file;  ///< empty: written, never read
  std::function<std::optional<io::FileInfo>(const std::string& path)> info;
};

/// A kind as its file gives it. T: what its values hold.
template <class T>
struct KindOf {
  std::string name;
  std::string about;
  std::vector<std::string> files;
  std::vector<std::string> reads;

  std::function<const GridFrame*(const T&)> frame;  ///< the raster or document frame of a value; empty: it has none
  /// Where a value lies; empty: as its frame says, or nowhere.
  std::function<std::optional<Extent>(const T&)> extent = {};
  /// The value elsewhere; empty: it lies nowhere. Throws where there is no way.
  std::function<T(const T&, const Destination&)> bring = {};
  /// The value with all its cells known, or nothing if they are; says how many were filled, of what `name` calls it.
  /// Empty: it has none that could be unknown.
  std::function<std::optional<T>(const T&, const std::string& name, const RunContext&)> without_voids = {};
  std::function<size_t(const T&)> bytes;         ///< of memory, about
  std::function<void(Writer&, const T&)> write;  ///< for the cache: exact
  std::function<T(Reader&)> read;                ///< what write wrote; throws Damaged
  std::function<T(const FileCall&)> read_file;   ///< throws IoError; empty: written, never read
  /// What `seamount info` says of a file, or nothing if it is no file of this kind; empty: knows none.
  std::function<std::optional<io::FileInfo>(const std::string& path)> info;
};

template <class T>
Kind make_kind(KindOf<T> given) {
  const auto typed = [](const void* value) -> const T& { return *static_cast<const T*>(value); };
  Kind kind;
  kind.name = given.name;
  kind.about = given.about;
  kind.files = given.files;
  kind.reads = given.reads;
  kind.info = given.info;
  kind.frame = [typed, f = given.frame](const void* value) { return f ? f(typed(value)) : nullptr; };
  kind.extent = [typed, frame = kind.frame, f = given.extent](const void* value) -> std::optional<Extent> {
    if (f) return f(typed(value));
    const GridFrame* own = frame(value);
    return own != nullptr ? std::optional(Extent::of(*own)) : std::nullopt;
  };
  if (given.bring)
    kind.bring = [typed, f = given.bring](const void* value, const Destination& to) {
      return std::make_shared<const T>(f(typed(value), to));
    };
  if (given.without_voids)
    kind.without_voids = [typed, f = given.without_voids](const void* value, const std::string& name,
                                                          const RunContext& run) -> std::shared_ptr<const void> {
      std::optional<T> filled = f(typed(value), name, run);
      return filled ? std::make_shared<const T>(std::move(*filled)) : nullptr;
    };
  kind.bytes = [typed, f = given.bytes](const void* value) { return f(typed(value)); };
  kind.write = [typed, f = given.write](Writer& writer, const void* value) { f(writer, typed(value)); };
  kind.read = [f = given.read](Reader& reader) { return std::make_shared<const T>(f(reader)); };
  if (given.read_file)
    kind.read_file = [f = given.read_file](const FileCall& call) { return std::make_shared<const T>(f(call)); };
  return kind;
}

}  // namespace seamount::recipe
