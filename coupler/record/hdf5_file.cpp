// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"
#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

namespace {

constexpr hsize_t values_in_chunk = 1 << 17;

/// An identifier of the library with the function that closes it.
class Identifier {
 public:
  using Close = herr_t (*)(hid_t);
  Identifier(hid_t id, Close close_function) : id_(id), close_(close_function) {}
  ~Identifier() {
    if (id_ >= 0) close_(id_);
  }
  Identifier(Identifier&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Identifier& operator=(Identifier&&) = delete;

  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] herr_t close() { return close_(std::exchange(id_, -1)); }

 private:
  hid_t id_;
  Close close_;
};

void start_library() {
  static const bool started = [] {
    // Everything is closed here; at exit the library would only try again what has failed on a full disk.
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  (void)started;
}

herr_t keep_innermost(unsigned depth, const H5E_error2_t* entry, void* reason) {
  if (depth == 0 && entry->desc != nullptr) *static_cast<std::string*>(reason) = entry->desc;
  return 0;
}

std::string library_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  const std::string before = "error message = '";
  const auto begin = reason.find(before);
  if (begin == std::string::npos) return reason.empty() ? "HDF5 gives no reason" : reason;
  const auto text = begin + before.size();
  return reason.substr(text, reason.find('\'', text) - text);
}

hid_t type_of(const std::string& dtype) {
  if (dtype == "float64") return H5T_IEEE_F64LE;
  if (dtype == "int64") return H5T_STD_I64LE;
  if (dtype == "uint64") return H5T_STD_U64LE;
  if (dtype == "uint8") return H5T_STD_U8LE;
  return H5I_INVALID_HID;
}

std::size_t value_size(const std::string& dtype) {
  return dtype == "uint8" ? 1 : 8;
}

/// Bytes of such an array; nothing if 64 bits cannot count them.
std::optional<std::uint64_t> byte_count(const std::string& dtype, const std::vector<std::uint64_t>& shape) {
  if (std::find(shape.begin(), shape.end(), 0) != shape.end()) return 0;
  std::uint64_t bytes = value_size(dtype);
  for (const std::uint64_t extent : shape) {
    if (bytes > std::numeric_limits<std::uint64_t>::max() / extent) return std::nullopt;
    bytes *= extent;
  }
  return bytes;
}

std::string dtype_of(hid_t type) {
  for (const char* dtype : {"float64", "int64", "uint64", "uint8"})
    if (H5Tequal(type, type_of(dtype)) > 0) return dtype;
  return "";
}

}  // namespace

struct Hdf5File::Handle {
  std::filesystem::path path;
  Identifier file;

  [[noreturn]] void fail(const char* doing, const std::string& object) const {
    throw StorageError(fmt::format("cannot {} {} in {}: {}", doing, object, path.string(), library_reason()));
  }

  void check(herr_t result, const char* doing, const std::string& object) const {
    if (result < 0) fail(doing, object);
  }

  Identifier own(hid_t id, Identifier::Close close, const char* doing, const std::string& object) const {
    if (id < 0) fail(doing, object);
    return {id, close};
  }

  void write_attribute(hid_t object, const std::string& name, hid_t type, const void* value) const {
    Identifier space = own(H5Screate(H5S_SCALAR), H5Sclose, "describe attribute", name);
    Identifier attribute = own(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                               H5Aclose, "create attribute", name);
    check(H5Awrite(attribute.id(), type, value), "write attribute", name);
    check(attribute.close(), "close attribute", name);
  }

