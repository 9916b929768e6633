#include "seamount/geom/contour/close_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/geom/contour/sheet_faces.h"
#include "seamount/geom/polygon/joined_lines.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

constexpr double kAtBorder = 2e-3;  ///< of the sheet's size
constexpr double kReach = 0.01;     ///< share of the way from the middle by which the lowest closing lies further out

struct BorderEnd {
  double arc;
  size_t line;
  bool first;  ///< of the line's points
};

std::string quoted(const ValuedLine& line) {
  const Vec2 a = line.points.front(), b = line.points.back();
  return fmt::format("the line of {} m from {} to {}", format_number(line.value), format_place(a), format_place(b));
}

size_t count_open(const std::vector<ValuedLine>& lines) {
  return static_cast<size_t>(
      std::count_if(lines.begin(), lines.end(), [](const ValuedLine& line) { return !line.closed; }));
}

bool at_border(const SheetBorder& sheet, Vec2 p) { return sheet.nearest(p).distance <= kAtBorder * sheet.size(); }

/// Joins the pieces of lines, then ends inside the sheet over gaps.
std::vector<ValuedLine> join_all(std::vector<ValuedLine> lines, const SheetBorder& sheet, const CloseOptions& options,
                                 const RunContext& run) {
  constexpr double kSamePlace = 1e-10;
  lines = join_lines(lines, true, kSamePlace * sheet.size());
  std::vector<ValuedLine> broken, whole;
  for (ValuedLine& line : lines) {
    const bool inside =
        !line.closed && (!at_border(sheet, line.points.front()) || !at_border(sheet, line.points.back()));
    (inside ? broken : whole).push_back(std::move(line));
  }
  if (broken.empty()) return whole;
  const size_t before = broken.size();
  std::vector<ValuedLine> mended = join_lines(broken, true, options.gap_m);
  for (const ValuedLine& line : mended) {
    if (line.closed) continue;
    for (const Vec2 end : {line.points.front(), line.points.back()})
      if (!at_border(sheet, end))
        throw InvalidArgument(options.field,
                              fmt::format("{} ends inside the sheet, at {}; contours are closed or end at its border",
                                          quoted(line), format_place(end)));
  }
  run.say(fmt::format("{}: {} broken lines were joined over gaps of at most {:.3g} m", options.field, before,
                      options.gap_m));
  whole.insert(whole.end(), std::make_move_iterator(mended.begin()), std::make_move_iterator(mended.end()));
  return whole;
}

/// Brings both ends onto the border where they lie short of it. What lies beyond, as on a side that bends, stays there.
void extend(ValuedLine& line, const SheetBorder& sheet) {
  constexpr double kRounding = 1e-6;
  const auto foot = [&](Vec2 end) -> std::optional<Vec2> {
    const SheetBorder::Foot nearest = sheet.nearest(end);
    if (nearest.distance <= kRounding * sheet.size() || !contains(sheet.ring(), end)) return std::nullopt;
    return sheet.place(nearest.arc, 0.0);
  };
  const auto first = foot(line.points.front()), last = foot(line.points.back());
  if (first) line.points.insert(line.points.begin(), *first);
  if (last) line.points.push_back(*last);
}

std::vector<BorderEnd> ends_of(const std::vector<ValuedLine>& open, const SheetBorder& sheet) {
  std::vector<BorderEnd> ends;
  for (size_t i = 0; i < open.size(); ++i) {
    ends.push_back({sheet.nearest(open[i].points.front()).arc, i, true});
    ends.push_back({sheet.nearest(open[i].points.back()).arc, i, false});
  }
  std::sort(ends.begin(), ends.end(), [](const BorderEnd& a, const BorderEnd& b) {
    return a.arc != b.arc ? a.arc < b.arc : a.line != b.line ? a.line < b.line : a.first > b.first;
  });
  return ends;
}

/// How far out a height is closed.
class Closing {
 public:
  Closing(const std::vector<ValuedLine>& open, const std::vector<ValuedLine>& rings, double base) : base_(base) {
    for (const auto* lines : {&open, &rings})
      for (const ValuedLine& line : *lines) heights_.push_back(line.value);
    std::sort(heights_.begin(), heights_.end());
    heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
  }
  const std::vector<double>& heights() const { return heights_; }
  double out(double height) const {
    const auto rank = std::lower_bound(heights_.begin(), heights_.end(), height) - heights_.begin();
    const auto count = static_cast<double>(heights_.size());
    return base_ + kReach * (count - static_cast<double>(rank)) / count;
  }

 private:
  std::vector<double> heights_;
  double base_;
};

/// The share by which closings must at least lie beyond the border, so that none lies within the frame.
double least_out(const SheetBorder& sheet, const GridFrame& frame) {
  constexpr double kStep = 0.002;
  const Ring corners = frame_ring(frame);
  for (double out = kStep; out < 0.5; out += kStep) {
    const Ring moved = sheet.moved(out);
    if (std::all_of(corners.begin(), corners.end(), [&](Vec2 p) { return contains(moved, p); })) return out;
  }
  return kStep;
}

