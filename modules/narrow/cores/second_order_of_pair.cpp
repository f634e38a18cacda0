module abut.narrow.cores.second_order_of_pair;
import abut.capability.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {
constexpr Real parallel_share = 1e-15;  // of the square of a sine, less than which is rounding
}  // namespace

void join_parallel_steps(PairGerm& germ) {
  for (std::size_t i = 0; i < germ.a.step_count; ++i) {
    InFrame& u = germ.a.steps[i];
    const Real square = u.n * u.n + u.x * u.x + u.y * u.y;
    for (std::size_t j = 0; j < germ.b.step_count; ++j) {
      InFrame v = germ.b.steps[j];
      const Real along = u.n * v.n + u.x * v.x + u.y * v.y, other = v.n * v.n + v.x * v.x + v.y * v.y;
      if (square * other - along * along > parallel_share * square * other) {
        continue;
      }
      if (along < 0) {
        // Across both, where neither end is the further one: from the other end of b.
        germ.point = {germ.point.n + v.n, germ.point.x + v.x, germ.point.y + v.y};
        v = {-v.n, -v.x, -v.y};
      }
      germ.part_of_a[i] = 1 / (1 + std::sqrt(other / square));
      u = {u.n + v.n, u.x + v.x, u.y + v.y};
      germ.b.steps[j] = germ.b.steps[--germ.b.step_count];
      break;
    }
  }
}

}  // namespace abut
