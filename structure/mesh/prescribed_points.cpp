// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/prescribed_points.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {
namespace {

constexpr double walk_step = 0.1;  // of the local size

double length(Point a, Point b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

Point between(Point a, Point b, double fraction) {
  return {a[0] + fraction * (b[0] - a[0]), a[1] + fraction * (b[1] - a[1])};
}

void divide_lines(PrescribedPoints& prescribed, const LineArrangement& lines, double size) {
  prescribed.points = lines.vertices;
  for (const LinePiece& piece : lines.pieces) {
    const Point begin = lines.vertices[piece.begin], end = lines.vertices[piece.end];
    const int count = edge_count(length(begin, end), size);
    std::uint32_t last = piece.begin;
    for (int i = 1; i <= count; ++i) {
      std::uint32_t next = piece.end;
      if (i < count) {
        next = static_cast<std::uint32_t>(prescribed.points.size());
        prescribed.points.push_back(between(begin, end, static_cast<double>(i) / count));
      }
      prescribed.edges.push_back({last, next});
      prescribed.line_edges.push_back({last, next, piece.line});
      last = next;
    }
  }
}

// Fractions at which a straight stretch is cut so that every part holds the same integral of 1/h.
std::vector<double> graded_fractions(Point begin, Point end, const SizeField& field) {
  const double total = length(begin, end);
  std::vector<double> along{0}, integral{0};
  while (along.back() < total) {
    const double step = walk_step * field.size(between(begin, end, along.back() / total));
    const double next = std::min(total, along.back() + step);
    const double middle = field.size(between(begin, end, (along.back() + next) / 2 / total));
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

void divide_stretch_of_side(PrescribedPoints& prescribed, std::uint32_t from, std::uint32_t to,
                            const SizeField& field) {
  const Point begin = prescribed.points[from], end = prescribed.points[to];
  std::uint32_t last = from;
  for (const double fraction : graded_fractions(begin, end, field)) {
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

std::vector<SizedSegment> stretches(const LineArrangement& lines, const MeshControls& controls) {
  std::vector<SizedSegment> result;
  for (const LinePiece& piece : lines.pieces) {
    const Point begin = lines.vertices[piece.begin], end = lines.vertices[piece.end];
    const double total = length(begin, end);
    result.push_back({begin, end, total / edge_count(total, controls.fracture_size)});
  }
  return result;
}

PrescribedPoints prescribe_points(const LineArrangement& lines, const SizeField& field, const Case& given) {
  PrescribedPoints prescribed;
  divide_lines(prescribed, lines, given.mesh.fracture_size);
  divide_sides(prescribed, lines, field, given.domain);
  return prescribed;
}

}  // namespace fissura::structure
