// SPDX-License-Identifier: Apache-2.0
// From points to hull vertices and faces: Qhull, behind a clean-up that hands it only clouds that
// extend in all three directions, scaled so that they extend alike.
//
// The scaling is an affine map, which keeps the set of extreme points. So needles and plates lose no digits. Clouds
// without extent in a direction, measured along their principal axes, become polygons, segments or points instead.
module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <libqhull_r/qhull_ra.h>
#pragma clang diagnostic pop
#include "../../core/check.hpp"
module abut.shapes.hull.data;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;

namespace abut {
namespace {

// Coordinates of a point along the principal axes of the cloud, with the extents of the cloud.
struct Frame {
  PrincipalAxes axes;
  Vec3 low, high;

  [[nodiscard]] Vec3 coordinates(const Vec3& p) const {
    const Vec3 d = p - axes.mean;
    return {dot(d, axes.first), dot(d, axes.second), dot(d, axes.third)};
  }
};

Frame frame_of(std::span<const Vec3> points) {
  Frame frame{principal_axes(points), {}, {}};
  Aabb box = Aabb::empty();
  for (const Vec3& p : points) {
    box.include(frame.coordinates(p));
  }
  frame.low = box.low;
  frame.high = box.high;
  return frame;
}

// Hull of points in a plane by Andrew's monotone chain (1979), as a polygon with two sides.
HullData flat_hull(std::span<const Vec3> points, const Frame& frame) {
  struct Flat {
    Real u, v;
    std::size_t index;
  };
  std::vector<Flat> sorted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 c = frame.coordinates(points[i]);
    sorted[i] = {c.x, c.y, i};
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const Flat& a, const Flat& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
  const Real smallest_area = rounding_of((frame.high.x - frame.low.x) * (frame.high.y - frame.low.y));
  const auto turns_left = [&](const Flat& a, const Flat& b, const Flat& c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u) > smallest_area;
  };
  std::vector<Flat> loop;
  const auto chain = [&](auto begin, auto end) {
    const std::size_t base = loop.size();
    for (auto it = begin; it != end; ++it) {
      while (loop.size() >= base + 2 && !turns_left(loop[loop.size() - 2], loop.back(), *it)) {
        loop.pop_back();
      }
      loop.push_back(*it);
    }
    loop.pop_back();  // the end is the start of the other chain
  };
  chain(sorted.begin(), sorted.end());
  chain(sorted.rbegin(), sorted.rend());

  HullData hull;
  std::vector<std::uint32_t> front;
  for (const Flat& corner : loop) {
    front.push_back(static_cast<std::uint32_t>(hull.vertices.size()));
    hull.vertices.push_back(points[corner.index]);
  }
  if (front.size() >= 3) {
    const std::vector<std::uint32_t> back(front.rbegin(), front.rend());
    add_face(hull, front);
    add_face(hull, back);
  }
  return hull;
}

HullData segment_hull(std::span<const Vec3> points, const Vec3& direction) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return dot(a, direction) < dot(b, direction);
  });
  HullData hull;
  hull.vertices.push_back(*low);
  if (*high != *low) {
    hull.vertices.push_back(*high);
  }
  return hull;
}

struct QhullDeleter {
  void operator()(qhT* qh) const {
    qh_freeqhull(qh, !qh_ALL);
    int long_count = 0, long_bytes = 0;
    qh_memfreeshort(qh, &long_count, &long_bytes);
    std::default_delete<qhT>()(qh);
  }
};

// Nothing when Qhull gives up.
HullData solid_hull(std::span<const Vec3> points, const Frame& frame) {
  const Vec3 size = frame.high - frame.low;
  std::vector<coordT> scaled;
  scaled.reserve(3 * points.size());
  for (const Vec3& p : points) {
    // An affine map keeps which points are extreme; equal extents keep needles and plates whole.
    const Vec3 c = frame.coordinates(p) - frame.low;
    scaled.insert(scaled.end(), {c.x / size.x, c.y / size.y, c.z / size.z});
  }
  const std::unique_ptr<qhT, QhullDeleter> qh(std::make_unique<qhT>().release());
  qh_zero(qh.get(), nullptr);
  std::array<char, 16> command{"qhull Pp"};
  HullData hull;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> sink(std::fopen("/dev/null", "w"),
                                                             [](std::FILE* f) { return f ? std::fclose(f) : 0; });
  if (qh_new_qhull(qh.get(), 3, static_cast<int>(points.size()), scaled.data(), False, command.data(), sink.get(),
                   sink.get()) != 0) {
    return hull;
  }
  std::vector<std::uint32_t> numbers(points.size(), no_index);
  const auto number_of = [&](vertexT* vertex) {
    const auto point = static_cast<std::size_t>(qh_pointid(qh.get(), vertex->point));
    if (numbers[point] == no_index) {
      numbers[point] = static_cast<std::uint32_t>(hull.vertices.size());
      hull.vertices.push_back(points[point]);
    }
    return numbers[point];
  };
  std::vector<std::uint32_t> loop;
  // SAFETY: Qhull's lists end at a sentinel (facets) and at a null pointer (sets of vertices).
  ABUT_UNSAFE_BEGIN
  for (facetT* facet = qh->facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
    setT* vertices = qh_facet3vertex(qh.get(), facet);
    loop.clear();
    for (setelemT* element = &vertices->e[0]; element->p != nullptr; ++element) {
      loop.push_back(number_of(static_cast<vertexT*>(element->p)));
    }
    qh_settempfree(qh.get(), &vertices);
    std::reverse(loop.begin(), loop.end());  // Qhull's order is clockwise from outside (qh_ORIENTclock)
    add_face(hull, loop);
  }
  ABUT_UNSAFE_END
  return hull;
}

}  // namespace

HullData build_hull(std::span<const Vec3> points) {
  const Frame frame = frame_of(points);
  const Vec3 size = frame.high - frame.low;
  Real magnitude = 0;
  for (const Vec3& p : points) {
    magnitude = std::max(magnitude, largest_magnitude(p));
  }
  // Extents below this are rounding of the given coordinates.
  const Real noise = rounding_of(magnitude);
  HullData hull;
  if (size.x <= noise) {
    hull.vertices.push_back(points[0]);
  } else if (size.y <= noise) {
    hull = segment_hull(points, frame.axes.first);
  } else if (size.z > noise) {
    hull = solid_hull(points, frame);
  }
  if (hull.vertices.empty()) {
    hull = flat_hull(points, frame);
  }
  finish_hull(hull);
  hull.report = report_on(hull, points, noise);
  return hull;
}

}  // namespace abut
