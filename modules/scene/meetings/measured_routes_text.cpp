// SPDX-License-Identifier: Apache-2.0
// What `abut tune` wrote; scripts/routes renews it.
module abut.scene.meetings.measured_routes;
import abut.core.standard;

namespace abut {

std::string_view committed_routes() {
  return R"routes(# abut routes 1
# AMD EPYC, 2026-11-29, abut 0.2.0
# question kind kind algorithm error_bound seconds worst_error
distance sphere sphere auto 0 7.79e-08 1e-13
distance sphere capsule auto 0 1.13e-07 1e-13
distance sphere box auto 0 1.03e-07 1e-13
distance sphere cylinder auto 0 1.31e-07 1e-13
distance sphere cone auto 0 1.04e-07 1e-13
distance sphere ellipsoid auto 0 2.48e-07 1e-13
distance sphere hull auto 0 2.91e-07 1e-13
distance capsule capsule auto 0 1.26e-07 1e-13
distance capsule capsule auto 0.0001 1.19e-07 0.0001
distance capsule box auto 0 1.43e-07 1e-13
distance capsule cylinder auto 1e-12 2.26e-07 1e-12
distance capsule cone auto 1e-12 2.66e-07 1e-12
distance capsule ellipsoid auto 1e-12 5.01e-07 1e-12
distance capsule hull auto 0 3.87e-07 1e-12
distance box box auto 0 4.11e-07 1e-12
distance box cylinder auto 1e-12 1e-06 1e-12
distance box cone auto 1e-12 9.07e-07 1e-12
distance box cone auto 1e-09 8.2e-07 1e-09
distance box ellipsoid auto 1e-12 3.14e-06 1e-12
distance box ellipsoid auto 0 2.8e-06 1e-09
distance box ellipsoid auto 0.01 2.29e-06 0.01
distance box hull auto 0 1.15e-06 1e-12
distance box hull auto 0.01 1.01e-06 0.01
distance cylinder cylinder auto 1e-12 1.85e-06 1e-12
distance cylinder cylinder auto 1e-09 1.7e-06 1e-09
distance cylinder cylinder auto 1e-06 1.6e-06 1e-06
distance cylinder cylinder auto 0.01 1.49e-06 0.01
distance cylinder cone auto 1e-12 2.09e-06 1e-12
distance cylinder cone auto 1e-09 1.86e-06 1e-09
distance cylinder cone auto 1e-06 1.65e-06 1e-06
distance cylinder cone auto 0.0001 1.56e-06 0.0001
distance cylinder ellipsoid auto 1e-09 3.19e-06 1e-09
distance cylinder ellipsoid gjk_epa 1e-06 2.91e-06 1e-06
distance cylinder ellipsoid gjk_epa 0.0001 2.4e-06 0.0001
distance cylinder hull auto 1e-12 2.66e-06 1e-12
distance cylinder hull auto 1e-09 2.31e-06 1e-09
distance cylinder hull auto 1e-06 2.01e-06 1e-06
distance cone cone auto 1e-12 2.16e-06 1e-12
distance cone cone auto 1e-09 1.75e-06 1e-09
distance cone ellipsoid auto 1e-09 4.7e-06 1e-09
distance cone ellipsoid auto 1e-06 4.05e-06 1e-06
distance cone ellipsoid gjk_epa 0.0001 3.53e-06 0.0001
distance cone hull auto 1e-12 2.07e-06 1e-12
distance cone hull auto 1e-09 1.42e-06 1e-09
distance cone hull auto 1e-06 1.31e-06 1e-06
distance ellipsoid ellipsoid auto 1e-12 4.39e-06 1e-12
distance ellipsoid ellipsoid auto 1e-09 3.6e-06 1e-09
distance ellipsoid ellipsoid auto 1e-06 2.9e-06 1e-06
distance ellipsoid ellipsoid auto 0.0001 2.59e-06 0.0001
distance ellipsoid ellipsoid auto 0.01 2.02e-06 0.01
distance ellipsoid hull auto 1e-12 6.5e-06 1e-12
distance ellipsoid hull auto 1e-09 5.61e-06 1e-09
distance ellipsoid hull auto 1e-06 5.09e-06 1e-06
distance ellipsoid hull auto 0.0001 4.41e-06 0.0001
distance hull hull auto 0 1.99e-06 1e-12
distance hull hull auto 0.0001 1.79e-06 0.0001
contacts sphere sphere auto 0 1.83e-07 1e-13
contacts sphere capsule auto 0 1.37e-07 1e-13
contacts sphere box auto 0 1.5e-07 1e-13
contacts sphere cylinder auto 0 2.29e-07 1e-13
contacts sphere cone auto 0 2.59e-07 1e-13
contacts sphere ellipsoid auto 0 2.87e-07 1e-13
contacts sphere hull auto 0 6.34e-07 1e-13
contacts sphere hull auto 0.01 5.8e-07 0.01
contacts capsule capsule auto 0 2.28e-07 1e-13
contacts capsule box auto 0 5.08e-07 1e-13
contacts capsule cylinder gjk_epa 1e-12 1.68e-06 1e-12
contacts capsule cylinder gjk_epa 1e-09 1.41e-06 1e-09
contacts capsule cylinder gjk_epa 1e-06 1.13e-06 1e-06
contacts capsule cylinder auto 0.0001 9.53e-07 0.0001
contacts capsule cylinder gjk_epa 0.01 7.55e-07 0.01
contacts capsule cone gjk_epa 1e-12 1.32e-06 1e-12
contacts capsule cone gjk_epa 1e-09 1.12e-06 1e-09
contacts capsule cone gjk_epa 1e-06 9.14e-07 1e-06
contacts capsule cone gjk_epa 0.0001 7.66e-07 0.0001
contacts capsule cone gjk_epa 0.01 6.31e-07 0.01
contacts capsule ellipsoid auto 1e-12 3.45e-06 1e-12
contacts capsule ellipsoid auto 1e-09 2.79e-06 1e-09
contacts capsule ellipsoid auto 1e-06 1.94e-06 1e-06
contacts capsule ellipsoid auto 0.0001 1.43e-06 0.0001
contacts capsule ellipsoid auto 0.01 9.36e-07 0.01
contacts capsule hull auto 0 7.8e-07 1e-13
contacts box box auto 0 6.66e-07 1e-13
contacts box cylinder auto 1e-12 3.54e-06 1e-13
contacts box cylinder auto 1e-09 3.18e-06 1e-09
contacts box cone auto 1e-12 3.01e-06 1e-13
contacts box ellipsoid auto 0 4.92e-06 1e-13
contacts box hull auto 0 3.13e-06 1e-13
contacts cylinder cylinder gjk_epa 1e-12 7.17e-06 1e-12
contacts cylinder cylinder auto 0 3.44e-06 1e-09
contacts cylinder cylinder auto 0.0001 3.04e-06 0.0001
contacts cylinder cone gjk_epa 1e-12 6.58e-06 1e-12
contacts cylinder cone auto 0 3.29e-06 1e-09
contacts cylinder cone auto 0.0001 2.97e-06 0.0001
contacts cylinder ellipsoid auto 1e-12 5.09e-06 1e-12
contacts cylinder ellipsoid auto 1e-09 4.48e-06 1e-09
contacts cylinder ellipsoid auto 0.0001 4.06e-06 0.0001
contacts cylinder hull auto 1e-12 5.26e-06 1e-13
contacts cone ellipsoid auto 1e-12 8.13e-06 1e-12
contacts cone ellipsoid auto 1e-09 6.82e-06 1e-09
contacts cone ellipsoid auto 1e-06 6.09e-06 1e-06
contacts cone ellipsoid auto 0.0001 5.4e-06 0.0001
contacts cone hull auto 1e-12 3.51e-06 1e-13
contacts ellipsoid ellipsoid auto 1e-09 3.87e-06 1e-13
contacts ellipsoid ellipsoid auto 0.01 3.47e-06 0.01
contacts ellipsoid hull auto 1e-12 1.03e-05 1e-13
contacts ellipsoid hull auto 1e-06 9.6e-06 1e-06
contacts ellipsoid hull auto 0.0001 8.42e-06 0.0001
contacts ellipsoid hull auto 0.01 6.89e-06 0.01
contacts hull hull gjk_epa 0 5.58e-06 1e-13
)routes";
}

}  // namespace abut
