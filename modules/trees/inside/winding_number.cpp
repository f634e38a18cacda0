// SPDX-License-Identifier: Apache-2.0
module abut.trees.inside.winding_number;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.wide;
import abut.trees.inside.solid_angle;

namespace abut {
namespace {

// The error that a group may have in the first attempt, and by how much less in each one after it. Then nothing is met
// as one.
constexpr Real first_error = 0x1p-6, next_share = 0x1p-8;
constexpr int attempts = 4;

// What rounding adds to the number: more than the sum of some thousand terms has.
constexpr Real rounding = 1e-9;

// In units of the whole: from further on nothing of it is seen.
constexpr Real far = 1e9;

// Enough for a tree of 2^31 triangles, with four children to a block.
constexpr std::size_t most_waiting = 64;

}  // namespace

// The field of an area, by harmonics. That of order n is at most n radius^(n - 1) / distance^(n + 1) of the area, over
// four pi: a Legendre polynomial and its slope over n lie in the unit circle (Bernstein, Szego). The orders from 4 on
// are left out.
inline WindingNumber::Terms WindingNumber::terms_of(const Block& block, const Vec3& point) {
  const Columns to = block.centre - Columns::all(point);
  const Lanes x = to.x, y = to.y, z = to.z, xx = x * x, yy = y * y, zz = z * z;
  const Lanes inverse_square = 1 / (xx + yy + zz), inverse = __builtin_elementwise_sqrt(inverse_square);
  const auto& [s_xx, s_yy, s_xy, s_xz, s_yz] = block.first;
  const Lanes first = s_xx * (xx - zz) + s_yy * (yy - zz) + 2 * (s_xy * (x * y) + s_xz * (x * z) + s_yz * (y * z));
  const auto& [t_xxx, t_yyy, t_xxy, t_xxz, t_yyx, t_yyz, t_xyz] = block.second;
  const Lanes second = t_xxx * (x * (xx - 3 * zz)) + t_yyy * (y * (yy - 3 * zz)) + 3 * t_xxy * (y * (xx - zz)) +
                       3 * t_yyx * (x * (yy - zz)) + t_xxz * (z * (3 * xx - zz)) + t_yyz * (z * (3 * yy - zz)) +
                       6 * t_xyz * (x * y * z);
  const Lanes inverse_cube = inverse_square * inverse;
  const Lanes number =
      inverse_cube * (dot(block.area, to) - 3 * inverse_square * (first - 2.5 * inverse_square * second));
  const Lanes share = block.radius * inverse, left = 1 - share;
  const Lanes error = block.blur * inverse_square * inverse_cube * (4 - 3 * share) / (left * left);
  return {number, share < 0.9 ? error : all_lanes(infinity)};
}

inline void WindingNumber::add_triangles(const Vec3& point, const Range& range, SolidAngles& angles) const {
  for (std::uint32_t begin = 0; begin < range.count; begin += width) {
    std::array<std::array<Vec3, 3>, width> seen;
    for (std::uint32_t lane = 0; lane < width; ++lane) {
      if (begin + lane < range.count) {
        const Corners& corners = triangles_[range.first + begin + lane];
        for (std::size_t corner = 0; corner < 3; ++corner) {
          seen[lane][corner] = scale_ * (vertices_[corners[corner]] - point);
        }
      } else {
        seen[lane].fill({1, 0, 0});  // a triangle without size is not seen
      }
    }
    const auto columns = [&](std::size_t corner) {
      return Columns::of(lanes_of(seen[0][corner]), lanes_of(seen[1][corner]), lanes_of(seen[2][corner]),
                         lanes_of(seen[3][corner]));
    };
    angles.add({columns(0), columns(1), columns(2)}, [&](std::size_t lane) {
      const Corners& corners = triangles_[range.first + begin + lane];
      const auto exact = [&](std::size_t corner) {
        return Wide(scale_) * wide_difference(vertices_[corners[corner]], point);
      };
      return std::array{exact(0), exact(1), exact(2)};
    });
  }
}

// `most_of_group`: the error of a group that is met as one.
WindingNumber::Estimate WindingNumber::estimate(const Vec3& point, Real most_of_group) const {
  const Vec3 at = local(point);
  Estimate sum{0, rounding};
  if (blocks_.empty() || !(largest_magnitude(at) < far)) {
    return sum;
  }
  SolidAngles angles;
  std::array<std::uint32_t, most_waiting> waiting;
  waiting[0] = 0;
  std::size_t count = 1;
  while (count > 0) {
    const Block& block = blocks_[waiting[--count]];
    const Terms terms = terms_of(block, at);
    for (std::size_t lane = 0; lane < width; ++lane) {
      if (terms.error[lane] <= most_of_group) {
        sum.number += terms.number[lane];
        sum.error += terms.error[lane];
      } else if (block.children[lane] == no_child) {
        add_triangles(point, block.ranges[lane], angles);
      } else {
        waiting[count++] = block.children[lane];
      }
    }
  }
  sum.number += angles.turns();
  return sum;
}

bool WindingNumber::contains(const Vec3& point) const {
  Real most = first_error;
  for (int attempt = 0; attempt < attempts; ++attempt, most *= next_share) {
    const Estimate found = estimate(point, most);
    if (std::fabs(found.number - 0.5) > found.error) {
      return found.number > 0.5;
    }
  }
  // On a face it is one half, and the order of sums would tell.
  return estimate(point, 0).number > 0.5 + rounding;
}

WindingNumber::Estimate WindingNumber::at(const Vec3& point, Real most_error) const {
  Real most = first_error;
  for (int attempt = 0; attempt < attempts; ++attempt, most *= next_share) {
    if (const Estimate found = estimate(point, most); found.error <= most_error) {
      return found;
    }
  }
  return estimate(point, 0);
}

}  // namespace abut
