// report: measured numbers and plots.
#include "seamount/io/report.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/frame_bytes.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

void write_plot(Writer& writer, const Plot& plot) {
  writer.plain(static_cast<uint8_t>(plot.kind));
  writer.text(plot.x_title);
  writer.text(plot.y_title);
  writer.plain(static_cast<uint8_t>(plot.log_x));
  writer.plain(static_cast<uint8_t>(plot.log_y));
  writer.plain(static_cast<uint64_t>(plot.lines.size()));
  for (const PlotLine& line : plot.lines) {
    writer.list(line.x);
    writer.list(line.y);
  }
}

Plot read_plot(Reader& reader) {
  Plot plot;
  const auto kind = reader.plain<uint8_t>();
  if (kind > static_cast<uint8_t>(PlotKind::bars)) throw Damaged();
  plot.kind = static_cast<PlotKind>(kind);
  plot.x_title = reader.text();
  plot.y_title = reader.text();
  plot.log_x = reader.plain<uint8_t>() != 0;
  plot.log_y = reader.plain<uint8_t>() != 0;
  plot.lines.resize(reader.count(16));
  for (PlotLine& line : plot.lines) {
    line.x = reader.list<double>();
    line.y = reader.list<double>();
  }
  return plot;
}

void write_measures(Writer& writer, const std::vector<Measure>& measures) {
  writer.plain(static_cast<uint64_t>(measures.size()));
  for (const Measure& measure : measures) {
    writer.text(measure.name);
    writer.text(measure.unit);
    writer.list(measure.values);
  }
}

std::vector<Measure> read_measures(Reader& reader) {
  std::vector<Measure> measures(reader.count(24));
  for (Measure& measure : measures) {
    measure.name = reader.text();
    measure.unit = reader.text();
    measure.values = reader.list<double>();
  }
  return measures;
}

void write_report(Writer& writer, const Report& report) {
  writer.text(report.title);
  writer.plain(static_cast<uint64_t>(report.subjects.size()));
  for (const std::string& subject : report.subjects) writer.text(subject);
  write_measures(writer, report.settings);
  writer.plain(static_cast<uint64_t>(report.descriptors.size()));
  for (const Descriptor& descriptor : report.descriptors) {
    writer.text(descriptor.name);
    writer.text(descriptor.title);
    writer.text(descriptor.meaning);
    write_plot(writer, descriptor.plot);
    write_measures(writer, descriptor.measures);
    writer.plain(static_cast<uint8_t>(descriptor.distance.has_value()));
    writer.plain(descriptor.distance.value_or(0.0));
  }
}

Report read_report(Reader& reader) {
  Report report;
  report.title = reader.text();
  report.subjects.resize(reader.count(8));
  for (std::string& subject : report.subjects) subject = reader.text();
  report.settings = read_measures(reader);
  report.descriptors.resize(reader.count(64));
  for (Descriptor& descriptor : report.descriptors) {
    descriptor.name = reader.text();
    descriptor.title = reader.text();
    descriptor.meaning = reader.text();
    descriptor.plot = read_plot(reader);
    descriptor.measures = read_measures(reader);
    const bool has_distance = reader.plain<uint8_t>() != 0;
    const auto distance = reader.plain<double>();
    if (has_distance) descriptor.distance = distance;
  }
  return report;
}

size_t size_of(const Report& report) {
  size_t numbers = 0;
  for (const Descriptor& descriptor : report.descriptors)
    for (const PlotLine& line : descriptor.plot.lines) numbers += line.x.size() + line.y.size();
  return numbers * sizeof(double);
}

}  // namespace

const Kind& kinds::Report::kind() {
  static const Kind kind = make_kind<seamount::Report>({
      .name = "report",
      .about = "measured numbers and plots",
      .files = {".html", ".json"},
      .reads = {},
      .frame = {},
      .bytes = size_of,
      .write = write_report,
      .read = read_report,
      .read_file = {},
      .info = {},
  });
  return kind;
}

void kinds::Report::add_formats(Registry& registry) {
  const std::vector<std::string> files = {".html", ".json"};
  registry.add(make_format<NoParams>(
      {"report", "measured numbers: JSON, or a page with plots", files, files, {&kind()}},
      [](const NoParams&, const OutputCall& call) { io::write_report(call.value.get<Report>(), call.path); }));
}

}  // namespace seamount::recipe
