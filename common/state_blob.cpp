// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/state_blob.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "common/errors.hpp"
#include "common/hash.hpp"

namespace fissura {

namespace {

constexpr std::array<char, 8> magic{'F', 'i', 's', 's', 'S', 't', 'a', 't'};

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(ExitCode::checkpoint_unusable, sentence);
}

void require_same(const char* what, const std::string& found, const std::string& expected) {
  if (found != expected)
    refuse(fmt::format("the saved state is of another {}: {:.40}, expected {:.40}", what, found, expected));
}

/// The bytes before the checksum, which must hold.
std::span<const std::byte> checked(std::span<const std::byte> blob) {
  std::uint32_t sum = 0;
  if (blob.size() < magic.size() + sizeof(sum)) refuse("the saved state is cut short");
  if (std::memcmp(blob.data(), magic.data(), magic.size()) != 0) refuse("the bytes are not a saved state");
  const auto content = blob.first(blob.size() - sizeof(sum));
  ByteReader(blob.last(sizeof(sum))).get(sum);
  if (crc32(content) != sum) refuse("the saved state is damaged: its checksum is wrong");
  return content;
}

}  // namespace

void begin_state(const StateOwner& owner, ByteWriter& bytes) {
  bytes.put(magic);
  bytes.put(owner.solver);
  bytes.put(owner.program);
  bytes.put(owner.format);
  bytes.put(owner.case_hash);
}

std::vector<std::byte> end_state(ByteWriter& bytes) {
  bytes.put(crc32(bytes.bytes()));
  return bytes.take();
}

std::span<const std::byte> state_inside(std::span<const std::byte> blob, const StateOwner& owner) {
  const auto content = checked(blob).subspan(magic.size());
  ByteReader reader(content);
  StateOwner found;
  reader.get(found.solver);
  require_same("solver", found.solver, owner.solver);
  reader.get(found.program);
  require_same("program", found.program, owner.program);
  reader.get(found.format);
  require_same("format", std::to_string(found.format), std::to_string(owner.format));
  reader.get(found.case_hash);
  require_same("case", found.case_hash, owner.case_hash);
  return reader.rest();
}

}  // namespace fissura