/// Follows the lines of one height, high ground on the left, and the border between them.
class RingTracer {
 public:
  RingTracer(const std::vector<ValuedLine>& open, const std::vector<SheetLine>& lines,
             const std::vector<BorderEnd>& ends, const SheetBorder& sheet, const Closing& closing,
             const std::string& field)
      : open_(open), lines_(lines), ends_(ends), sheet_(sheet), closing_(closing), field_(field) {
    done_.assign(open.size(), 0);
  }

  std::vector<Contour> trace() {
    std::vector<Contour> contours;
    for (size_t i = 0; i < open_.size(); ++i) {
      if (done_[i] != 0) continue;
      Contour contour{open_[i].value, {}, -1};
      for (size_t at = i; done_[at] == 0;) {
        done_[at] = 1;
        at = follow(at, contour);
      }
      contours.push_back(std::move(contour));
    }
    return contours;
  }

 private:
  size_t start_of(size_t line) const { return lines_[line].left_is_high ? lines_[line].from : lines_[line].to; }
  size_t exit_of(size_t line) const { return lines_[line].left_is_high ? lines_[line].to : lines_[line].from; }

  /// Appends a line and its way along the border to the next one.
  size_t follow(size_t at, Contour& contour) const {
    Polyline points = open_[at].points;
    if (!lines_[at].left_is_high) std::reverse(points.begin(), points.end());
    contour.ring.insert(contour.ring.end(), points.begin(), points.end());
    size_t end = exit_of(at);
    do {
      end = (end + 1) % ends_.size();
    } while (open_[ends_[end].line].value != open_[at].value);
    const size_t next = ends_[end].line;
    if (start_of(next) != end)
      throw InvalidArgument(field_, fmt::format("{} and {} contradict each other at the border: the ground between "
                                                "them is both above and below",
                                                quoted(open_[at]), quoted(open_[next])));
    const double out = closing_.out(contour.height_m);
    const double from = ends_[exit_of(at)].arc, to = ends_[end].arc;
    contour.ring.push_back(sheet_.place(from, out));
    sheet_.append_corners(from, to, out, contour.ring);
    contour.ring.push_back(sheet_.place(to, out));
    return next;
  }

  const std::vector<ValuedLine>& open_;
  const std::vector<SheetLine>& lines_;
  const std::vector<BorderEnd>& ends_;
  const SheetBorder& sheet_;
  const Closing& closing_;
  const std::string& field_;
  std::vector<char> done_;
};

/// Rings around the whole sheet of the heights that its border lies above all along.
void add_outer_rings(const std::vector<ValuedLine>& open, const SheetBorder& sheet, const Closing& closing,
                     std::vector<Contour>& contours) {
  for (const double height : closing.heights()) {
    const bool above = std::all_of(open.begin(), open.end(), [&](const ValuedLine& l) { return l.value > height; });
    if (!above) continue;
    contours.push_back({height, sheet.moved(closing.out(height)), -1});
  }
}

}  // namespace

std::vector<Contour> close_lines(std::vector<ValuedLine> lines, const SheetBorder& sheet, const CloseOptions& options,
                                 const RunContext& run) {
  lines = join_all(std::move(lines), sheet, options, run);
  run.check_cancelled();
  std::vector<ValuedLine> open, rings;
  open.reserve(count_open(lines));
  for (ValuedLine& line : lines) {
    if (!line.closed) extend(line, sheet);
    (line.closed ? rings : open).push_back(std::move(line));
  }
  const std::vector<BorderEnd> ends = ends_of(open, sheet);
  std::vector<SheetLine> sheet_lines(open.size());
  for (size_t e = 0; e < ends.size(); ++e) {
    SheetLine& line = sheet_lines[ends[e].line];
    line.line = &open[ends[e].line];
    (ends[e].first ? line.from : line.to) = e;
  }
  run.check_cancelled();
  const Closing closing(open, rings, least_out(sheet, options.frame));
  std::vector<Contour> contours;
  if (!open.empty()) {
    const SideGuess guess = find_sides(sheet_lines, ends.size(), rings, options.left_is_high);
    if (guess.guessed > 0 && !options.left_is_high)
      run.say(
          fmt::format("{}: which side of {} lines is higher is taken from the way they run, since no line of another "
                      "height tells",
                      options.field, guess.guessed));
    contours = RingTracer(open, sheet_lines, ends, sheet, closing, options.field).trace();
    add_outer_rings(open, sheet, closing, contours);
  }
  for (ValuedLine& ring : rings) contours.push_back({ring.value, std::move(ring.points), -1});
  return contours;
}

}  // namespace seamount::geom
