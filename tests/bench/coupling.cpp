// SPDX-License-Identifier: GPL-3.0-or-later

/// Microseconds of one coupling step of the trio without the work of its solvers, next to bare ZeroMQ and to
/// shared memory.
///
/// Run it on a machine with nothing else to do:
///   cmake --build build/release --target coupling
///   build/release/tests/coupling
///
/// All three relays are coupler -> network -> coupler -> structure -> coupler between three processes and
/// carry the arrays of ADVANCE, PRESSURE, ADVANCE and RESPONSE, each of N values:
///   trio           what `coupler run` does in an interval: coupling laws, messages with checksum, range
///   checks, supervision; no record ZeroMQ         frames without anything around them, copied in, read
///   where they arrive shared memory  copied in, read in place, woken by a futex
/// They are measured in turns; a number is the median of the repetitions.

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "common/errors.hpp"
#include "tests/bench/shared_memory_relay.hpp"
#include "tests/bench/trio_relay.hpp"
#include "tests/bench/zeromq_relay.hpp"

namespace {

using namespace fissura;
using namespace fissura::bench;

constexpr std::array<std::size_t, 5> sizes{100, 1'000, 10'000, 100'000, 1'000'000};
constexpr int repetitions = 9;

/// A directory for the sockets, gone with it.
class SocketDirectory {
 public:
  SocketDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fissura-coupling-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw Error(ExitCode::precondition, "no directory for the sockets");
    path_ = pattern;
  }
  ~SocketDirectory() { std::filesystem::remove_all(path_); }
  SocketDirectory(const SocketDirectory&) = delete;
  SocketDirectory& operator=(const SocketDirectory&) = delete;
  [[nodiscard]] std::string endpoint(const char* name) const { return "ipc://" + (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

int steps_per_repetition(std::size_t values) {
  return static_cast<int>(std::clamp<std::size_t>(1'000'000 / values, 4, 500));
}

double microseconds_per_step(Relay& relay, int steps) {
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < steps; ++step) relay.step();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() / steps;
}

double median(std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}

void measure(const std::array<Relay*, 3>& relays, std::size_t values) {
  const int steps = steps_per_repetition(values);
  std::array<std::vector<double>, 3> samples;
  for (Relay* relay : relays) {
    relay->set_values(values);
    (void)microseconds_per_step(*relay, std::max(2, steps / 10));
  }
  for (int repetition = 0; repetition < repetitions; ++repetition)
    for (std::size_t k = 0; k < relays.size(); ++k)
      samples[k].push_back(microseconds_per_step(*relays[k], steps));
  const double trio = median(samples[0]), zeromq = median(samples[1]), memory = median(samples[2]);
  const double exchanged = static_cast<double>(arrays_per_step * values);
  fmt::print("{:>8} {:>12.1f} {:>12.1f} {:>12.1f} {:>10.2f} {:>10.2f} {:>10.2f} {:>10.2f} {:>10.2f}\n",
             values, trio, zeromq, memory, trio / zeromq, trio / memory, 1e3 * trio / exchanged,
             1e3 * zeromq / exchanged, 1e3 * memory / exchanged);
}

void compare(const std::string& program) {
  const SocketDirectory sockets;
  SharedMemoryRelay memory(sizes.back());
  ZeromqRelay zeromq(sockets.endpoint("zeromq"));
  TrioRelay trio(sockets.endpoint("trio"), program);
  fmt::print(
      "{} repetitions in turns, medians; {} arrays of N values per step. Both cores are shared by three "
      "processes,\n"
      "the I/O threads of ZeroMQ and whatever else runs here: compare within a line, not between runs.\n\n",
      repetitions, arrays_per_step);
  fmt::print("{:>8} {:>38} {:>21} {:>32}\n", "", "microseconds per step", "trio over",
             "nanoseconds per value");
  fmt::print("{:>8} {:>12} {:>12} {:>12} {:>10} {:>10} {:>10} {:>10} {:>10}\n", "N", "trio", "ZeroMQ",
             "memory", "ZeroMQ", "memory", "trio", "ZeroMQ", "memory");
  for (const std::size_t values : sizes) measure({&trio, &zeromq, &memory}, values);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view role = argc > 1 ? argv[1] : "";
  if (role == name(Role::network)) return play(Role::network, argc - 1, argv + 1);
  if (role == name(Role::structure)) return play(Role::structure, argc - 1, argv + 1);
  try {
    compare(std::filesystem::read_symlink("/proc/self/exe").string());
    return 0;
  } catch (const Error& failure) {
    fmt::print(stderr, "{}\n", failure.what());
    return static_cast<int>(failure.code());
  }
}
