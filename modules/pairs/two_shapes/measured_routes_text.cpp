// SPDX-License-Identifier: Apache-2.0
// What `abut tune` wrote; scripts/routes renews it.
module abut.pairs.two_shapes.measured_routes;
import abut.core.standard;

namespace abut {

std::string_view committed_routes() {
  return R"routes(# abut routes 1
# AMD EPYC, 2026-11-30, abut 0.2.0
# question kind kind algorithm error_bound seconds worst_error
distance sphere sphere auto 0 1.04e-07 1e-13
distance sphere capsule auto 0 1.1e-07 1e-13
distance sphere box auto 0 1.13e-07 1e-13
distance sphere cylinder auto 0 1.31e-07 1e-13
distance sphere cone auto 0 1.44e-07 1e-13
distance sphere ellipsoid auto 0 3.04e-07 1e-13
distance sphere hull auto 0 2.75e-07 1e-13
distance capsule capsule auto 0 1.21e-07 1e-13
distance capsule box auto 0 1.38e-07 1e-13
distance capsule cylinder auto 1e-12 2.68e-07 1e-12
distance capsule cone auto 1e-12 2.68e-07 1e-12
distance capsule ellipsoid auto 1e-12 4.99e-07 1e-12
distance capsule ellipsoid auto 0.01 4.73e-07 0.01
distance capsule hull auto 0 4.22e-07 1e-12
distance capsule hull auto 0.01 3.91e-07 0.01
distance box box auto 0 4.49e-07 1e-12
distance box cylinder auto 1e-12 1.02e-06 1e-12
distance box cylinder auto 1e-09 9.52e-07 1e-09
distance box cone auto 1e-12 9.14e-07 1e-12
distance box ellipsoid auto 1e-12 3.69e-06 1e-12
distance box ellipsoid auto 1e-09 3.42e-06 1e-09
distance box ellipsoid auto 0.0001 3.14e-06 0.0001
distance box ellipsoid gjk_epa 0.01 2.8e-06 0.01
distance box hull auto 0 1.19e-06 1e-12
distance box hull auto 0.01 1.06e-06 0.01
distance cylinder cylinder auto 1e-12 2.23e-06 1e-12
distance cylinder cylinder auto 0.0001 1.89e-06 0.0001
distance cylinder cylinder auto 0.01 1.71e-06 0.01
distance cylinder cone auto 1e-12 2.51e-06 1e-12
distance cylinder cone auto 1e-09 2.28e-06 1e-09
distance cylinder cone auto 1e-06 2.03e-06 1e-06
distance cylinder cone auto 0.0001 1.84e-06 0.0001
distance cylinder ellipsoid auto 1e-09 3.98e-06 1e-09
distance cylinder ellipsoid gjk_epa 1e-06 3.73e-06 1e-06
distance cylinder ellipsoid gjk_epa 0.0001 3.1e-06 0.0001
distance cylinder hull auto 1e-12 2.53e-06 1e-12
distance cylinder hull auto 1e-09 2.31e-06 1e-09
distance cylinder hull auto 1e-06 2.1e-06 1e-06
distance cone cone auto 1e-12 2.3e-06 1e-12
distance cone cone auto 1e-09 1.9e-06 1e-09
distance cone cone auto 1e-06 1.73e-06 1e-06
distance cone cone auto 0.0001 1.65e-06 0.0001
distance cone ellipsoid auto 1e-09 4.48e-06 1e-09
distance cone ellipsoid auto 1e-06 3.86e-06 1e-06
distance cone ellipsoid gjk_epa 0.0001 3.26e-06 0.0001
distance cone hull auto 1e-12 2.28e-06 1e-12
distance cone hull auto 1e-09 1.96e-06 1e-09
distance cone hull auto 1e-06 1.75e-06 1e-06
distance ellipsoid ellipsoid auto 1e-12 4.2e-06 1e-12
distance ellipsoid ellipsoid auto 1e-09 3.69e-06 1e-09
distance ellipsoid ellipsoid auto 1e-06 2.79e-06 1e-06
distance ellipsoid ellipsoid auto 0.0001 2.46e-06 0.0001
distance ellipsoid ellipsoid auto 0.01 1.89e-06 0.01
distance ellipsoid hull auto 1e-12 6.69e-06 1e-12
distance ellipsoid hull auto 1e-09 6.09e-06 1e-09
distance ellipsoid hull auto 1e-06 5.3e-06 1e-06
distance ellipsoid hull auto 0.0001 4.35e-06 0.0001
distance hull hull auto 0 2.03e-06 1e-12
distance hull hull auto 0.0001 1.73e-06 0.0001
contacts sphere sphere auto 0 1.74e-07 1e-13
contacts sphere capsule auto 0 1.83e-07 1e-13
contacts sphere box auto 0 1.92e-07 1e-13
contacts sphere cylinder auto 0 2.59e-07 1e-13
contacts sphere cone auto 0 2.54e-07 1e-13
contacts sphere ellipsoid auto 0 3.56e-07 1e-13
contacts sphere hull auto 0 6.04e-07 1e-13
contacts capsule capsule auto 0 1.98e-07 1e-13
contacts capsule box auto 0 6.43e-07 1e-13
contacts capsule cylinder gjk_epa 1e-12 1.91e-06 1e-12
contacts capsule cylinder gjk_epa 1e-09 1.6e-06 1e-09
contacts capsule cylinder gjk_epa 1e-06 1.3e-06 1e-06
contacts capsule cylinder gjk_epa 0.0001 1.1e-06 0.0001
contacts capsule cylinder gjk_epa 0.01 9.14e-07 0.01
contacts capsule cone gjk_epa 1e-12 1.71e-06 1e-12
contacts capsule cone auto 1e-09 1.59e-06 1e-09
contacts capsule cone gjk_epa 1e-06 1.3e-06 1e-06
contacts capsule cone gjk_epa 0.0001 1.09e-06 0.0001
contacts capsule cone gjk_epa 0.01 8.8e-07 0.01
contacts capsule ellipsoid auto 1e-12 3.69e-06 1e-12
contacts capsule ellipsoid auto 1e-09 2.68e-06 1e-09
contacts capsule ellipsoid auto 1e-06 1.95e-06 1e-06
contacts capsule ellipsoid auto 0.0001 1.52e-06 0.0001
contacts capsule ellipsoid auto 0.01 9.46e-07 0.01
contacts capsule hull auto 0 1.21e-06 1e-13
contacts box box auto 0 7.61e-07 1e-13
contacts box cylinder auto 1e-12 3.63e-06 1e-13
contacts box cylinder auto 1e-09 3.42e-06 1e-09
contacts box cone auto 1e-12 2.9e-06 1e-13
contacts box ellipsoid auto 0 6.47e-06 1e-13
contacts box ellipsoid auto 0.0001 5.74e-06 0.0001
contacts box ellipsoid auto 0.01 5.36e-06 0.01
contacts box hull auto 0 2.83e-06 1e-13
contacts cylinder cylinder gjk_epa 1e-12 9.18e-06 1e-12
contacts cylinder cylinder auto 0 4.15e-06 1e-09
contacts cylinder cone gjk_epa 1e-12 7.96e-06 1e-12
contacts cylinder cone auto 0 3.95e-06 1e-09
contacts cylinder cone auto 0.0001 3.65e-06 0.0001
contacts cylinder ellipsoid auto 1e-12 6.02e-06 1e-12
contacts cylinder ellipsoid auto 0.0001 5.25e-06 0.0001
contacts cylinder hull auto 1e-12 5.57e-06 1e-13
contacts cylinder hull auto 1e-09 5.27e-06 1e-09
contacts cone cone gjk_epa 1e-12 8.02e-06 1e-12
contacts cone cone auto 0 3.61e-06 1e-09
contacts cone ellipsoid auto 1e-12 9.43e-06 1e-12
contacts cone ellipsoid auto 0 7.69e-06 1e-09
contacts cone ellipsoid auto 1e-06 6.61e-06 1e-06
contacts cone ellipsoid auto 0.0001 6.11e-06 0.0001
contacts cone hull auto 1e-12 4.59e-06 1e-13
contacts ellipsoid ellipsoid auto 1e-09 3.94e-06 1e-13
contacts ellipsoid hull auto 1e-12 9.02e-06 1e-13
contacts ellipsoid hull auto 0.0001 8.12e-06 0.0001
contacts ellipsoid hull auto 0.01 6.57e-06 0.01
contacts hull hull auto 0 4.99e-06 1e-13
)routes";
}

}  // namespace abut
