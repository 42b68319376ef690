// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>

#include "common/errors.hpp"
#include "common/exchange/codec.hpp"
#include "coupler/tape/tape_reader.hpp"
#include "coupler/tape/tape_recorder.hpp"
#include "coupler/tape/tape_writer.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;
using sample::TemporaryDirectory;

namespace {

const TapeHeader header{Role::network, 2, {1, 2, 3}, 1.75e9};

Frames frames_of(Message message, std::uint64_t sequence) {
  const EncodedMessage encoded = encode(std::move(message), {header.run, header.epoch, sequence});
  Frames frames;
  for (const auto& frame : fissura::frames_of(encoded)) frames.emplace_back(frame.begin(), frame.end());
  return frames;
}

Frames hello(const char* role) {
  Message message(MessageType::hello);
  message.body = {{"role", role}, {"solver", "sample"}, {"version", "1"}, {"pid", 7}};
  return frames_of(std::move(message), 0);
}

Frames pressure(std::uint64_t interval, std::size_t nodes) {
  Message message(MessageType::pressure);
  message.interval = interval;
  std::vector<double> values(nodes);
  for (std::size_t i = 0; i < nodes; ++i) values[i] = 1e6 + static_cast<double>(interval * nodes + i);
  message.add("pressure", "Pa", values);
  return frames_of(std::move(message), interval);
}

std::vector<std::span<const std::byte>> views(const Frames& frames) {
  return {frames.begin(), frames.end()};
}

/// Four messages; @returns where each record begins, and the end.
std::vector<std::uintmax_t> write_sample(const std::filesystem::path& file, std::vector<Frames>& messages) {
  messages = {hello("network"), pressure(1, 3), Frames{}, pressure(2, 500)};
  TapeWriter tape(file, header);
  std::vector<std::uintmax_t> places;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    places.push_back(std::filesystem::file_size(file));
    tape.write(i % 2 == 0 ? Direction::to_coupler : Direction::to_participant, 0.5 * static_cast<double>(i),
               views(messages[i]));
  }
  tape.sync();
  places.push_back(std::filesystem::file_size(file));
  return places;
}

std::vector<TapeRecord> read(const std::filesystem::path& file) {
  TapeReader tape(file);
  std::vector<TapeRecord> records;
  while (std::optional<TapeRecord> record = tape.next()) records.push_back(std::move(*record));
  return records;
}

void overwrite(const std::filesystem::path& file, std::uintmax_t place, char change) {
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(place));
  const char letter = static_cast<char>(stream.get() ^ change);
  stream.seekp(static_cast<std::streamoff>(place));
  stream.put(letter);
}

}  // namespace

TEST_CASE("a tape gives back every message with direction, time and all bytes, in order", "[coupler][tape]") {
  const TemporaryDirectory folder;
  std::vector<Frames> messages;
  const auto places = write_sample(folder.path() / "t", messages);
  TapeReader tape(folder.path() / "t");
  CHECK(tape.header() == header);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const std::optional<TapeRecord> record = tape.next();
    REQUIRE(record);
    CHECK(record->number == i);
    CHECK(record->offset == places[i]);
    CHECK(record->direction == (i % 2 == 0 ? Direction::to_coupler : Direction::to_participant));
    CHECK(record->time == 0.5 * static_cast<double>(i));
    CHECK(record->frames == messages[i]);
    CHECK_FALSE(record->damaged);
  }
  CHECK_FALSE(tape.next());
  CHECK(tape.cut_bytes() == 0);
}

TEST_CASE("a tape that is cut off anywhere can be read up to its last whole message", "[coupler][tape]") {
  const TemporaryDirectory folder;
  std::vector<Frames> messages;
  const auto places = write_sample(folder.path() / "t", messages);
  for (std::uintmax_t size = places.back(); size-- > tape_header_size;) {
    std::filesystem::resize_file(folder.path() / "t", size);
    TapeReader tape(folder.path() / "t");
    std::size_t whole = 0;
    while (tape.next()) ++whole;
    REQUIRE(whole < places.size());
    CHECK(places[whole] <= size);
    CHECK((whole + 1 == places.size() || places[whole + 1] > size));
    CHECK(tape.cut_bytes() == size - places[whole]);
  }
  std::filesystem::resize_file(folder.path() / "t", tape_header_size - 1);
  CHECK_THROWS_AS(TapeReader(folder.path() / "t"), StorageError);
}

TEST_CASE("no flipped bit of a tape stays unnoticed, and damage to one message does not touch the others",
          "[coupler][tape]") {
  const TemporaryDirectory folder;
  const std::filesystem::path file = folder.path() / "t";
  std::vector<Frames> messages;
  const auto places = write_sample(file, messages);
  for (std::uintmax_t place = 0; place < places[2]; ++place) {
    INFO("byte " << place);
    overwrite(file, place, 16);
    if (place < tape_header_size) {
      CHECK_THROWS_AS(TapeReader(file), StorageError);
    } else {
      const std::size_t struck = place < places[1] ? 0 : 1;
      if (place < places[struck] + record_header_size) {
        CHECK_THROWS_AS(read(file), StorageError);
      } else {
        const std::vector<TapeRecord> records = read(file);
        REQUIRE(records.size() == messages.size());
        for (std::size_t i = 0; i < records.size(); ++i) CHECK(records[i].damaged == (i == struck));
        CHECK(records[3].frames == messages[3]);
      }
    }
    overwrite(file, place, 16);
  }
}

TEST_CASE("only participants that were welcomed are taped, and only those of the wanted roles",
          "[coupler][tape]") {
  const TemporaryDirectory folder;
  Message yes(MessageType::welcome), no(MessageType::reject);
  const Frames welcome = frames_of(std::move(yes), 0), reject = frames_of(std::move(no), 0);
  TapeRecorder recorder(folder.path(), {Role::network}, header.run, header.epoch);
  recorder.received(1, views(hello("network")));
  recorder.sent(1, views(reject));
  recorder.received(2, views(hello("structure")));
  recorder.sent(2, views(welcome));
  recorder.received(3, views(pressure(1, 4)));
  recorder.received(4, views(hello("network")));
  recorder.sent(4, views(welcome));
  recorder.received(2, views(pressure(1, 5)));
  recorder.received(4, views(pressure(1, 6)));
  recorder.received(1, views(pressure(1, 7)));
  CHECK(taped_epochs(folder.path(), Role::structure).empty());
  REQUIRE(taped_epochs(folder.path(), Role::network) == std::vector<std::uint32_t>{header.epoch});
  const std::vector<TapeRecord> records = read(tape_file(folder.path(), Role::network, header.epoch));
  REQUIRE(records.size() == 3);
  CHECK(records[0].frames == hello("network"));
  CHECK(records[1].frames == welcome);
  CHECK(records[1].direction == Direction::to_participant);
  CHECK(records[2].frames == pressure(1, 6));
  CHECK(records[0].time <= records[1].time);
}
