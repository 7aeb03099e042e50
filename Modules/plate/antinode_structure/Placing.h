#pragma once

#include "PlacementCandidates.h"
#include "PlacementSearch.h"

#include <Eigen/Core>

namespace antinode
{
/** The correlation of the velocity responses of modes to past voltages: H_kl = integral over 0..T of h_k h_l, h_k the
   velocity that mode k has a time tau after a unit impulse of force. Ceramic i then brings diag(alpha_i) H
   diag(alpha_i) to the Gramian of the velocities that can be reached at T.
    @param angularFrequencies, dampingRatios  N_m each, rad/s and less than 1
    @param duration                           T, s
    @return                                   N_m x N_m, s
    [worker] Docs/Theory.md, section 1.9. */
Eigen::MatrixXd velocityKernel (const Eigen::VectorXd& angularFrequencies, const Eigen::VectorXd& dampingRatios,
                                double duration);

/** The Gramian's worst direction: the least eigenvalue of sum_i diag(alpha_i) H diag(alpha_i). Its inverse is the
   largest energy, in V^2 s, that one unit of modal velocity can cost.
    @param kernel         N_m x N_m, scaled to what the modes are wanted for
    @param participation  N_m x ceramics
    [worker] Docs/Theory.md, section 1.9. */
double worstControllability (const Eigen::MatrixXd& kernel, const Eigen::MatrixXd& participation);

/** The best positions of ceramics of one kind on a device. */
struct PlacedCeramics
{
    std::vector<CeramicDescription> ceramics; ///< Named C1, C2 and so on.
    double controllability = 0;     ///< Of the worst mode, relative to average positions that do not couple modes.
    std::optional<double> resolved; ///< The same with the ceramics' mass and stiffness.
    Eigen::VectorXd perMode;        ///< N_m: the Gramian's diagonal, relative too.
    Eigen::Index candidates = 0;
    int exchanges = 0;
};

/** A rectangle of a surface that ceramics keep out of: a display, a cable, a hole. m */
struct KeepOut
{
    double left = 0, bottom = 0, right = 0, top = 0;
};

struct PlacingOptions
{
    CandidateGrid grid;
    Eigen::Index count = 0;  ///< How many ceramics.
    double duration = 0.025; ///< Time available to excite the modes, s.
    PlacementCostOf costOf;  ///< What the places are exchanged for in the end; none: controllability alone counts.
    PlacementNews better;    ///< Hears of the best places so far, from the calling thread.
    std::vector<KeepOut> keepOut;
    bool isResolved = true; ///< Whether the device is solved again with its ceramics.
};

/** Chooses places by the worst controllability of the lowest modes, on the bare device's
   modes; exchanges them for neighbours where a cost is given; then solves it with its ceramics.
    @throws InputError  where keep-out zones leave no position; as placementCandidates and searchPlacement, and when
   some mode is moved from none of the places
    @param progress  hears how far the work is, 0 to 1, from any thread, one at a time
    [worker], on all cores. Docs/Theory.md, section 1.9. */
PlacedCeramics placeCeramics (const DeviceDescription&, const CeramicDescription& like, const PlacingOptions&,
                              const std::function<void (double)>& progress = {});
} // namespace antinode
