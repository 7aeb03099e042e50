#pragma once

#include "Bench.h"

#include <antinode_measurement/Amplifier.h>

#include <functional>

namespace antinode
{
/** The amplifiers of a bench as they were measured, N_b each. */
struct AmplifierMeasurement
{
    Eigen::VectorXd frequencies; ///< N_f, Hz
    Eigen::MatrixXcd responses;  ///< N_f x N_b: volts at the ceramic per volt that was asked for.
    std::vector<MeasuredAmplifier> amplifiers;
};

/** Plays each ceramic's run and fits the amplifier to what its monitor gives.
    @param bench   whose sensors are the monitors, in volts at the ceramic for m/s: one per ceramic, or one that is
   moved
    @param latency samples, of a bench without a sync channel
    @param before  called with each ceramic before it is played: to move the monitor, or to show progress
    @throws InputError  where the bench cannot play, or a monitor gives nothing; Cancelled as checkWatch()
    [worker] */
AmplifierMeasurement measureAmplifiers (Bench&, const Excitation&, double latency,
                                        const std::function<void (Eigen::Index ceramic)>& before);

/** A bench of amplifiers whose monitors are wired to the sensors' inputs, one per ceramic. */
class SimulatedAmplifiers : public Bench
{
public:
    /** @param noise  of the monitors, RMS, of the largest voltage that is played
        @param delay  s, of the interface, of the sync channel, too [any] */
    SimulatedAmplifiers (std::vector<Amplifier>, double noise, double delay, std::uint64_t seed);

    Eigen::Index sensors() const override { return std::ssize (amplifiers); }
    double fullScaleVelocity() const override;
    RunRecording play (const Excitation&, Eigen::Index ceramic, Eigen::Index firstPoint, Eigen::Index points) override;
    RunRecording playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync, double sampleRate,
                               Eigen::Index points) override;

private:
    std::vector<Amplifier> amplifiers;
    double noise, delay;
    std::uint64_t seed;
};
} // namespace antinode
