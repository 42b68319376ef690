// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/exchange/message.hpp"

namespace fissura::coupler {

/// One HDF5 file; the only door to the library, one thread at a time. Files are written with checksummed
/// metadata (latest format) and Fletcher-32 on every array, so that damage is an error and never a wrong
/// number. Every return code is checked: all functions throw StorageError with the file, the object and the
/// library's reason.
class Hdf5File {
 public:
  /// Creates `file`, or empties it.
  static Hdf5File create(const std::filesystem::path& file);
  /// Opens `file` for reading.
  static Hdf5File open(const std::filesystem::path& file);

  ~Hdf5File();
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;

  /// Writes `array` as the new dataset `dataset` ("/reports/000001/structure/displacement"; groups on the way
  /// are created) with its unit as attribute `unit`. array.name is not used. @pre is_writable(array)
  void write(const std::string& dataset, const Array& array);
  /// Creates a group, and those on the way.
  void create_group(const std::string& group);
  /// Adds an attribute to a group or dataset that exists.
  void write_attribute(const std::string& object, const std::string& attribute, double value);
  void write_attribute(const std::string& object, const std::string& attribute, std::uint64_t value);
  void write_attribute(const std::string& object, const std::string& attribute, const std::string& text);

  /// Names of all datasets that can be reached, in the order of their names. What is wrong with the rest is
  /// found out by reading it.
  [[nodiscard]] std::vector<std::string> datasets() const;
  /// Whether there is such a dataset.
  [[nodiscard]] bool has(const std::string& dataset) const;
  /// The dataset as written; Array::name is `dataset`.
  [[nodiscard]] Array read(const std::string& dataset) const;
  /// As read(), without the values.
  [[nodiscard]] Array describe(const std::string& dataset) const;
  [[nodiscard]] double read_number(const std::string& object, const std::string& attribute) const;

  /// Flushes, closes and waits for the disk. Only after this has returned is anything in the file certain.
  void close();

 private:
  struct Handle;
  explicit Hdf5File(std::unique_ptr<Handle> handle);
  std::unique_ptr<Handle> handle_;
};

/// Whether Hdf5File::write takes it: a type of the protocol, at least one dimension, and as many bytes as its
/// shape says.
bool is_writable(const Array& array);

/// Version of the HDF5 library in use, e.g. "1.10.8".
std::string hdf5_version();

}  // namespace fissura::coupler
