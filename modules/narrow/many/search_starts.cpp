// SPDX-License-Identifier: Apache-2.0
module abut.narrow.many.search_starts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

namespace abut {

void add_start(const Vec3& direction, Real estimate, SearchStarts& starts) {
  constexpr Real same_cosine = 1 - 1e-10;
  constexpr std::size_t most = 48;
  for (SearchStart& known : starts.span()) {
    if (dot(known.direction, direction) > same_cosine) {
      known.estimate = std::max(known.estimate, estimate);
      return;
    }
  }
  if (starts.size() < most) {
    starts.push_back({direction, estimate});
  }
}

bool add_planes(std::span<const OverlappedFour> overlapped, bool leaves_backs, SearchStarts& starts) {
  constexpr std::size_t most_planes = 16;
  for (const OverlappedFour& four : overlapped) {
    for (std::size_t lane = 0; lane < four.count; ++lane) {
      const Vec3 normal = four.normals[lane];
      if (squared_norm(normal) > 0) {
        add_start(normal, four.behind[lane], starts);
        if ((four.one_sided >> lane & 1u) == 0 || leaves_backs) {
          add_start(-normal, four.before[lane], starts);
        }
      }
      if (starts.size() > most_planes) {
        return false;
      }
    }
  }
  return true;
}

void add_mean_normals(std::span<const OverlappedFour> overlapped, Real size, bool leaves_backs, SearchStarts& starts) {
  constexpr int cells = 4;  // along each side of a cube
  struct Cell {
    Vec3 sum{0, 0, 0};
    Real weight = 0;
  };
  std::array<Cell, 6 * cells * cells> of_cells{};
  const auto cell_of = [](const Vec3& n) {
    const Vec3 parts = absolute(n);
    const int axis = parts.x >= parts.y && parts.x >= parts.z ? 0 : parts.y >= parts.z ? 1 : 2;
    const auto along = [&](Real coordinate) {
      return std::min(cells - 1, static_cast<int>((coordinate / parts[axis] * 0.5 + 0.5) * cells));
    };
    const int side = 2 * axis + (n[axis] > 0 ? 0 : 1);
    return static_cast<std::size_t>((side * cells + along(n[axis == 0 ? 1 : 0])) * cells + along(n[axis == 2 ? 1 : 2]));
  };
  for (const OverlappedFour& four : overlapped) {
    for (std::size_t lane = 0; lane < four.count; ++lane) {
      const Vec3 normal = four.normals[lane];
      if (!(squared_norm(normal) > 0)) {
        continue;
      }
      const TriangleCorners corners = four.triangles[lane];
      const Real area = 0.5 * norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
      const Real weight = std::min(area, size * size);
      const auto add = [&](const Vec3& n) {
        Cell& cell = of_cells[cell_of(n)];
        cell.sum += weight * n;
        cell.weight += weight;
      };
      add(normal);
      if ((four.one_sided >> lane & 1u) == 0 || leaves_backs) {
        add(-normal);
      }
    }
  }
  for (const Cell& cell : of_cells) {
    if (const auto mean = UnitVec3::make(cell.sum); mean && cell.weight > 0) {
      add_start(*mean, -cell.weight, starts);
    }
  }
}

bool are_ground(std::span<const OverlappedFour> overlapped, const Vec3& direction) {
  constexpr Real least_cosine = 0.7;
  constexpr std::size_t few_fours = 2;
  const Columns best = Columns::all(direction);
  Lanes least = all_lanes(1), most = all_lanes(-1);
  for (const OverlappedFour& four : overlapped) {
    const Lanes cosines = dot(four.normals, best);
    for (std::size_t lane = 0; lane < four.count; ++lane) {
      least[lane] = std::min(least[lane], cosines[lane]);
      most[lane] = std::max(most[lane], cosines[lane]);
    }
  }
  return overlapped.size() > few_fours &&
         (bits_of(least < all_lanes(least_cosine)) == 0 || bits_of(most > all_lanes(-least_cosine)) == 0);
}

}  // namespace abut
