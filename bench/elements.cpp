// SPDX-License-Identifier: Apache-2.0
// Elements of a sheet in folds: how long its tree takes to be made and fitted, and to find candidates.
//
// usage: abut_bench_elements [FOLDER]
//
// Without a folder the sheet is made up. FOLDER holds cloth_ball92.ply and cloth_ball93.ply of the repository
// Continuous-Collision-Detection/Sample-Scalable-CCD-Data, in binary PLY. Then the program
// fails unless its counts of candidates are the published ones.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cloth_file.hpp"

import abut.core;
import abut.math;
import abut.triangles.elements;
import abut.trees.elements.element_pairs;
import abut.trees.elements.element_tree;

namespace {

struct Cloth {
  std::vector<abut::Vec3> vertices;
  std::vector<std::uint32_t> triangles;
};

Cloth read_cloth(const std::string& path) {
  const abut_bench::ClothFrame frame = abut_bench::read_cloth_frame(path);
  Cloth cloth{{}, frame.triangles};
  for (std::size_t i = 0; i < frame.xyz.size(); i += 3) {
    cloth.vertices.push_back({frame.xyz[i], frame.xyz[i + 1], frame.xyz[i + 2]});
  }
  return cloth;
}

// The time is that of this process, so that other programs do not count.
double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall_milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The least time of several runs, by a clock in milliseconds.
template <class Work>
double milliseconds(int runs, const Work& work, double (*clock)() = processor_milliseconds) {
  double least = abut::infinity;
  for (int run = 0; run < runs; ++run) {
    const double start = clock();
    work();
    least = std::min(least, clock() - start);
  }
  return least;
}

struct Counts {
  std::size_t vertices_and_faces = 0, edges = 0;
};

// Each task fills the memory of its own again and again.
class Finder {
 public:
  Counts count(const abut::ElementTree& tree, const abut::Workers& workers) {
    pairs_.cut(tree, tree, 64);
    const std::span<const abut::NodePair> pairs = pairs_.list();
    found_.resize(pairs.size());
    workers.for_each(pairs.size(), [&](std::size_t i) {
      found_[i].clear();
      abut::append_candidates(tree, tree, pairs[i], found_[i]);
    });
    Counts counts;
    for (const abut::Candidates& found : found_) {
      counts.vertices_and_faces += found.vertices_and_faces.list().size();
      counts.edges += found.edges.list().size();
    }
    return counts;
  }

 private:
  abut::NodePairs pairs_;
  std::vector<abut::Candidates> found_;
};

bool report_counts(const char* what, std::size_t got, std::size_t published) {
  std::printf("%-28s %9zu, published %9zu%s\n", what, got, published, got == published ? "" : "  DIFFERENT");
  return got == published;
}

// An accordion of ten folds, and the same after a small move.
Cloth folded_cloth() {
  constexpr std::uint32_t side = 216;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.0005, 0.0005);
  Cloth cloth;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const double along = 10.0 * i / (side - 1), fold = std::floor(along), rest = along - fold;
      cloth.vertices.push_back({0.01 * along + noise(random), static_cast<double>(j) / (side - 1) + noise(random),
                                (std::fmod(fold, 2) < 1 ? rest : 1 - rest) + noise(random)});
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t a = i * side + j, b = a + side;
        cloth.triangles.insert(cloth.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
    }
  }
  return cloth;
}
Cloth moved(Cloth cloth) {
  for (std::size_t i = 0; i < cloth.vertices.size(); ++i) {
    cloth.vertices[i] += std::sin(0.1 * static_cast<double>(i)) * abut::Vec3{0.002, 0.001, 0.001};
  }
  return cloth;
}

Counts measure(const Cloth& cloth, const Cloth& next) {
  const abut::Workers one(1), two(2);
  abut::ElementTable table;
  std::printf("table                        %7.2f ms\n",
              milliseconds(3, [&] { table = abut::ElementTable(cloth.vertices.size(), cloth.triangles); }));
  abut::ElementTree tree;
  std::printf("tree                         %7.2f ms\n",
              milliseconds(3, [&] { tree = abut::ElementTree(table, cloth.triangles, cloth.vertices, one); }));
  std::printf("bytes of a triangle          %7.1f\n",
              static_cast<double>(tree.bytes()) / static_cast<double>(table.triangle_count()));
  std::printf("fit to two times             %7.2f ms\n",
              milliseconds(9, [&] { tree.fit(cloth.vertices, next.vertices, 0, one); }));
  Finder swept;
  Counts counts;
  const double on_one = milliseconds(9, [&] { counts = swept.count(tree, one); });
  const double on_two = milliseconds(9, [&] { counts = swept.count(tree, two); }, wall_milliseconds);
  const double all = static_cast<double>(counts.vertices_and_faces + counts.edges);
  std::printf("candidates of the step       %7.2f ms, %.1f million/s; %.2f ms by the clock on two threads\n", on_one,
              1e-3 * all / on_one, on_two);
  const Counts of_step = counts;
  abut::Aabb around = abut::Aabb::empty();
  for (const abut::Vec3& vertex : cloth.vertices) {
    around.include(vertex);
  }
  tree.fit(cloth.vertices, cloth.vertices, 0.5e-3 * abut::norm(around.high - around.low), one);
  Finder near;
  const double at_rest = milliseconds(9, [&] { counts = near.count(tree, one); });
  std::printf("candidates of 1e-3 of size   %7.2f ms, %zu and %zu\n", at_rest, counts.vertices_and_faces, counts.edges);
  return of_step;
}

bool run(const std::string& folder) {
  const Cloth cloth = read_cloth(folder + "/cloth_ball92.ply"), next = read_cloth(folder + "/cloth_ball93.ply");
  const Counts counts = measure(cloth, next);
  const bool is_right = report_counts("vertices and faces", counts.vertices_and_faces, 1655541);
  return report_counts("pairs of edges", counts.edges, 5197332) && is_right;
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  try {
    if (arguments.size() < 2 || std::string_view(arguments[1]).starts_with("--")) {
      const Cloth cloth = folded_cloth();
      const Counts counts = measure(cloth, moved(cloth));
      std::printf("%zu vertices and faces, %zu pairs of edges\n", counts.vertices_and_faces, counts.edges);
      return 0;
    }
    return run(arguments[1]) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
