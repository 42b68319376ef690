// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/prescribed_points.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {
namespace {

constexpr double walk_step = 0.1;       // of the local size
constexpr double refined_below = 0.99;  // of the size along the line

double length(Point a, Point b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

Point between(Point a, Point b, double fraction) {
  return {a[0] + fraction * (b[0] - a[0]), a[1] + fraction * (b[1] - a[1])};
}

// Fractions at which a straight stretch is cut so that every part holds the same integral of 1/size.
template <class Size>
std::vector<double> graded_fractions(Point begin, Point end, const Size& size) {
  const double total = length(begin, end);
  std::vector<double> along{0}, integral{0};
  while (along.back() < total) {
    const double step = walk_step * size(between(begin, end, along.back() / total));
    const double next = std::min(total, along.back() + step);
    const double middle = size(between(begin, end, (along.back() + next) / 2 / total));
    integral.push_back(integral.back() + (next - along.back()) / middle);
    along.push_back(next);
  }
  const int count = std::max(1, static_cast<int>(std::lround(integral.back())));
  std::vector<double> fractions;
  std::size_t k = 1;
  for (int i = 1; i < count; ++i) {
    const double wanted = integral.back() * i / count;
    while (integral[k] < wanted) ++k;
    const double share = (wanted - integral[k - 1]) / (integral[k] - integral[k - 1]);
    fractions.push_back((along[k - 1] + share * (along[k] - along[k - 1])) / total);
  }
  return fractions;
}

bool is_refined(Point begin, Point end, const SizeField& field, double size) {
  const int samples = static_cast<int>(std::ceil(length(begin, end) / (walk_step * size)));
  for (int i = 0; i <= samples; ++i)
    if (field.size_on_line(between(begin, end, static_cast<double>(i) / samples), size) <
        refined_below * size)
      return true;
  return false;
}

std::vector<double> fractions_on_line(Point begin, Point end, const SizeField& field, double size) {
  if (is_refined(begin, end, field, size))
    return graded_fractions(begin, end, [&](Point point) { return field.size_on_line(point, size); });
  std::vector<double> fractions;
  const int count = edge_count(length(begin, end), size);
  for (int i = 1; i < count; ++i) fractions.push_back(static_cast<double>(i) / count);
  return fractions;
}

void divide_lines(PrescribedPoints& prescribed, const LineArrangement& lines, const SizeField& field,
                  const Case& given) {
  prescribed.points = lines.vertices;
  for (const LinePiece& piece : lines.pieces) {
    const Point begin = lines.vertices[piece.begin], end = lines.vertices[piece.end];
    const double size = size_along(given.fractures[piece.line].kind, given.mesh);
    std::uint32_t last = piece.begin;
    const auto add_edge_to = [&](std::uint32_t next) {
      prescribed.edges.push_back({last, next});
      prescribed.line_edges.push_back({last, next, piece.line});
      last = next;
    };
    for (const double fraction : fractions_on_line(begin, end, field, size)) {
      prescribed.points.push_back(between(begin, end, fraction));
      add_edge_to(static_cast<std::uint32_t>(prescribed.points.size() - 1));
    }
    add_edge_to(piece.end);
  }
}

void divide_stretch_of_side(PrescribedPoints& prescribed, std::uint32_t from, std::uint32_t to,
                            const SizeField& field) {
  const Point begin = prescribed.points[from], end = prescribed.points[to];
  std::uint32_t last = from;
  for (const double fraction :
       graded_fractions(begin, end, [&field](Point point) { return field.size(point); })) {
    const auto next = static_cast<std::uint32_t>(prescribed.points.size());
    prescribed.points.push_back(between(begin, end, fraction));
    prescribed.edges.push_back({last, next});
    last = next;
  }
  prescribed.edges.push_back({last, to});
}

void divide_sides(PrescribedPoints& prescribed, const LineArrangement& lines, const SizeField& field,
                  const Domain& domain) {
  const double x = domain.width / 2, y = domain.height / 2;
  const Point corners[4] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  std::uint32_t corner_point[4];
  for (int c = 0; c < 4; ++c) {
    const auto known = std::find(lines.vertices.begin(), lines.vertices.end(), corners[c]);
    corner_point[c] = static_cast<std::uint32_t>(
        known == lines.vertices.end() ? prescribed.points.size() : known - lines.vertices.begin());
    if (known == lines.vertices.end()) prescribed.points.push_back(corners[c]);
  }
  for (int c = 0; c < 4; ++c) {
    const std::uint32_t first = corner_point[c], last = corner_point[(c + 1) % 4];
    const int across = c % 2 == 0 ? 1 : 0, along = 1 - across;
    std::vector<std::uint32_t> stops{first, last};
    for (std::uint32_t v = 0; v < lines.vertices.size(); ++v)
      if (lines.vertices[v][across] == corners[c][across] && v != first && v != last) stops.push_back(v);
    const bool ascending = corners[(c + 1) % 4][along] > corners[c][along];
    std::sort(stops.begin(), stops.end(), [&](std::uint32_t a, std::uint32_t b) {
      return ascending ? prescribed.points[a][along] < prescribed.points[b][along]
                       : prescribed.points[a][along] > prescribed.points[b][along];
    });
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
      divide_stretch_of_side(prescribed, stops[i], stops[i + 1], field);
  }
}

}  // namespace

int edge_count(double length, double size) {
  const double exact = length / size;
  const double below = std::max(1.0, std::floor(exact));
  return static_cast<int>(exact / below > (below + 1) / exact ? below + 1 : below);
}

std::vector<SizedSegment> stretches(const LineArrangement& lines, const Case& given) {
  std::vector<SizedSegment> result;
  for (const LinePiece& piece : lines.pieces) {
    const Point begin = lines.vertices[piece.begin], end = lines.vertices[piece.end];
    const double total = length(begin, end);
    const double size = size_along(given.fractures[piece.line].kind, given.mesh);
    result.push_back({begin, end, total / edge_count(total, size), size});
  }
  return result;
}

std::vector<Point> growing_tips(const LineArrangement& lines, const Case& given) {
  if (given.growth.path != PathRule::free) return {};
  std::vector<int> pieces(lines.vertices.size(), 0);
  for (const LinePiece& piece : lines.pieces) {
    ++pieces[piece.begin];
    ++pieces[piece.end];
  }
  const auto inside = [&given](Point point) {
    return std::abs(point[0]) < given.domain.width / 2 && std::abs(point[1]) < given.domain.height / 2;
  };
  std::vector<Point> tips;
  for (const LinePiece& piece : lines.pieces)
    for (const std::uint32_t end : {piece.begin, piece.end})
      if (pieces[end] == 1 && given.fractures[piece.line].kind == FractureKind::open &&
          inside(lines.vertices[end]))
        tips.push_back(lines.vertices[end]);
  return tips;
}

PrescribedPoints prescribe_points(const LineArrangement& lines, const SizeField& field, const Case& given) {
  PrescribedPoints prescribed;
  divide_lines(prescribed, lines, field, given);
  divide_sides(prescribed, lines, field, given.domain);
  return prescribed;
}

}  // namespace fissura::structure
