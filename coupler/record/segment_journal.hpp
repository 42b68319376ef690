// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "common/byte_archive.hpp"
#include "common/exchange/message.hpp"
#include "coupler/record/hdf5_file.hpp"

namespace fissura::coupler {

/// What the open segment will hold, in memory until it is written in one go: so that a segment has the same
/// bytes whether or not its run was interrupted, and that nothing half written ever lies on disk.
class SegmentJournal {
 public:
  void create_group(const std::string& group);
  /// The array as the new dataset `dataset`; see Hdf5File::write.
  void write(const std::string& dataset, const Array& array);
  /// To a group or dataset that is in here.
  void write_attribute(const std::string& object, const std::string& attribute, double value);
  void write_attribute(const std::string& object, const std::string& attribute, std::uint64_t value);

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Of all arrays together.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  /// Everything, in the order in which it came. Throws StorageError.
  void write_to(Hdf5File& file) const;
  /// Throws StorageError, naming the dataset, unless every array comes back from `file` with every byte.
  void compare_with(const Hdf5File& file) const;

  void save(ByteWriter& archive) const;
  /// Throws Error(checkpoint_unusable).
  void restore(ByteReader& archive);

 private:
  struct Group {
    std::string name;
  };
  struct Dataset {
    std::string name;
    Array array;
  };
  struct Attribute {
    std::string object, name;
    std::variant<double, std::uint64_t> value;
  };
  using Entry = std::variant<Group, Dataset, Attribute>;

  std::vector<Entry> entries_;
  std::uint64_t bytes_ = 0;
};

}  // namespace fissura::coupler
