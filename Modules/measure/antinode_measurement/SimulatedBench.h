#pragma once

#include "Excitation.h"
#include "RunAnalysis.h"

#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <vector>

namespace antinode
{
/** A simulated bench: its sensors, amplifiers and converters. */
struct SimulatedBenchSettings
{
    double sampleRate = 96000; ///< Hz
    double signalToNoise =
        40; ///< dB: effective value of each sensor over that of its white noise, while the surface moves.
    double delay = 0.00123456; ///< s, from output to input, of sensors and sync channel alike.
    double cubic =
        0; ///< Share of the voltage cubed: u becomes u (1 + cubic (u / largest)^2), as ceramics with hysteresis do.
    std::uint64_t seed = 1; ///< Of the noise.
};

/** The recording of the sensors of such a bench for played voltages: each mode's response, line by line of a transform
   so long that nothing folds.

    @param shapes    N x N_m: the rows of mode shapes at the sensors (shapesAt), kg^-1/2
    @param voltages  N_b x N_s, V, of ceramics; silent at the end
    @param sync      N_s: what the sync channel plays; it returns delayed and otherwise as it is
    @return          N_s samples of every channel; no reference
    @throws InputError  where sizes do not agree or a number is not usable
    [worker] Docs/Theory.md, section 8.10. */
RunRecording simulateBench (const ModalModel&, const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& voltages,
                            const Eigen::VectorXd& sync, const SimulatedBenchSettings&);

/** A sensor's signal while one ceramic plays, as the modes predict it. */
struct ExpectedSignal
{
    double peak = 0;      ///< m/s
    double effective = 0; ///< RMS value while the excitation plays, m/s.
};

/** A mode that a sensor should see. */
struct ExpectedResonance
{
    double frequency = 0;     ///< Hz
    double response = 0;      ///< (m/s)/V, of the ceramic that drives it most.
    Eigen::Index ceramic = 0; ///< That ceramic, from 0.
};

/** What a ceramic's amplifier must give for an excitation. */
struct ExcitationLoad
{
    double slew = 0;         ///< Largest |dU/dt|, V/s.
    double current = 0;      ///< Largest current into the capacitance, A; 0 where the capacitance is unknown.
    double highestLevel = 0; ///< The peak voltage at which slew and current limits are just kept, V; 0: no such limit.
};

/** The signals at one place, ceramic by ceramic: the simulated bench without noise and delay.
    @param shapes  N_m: the row of mode shapes at the place (shapesAt), kg^-1/2
    @return        N_b
    @throws InputError  as simulateBench [worker] */
std::vector<ExpectedSignal> expectedSignals (const ModalModel&, const Eigen::RowVectorXd& shapes, const Excitation&);

/** The modes of a band with the largest response at one place, the strongest first.
    @param shapes  N_m, as above
    @param count   at most so many
    [worker] Docs/Theory.md, section 8.1. */
std::vector<ExpectedResonance> strongestResonances (const ModalModel&, const Eigen::RowVectorXd& shapes,
                                                    double lowestFrequency, double highestFrequency, std::size_t count);

/** The magnitude of a ceramic's response at one place and frequency, (m/s)/V.
    @param shapes     N_m, as above
    @param frequency  Hz
    [worker] Docs/Theory.md, section 8.1. */
double expectedResponse (const ModalModel&, const Eigen::RowVectorXd& shapes, Eigen::Index ceramic, double frequency);

/** The load of each ceramic's amplifier, of the band-limited waveform through the excitation's samples: N_b. [worker]
 */
std::vector<ExcitationLoad> excitationLoads (const ModalModel&, const Excitation&);
} // namespace antinode
