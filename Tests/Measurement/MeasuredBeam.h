#pragma once

#include <antinode_measurement/Excitation.h>
#include <antinode_measurement/SimulatedBench.h>

#include <Support/ClosedFormResponse.h>
#include <Support/SineBeam.h>

#include <complex>

namespace antinode::test
{
/** The place at which the tests listen, off the nodal lines of the lowest modes, m. */
inline constexpr double listeningPlace = 0.0233;

/** Settings of a short measurement of the sine beam. */
inline ExcitationSettings shortSettings (ExcitationSignal signal, Eigen::Index ceramics)
{
    ExcitationSettings settings;
    settings.signal = signal;
    settings.sampleRate = 24000;
    settings.lowestFrequency = 80;
    settings.highestFrequency = 6000;
    settings.resolution = 1;
    settings.sweepDuration = 2;
    settings.periods = 3;
    settings.levels = Eigen::VectorXd::Constant (ceramics, 20);
    return settings;
}

inline Excitation testExcitation (const ExcitationSettings& settings)
{
    return makeExcitation (settings, Eigen::VectorXd::Constant (settings.levels.size(), 150));
}

/** The beam of the bench: a first mode at 115 Hz. */
inline ModalModel benchBeam()
{
    return sineBeam (6, 2);
}

/** What a bench records of one ceramic's run at the listening place. */
inline RunRecording recordRun (const Excitation& excitation, const ModalModel& model, Eigen::Index ceramic,
                               const SimulatedBenchSettings& bench)
{
    const Eigen::MatrixXd played = playedRun (excitation, ceramic, model.fullScaleVoltage);
    auto settings = bench;
    settings.sampleRate = excitation.settings.sampleRate;
    return simulateBench (model, shapesAt (model, listeningPlace, 0),
                          played.topRows (played.rows() - 1) * model.fullScaleVoltage,
                          played.bottomRows (1).transpose(), settings);
}

/** Effective error over effective value, dB. */
inline double errorInDecibels (const Eigen::VectorXcd& measured, const Eigen::VectorXcd& right)
{
    return 20 * std::log10 ((measured - right).norm() / right.norm());
}
} // namespace antinode::test
