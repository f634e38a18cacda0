// SPDX-License-Identifier: Apache-2.0
module abut.trees.samples.sparse_blocks_spline;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

constexpr std::array<std::size_t, 3> steps{1, 3, 9};  // between neighbours along each axis

// Calls visit(first) for the nine lines of three numbers along an axis.
template <class Visitor>
void visit_lines(int axis, Visitor&& visit) {
  const std::size_t across = axis == 0 ? 3 : 1, other = axis == 2 ? 3 : 9;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      visit(j * other + i * across);
    }
  }
}

}  // namespace

SplinePatch SplinePatch::make(const SamplesAround& samples, const std::array<NearestSample, 3>& middle, const Vec3& low,
                              const Vec3& high) {
  SplinePatch out{};
  std::ranges::copy(samples, out.c.begin());
  for (int axis = 0; axis < 3; ++axis) {
    const NearestSample& its = middle[static_cast<std::size_t>(axis)];
    const std::array<SampleShares, 3> shares{its.shares(low[axis], low[axis]), its.shares(low[axis], high[axis]),
                                             its.shares(high[axis], high[axis])};
    const std::size_t step = steps[static_cast<std::size_t>(axis)];
    visit_lines(axis, [&](std::size_t first) {
      const std::array<Real, 3> line{out.c[first], out.c[first + step], out.c[first + 2 * step]};
      for (std::size_t i = 0; i < 3; ++i) {
        out.c[first + i * step] = shares[i][0] * line[0] + shares[i][1] * line[1] + shares[i][2] * line[2];
      }
    });
  }
  return out;
}

SplinePatch SplinePatch::half(int axis, bool is_upper) const {
  SplinePatch out = *this;
  const std::size_t step = steps[static_cast<std::size_t>(axis)];
  visit_lines(axis, [&](std::size_t first) {
    const Real left = 0.5 * (c[first] + c[first + step]), right = 0.5 * (c[first + step] + c[first + 2 * step]);
    out.c[first + step] = is_upper ? right : left;
    out.c[first + (is_upper ? 0 : 2 * step)] = 0.5 * (left + right);
  });
  return out;
}

std::array<Real, 7> SplinePatch::diagonal() const {
  constexpr std::array<Real, 3> of_axis{1, 2, 1};
  constexpr std::array<Real, 7> of_all{1, 6, 15, 20, 15, 6, 1};
  std::array<Real, 7> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        out[i + j + k] += of_axis[i] * of_axis[j] * of_axis[k] * c[9 * k + 3 * j + i];
      }
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] /= of_all[i];
  }
  return out;
}

}  // namespace abut
