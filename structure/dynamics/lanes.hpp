// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "structure/dynamics/node_record.hpp"
#include "structure/dynamics/pair.hpp"

/// Vectors of `lanes` doubles (vector extension of GCC and Clang). The width suits the registers of the
/// machine; each lane is computed as a scalar would be and forces are added four lanes at a time, so no
/// result depends on the width. Included by element_loop.cpp only: another file may be compiled for other
/// registers.
namespace fissura::structure {

#ifdef __AVX512F__
constexpr std::size_t lanes = 8;
#else
constexpr std::size_t lanes = 4;
#endif

using Quad = double __attribute__((vector_size(4 * sizeof(double))));
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));
using FloatLanes = float __attribute__((vector_size(lanes * sizeof(float))));
using MarkBytes = std::int8_t __attribute__((vector_size(lanes)));
using LaneMask = std::int64_t __attribute__((vector_size(lanes * sizeof(std::int64_t))));

/// Records of `lanes` nodes, one vector per member.
struct RecordLanes {
  Lanes x, y, ux, uy;
};

namespace detail {

inline Quad load_record(const NodeRecord& record) {
  Quad quad;
  std::memcpy(&quad, &record, sizeof(quad));
  return quad;
}

}  // namespace detail

/// Reads and transposes the records of `lanes` nodes.
inline RecordLanes load_records(const NodeRecord* record, const std::uint16_t* node) {
  const auto quad = [&](std::size_t lane) { return detail::load_record(record[node[lane]]); };
#ifdef __AVX512F__
  const auto join = [&](std::size_t lane) {
    return __builtin_shufflevector(quad(lane), quad(lane + 4), 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const Lanes a = join(0), b = join(1), c = join(2), d = join(3);
  const Lanes x_ux_ab = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes y_uy_ab = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes x_ux_cd = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes y_uy_cd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  return {__builtin_shufflevector(x_ux_ab, x_ux_cd, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(y_uy_ab, y_uy_cd, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(x_ux_ab, x_ux_cd, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(y_uy_ab, y_uy_cd, 2, 3, 10, 11, 6, 7, 14, 15)};
#else
  const Quad a = quad(0), b = quad(1), c = quad(2), d = quad(3);
  const Quad x_ux_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             y_uy_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad x_ux_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             y_uy_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(x_ux_ab, x_ux_cd, 0, 1, 4, 5),
          __builtin_shufflevector(y_uy_ab, y_uy_cd, 0, 1, 4, 5),
          __builtin_shufflevector(x_ux_ab, x_ux_cd, 2, 3, 6, 7),
          __builtin_shufflevector(y_uy_ab, y_uy_cd, 2, 3, 6, 7)};
#endif
}

/// Single-precision values as double lanes.
inline Lanes load_floats(const float* value) {
  FloatLanes floats;
  std::memcpy(&floats, value, sizeof(floats));
  return __builtin_convertvector(floats, Lanes);
}

/// The (x, y) of each lane side by side: those of the even lanes, those of the odd ones.
struct PairLanes {
  Lanes even, odd;
};

inline PairLanes interleave(const Lanes& x, const Lanes& y) {
#ifdef __AVX512F__
  return {__builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14),
          __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15)};
#else
  return {__builtin_shufflevector(x, y, 0, 4, 2, 6), __builtin_shufflevector(x, y, 1, 5, 3, 7)};
#endif
}

/// Adds the pairs of the four lanes from `first` on to the forces of their nodes, in ascending order.
template <std::size_t first>
void add_quad(std::array<double, 2>* force, const std::uint16_t* node, const PairLanes& pairs) {
  const auto add = [&](std::size_t lane, const Pair& value) {
    double* sum = force[node[lane]].data();
    store_pair(sum, load_pair(sum) + value);
  };
  add(first, __builtin_shufflevector(pairs.even, pairs.even, first, first + 1));
  add(first + 1, __builtin_shufflevector(pairs.odd, pairs.odd, first, first + 1));
  add(first + 2, __builtin_shufflevector(pairs.even, pairs.even, first + 2, first + 3));
  add(first + 3, __builtin_shufflevector(pairs.odd, pairs.odd, first + 2, first + 3));
}

/// One byte per lane, as a number: 0 if no lane is marked.
using LaneMarks = std::uint64_t;

inline LaneMarks marks_of(const LaneMask& mask) {
  const MarkBytes bytes = __builtin_convertvector(mask, MarkBytes);
  LaneMarks marks = 0;
  std::memcpy(&marks, &bytes, sizeof(bytes));
  return marks;
}

inline LaneMarks load_marks(const std::uint8_t* first) {
  LaneMarks marks = 0;
  std::memcpy(&marks, first, lanes);
  return marks;
}

inline bool marked(LaneMarks marks, std::size_t lane) {
  return (marks >> (8 * lane) & 0xff) != 0;
}

/// Values of the lanes without a mark, 0 in the others.
inline Lanes unmarked(const Lanes& values, LaneMarks marks) {
  MarkBytes bytes;
  std::memcpy(&bytes, &marks, sizeof(bytes));
  const Lanes zero{};
  return __builtin_convertvector(bytes, LaneMask) != 0 ? zero : values;
}

inline Lanes square_root(const Lanes& values) {
  Lanes roots;
  for (std::size_t lane = 0; lane < lanes; ++lane) roots[lane] = std::sqrt(values[lane]);
  return roots;
}

}  // namespace fissura::structure
