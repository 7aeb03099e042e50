#pragma once

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** Hysteresis of a ceramic as its first harmonic: what it does at its full level is 1 + gain - i phase of what it does
    at the lowest levels, in proportion between. */
struct Hysteresis
{
    double gain = 0;  ///< Relative.
    double phase = 0; ///< rad: by how much it lags more.
};

/** Hysteresis that was measured. */
struct MeasuredHysteresis
{
    Hysteresis hysteresis;
    double misfit = 0; ///< RMS of what the response at the high level has beside, relative to it.
};

/** From responses of the surface at the same lines and points at two levels, weighted by their power.
    @param highLevel, lowLevel  of the full one: high above low above 0
    @throws InputError  where these or the sizes are not right, the low response is 0 or not finite, or full level would
                        change the response by more than itself
    [worker] Docs/Theory.md, section 7.9. */
MeasuredHysteresis fitHysteresis (const Eigen::VectorXcd& high, const Eigen::VectorXcd& low, double highLevel,
                                  double lowLevel);

/** A device as it answers where ceramics are played at these levels: participations by their gains there, so that
    designs ask for voltages that come out right. Limits are those of voltages and stay; what lags becomes the angle of
   the ceramic's lag.
    @param hysteresis, levels  N_b; levels of the full one, 0 to 1
    @throws InputError  where sizes do not agree, a gain leaves nothing, an angle is beyond 45 degrees, or the
                        device has one already
    [worker] */
ModalModel withHysteresis (ModalModel, const std::vector<Hysteresis>& hysteresis, const Eigen::VectorXd& levels);
} // namespace antinode
