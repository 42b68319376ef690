// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <fstream>
#include <numeric>

#include "common/errors.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

Message arrays_of_every_kind() {
  Message message(MessageType::fields);
  message.add("pressure", "Pa", std::vector<double>{1.5, -2.5, 1.0 / 3});
  message.add("displacement", "m", std::vector<double>{1, 2, 3, 4, 5, 6}, 3, 2);
  message.add_ids("elements", std::vector<std::uint64_t>{0, 1, 1ull << 60}, 3);
  message.add_bytes("broken", std::vector<std::byte>{std::byte{0}, std::byte{255}});
  message.add("nothing", "", std::vector<double>{});
  return message;
}

}  // namespace

TEST_CASE("arrays come back from HDF5 with every bit, shape, type and unit", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const auto path = folder.path() / "arrays.h5";
  const Message written = arrays_of_every_kind();
  Hdf5File file = Hdf5File::create(path);
  for (const Array& array : written.arrays) file.write("/deep/group/" + array.name, array);
  file.write_attribute("/deep/group", "time", 0.1);
  file.write_attribute("/deep/group", "revision", std::uint64_t{7});
  file.close();

  const Hdf5File reread = Hdf5File::open(path);
  for (const Array& array : written.arrays) {
    INFO(array.name);
    const Array read = reread.read("/deep/group/" + array.name);
    CHECK(read.bytes == array.bytes);
    CHECK(read.shape == array.shape);
    CHECK(read.dtype == array.dtype);
    CHECK(read.unit == array.unit);
  }
  CHECK(reread.has("/deep/group/pressure"));
  CHECK_FALSE(reread.has("/deep/group/aperture"));
  CHECK_FALSE(reread.has("/no/such/group"));
  CHECK(reread.read_number("/deep/group", "time") == 0.1);
  CHECK(reread.read_number("/deep/group", "revision") == 7);
}

TEST_CASE("an array larger than a chunk comes back whole", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  std::vector<double> values(300'000);
  std::iota(values.begin(), values.end(), 0.0);
  Message message(MessageType::fields);
  message.add("stress", "Pa", values, values.size() / 4, 4);
  Hdf5File file = Hdf5File::create(folder.path() / "large.h5");
  file.write("/stress", message.arrays[0]);
  file.close();
  CHECK(Hdf5File::open(folder.path() / "large.h5").read("/stress").bytes == message.arrays[0].bytes);
}

TEST_CASE("one flipped bit in an HDF5 file is an error and never a wrong number", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const auto path = folder.path() / "damaged.h5";
  Message message(MessageType::fields);
  message.add("pressure", "Pa", std::vector<double>(64, 31e6));
  Hdf5File file = Hdf5File::create(path);
  file.write("/pressure", message.arrays[0]);
  file.close();

  const std::string sound = sample::content(path);
  int detected = 0, silently_wrong = 0;
  for (std::size_t position = 0; position < sound.size(); position += 7) {
    std::string damaged = sound;
    damaged[position] = static_cast<char>(damaged[position] ^ (1 << (position % 8)));
    std::ofstream(path, std::ios::binary) << damaged;
    try {
      if (Hdf5File::open(path).read("/pressure").bytes != message.arrays[0].bytes) ++silently_wrong;
    } catch (const StorageError&) {
      ++detected;
    }
  }
  CHECK(silently_wrong == 0);
  // Every flip within the values themselves is seen.
  CHECK(detected >= 64 * 8 / 7);
}

TEST_CASE("a dataset that is missing or comes twice is named in the error", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const Message message = arrays_of_every_kind();
  Hdf5File file = Hdf5File::create(folder.path() / "file.h5");
  file.write("/pressure", message.arrays[0]);
  CHECK_THROWS_WITH(file.write("/pressure", message.arrays[0]), Catch::Contains("create /pressure in"));
  CHECK_THROWS_WITH(file.read("/aperture"), Catch::Contains("open /aperture in"));
  CHECK_THROWS_AS(Hdf5File::open(folder.path() / "none.h5"), StorageError);
}
