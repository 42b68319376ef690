// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/transcript.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/exchange/envelope.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

Transcript::Transcript(const std::filesystem::path& file, std::uint64_t epoch)
    : descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)), epoch_(epoch) {
  if (descriptor_ < 0)
    throw Error(ExitCode::precondition,
                fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
}

Transcript::~Transcript() {
  ::close(descriptor_);
}

void Transcript::note(Direction direction, const Frames& message, const std::string& did) {
  nlohmann::ordered_json line;
  line["epoch"] = epoch_;
  line["direction"] = name_of(direction, directions);
  try {
    const Envelope envelope = decode_envelope(message.at(0));
    const bool counts = envelope.type != MessageType::progress;
    if (!counts && did.empty()) return;
    if (counts) line["n"] = ++count_[static_cast<std::size_t>(direction)];
    line["type"] = name(envelope.type);
    line["interval"] = envelope.interval;
    line["revision"] = envelope.revision;
  } catch (const ProtocolError&) {
    line["n"] = ++count_[static_cast<std::size_t>(direction)];
    line["type"] = "unreadable";
  }
  std::uint64_t bytes = 0;
  std::uint32_t sum = 0;
  for (std::size_t i = 2; i < message.size(); ++i) {
    bytes += message[i].size();
    sum = crc32(message[i], sum);
  }
  line["bytes"] = bytes;
  line["crc"] = fmt::format("{:08x}", sum);
  if (!did.empty()) line["did"] = did;
  const std::string text = line.dump() + "\n";
  (void)!::write(descriptor_, text.data(), text.size());
}

}  // namespace fissura::coupler