  void write_text(hid_t object, const std::string& name, const std::string& text) const {
    Identifier type = own(H5Tcopy(H5T_C_S1), H5Tclose, "describe attribute", name);
    check(H5Tset_size(type.id(), std::max<std::size_t>(text.size(), 1)), "describe attribute", name);
    check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "describe attribute", name);
    check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "describe attribute", name);
    write_attribute(object, name, type.id(), text.c_str());
  }

  std::string read_unit(hid_t dataset) const {
    Identifier attribute = own(H5Aopen(dataset, "unit", H5P_DEFAULT), H5Aclose, "open attribute", "unit");
    Identifier type = own(H5Aget_type(attribute.id()), H5Tclose, "read attribute", "unit");
    std::string unit(H5Tget_size(type.id()), '\0');
    check(H5Aread(attribute.id(), type.id(), unit.data()), "read attribute", "unit");
    return unit.substr(0, unit.find('\0'));
  }

  /// Equal content shall give equal files.
  Identifier timeless(hid_t kind, const std::string& object) const {
    Identifier properties = own(H5Pcreate(kind), H5Pclose, "set the properties of", object);
    check(H5Pset_obj_track_times(properties.id(), false), "set the properties of", object);
    return properties;
  }

  Identifier creation_properties(const std::vector<hsize_t>& extent, const std::string& dataset) const {
    Identifier properties = timeless(H5P_DATASET_CREATE, dataset);
    hsize_t row = 1;
    for (std::size_t dimension = 1; dimension < extent.size(); ++dimension) row *= extent[dimension];
    if (extent[0] == 0 || row == 0) return properties;
    std::vector<hsize_t> chunk = extent;
    chunk[0] = std::clamp<hsize_t>(values_in_chunk / row, 1, extent[0]);
    check(H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data()),
          "set the properties of", dataset);
    check(H5Pset_fletcher32(properties.id()), "set the properties of", dataset);
    return properties;
  }

  void create_group(const std::string& group) const {
    Identifier properties = timeless(H5P_GROUP_CREATE, group);
    Identifier id = own(H5Gcreate2(file.id(), group.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                        H5Gclose, "create", group);
    check(id.close(), "close", group);
  }

  /// The library would give groups that it creates on the way the time of day.
  void create_groups_above(const std::string& object) const {
    for (auto end = object.find('/', 1); end != std::string::npos; end = object.find('/', end + 1)) {
      const std::string group = object.substr(0, end);
      const htri_t exists = H5Lexists(file.id(), group.c_str(), H5P_DEFAULT);
      check(exists, "look for", group);
      if (exists == 0) create_group(group);
    }
  }

  Identifier open_dataset(const std::string& dataset) const {
    return own(H5Dopen2(file.id(), dataset.c_str(), H5P_DEFAULT), H5Dclose, "open", dataset);
  }

  Array describe(const std::string& name, hid_t dataset) const {
    Array array;
    array.name = name;
    Identifier space = own(H5Dget_space(dataset), H5Sclose, "read the shape of", name);
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank < 0) fail("read the shape of", name);
    std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
    check(H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr), "read the shape of", name);
    array.shape.assign(extent.begin(), extent.end());
    Identifier type = own(H5Dget_type(dataset), H5Tclose, "read the type of", name);
    array.dtype = dtype_of(type.id());
    if (array.dtype.empty())
      throw StorageError(fmt::format("{} in {} is of a type that is not ours", name, path.string()));
    array.unit = read_unit(dataset);
    return array;
  }
};

Hdf5File::Hdf5File(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}
Hdf5File::~Hdf5File() = default;
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;

