#include "seamount/recipe/value_bytes.h"

#include "seamount/recipe/value_stream.h"

namespace seamount::recipe {
namespace {

constexpr uint64_t kMagic = 0x32304d5354414d53ULL;  // "SMATSM02"

}  // namespace

void write_values(std::ostream& out, const Values& values) {
  Writer writer(out);
  writer.plain(kMagic);
  writer.plain(static_cast<uint64_t>(values.size()));
  for (const auto& [name, value] : values) {
    writer.text(name);
    writer.text(value.kind().name);
    value.write(writer);
  }
  writer.finish();
}

std::optional<Values> read_values(std::istream& in, const Registry& registry) {
  try {
    Reader reader(in);
    if (reader.plain<uint64_t>() != kMagic) return std::nullopt;
    Values values;
    const uint64_t count = reader.count(8);
    for (uint64_t i = 0; i < count; ++i) {
      std::string name = reader.text();
      const Kind* kind = registry.find_kind(reader.text());
      if (kind == nullptr) return std::nullopt;
      values.insert_or_assign(std::move(name), Value(*kind, kind->read(reader)));
    }
    reader.finish();
    return values;
  } catch (const Damaged&) {
    return std::nullopt;
  }
}

}  // namespace seamount::recipe
