// SPDX-License-Identifier: Apache-2.0
// The shortest translation that leaves some half-spaces.
export module abut.narrow.ways.least_translation;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;

export namespace abut {

// Translations that leave it: dot(normal, translation) >= least.
struct HalfSpaceToLeave {
  Vec3 normal;  // unit
  Real least;
};

// Of planes that are alike the one that is left later counts; of many the first one gives way.
template <std::size_t Most>
void add_plane(const HalfSpaceToLeave& plane, SmallVector<HalfSpaceToLeave, Most>& planes) {
  for (HalfSpaceToLeave& known : planes.span()) {
    if (dot(known.normal, plane.normal) > one_direction) {
      known.least = std::max(known.least, plane.least);
      return;
    }
  }
  if (planes.size() == Most) {
    std::ranges::copy(planes.span().subspan(1), planes.span().begin());
    planes.pop_back();
  }
  planes.push_back(plane);
}

// Few half-spaces, of which up to three hold the shortest translation: all sets of one, two and three planes are tried,
// fewer planes first. Nothing where no translation leaves all.
std::optional<Vec3> least_translation(std::span<const HalfSpaceToLeave> planes) {
  // Of cosines between planes that have no line, and of products of three that have no point in common.
  constexpr Real parallel = 1e-10, flat = 1e-8, slack_share = 1e-11;
  std::optional<Vec3> best;
  const auto offer = [&](const Vec3& move) {
    const Real slack = slack_share * norm(move);
    if ((!best || squared_norm(move) < squared_norm(*best)) &&
        std::ranges::all_of(
            planes, [&](const HalfSpaceToLeave& plane) { return dot(plane.normal, move) >= plane.least - slack; })) {
      best = move;
    }
  };
  for (const HalfSpaceToLeave& plane : planes) {
    offer(plane.least * plane.normal);
  }
  if (best) {
    return best;
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const auto& [a, of_a] = planes[i];
      const auto& [b, of_b] = planes[j];
      const Real cosine = dot(a, b), square = 1 - cosine * cosine;
      const Real along_a = of_a - cosine * of_b, along_b = of_b - cosine * of_a;
      if (square > parallel && along_a >= 0 && along_b >= 0) {
        offer((along_a / square) * a + (along_b / square) * b);
      }
    }
  }
  if (best) {
    return best;
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const auto& [a, of_a] = planes[i];
        const auto& [b, of_b] = planes[j];
        const auto& [c, of_c] = planes[k];
        const Real volume = dot(a, cross(b, c));
        if (std::fabs(volume) > flat) {
          offer((1 / volume) * (of_a * cross(b, c) + of_b * cross(c, a) + of_c * cross(a, b)));
        }
      }
    }
  }
  return best;
}

}  // namespace abut
