// Writes the committed corpus: six records for each pair of kinds.
// usage: abut_fuzz_seeds <folder>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>
#include "core/check.hpp"
import abut.any_shape;
import abut.fuzz;

namespace {

using namespace abut::fuzz;

Record ordinary() {
  Record record;
  record.a = {1, 0.75, 0.5, 0.25, 1.5, -0.5, 2, 3};
  record.b = {0.5, 1.25, 0.75, -0.5, 1, 2.5, -1, 0.125};
  record.rotation = {0.9, 0.3, 0.1, 0.3};
  record.position = {0.3, -0.2, 0.4};
  return record;
}

struct Seed {
  std::string name;
  Record record;
};

std::vector<Seed> seeds_of(std::size_t a, std::size_t b) {
  Record apart = ordinary();
  apart.position = {2.5, -3, 4};
  apart.extra = {0.125, 0};
  Record touching = apart;
  snap_to_touching(a, b, touching);
  Record deep = ordinary();
  deep.position = {0.1, -0.05, 0.2};
  Record coincident = ordinary();
  coincident.flags = parallel;
  coincident.b = coincident.a;
  coincident.position = {};
  Record in_parallel = ordinary();
  in_parallel.flags = parallel | lattice;
  in_parallel.position = {0, 0, 1};
  Record degenerate = ordinary();
  degenerate.flags = flat_a | doubled_a | flat_b | doubled_b;
  degenerate.a[2] = degenerate.b[2] = 0;
  degenerate.position = {0.5, 0.25, 0.0625};
  return {{"apart", apart}, {"coincident", coincident}, {"deep", deep}, {"degenerate", degenerate}, {"parallel", in_parallel}, {"touching", touching}};
}

void write(const std::filesystem::path& path, const Record& record) {
  std::ofstream file(path, std::ios::binary);
  for (const auto byte : bytes_of(record)) {
    file.put(static_cast<char>(byte));
  }
}

}  // namespace

int main(int count, char** values) {
  // SAFETY: the C runtime hands over `count` strings.
  ABUT_UNSAFE_BEGIN
  const std::vector<std::string> arguments(values, values + count);
  ABUT_UNSAFE_END
  if (arguments.size() != 2) {
    return 2;
  }
  for (std::size_t a = 0; a < abut::shape_kind_count; ++a) {
    for (std::size_t b = 0; b < abut::shape_kind_count; ++b) {
      if (abut::kind_name(a) > abut::kind_name(b) || !abut::is_supported(a, b)) {
        continue;
      }
      const auto folder = std::filesystem::path(arguments[1]) / (std::string(abut::kind_name(a)) + "_" + std::string(abut::kind_name(b)));
      std::filesystem::create_directories(folder);
      for (const Seed& seed : seeds_of(a, b)) {
        write(folder / seed.name, seed.record);
      }
    }
  }
  return 0;
}
