// SPDX-License-Identifier: Apache-2.0
// Runs one universe for a long time in which the same load comes back again and
// again, and watches its memory.
// usage: abut_soak [steps, default 100000, at least 4000]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <unistd.h>

#include "universes.hpp"

namespace {

using namespace universe_calls;

void expect_ok(abut_status status) {
  require(status == ABUT_OK, std::string(abut_status_name(status)) + ": " + abut_last_error_message());
}

// Of this process, in bytes; 0 where the system does not tell.
std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  return file >> pages >> pages ? pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

class Soak {
 public:
  Soak() {
    expect_ok(abut_universe_create(nullptr, &universe_));
    for (abut_part_id& part : parts_) {
      expect_ok(abut_part_create(universe_, nullptr, &part));
    }
    restart();
  }
  ~Soak() { abut_universe_destroy(universe_); }
  Soak(const Soak&) = delete;
  Soak& operator=(const Soak&) = delete;

  // Empties the pool, so that the same numbers give the same load once more.
  void restart() {
    random_ = Random(7);
    for (abut_geometry_id& geometry : geometries_) {
      if (geometry.slot != 0) {
        expect_ok(abut_geometry_destroy(universe_, geometry));
        geometry = {};
      }
    }
  }

  // Some of the pool are parked or come back, some are destroyed or created,
  // and eight parts move.
  void step() {
    for (int i = 0; i < 24; ++i) {
      abut_geometry_id& geometry = geometries_.at(random_.below(pool));
      const auto parking = static_cast<abut_parking>(random_.below(3));
      if (geometry.slot != 0) {
        expect_ok(abut_geometry_park(universe_, geometry, parking));
        ++parked_;
      }
      const std::size_t place = random_.below(pool);
      abut_geometry_id& other = geometries_.at(place);
      if (other.slot != 0 && random_.below(4) == 0) {
        expect_ok(abut_geometry_destroy(universe_, other));
        other = {};
        ++created_;
      } else if (other.slot == 0) {
        expect_ok(
            abut_geometry_create(universe_, parts_.at(place), shapes().at(random_.below(27)).shape, nullptr, &other));
        ++created_;
      }
    }
    for (int i = 0; i < 8; ++i) {
      const auto coordinate = [&] { return static_cast<double>(random_.below(24)); };
      const abut_pose pose{{coordinate(), coordinate(), coordinate()}, {1, 0, 0, 0}};
      expect_ok(abut_part_set_pose(universe_, parts_.at(random_.below(pool)), &pose));
    }
    expect_ok(abut_universe_step(universe_, 0.01));
  }

  abut_step_stats stats() const { return found_in(universe_).stats; }
  std::size_t parked() const { return parked_; }
  std::size_t created() const { return created_; }

 private:
  static constexpr std::size_t pool = 256;
  abut_universe* universe_ = nullptr;
  std::array<abut_part_id, pool> parts_{};
  std::array<abut_geometry_id, pool> geometries_{};
  Random random_{7};
  std::size_t parked_ = 0, created_ = 0;
};

int soak(std::size_t steps) {
  Soak soak;
  // Lists have grown to what the load needs after one round; another one for
  // what is found only then.
  constexpr std::size_t round = 1000;
  require(steps >= 4 * round, "expected at least 4000 steps: fewer are over before memory can be compared");
  const std::size_t warm = std::max(2 * round, steps / 10 / round * round);
  std::size_t warm_bytes = 0, warm_resident = 0, last_bytes = 0, last_resident = 0;
  std::printf("%10s %12s %18s %10s %14s %14s\n", "steps", "park calls", "created/destroyed", "contacts", "bytes",
              "resident KiB");
  for (std::size_t done = 0; done < steps;) {
    soak.restart();
    for (std::size_t i = 0; i < round && done < steps; ++i, ++done) {
      soak.step();
    }
    if (done % warm != 0 && done < steps) {
      continue;
    }
    const abut_step_stats stats = soak.stats();
    last_bytes = static_cast<std::size_t>(stats.bytes);
    last_resident = resident_bytes();
    if (done == warm) {
      warm_bytes = last_bytes;
      warm_resident = last_resident;
    }
    std::printf("%10zu %12zu %18zu %10llu %14zu %14zu\n", done, soak.parked(), soak.created(),
                static_cast<unsigned long long>(stats.contacts), last_bytes, last_resident / 1024);
  }
  // Pages come and go with the allocator; memory that is lost for good grows
  // with the steps.
  constexpr std::size_t slack = std::size_t{1} << 20;
  const bool is_constant = last_bytes <= warm_bytes && last_resident <= warm_resident + slack;
  std::printf("%s\n", is_constant ? "memory is constant" : "memory grows");
  return is_constant ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** values) {
  std::vector<std::string> arguments;
  std::copy_n(values, count, std::back_inserter(arguments));
  try {
    return soak(arguments.size() > 1 ? std::stoul(arguments[1]) : 100000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "abut_soak: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
