// SPDX-License-Identifier: Apache-2.0
module abut.triangles.report;
import abut.capability;
import abut.core.joined_sets;
import abut.core.standard;
import abut.math;
import abut.triangles.buffers;
import abut.triangles.edges;
import abut.triangles.volume;

namespace abut {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// How many elements of a sorted list equal the one before.
template <class T>
std::uint64_t repeated(const std::vector<T>& sorted) {
  std::uint64_t count = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    count += sorted[i] == sorted[i - 1] ? 1 : 0;
  }
  return count;
}

std::vector<std::uint32_t> present_triangles(std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> out;
  out.reserve(triangles.size());
  for (std::uint32_t triangle = 0; triangle < triangles.size() / 3; ++triangle) {
    if (!is_removed(triangles, triangle)) {
      const auto its = triangles.subspan(3 * std::size_t{triangle}, 3);
      out.insert(out.end(), its.begin(), its.end());
    }
  }
  return out;
}

void count_vertices(std::span<const Vec3> places, std::span<const std::uint32_t> triangles, TriangleReport& out) {
  std::vector<bool> is_used(places.size());
  JoinedSets components(places.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    is_used[triangles[i]] = true;
    components.join(triangles[i], triangles[i - i % 3]);
  }
  std::vector<std::tuple<Real, Real, Real>> used;
  for (std::uint32_t vertex = 0; vertex < places.size(); ++vertex) {
    if (is_used[vertex]) {
      used.emplace_back(places[vertex].x, places[vertex].y, places[vertex].z);
      out.components += components.of(vertex) == vertex ? 1 : 0;
    }
  }
  std::ranges::sort(used);
  out.vertices = used.size();
  out.duplicate_vertices = repeated(used);
}

void count_triangles(std::span<const Vec3> places, std::span<const std::uint32_t> triangles, TriangleReport& out) {
  constexpr Real thin = 1e-3;
  std::vector<Corners> all;
  all.reserve(triangles.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    Corners& its = all.emplace_back(Corners{triangles[i], triangles[i + 1], triangles[i + 2]});
    const Vec3 a = places[its[0]], b = places[its[1]], c = places[its[2]];
    const Real longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
    out.slivers += norm(cross(b - a, c - a)) > thin * longest * longest ? 0 : 1;
    std::ranges::sort(its);
  }
  std::ranges::sort(all);
  out.triangles = all.size();
  out.duplicate_triangles = repeated(all);
}

// Each triangle stands in two sets, as it is and turned. Neighbours that agree are joined as they are, and turned.
void count_edges(std::span<const std::uint32_t> triangles, TriangleReport& out) {
  const auto count = static_cast<std::uint32_t>(triangles.size() / 3);
  JoinedSets sets(2 * std::size_t{count});
  visit_edges(triangles, [&](std::span<const EdgeOfTriangle> sharing) {
    if (sharing[0].low == sharing[0].high) {
      return;
    }
    out.open_edges += sharing.size() == 1 ? 1 : 0;
    out.non_manifold_edges += sharing.size() > 2 ? 1 : 0;
    if (sharing.size() == 2) {
      const std::uint32_t a = sharing[0].triangle, b = sharing[1].triangle;
      const bool agree = sharing[0].is_forward != sharing[1].is_forward;
      sets.join(a, agree ? b : b + count);
      sets.join(a + count, agree ? b + count : b);
    }
  });
  // Of the two sets of a patch, the one with fewer triangles as they are holds those to be turned.
  std::vector<std::uint32_t> as_they_are(2 * std::size_t{count});
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    ++as_they_are[sets.of(triangle)];
  }
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    // The first triangle of a patch stands for its set.
    const std::uint32_t turned = sets.of(triangle + count);
    if (sets.of(triangle) == triangle && turned >= triangle) {
      out.twisted_patches += turned == triangle ? 1 : 0;
      out.reversed_triangles += turned == triangle ? 0 : std::min(as_they_are[triangle], as_they_are[turned]);
    }
  }
}

}  // namespace

TriangleReport report_triangles(std::span<const Real> xyz, std::span<const std::uint32_t> triangles) {
  TriangleReport out;
  std::vector<Vec3> places(xyz.size() / 3);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
  }
  const std::vector<std::uint32_t> present = present_triangles(triangles);
  count_vertices(places, present, out);
  count_triangles(places, present, out);
  count_edges(present, out);
  out.volume = enclosed_volume({std::move(places), present}).volume;
  return out;
}

}  // namespace abut
