// SPDX-License-Identifier: Apache-2.0
// Files that a program without a fuzzing engine plays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace fuzz_files {

// By name; none where there is no such folder.
inline std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

// All files to play for a pair of kinds: those for every pair, those for a pair with a mesh, and its own regressions.
inline std::vector<std::filesystem::path> files_of_pair(const std::filesystem::path& root, const std::string& a,
                                                        const std::string& b) {
  std::vector<std::filesystem::path> files = files_in(root / "corpus" / "pairs");
  if (a == "mesh" || b == "mesh") {
    std::ranges::copy(files_in(root / "corpus" / "meshes"), std::back_inserter(files));
  }
  std::ranges::copy(files_in(root / "regress" / (a + "_" + b)), std::back_inserter(files));
  return files;
}

inline std::vector<std::uint8_t> bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::uint8_t> bytes;
  std::ranges::transform(text, std::back_inserter(bytes),
                         [](char c) { return static_cast<std::uint8_t>(static_cast<unsigned char>(c)); });
  return bytes;
}

// Prints what is wrong with an input, if anything is. Whether it is.
inline bool report(const std::string& name, const std::string& finding) {
  if (!finding.empty()) {
    std::printf("finding: %s: %s\n", name.c_str(), finding.c_str());
  }
  return !finding.empty();
}

}  // namespace fuzz_files
