// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/some_words.hpp"

#include "common/fracture_network/insertion_json.hpp"

namespace fissura::test {

namespace {

MessageType type_of(Word word) {
  switch (word) {
    case Word::hello:
      return MessageType::hello;
    case Word::welcome:
    case Word::welcome_resuming:
      return MessageType::welcome;
    case Word::reject:
      return MessageType::reject;
    case Word::topology:
      return MessageType::topology;
    case Word::insert:
      return MessageType::insert;
    case Word::acknowledge:
      return MessageType::acknowledge;
    case Word::advance:
      return MessageType::advance;
    case Word::pressure:
      return MessageType::pressure;
    case Word::response:
    case Word::proposal:
      return MessageType::response;
    case Word::report:
      return MessageType::report;
    case Word::fields:
      return MessageType::fields;
    case Word::save:
      return MessageType::save;
    case Word::state:
      return MessageType::state;
    case Word::restore:
      return MessageType::restore;
    case Word::restored:
      return MessageType::restored;
    case Word::finish:
      return MessageType::finish;
    case Word::bye:
      return MessageType::bye;
    case Word::fail:
      return MessageType::fail;
    case Word::progress:
      return MessageType::progress;
  }
  return MessageType::fail;
}

}  // namespace

Insertion insertion_of_revision(std::uint64_t revision) {
  Insertion insertion;
  insertion.revision = revision;
  insertion.new_nodes = {{.id = revision + 1, .x = static_cast<double>(revision), .lumped_length = 1}};
  return insertion;
}

Message message_of(Word word, std::uint64_t revision) {
  Message message(type_of(word));
  if (word == Word::welcome || word == Word::welcome_resuming)
    message.body = {{"case", nlohmann::json::object()},
                    {"threads", 1},
                    {"coupler_deadline", 60.0},
                    {"resumes", word == Word::welcome_resuming}};
  if (word == Word::reject || word == Word::fail) message.body = {{"reason", "as a test"}};
  if (word == Word::insert || word == Word::proposal || word == Word::topology)
    message.body["insertion"] = insertion_to_json(insertion_of_revision(revision));
  if (word == Word::restore) {
    message.body["insertions"] = {insertion_to_json(insertion_of_revision(0))};
    message.add_bytes("state", {});
  }
  return message;
}

}  // namespace fissura::test
