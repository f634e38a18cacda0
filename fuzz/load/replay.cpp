// SPDX-License-Identifier: Apache-2.0
// Loads the committed universes and variations of them, without a fuzzing engine.
// usage: abut_fuzz_load <folder of fuzz> [variations of each] [seed]
//        abut_fuzz_load --write <folder>   writes the universes to begin with
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string_view>

#include "../files.hpp"
#include "load.hpp"

namespace {

using namespace load_fuzzing;
using Bytes = std::vector<std::uint8_t>;

int write(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Seed& seed : seeds()) {
    std::ofstream file(folder / seed.name, std::ios::binary);
    for (const std::uint8_t byte : seed.body) {
      file.put(static_cast<char>(byte));
    }
  }
  return 0;
}

// Some bytes are other ones; one in ten is cut off.
Bytes varied(Bytes bytes, std::mt19937& random) {
  constexpr std::array<std::uint8_t, 6> usual{0, 1, 0x7f, 0x80, 0xf0, 0xff};
  for (std::size_t left = 1 + random() % 3; left > 0 && !bytes.empty(); --left) {
    const bool is_usual = random() % 2 == 0;
    bytes[random() % bytes.size()] = is_usual ? usual.at(random() % usual.size()) : static_cast<std::uint8_t>(random());
  }
  if (random() % 10 == 0 && !bytes.empty()) {
    bytes.resize(random() % bytes.size());
  }
  return bytes;
}

bool has_finding(const Bytes& bytes, const std::string& name) { return fuzz_files::report(name, finding_of(bytes)); }

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments;
  std::copy_n(argv, argc, std::back_inserter(arguments));
  arguments.erase(arguments.begin());
  if (arguments.size() == 2 && arguments[0] == "--write") {
    return write(arguments[1]);
  }
  if (arguments.empty()) {
    std::puts("usage: abut_fuzz_load <folder of fuzz> [variations of each] [seed], or --write <folder>");
    return 2;
  }
  const std::size_t variations = arguments.size() > 1 ? std::stoul(arguments[1]) : 0;
  std::mt19937 random(static_cast<std::mt19937::result_type>(arguments.size() > 2 ? std::stoul(arguments[2]) : 1));
  std::size_t universes = 0, loaded = 0, findings = 0;
  for (const char* folder : {"corpus/load", "regress/load"}) {
    for (const std::filesystem::path& path : fuzz_files::files_in(std::filesystem::path(arguments[0]) / folder)) {
      const Bytes bytes = fuzz_files::bytes_of(path);
      ++universes;
      findings += has_finding(bytes, path.filename().string()) ? 1 : 0;
      if (std::string_view(folder) == "corpus/load" && !is_loaded(bytes)) {
        std::printf("finding: %s is no universe\n", path.filename().c_str());
        ++findings;
      }
      for (std::size_t i = 0; i < variations; ++i) {
        const Bytes other = varied(bytes, random);
        loaded += is_loaded(other) ? 1 : 0;
        findings += has_finding(other, path.filename().string() + ", variation " + std::to_string(i)) ? 1 : 0;
      }
    }
  }
  std::printf("%zu universes, %zu variations of each, %zu of all loaded, %zu findings\n", universes, variations, loaded,
              findings);
  return universes == 0 || findings > 0 ? 1 : 0;
}
