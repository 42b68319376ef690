// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/secure_endpoint.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

constexpr rlim_t open_files_wished = 1024;

}  // namespace

bool is_local(const std::string& endpoint) {
  return !endpoint.starts_with("tcp://") || endpoint.starts_with("tcp://127.") ||
         endpoint.starts_with("tcp://[::1]:");
}

void require_keys(const std::string& endpoint, Keys keys) {
  if (keys == Keys::present || is_local(endpoint)) return;
  throw Error(
      ExitCode::security,
      fmt::format(
          "exchange.endpoint {} can be reached from other machines, so participants must prove who they are: "
          "make keys with `coupler keys new DIR` and give --keys DIR, or use \"ipc\" or tcp://127.0.0.1:*",
          endpoint));
}

void raise_limit_of_open_files() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= open_files_wished) return;
  limit.rlim_cur = std::min(limit.rlim_max, open_files_wished);
  (void)::setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace fissura::coupler