namespace {

Identifier access_properties() {
  start_library();
  Identifier access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // Our run directory has its own lock; that of the library fails on file systems without locks.
  const bool set = access.id() >= 0 &&
                   H5Pset_libver_bounds(access.id(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST) >= 0 &&
                   H5Pset_file_locking(access.id(), false, true) >= 0;
  if (!set) throw StorageError("cannot set up HDF5: " + library_reason());
  return access;
}

}  // namespace

Hdf5File Hdf5File::create(const std::filesystem::path& file) {
  Identifier access = access_properties();
  Identifier creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  if (creation.id() < 0 || H5Pset_obj_track_times(creation.id(), false) < 0)
    throw StorageError("cannot set up HDF5: " + library_reason());
  Identifier id(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  if (id.id() < 0) throw StorageError(fmt::format("cannot create {}: {}", file.string(), library_reason()));
  return Hdf5File(std::make_unique<Handle>(Handle{file, std::move(id)}));
}

Hdf5File Hdf5File::open(const std::filesystem::path& file) {
  Identifier access = access_properties();
  Identifier id(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  if (id.id() < 0) throw StorageError(fmt::format("cannot open {}: {}", file.string(), library_reason()));
  return Hdf5File(std::make_unique<Handle>(Handle{file, std::move(id)}));
}

bool is_writable(const Array& array) {
  return type_of(array.dtype) >= 0 && !array.shape.empty() &&
         byte_count(array.dtype, array.shape) == array.bytes.size();
}

void Hdf5File::write(const std::string& dataset, const Array& array) {
  ENSURE(is_writable(array));
  const hid_t type = type_of(array.dtype);
  if (const int error = injected_error(StorageCall::write))
    throw StorageError(
        fmt::format("cannot write {} in {}: {}", dataset, handle_->path.string(), std::strerror(error)));
  const std::vector<hsize_t> extent(array.shape.begin(), array.shape.end());
  Identifier space = handle_->own(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                                  H5Sclose, "describe", dataset);
  Identifier creation = handle_->creation_properties(extent, dataset);
  handle_->create_groups_above(dataset);
  Identifier id = handle_->own(H5Dcreate2(handle_->file.id(), dataset.c_str(), type, space.id(), H5P_DEFAULT,
                                          creation.id(), H5P_DEFAULT),
                               H5Dclose, "create", dataset);
  if (!array.bytes.empty())
    handle_->check(H5Dwrite(id.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.bytes.data()), "write",
                   dataset);
  handle_->write_text(id.id(), "unit", array.unit);
  handle_->check(id.close(), "close", dataset);
}

void Hdf5File::create_group(const std::string& group) {
  handle_->create_groups_above(group);
  handle_->create_group(group);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& attribute, double value) {
  Identifier id =
      handle_->own(H5Oopen(handle_->file.id(), object.c_str(), H5P_DEFAULT), H5Oclose, "open", object);
  handle_->write_attribute(id.id(), attribute, H5T_IEEE_F64LE, &value);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& attribute, std::uint64_t value) {
  Identifier id =
      handle_->own(H5Oopen(handle_->file.id(), object.c_str(), H5P_DEFAULT), H5Oclose, "open", object);
  handle_->write_attribute(id.id(), attribute, H5T_STD_U64LE, &value);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& attribute,
                               const std::string& text) {
  Identifier id =
      handle_->own(H5Oopen(handle_->file.id(), object.c_str(), H5P_DEFAULT), H5Oclose, "open", object);
  handle_->write_text(id.id(), attribute, text);
}

namespace {

herr_t list_dataset(hid_t, const char* name, const H5O_info_t* info, void* names) {
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(names)->push_back(std::string("/") + name);
  return 0;
}

}  // namespace

std::vector<std::string> Hdf5File::datasets() const {
  std::vector<std::string> names;
  // A damaged group ends the visit; the names so far are still worth having.
  (void)H5Ovisit2(handle_->file.id(), H5_INDEX_NAME, H5_ITER_INC, list_dataset, &names, H5O_INFO_BASIC);
  return names;
}

bool Hdf5File::has(const std::string& dataset) const {
  // The library takes a missing group on the way for an error.
  for (std::size_t end = dataset.find('/', 1);; end = dataset.find('/', end + 1)) {
    const htri_t found = H5Lexists(handle_->file.id(), dataset.substr(0, end).c_str(), H5P_DEFAULT);
    handle_->check(found, "look for", dataset);
    if (found == 0) return false;
    if (end == std::string::npos) return true;
  }
}

Array Hdf5File::read(const std::string& dataset) const {
  Identifier id = handle_->open_dataset(dataset);
  Array array = handle_->describe(dataset, id.id());
  const auto bytes = byte_count(array.dtype, array.shape);
  if (!bytes || *bytes > std::filesystem::file_size(handle_->path))
    throw StorageError(
        fmt::format("{} in {} says that it is larger than the file", dataset, handle_->path.string()));
  array.bytes.resize(*bytes);
  if (!array.bytes.empty())
    handle_->check(H5Dread(id.id(), type_of(array.dtype), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.bytes.data()),
                   "read", dataset);
  return array;
}

Array Hdf5File::describe(const std::string& dataset) const {
  Identifier id = handle_->open_dataset(dataset);
  return handle_->describe(dataset, id.id());
}

double Hdf5File::read_number(const std::string& object, const std::string& attribute) const {
  Identifier id =
      handle_->own(H5Oopen(handle_->file.id(), object.c_str(), H5P_DEFAULT), H5Oclose, "open", object);
  Identifier value =
      handle_->own(H5Aopen(id.id(), attribute.c_str(), H5P_DEFAULT), H5Aclose, "open attribute", attribute);
  double number = 0;
  handle_->check(H5Aread(value.id(), H5T_NATIVE_DOUBLE, &number), "read attribute", attribute);
  return number;
}

void Hdf5File::close() {
  handle_->check(H5Fflush(handle_->file.id(), H5F_SCOPE_GLOBAL), "flush", "everything");
  handle_->check(handle_->file.close(), "close", "everything");
  sync_to_disk(handle_->path);
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace fissura::coupler
