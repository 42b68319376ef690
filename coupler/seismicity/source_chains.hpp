// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "coupler/seismicity/source.hpp"

namespace fissura::coupler {

/// Order in which records are summed and chained; comes_before() with all other numbers behind it, so that
/// any order of arrival gives the same bits.  @returns indices
std::vector<std::uint32_t> order_of(const std::vector<SourceRecord>& records);

/// Complete sources, the first one in their order at the front.
class WaitingSources {
 public:
  void push(const Source& source);
  void pop();
  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] const Source& first() const { return heap_.front(); }
  /// All of them, in their order.
  [[nodiscard]] std::vector<Source> sources() const;

 private:
  std::vector<Source> heap_;
};

/// Chains the seismic records of each entity and class to sources.
class SourceChains {
 public:
  explicit SourceChains(const SourceRules& rules) : rules_(rules) {}

  /// Goes on with the open source of the entity, or closes it into `closed` and opens another one.
  /// @pre records come in their order
  void add(const SourceRecord& record, WaitingSources& closed);

  /// Closes those which no record that ends at `time` [s] or later continues.
  void close_before(double time, WaitingSources& closed);

  /// No open source will have an earlier time than this [s]; infinite if there is none.
  [[nodiscard]] double earliest_time() const;

  void add_to(TensorSum& moment) const;

  /// In the order of entities and classes.
  [[nodiscard]] std::vector<OpenSource> open_sources() const;
  void put_back(std::vector<OpenSource> sources);

 private:
  struct Key {
    Entity entity;
    SourceClass source_class;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  /// A source that may have gone on or closed since it was noted down.
  struct Note {
    double until = 0;      // when it listened until, then [s]
    double first_end = 0;  // which source of the key it is [s]
    Key key;
    friend auto operator<=>(const Note&, const Note&) = default;
  };

  void open(const Key& key, const OpenSource& source);
  [[nodiscard]] bool is_open(const Note& note) const;
  void drop_closed_beginnings();

  SourceRules rules_;
  std::unordered_map<Key, OpenSource, KeyHash> open_;
  std::deque<Note> beginnings_;                                             // by first end; the front is open
  std::priority_queue<Note, std::vector<Note>, std::greater<>> listening_;  // by until; one an open source
};

}  // namespace fissura::coupler
