#pragma once

#include "FingerFilters.h"

#include <Eigen/Core>

namespace antinode
{
/** What noise at an input that fills the band evenly gives at each ceramic, RMS for RMS: N_b x tracks, V/m. [worker] */
Eigen::MatrixXd noiseGains (const FingerFilters&, TrackBand);
} // namespace antinode
