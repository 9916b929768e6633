// Reports as files: numbers for programs, a page for people.
#pragma once

#include <string>

#include "seamount/model/report.h"

namespace seamount::io {

/// By extension: .json (every number and curve by name; what is not defined is null) or .html (one file without
/// anything from outside, light or dark as the reader's system is). Throws IoError{path}.
void write_report(const Report& report, const std::string& path);

/// The pieces, as text.
std::string report_json(const Report& report);
std::string report_html(const Report& report);

/// A plot as an inline SVG element whose colours are the page's CSS variables --s0, --s1, ... (subjects), --grid,
/// --text. A plot without points is a note that says so.
std::string plot_svg(const Plot& plot);

}  // namespace seamount::io
