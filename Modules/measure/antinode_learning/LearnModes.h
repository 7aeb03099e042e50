#pragma once

#include "ModeSpread.h"
#include "PlayedRecording.h"

#include <antinode_model/ModalModel.h>

#include <array>
#include <vector>

namespace antinode
{
/** A device after what was heard of it. */
struct LearntModes
{
    ModalModel model;                        ///< The most probable one.
    std::vector<Sensor> sensors;             ///< Their most probable shapes.
    Eigen::VectorXd delays;                  ///< s, of each recording.
    Eigen::VectorXd distortions;             ///< N_b, 1/V^2: a ceramic acts as a linear one under U + c U^3.
    Eigen::VectorXd distortionDeviations;    ///< N_b, 1/V^2: standard deviations that are left of them.
    Eigen::VectorXd frequencyDeviations;     ///< N_m: relative standard deviations that are left.
    Eigen::VectorXd dampingDeviations;       ///< N_m
    Eigen::VectorXd participationDeviations; ///< N_m: RMS over the ceramics.
    double residual = 0;       ///< RMS of what the model does not explain, of the noise: 1 where all is explained.
    double unexplained = 0;    ///< The same, of the signals.
    double distance = 0;       ///< RMS of the residual and of all deviations from what was known, of the noise.
    double largestMove = 0;    ///< Of a frequency, in its deviations, of modes below .4 of the lowest sample rate.
    double heldBack = 0;       ///< Of sensors that are held back in turn: RMS of what the others do not predict, of the
                               ///< signals; 0: where sensors are exact or there is only one.
    double heldBackBefore = 0; ///< The same by the device as it was.
    Eigen::VectorXd
        mixtures = {}; ///< N_m: how much of the next mode each one has, and the next one of it the opposite.
};

/** Whether a frequency that is moved by so many deviations shows a wrong minimum. [any] */
bool isUnlikelyMove (double deviations);

/** Whether a fit shows a sign of a wrong minimum: an unlikely move, or more than 1.2 of the noise. [any] */
bool isMissed (const LearntModes&);

/** The most probable modes of a device, from what sensors heard while voltages were played: normally distributed
    deviations from the model, normally distributed noise, by Gauss and Newton's method on records that grow from the
    first motion to their whole lengths, so that no mode is taken half a turn wrong.
    @param recordings  at least one; all with the same sensors
    @param before      learnt from the first of these recordings, to begin with; nullptr: nothing was
    @throws InputError  where sizes do not agree or a number is not usable; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 7.6. */
LearntModes learnModes (const ModalModel&, const std::vector<Sensor>&, const ModeSpread&,
                        const std::vector<PlayedRecording>& recordings, const LearntModes* before = nullptr);

/** How well some device explains the beginning of a recording, in which no mode can be half a turn wrong: the RMS of
   the residual and of the deviations, in units of the noise. Of several delays, the right one leaves least.
    @param enough    in units of the noise: where the first bound leaves less, the second one is not tried
    @param hopeless  the same, of each bound: a fit that still leaves more after a few steps ends there, and where it is
                     that of the first bound, the second one is not tried either
    @return  with all parameters bounded, and with the frequencies alone bounded: infinite where it was not tried
    @throws  as learnModes
    [worker] Docs/Theory.md, section 7.6. */
std::array<double, 2> misfitsOfBeginning (const ModalModel&, const std::vector<Sensor>&, const ModeSpread&,
                                          PlayedRecording, double enough, const std::array<double, 2>& hopeless);
} // namespace antinode
