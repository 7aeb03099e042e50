#pragma once

#include <antinode_allocation/Allocation.h>

#include <Eigen/Core>

#include <complex>
#include <cstdint>

namespace antinode::test
{
/** How the modes of an instance lie. */
enum class ModePattern
{
    beam, ///< Frequencies grow with the square.
    plate ///< Frequencies lie evenly dense, some close to each other.
};

enum class RowKind
{
    identity, ///< Rows (29) of the paper.
    terminal  ///< Terminal velocities of every mode under every drive.
};

/** What an instance looks like. */
struct InstanceSize
{
    int ceramics = 2, modes = 2, samples = 500, guards = 0;
    double sampleRate = 96000; ///< Hz
    double closePair = 0;      ///< Where more than 0: how far the last mode lies above the one before it, relative.
};

/** The sizes s1 to s6 on which solvers are compared. */
inline constexpr InstanceSize standardSizes[] = { { 2, 2, 500, 0, 96000 },     { 4, 6, 2000, 0, 96000 },
                                                  { 8, 15, 4800, 0, 192000 },  { 16, 40, 4800, 0, 192000 },
                                                  { 32, 64, 9600, 0, 384000 }, { 64, 200, 20000, 0, 800000 } };

/** Growing drives (four e-folds up to the end) of damped modes with random participations. The same for the same seed.
    Voltage limits are 1, the guards' weight 0. */
AllocationProblem instance (ModePattern, RowKind, const InstanceSize&, std::uint32_t seed);

/** The poles -a + j b of the modes that the same arguments control in instance. */
Eigen::VectorXcd instancePoles (ModePattern, const InstanceSize&, std::uint32_t seed);

/** The problem with limits such that its least peak ratio is 1 / slack. */
AllocationProblem withLimits (AllocationProblem, double slack, double minimumPeakRatio);

/** Row values, hard or guard, of an allocation: sum over i, l of participation (k, i) rows (k, l) M (i, l). */
Eigen::VectorXd rowValues (const Eigen::MatrixXd& participation, const Eigen::MatrixXd& rows,
                           const Eigen::MatrixXd& matrix);
} // namespace antinode::test
