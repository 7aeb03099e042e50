#pragma once

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <nlohmann/json_fwd.hpp>

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

/** One ceramic and its amplifier while an event is repeated: means over the period. */
struct RepeatedCeramic
{
    double rmsVoltage = 0;      ///< V
    double rmsCurrent = 0;      ///< A
    double realPower = 0;       ///< W that the ceramic keeps: its own loss and the work on the body.
    double reactivePower = 0;   ///< var: sqrt ((U_rms i_rms)^2 - realPower^2).
    double dielectricPower = 0; ///< W that heat the ceramic.
    double warming = 0; ///< K above the air, in the steady state: an estimate, Docs/Theory.md, section 6.8; 0 where the
                        ///< area is unknown.
};

/** What a kind of amplifier takes from its supply and turns into heat, all channels together. */
struct AmplifierPower
{
    double supply = 0; ///< W
    double heat = 0;   ///< W
};

/** The power of an event that is repeated. */
struct RepeatedPower
{
    double rate = 0;                       ///< Repetitions per second.
    std::vector<RepeatedCeramic> ceramics; ///< N_b
    double realPower = 0;                  ///< W, of all ceramics.
    double reactivePower = 0;              ///< var, the sum of all ceramics.
    AmplifierPower linear;                 ///< Class B between rails at the voltage limit.
    AmplifierPower switching;              ///< Class D that takes energy back, recoveryEfficiency each way.
    AmplifierPower
        charge; ///< Linear as well, with a capacitor of ten times the ceramic in series that senses the charge.
    bool overlaps = false; ///< Events last longer than the period: their energies are added as if they did not meet.
};

/** The efficiency of a switching amplifier for energy to and from the ceramic: typical of full-bridge stages. */
inline constexpr double recoveryEfficiency = 0.9;

/** Watts per square metre and kelvin from a face to still air, by convection and radiation: 5 to 15 is usual. */
inline constexpr double heatTransfer = 10;

/** The heat per channel up to which a linear amplifier needs no large heat sink, W. */
inline constexpr double modestHeat = 1;

/** An event repeated so often. Idle currents of amplifiers are not counted.
    @param rate  repetitions per second, above 0
    @throws InputError  where the rate is not usable
    [any] Docs/Theory.md, section 6.8. */
RepeatedPower repeatedPower (const ModalModel&, const PowerFlow&, double rate);

/** Which kind of amplifier does, in a sentence. [any] */
std::string amplifierAdvice (const RepeatedPower&);

/** The power of an event, a focus or waveforms at fingers, or why it cannot be told. */
struct FocusPower
{
    std::string obstacle; ///< Empty where the rest holds.
    PowerFlow once;
    RepeatedPower repeated;
};

/** @param voltages     N_b x N_s, V, from rest
    @param repetitions  per second
    @throws InputError  where the repetitions are not usable; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 6.8. */
FocusPower focusPower (const ModalModel&, const Eigen::MatrixXd& voltages, Playback, double repetitions);

/** The key "power" of summary.json and design.json. [any] */
nlohmann::ordered_json powerToJson (const ModalModel&, const FocusPower&);

/** Three short sentences: current, power, amplifier; or why there are none. [any] */
std::vector<std::string> powerInWords (const ModalModel&, const FocusPower&);
} // namespace antinode
