// SPDX-License-Identifier: Apache-2.0
// What `abut tune` wrote; scripts/routes renews it.
module abut.scene.meetings.measured_routes;
import abut.core.standard;

namespace abut {

std::string_view committed_routes() {
  return R"routes(# abut routes 1
# AMD EPYC, 2026-11-30, abut 0.2.0
# question kind kind algorithm error_bound seconds worst_error
distance sphere sphere auto 0 1.1e-07 1e-13
distance sphere capsule auto 0 1.12e-07 1e-13
distance sphere box auto 0 1.07e-07 1e-13
distance sphere cylinder auto 0 1.3e-07 1e-13
distance sphere cone auto 0 1.35e-07 1e-13
distance sphere ellipsoid auto 0 2.97e-07 1e-13
distance sphere hull auto 0 3.09e-07 1e-13
distance capsule capsule auto 0 1.34e-07 1e-13
distance capsule box auto 0 1.33e-07 1e-13
distance capsule cylinder auto 1e-12 2.91e-07 1e-12
distance capsule cone auto 1e-12 2.73e-07 1e-12
distance capsule ellipsoid auto 1e-12 5.18e-07 1e-12
distance capsule ellipsoid auto 0.0001 4.87e-07 0.0001
distance capsule hull auto 0 4.23e-07 1e-12
distance capsule hull auto 0.01 3.7e-07 0.01
distance box box auto 0 4.65e-07 1e-12
distance box cylinder auto 1e-12 7.8e-07 1e-12
distance box cone auto 1e-12 7.62e-07 1e-12
distance box ellipsoid auto 1e-12 2.66e-06 1e-12
distance box ellipsoid auto 0.0001 2.38e-06 0.0001
distance box ellipsoid gjk_epa 0.01 2.07e-06 0.01
distance box hull auto 0 1.02e-06 1e-12
distance box hull auto 0.01 8.34e-07 0.01
distance cylinder cylinder auto 1e-12 1.8e-06 1e-12
distance cylinder cylinder auto 1e-09 1.66e-06 1e-09
distance cylinder cylinder auto 1e-06 1.55e-06 1e-06
distance cylinder cylinder auto 0.0001 1.46e-06 0.0001
distance cylinder cylinder auto 0.01 1.38e-06 0.01
distance cylinder cone auto 1e-12 2.01e-06 1e-12
distance cylinder cone auto 1e-09 1.8e-06 1e-09
distance cylinder cone auto 1e-06 1.59e-06 1e-06
distance cylinder cone auto 0.0001 1.51e-06 0.0001
distance cylinder ellipsoid auto 1e-09 3.12e-06 1e-09
distance cylinder ellipsoid gjk_epa 1e-06 2.8e-06 1e-06
distance cylinder ellipsoid gjk_epa 0.0001 2.4e-06 0.0001
distance cylinder hull auto 1e-12 1.99e-06 1e-12
distance cylinder hull auto 1e-09 1.72e-06 1e-09
distance cylinder hull auto 1e-06 1.53e-06 1e-06
distance cylinder hull auto 0.0001 1.45e-06 0.0001
distance cone cone auto 1e-12 2.44e-06 1e-12
distance cone cone auto 1e-09 1.98e-06 1e-09
distance cone cone auto 1e-06 1.82e-06 1e-06
distance cone ellipsoid auto 1e-09 5.01e-06 1e-09
distance cone ellipsoid auto 1e-06 4.17e-06 1e-06
distance cone ellipsoid gjk_epa 0.0001 3.51e-06 0.0001
distance cone hull auto 1e-12 2.25e-06 1e-12
distance cone hull auto 1e-09 2e-06 1e-09
distance cone hull auto 1e-06 1.82e-06 1e-06
distance ellipsoid ellipsoid auto 1e-12 4.24e-06 1e-12
distance ellipsoid ellipsoid auto 1e-09 3.61e-06 1e-09
distance ellipsoid ellipsoid auto 1e-06 3.02e-06 1e-06
distance ellipsoid ellipsoid auto 0.0001 2.65e-06 0.0001
distance ellipsoid ellipsoid auto 0.01 2.03e-06 0.01
distance ellipsoid hull auto 1e-12 6.49e-06 1e-12
distance ellipsoid hull auto 1e-09 5.76e-06 1e-09
distance ellipsoid hull auto 1e-06 4.9e-06 1e-06
distance ellipsoid hull auto 0.0001 4.16e-06 0.0001
distance hull hull auto 0 2.13e-06 1e-12
distance hull hull auto 0.0001 1.99e-06 0.0001
contacts sphere sphere auto 0 2.08e-07 1e-13
contacts sphere capsule auto 0 1.97e-07 1e-13
contacts sphere box auto 0 2.28e-07 1e-13
contacts sphere cylinder auto 0 2.63e-07 1e-13
contacts sphere cone auto 0 2.54e-07 1e-13
contacts sphere ellipsoid auto 0 3.91e-07 1e-13
contacts sphere hull auto 0 6.24e-07 1e-13
contacts sphere hull auto 0.01 5.73e-07 0.01
contacts capsule capsule auto 0 2.29e-07 1e-13
contacts capsule box auto 0 7.25e-07 1e-13
contacts capsule cylinder gjk_epa 1e-12 1.97e-06 1e-12
contacts capsule cylinder auto 1e-09 1.68e-06 1e-09
contacts capsule cylinder gjk_epa 1e-06 1.33e-06 1e-06
contacts capsule cylinder gjk_epa 0.0001 1.12e-06 0.0001
contacts capsule cylinder gjk_epa 0.01 9.06e-07 0.01
contacts capsule cone gjk_epa 1e-12 1.67e-06 1e-12
contacts capsule cone gjk_epa 1e-09 1.43e-06 1e-09
contacts capsule cone gjk_epa 1e-06 1.2e-06 1e-06
contacts capsule cone gjk_epa 0.0001 1.07e-06 0.0001
contacts capsule cone auto 0.01 9.06e-07 0.01
contacts capsule ellipsoid auto 1e-12 3.44e-06 1e-12
contacts capsule ellipsoid auto 1e-09 2.62e-06 1e-09
contacts capsule ellipsoid auto 1e-06 1.9e-06 1e-06
contacts capsule ellipsoid auto 0.0001 1.45e-06 0.0001
contacts capsule ellipsoid auto 0.01 9.19e-07 0.01
contacts capsule hull gjk_epa 0 1.24e-06 1e-13
contacts box box auto 0 8.94e-07 1e-13
contacts box cylinder auto 1e-12 2.32e-06 1e-13
contacts box cone auto 1e-12 1.92e-06 1e-13
contacts box ellipsoid auto 0 4.58e-06 1e-13
contacts box ellipsoid auto 0.0001 4.13e-06 0.0001
contacts box ellipsoid auto 0.01 3.81e-06 0.01
contacts box hull auto 0 1.68e-06 1e-13
contacts cylinder cylinder gjk_epa 1e-12 6.36e-06 1e-12
contacts cylinder cylinder auto 0 3.02e-06 1e-09
contacts cylinder cone gjk_epa 1e-12 6.56e-06 1e-12
contacts cylinder cone auto 0 3.54e-06 1e-09
contacts cylinder cone auto 0.0001 3.08e-06 0.0001
contacts cylinder ellipsoid auto 1e-12 4.37e-06 1e-12
contacts cylinder ellipsoid auto 0.0001 3.68e-06 0.0001
contacts cylinder hull auto 1e-12 3.52e-06 1e-13
contacts cone ellipsoid auto 1e-12 9.23e-06 1e-12
contacts cone ellipsoid auto 1e-09 7.65e-06 1e-09
contacts cone ellipsoid auto 1e-06 6.25e-06 1e-06
contacts cone ellipsoid auto 0.0001 5.67e-06 0.0001
contacts cone hull auto 1e-12 5.13e-06 1e-13
contacts ellipsoid ellipsoid auto 1e-06 3.93e-06 1e-13
contacts ellipsoid hull auto 1e-12 8.11e-06 1e-13
contacts ellipsoid hull auto 0.0001 6.65e-06 0.0001
contacts ellipsoid hull auto 0.01 5.33e-06 0.01
contacts hull hull auto 0 4.59e-06 1e-13
)routes";
}

}  // namespace abut
