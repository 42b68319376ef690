// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/segment_journal.hpp"

#include <fmt/format.h>

namespace fissura::coupler {

namespace {

enum class EntryKind : std::uint8_t { group = 1, dataset = 2, number = 3, count = 4 };

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

[[noreturn]] void refuse() {
  throw Error(ExitCode::checkpoint_unusable, "the saved segment does not fit this program");
}

}  // namespace

void SegmentJournal::create_group(const std::string& group) {
  entries_.emplace_back(Group{group});
}

void SegmentJournal::write(const std::string& dataset, const Array& array) {
  bytes_ += array.bytes.size();
  entries_.emplace_back(Dataset{dataset, array});
}

void SegmentJournal::write_attribute(const std::string& object, const std::string& attribute, double value) {
  entries_.emplace_back(Attribute{object, attribute, value});
}

void SegmentJournal::write_attribute(const std::string& object, const std::string& attribute,
                                     std::uint64_t value) {
  entries_.emplace_back(Attribute{object, attribute, value});
}

void SegmentJournal::write_to(Hdf5File& file) const {
  const Overloaded write_entry{
      [&](const Group& group) { file.create_group(group.name); },
      [&](const Dataset& dataset) { file.write(dataset.name, dataset.array); },
      [&](const Attribute& attribute) {
        std::visit([&](auto value) { file.write_attribute(attribute.object, attribute.name, value); },
                   attribute.value);
      }};
  for (const Entry& entry : entries_) std::visit(write_entry, entry);
}

void SegmentJournal::compare_with(const Hdf5File& file) const {
  for (const Entry& entry : entries_) {
    const auto* dataset = std::get_if<Dataset>(&entry);
    if (dataset == nullptr) continue;
    const Array found = file.read(dataset->name);
    if (found.shape != dataset->array.shape || found.bytes != dataset->array.bytes)
      throw StorageError(fmt::format("{} is not what was written", dataset->name));
  }
}

void SegmentJournal::save(ByteWriter& archive) const {
  const Overloaded save_entry{[&](const Group& group) {
                                archive.put(EntryKind::group);
                                archive.put(group.name);
                              },
                              [&](const Dataset& dataset) {
                                archive.put(EntryKind::dataset);
                                archive.put(dataset.name);
                                archive.put(dataset.array.dtype);
                                archive.put(dataset.array.unit);
                                archive.put(dataset.array.shape);
                                archive.put(dataset.array.bytes);
                              },
                              [&](const Attribute& attribute) {
                                const bool is_count = std::holds_alternative<std::uint64_t>(attribute.value);
                                archive.put(is_count ? EntryKind::count : EntryKind::number);
                                archive.put(attribute.object);
                                archive.put(attribute.name);
                                std::visit([&](auto value) { archive.put(value); }, attribute.value);
                              }};
  archive.put(static_cast<std::uint64_t>(entries_.size()));
  for (const Entry& entry : entries_) std::visit(save_entry, entry);
}

void SegmentJournal::restore(ByteReader& archive) {
  *this = {};
  std::uint64_t count = 0;
  archive.get(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    EntryKind kind{};
    std::string object, attribute;
    archive.get(kind);
    archive.get(object);
    switch (kind) {
      case EntryKind::group:
        create_group(object);
        break;
      case EntryKind::dataset: {
        Array array;
        archive.get(array.dtype);
        archive.get(array.unit);
        archive.get(array.shape);
        archive.get(array.bytes);
        if (!is_writable(array)) refuse();
        write(object, array);
        break;
      }
      case EntryKind::number: {
        double value = 0;
        archive.get(attribute);
        archive.get(value);
        write_attribute(object, attribute, value);
        break;
      }
      case EntryKind::count: {
        std::uint64_t value = 0;
        archive.get(attribute);
        archive.get(value);
        write_attribute(object, attribute, value);
        break;
      }
      default:
        refuse();
    }
  }
}

}  // namespace fissura::coupler
