#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/Playback.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace antinode
{
/** The current and energy of one ceramic during an event. */
struct CeramicFlow
{
    double peakVoltage = 0;          ///< V
    double peakSlew = 0;             ///< V/s
    double peakCurrent = 0;          ///< A
    double peakCharge = 0;           ///< C
    double voltageSquaredTime = 0;   ///< Integral of U^2, V^2 s.
    double currentSquaredTime = 0;   ///< Integral of i^2, A^2 s.
    double currentMagnitudeTime = 0; ///< Integral of |i|, A s.
    double drawn = 0;                ///< J that the ceramic takes from its amplifier while U i > 0.
    double returned = 0;             ///< J that it gives back while U i < 0.
    double dielectricLoss = 0;       ///< J of these that become heat in the ceramic.
    double work = 0;                 ///< J of these that go into the motion of the body.
    double storedAtEnd = 0;          ///< J that are left in the capacitance at the end.
};

/** Where the electrical energy of an event goes. */
struct PowerFlow
{
    std::vector<CeramicFlow> ceramics;
    double duration = 0;       ///< s from the trigger until all voltages stay 0.
    double peakCurrent = 0;    ///< Largest sum of all |i|, A: what the supply of all amplifiers gives.
    double peakPower = 0;      ///< Largest sum of all U i, W.
    double peakMotion = 0;     ///< Largest energy of the motion, J.
    double motionAtEnd = 0;    ///< Its energy at the end, J.
    double mechanicalLoss = 0; ///< J that damping turns into heat.

    double drawn() const;          ///< Of all ceramics, J.
    double returned() const;       ///< The same.
    double dielectricLoss() const; ///< The same.
    double storedAtEnd() const;    ///< In motion and capacitances, J.

    /** Taken minus returned, J. */
    double electricalIn() const { return drawn() - returned(); }

    /** What is missing in or left over from electrical energy in = stored + lost, relative to the energy in. */
    double imbalance() const;
};

/** Why the power of a device cannot be told; empty where it can: each ceramic needs a capacitance, at least as large as
   the modes say that their ceramic stores. [any] */
std::string powerObstacle (const ModalModel&);

/** Current and energy of sampled voltages on a device that is at rest before the first of them.
    @param voltages  N_b x N_s, V
    @param playback  with a rate of more than 0; currents are those of the band-limited waveform through the samples,
   the work on the motion is that of what is played
    @throws InputError  where powerObstacle() has one, or sizes do not agree; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 6.8. */
PowerFlow powerFlow (const ModalModel&, const Eigen::MatrixXd& voltages, Playback playback);
} // namespace antinode
