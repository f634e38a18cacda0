// SPDX-License-Identifier: Apache-2.0
module abut.narrow.two_surfaces.placed_triangles;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.surface.triangle_source;

namespace abut {
namespace {

FourBoxes boxes_of(const FourTriangles& t) {
  const auto low = [](Lanes a, Lanes b, Lanes c) { return minimum(minimum(a, b), c); };
  const auto high = [](Lanes a, Lanes b, Lanes c) { return maximum(maximum(a, b), c); };
  return {{low(t.a.x, t.b.x, t.c.x), low(t.a.y, t.b.y, t.c.y), low(t.a.z, t.b.z, t.c.z)},
          {high(t.a.x, t.b.x, t.c.x), high(t.a.y, t.b.y, t.c.y), high(t.a.z, t.b.z, t.c.z)}};
}
void leave_out(FourBoxes& boxes, std::size_t from) {
  for (std::size_t lane = from; lane < 4; ++lane) {
    boxes.low.put(lane, {infinity, infinity, infinity});
    boxes.high.put(lane, {-infinity, -infinity, -infinity});
  }
}
Aabb box_around(const FourBoxes& boxes) {
  return {minimum(minimum(boxes.low[0], boxes.low[1]), minimum(boxes.low[2], boxes.low[3])),
          maximum(maximum(boxes.high[0], boxes.high[1]), maximum(boxes.high[2], boxes.high[3]))};
}

}  // namespace

void PlacedTriangles::gather(const TriangleSource& surface, const Pose& pose, const Aabb& box) {
  fours_.clear();
  nodes_.clear();
  levels_.clear();
  box_ = Aabb::empty();
  [[clang::uninitialized]] PlacedFour four;
  std::size_t count = 0;
  const auto add = [&] {
    FourTriangles& t = four.triangles;
    for (std::size_t lane = count; lane < 4; ++lane) {
      t.put(lane, FourTriangles::all(t[0]));
      std::span(t.numbers)[lane] = t.numbers[0];
    }
    four.present = (std::uint64_t{1} << count) - 1;
    four.one_sided = surface.one_sided(t) & four.present;
    four.set_planes(four.present);
    fours_.push_back(four);
    FourBoxes boxes = boxes_of(t);
    leave_out(boxes, count);
    nodes_.push_back(boxes);
    box_.include(box_around(boxes));
    count = 0;
  };
  const auto take = [&](const FourTriangles& local, std::uint64_t present) {
    const FourTriangles in_frame = placed(local, pose);
    for (std::uint64_t left = present & in_frame.overlapping(box); left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      four.triangles.put(count, FourTriangles::all(in_frame[lane]));
      std::span(four.triangles.numbers)[count] = std::span(in_frame.numbers)[lane];
      if (++count == 4) {
        add();
      }
    }
  };
  // What holds one reference is passed on without memory of its own.
  surface.visit(transformed(box, pose.inverse()), [&take](const FourTriangles& local, std::uint64_t present) {
    take(local, present);
    return true;
  });
  if (count > 0) {
    add();
  }
  levels_.push_back(0);
  for (std::size_t first = 0, size = nodes_.size(); size > 1; size = nodes_.size() - first) {
    const std::size_t next = nodes_.size();
    for (std::size_t at = 0; at < size; at += 4) {
      FourBoxes boxes{};
      const std::size_t children = std::min<std::size_t>(4, size - at);
      for (std::size_t lane = 0; lane < children; ++lane) {
        const Aabb around = box_around(nodes_[first + at + lane]);
        boxes.low.put(lane, around.low);
        boxes.high.put(lane, around.high);
      }
      leave_out(boxes, children);
      nodes_.push_back(boxes);
    }
    levels_.push_back(next);
    first = next;
  }
}

void PlacedTriangles::set_reaches(const Vec3& direction) {
  const Columns along = Columns::all(direction);
  reaches_.clear();
  for (const PlacedFour& four : fours_.span()) {
    const FourTriangles& t = four.triangles;
    reaches_.push_back(maximum(maximum(dot(along, t.a), dot(along, t.b)), dot(along, t.c)));
  }
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    const std::size_t first = levels_[level - 1], size = levels_[level] - first;
    for (std::size_t at = 0; at < size; at += 4) {
      // The last one stands in for those that lack.
      const auto reach = [&](std::size_t child) { return largest(reaches_[first + std::min(at + child, size - 1)]); };
      reaches_.push_back({reach(0), reach(1), reach(2), reach(3)});
    }
  }
}

}  // namespace abut
