// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/untouched_hash.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

namespace fissura::structure {

namespace {

__extension__ using Product = unsigned __int128;

// Folded multiplication, as in wyhash by Wang Yi; the constants are digits of pi (from Blowfish).
constexpr std::array<std::uint64_t, 2> element_start{0x243f6a8885a308d3u, 0x13198a2e03707344u};
constexpr std::array<std::uint64_t, 2> node_start{0xa4093822299f31d0u, 0x082efa98ec4e6c89u};
constexpr std::array<std::uint64_t, 2> first_key{0x452821e638d01377u, 0xbe5466cf34e90c6cu};
constexpr std::array<std::uint64_t, 2> second_key{0xc0ac29b7c97c50ddu, 0x3f84d5b5b5470917u};

std::uint64_t fold(std::uint64_t a, std::uint64_t b) {
  const Product product = Product{a} * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

template <std::size_t words>
std::uint64_t mix(const std::array<std::uint64_t, words>& word, std::uint64_t start, int lane) {
  static_assert(words % 2 == 0);
  std::uint64_t state = start;
  for (std::size_t i = 0; i < words; i += 2)
    state = fold(word[i] ^ first_key[lane] ^ state, word[i + 1] ^ second_key[lane] ^ std::rotl(state, 32));
  return fold(state ^ first_key[lane], start ^ second_key[lane]);
}

std::uint32_t bits(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

std::uint64_t pair(std::uint32_t low, std::uint32_t high) {
  return std::uint64_t{high} << 32 | low;
}

struct Sum {
  std::array<std::uint64_t, 2> lane{};

  template <std::size_t words>
  void add(const std::array<std::uint64_t, words>& word, const std::array<std::uint64_t, 2>& start) {
    for (int k = 0; k < 2; ++k) lane[k] += mix(word, start[k], k);
  }
};

void add_elements(const Mesh& mesh, const Body& body, const std::vector<ElementIndex>& touched, Sum& sum) {
  auto skip = touched.begin();
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    if (skip != touched.end() && *skip == element) {
      ++skip;
      continue;
    }
    const auto& [a, b, c] = mesh.elements[element];
    const InSituElement& at = body.in_situ[element];
    const std::array<std::uint64_t, 4> word{pair(a, b), pair(c, bits(at.xx)), pair(bits(at.yy), bits(at.xy)),
                                            pair(bits(at.zz), bits(at.pore_pressure))};
    sum.add(word, element_start);
  }
}

void add_nodes(const Mesh& mesh, const std::vector<double>& displacement, const std::vector<double>& velocity,
               const std::vector<NodeIndex>& touched, Sum& sum) {
  auto skip = touched.begin(), unused = mesh.unused_nodes.begin();
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    const bool is_touched = skip != touched.end() && *skip == node;
    const bool is_unused = unused != mesh.unused_nodes.end() && *unused == node;
    if (is_touched) ++skip;
    if (is_unused) ++unused;
    if (is_touched || is_unused) continue;
    const std::size_t x = 2 * std::size_t{node}, y = x + 1;
    sum.add(std::array<std::uint64_t, 8>{node, bits(mesh.position[node][0]), bits(mesh.position[node][1]),
                                         bits(displacement[x]), bits(displacement[y]), bits(velocity[x]),
                                         bits(velocity[y]), 0},
            node_start);
  }
}

}  // namespace

std::string untouched_hash(const Mesh& mesh, const Body& body, const std::vector<double>& displacement,
                           const std::vector<double>& velocity, const Touched& touched) {
  Sum sum;
  add_elements(mesh, body, touched.elements, sum);
  add_nodes(mesh, displacement, velocity, touched.nodes, sum);
  return fmt::format("{:016x}{:016x}", sum.lane[0], sum.lane[1]);
}

}  // namespace fissura::structure
