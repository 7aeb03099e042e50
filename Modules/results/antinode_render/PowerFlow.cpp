#include "PowerFlow.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_numerics/Fourier.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
double total (const std::vector<CeramicFlow>& ceramics, double CeramicFlow::*amount)
{
    double sum = 0;

    for (const auto& ceramic : ceramics)
        sum += ceramic.*amount;

    return sum;
}

/** N_b: the part of each capacitance that the modes store as they follow a constant voltage, F. */
Eigen::VectorXd modalCapacitances (const ModalModel& model)
{
    return (model.angularFrequencies.cwiseInverse().asDiagonal() * model.participation).colwise().squaredNorm();
}

/** The motion as the ceramics feel it, sample by sample. */
struct BodyMotion
{
    Eigen::MatrixXd charge;  ///< N_b x (N_s + 1): participation by modal displacement, C.
    Eigen::MatrixXd current; ///< N_b x N_s: participation by modal velocity, A.
};

/** Moves the body by the voltages and notes its energies. */
BodyMotion moveBody (const ModalModel& model, const Eigen::MatrixXd& voltages, Playback playback, PowerFlow& flow)
{
    constexpr Eigen::Index blockSize = 128;
    const auto samples = voltages.cols(), actuators = voltages.rows(), modes = model.modes();
    const Eigen::ArrayXd stiffness = model.angularFrequencies.array().square(),
                         damping = 2 * decayRates (model).array();
    PlateModel plate (model, playback, Eigen::MatrixXd (0, modes));
    BodyMotion felt { Eigen::MatrixXd::Zero (actuators, samples + 1), Eigen::MatrixXd::Zero (actuators, samples) };
    Eigen::MatrixXd velocities (modes, blockSize), displacements (modes, blockSize);
    const Eigen::VectorXd silence = Eigen::VectorXd::Zero (actuators);

    for (Eigen::Index n = 0; n < plate.latencySamples(); ++n)
        plate.processModes (n < samples ? voltages.col (n) : silence, velocities.leftCols (1));

    for (Eigen::Index first = 0; first <= samples; first += blockSize)
    {
        checkWatch();
        const auto count = std::min (blockSize, samples + 1 - first);

        for (Eigen::Index n = 0; n < count; ++n)
        {
            const auto fed = first + n + plate.latencySamples();
            plate.processModes (fed < samples ? voltages.col (fed) : silence, velocities.col (n));
            displacements.col (n) = plate.modalDisplacements();
            const auto& velocity = plate.modalVelocities();
            flow.motionAtEnd =
                0.5 * (velocity.squaredNorm() + (stiffness * displacements.col (n).array().square()).sum());
            flow.peakMotion = std::max (flow.peakMotion, flow.motionAtEnd);
            flow.mechanicalLoss += (damping * velocity.array().square()).sum() / playback.sampleRate;
        }

        felt.charge.middleCols (first, count) = model.participation.transpose() * displacements.leftCols (count);
        const auto kept = std::min (count, samples - first);
        felt.current.middleCols (first, kept) = model.participation.transpose() * velocities.leftCols (kept);
    }

    return felt;
}

/** The slope of the band-limited waveform through samples, and the current per farad of a loss factor of 1: whose phase
   is that of the voltage, whose size grows with the frequency. */
struct Slopes
{
    Eigen::VectorXd rate, loss; ///< V/s
};

Slopes waveformSlopes (const Eigen::VectorXd& voltage, double sampleRate)
{
    const auto length = quickLength (2.0 * static_cast<double> (voltage.size()));
    const auto perLine = 2 * std::numbers::pi * sampleRate / static_cast<double> (length);
    auto rate = forwardFourier (voltage, length);
    auto loss = rate;

    for (Eigen::Index k = 0; k < rate.size(); ++k)
    {
        const auto omega = perLine * static_cast<double> (k);
        rate[k] *= std::complex<double> (0, 2 * k == length ? 0 : omega);
        loss[k] *= omega;
    }

    return { inverseFourier (rate, length).head (voltage.size()), inverseFourier (loss, length).head (voltage.size()) };
}

/** One ceramic, sample by sample. */
struct SampledFlow
{
    Eigen::ArrayXd voltage, rate, charge, current, lost; ///< V, V/s, C, A, and the part of the current that is lost, A.
};

SampledFlow sampledFlow (const Eigen::VectorXd& voltage, const Ceramic& ceramic, double modalCapacitance,
                         const Eigen::VectorXd& feltCharge, const Eigen::VectorXd& feltCurrent, double sampleRate)
{
    const auto slopes = waveformSlopes (voltage, sampleRate);
    const auto held = ceramic.capacitance - modalCapacitance;
    SampledFlow flow { voltage.array(),
                       slopes.rate.array(),
                       held * voltage.array() + feltCharge.array(),
                       {},
                       ceramic.capacitance * ceramic.lossFactor * slopes.loss.array() };
    flow.current = held * flow.rate + flow.lost + feltCurrent.array();
    return flow;
}

CeramicFlow summedFlow (const SampledFlow& flow, const Eigen::VectorXd& feltCurrent, double held, double sampleRate)
{
    const Eigen::ArrayXd power = flow.voltage * flow.current;
    CeramicFlow sums;
    sums.peakVoltage = flow.voltage.abs().maxCoeff();
    sums.peakSlew = flow.rate.abs().maxCoeff();
    sums.peakCurrent = flow.current.abs().maxCoeff();
    sums.peakCharge = flow.charge.abs().maxCoeff();
    sums.voltageSquaredTime = flow.voltage.square().sum() / sampleRate;
    sums.currentSquaredTime = flow.current.square().sum() / sampleRate;
    sums.currentMagnitudeTime = flow.current.abs().sum() / sampleRate;
    sums.drawn = power.max (0).sum() / sampleRate;
    sums.returned = -power.min (0).sum() / sampleRate;
    sums.dielectricLoss = (flow.voltage * flow.lost).sum() / sampleRate;
    sums.work = (flow.voltage * feltCurrent.array()).sum() / sampleRate;
    sums.storedAtEnd = 0.5 * held * flow.voltage.tail<1>().square().value();
    return sums;
}

/** s until all voltages stay 0. */
double playedDuration (const Eigen::MatrixXd& voltages, double sampleRate)
{
    auto end = voltages.cols();

    while (end > 0 && (voltages.col (end - 1).array() == 0).all())
        --end;

    return static_cast<double> (end) / sampleRate;
}
} // namespace

double PowerFlow::drawn() const
{
    return total (ceramics, &CeramicFlow::drawn);
}

double PowerFlow::returned() const
{
    return total (ceramics, &CeramicFlow::returned);
}

double PowerFlow::dielectricLoss() const
{
    return total (ceramics, &CeramicFlow::dielectricLoss);
}

double PowerFlow::storedAtEnd() const
{
    return motionAtEnd + total (ceramics, &CeramicFlow::storedAtEnd);
}

double PowerFlow::imbalance() const
{
    const auto in = electricalIn();
    return in == 0 ? 0 : (in - storedAtEnd() - dielectricLoss() - mechanicalLoss) / in;
}

std::string powerObstacle (const ModalModel& model)
{
    if (model.hasComplexModes())
        return "the energies of complex modes do not add up; use a device with real modes and no fingers";

    if (! model.origin.scaleIsKnown)
        return "the size of its shapes is a convention; identify the device with --mass-kg, or with a driving point";

    const auto modal = modalCapacitances (model);

    for (std::size_t i = 0; i < model.ceramics.size(); ++i)
    {
        const auto& ceramic = model.ceramics[i];
        const auto least = modal[static_cast<Eigen::Index> (i)];

        if (! (ceramic.capacitance > 0))
            return "the capacitance of ceramic '" + ceramic.name + "' is not known; give its capacitance_nF";

        if (ceramic.capacitance < least)
            return "the capacitance of ceramic '" + ceramic.name + "', " + inWords (ceramic.capacitance * nano)
                   + " nF, is less than its participation in the modes implies, " + inWords (least * nano)
                   + " nF; correct one of them";
    }

    return {};
}

PowerFlow powerFlow (const ModalModel& model, const Eigen::MatrixXd& voltages, Playback playback)
{
    if (const auto obstacle = powerObstacle (model); ! obstacle.empty())
        throw InputError ("power", "cannot be told: " + obstacle);

    if (voltages.rows() != model.actuators() || voltages.cols() == 0 || std::ssize (model.ceramics) != voltages.rows())
        throw InputError ("power", "needs the voltages of all ceramics of the device");

    const auto rate = playback.sampleRate;
    const auto samples = voltages.cols();
    PowerFlow flow;
    flow.duration = playedDuration (voltages, rate);
    auto felt = moveBody (model, voltages, playback, flow);

    if (playback.reconstruction == Reconstruction::zeroOrderHold) // The mean over the time that a voltage is held.
        felt.current = (felt.charge.rightCols (samples) - felt.charge.leftCols (samples)) * rate;

    const auto modal = modalCapacitances (model);
    Eigen::ArrayXd currents = Eigen::ArrayXd::Zero (samples), powers = currents;

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
    {
        checkWatch();
        const auto& ceramic = model.ceramics[static_cast<std::size_t> (i)];
        const auto sampled = sampledFlow (voltages.row (i), ceramic, modal[i], felt.charge.row (i).head (samples),
                                          felt.current.row (i), rate);
        currents += sampled.current.abs();
        powers += sampled.voltage * sampled.current;
        flow.ceramics.push_back (summedFlow (sampled, felt.current.row (i), ceramic.capacitance - modal[i], rate));
    }

    flow.peakCurrent = currents.maxCoeff();
    flow.peakPower = powers.maxCoeff();
    return flow;
}

namespace
{
/** Heat that leaves by one face only: the other is glued to the body, which takes heat away as well, so the ceramic
   stays cooler. */
double estimatedWarming (double heat, double area)
{
    return area > 0 ? heat / (heatTransfer * area) : 0;
}

RepeatedCeramic repeatedCeramic (const CeramicFlow& flow, double area, double rate)
{
    RepeatedCeramic result;
    result.rmsVoltage = std::sqrt (flow.voltageSquaredTime * rate);
    result.rmsCurrent = std::sqrt (flow.currentSquaredTime * rate);
    result.realPower = (flow.drawn - flow.returned) * rate;
    const auto apparent = result.rmsVoltage * result.rmsCurrent;
    result.reactivePower = std::sqrt (std::max (0.0, apparent * apparent - result.realPower * result.realPower));
    result.dielectricPower = flow.dielectricLoss * rate;
    result.warming = estimatedWarming (result.dielectricPower, area);
    return result;
}
} // namespace

RepeatedPower repeatedPower (const ModalModel& model, const PowerFlow& flow, double rate)
{
    if (! (rate >= 1e-6 && rate <= 1e6))
        throw InputError ("repetition rate", "is " + inWords (rate) + " per second; allowed: 0.000001 to 1000000");

    constexpr auto sensing = 0.1; // of the voltage, across the capacitor of a charge amplifier
    RepeatedPower result;
    result.rate = rate;
    result.overlaps = flow.duration * rate > 1;

    for (std::size_t i = 0; i < flow.ceramics.size(); ++i)
    {
        const auto& ceramic = flow.ceramics[i];
        result.ceramics.push_back (repeatedCeramic (ceramic, model.ceramics[i].area, rate));
        result.realPower += result.ceramics.back().realPower;
        result.reactivePower += result.ceramics.back().reactivePower;
        // A rail gives the current whichever way the energy goes.
        result.linear.supply += model.ceramics[i].voltageLimit * ceramic.currentMagnitudeTime * rate;
        result.switching.supply += (ceramic.drawn / recoveryEfficiency - ceramic.returned * recoveryEfficiency) * rate;
    }

    result.charge.supply = result.linear.supply * (1 + sensing);

    for (auto* const amplifier : { &result.linear, &result.switching, &result.charge })
        amplifier->heat = amplifier->supply - result.realPower;

    return result;
}

std::string amplifierAdvice (const RepeatedPower& power)
{
    const auto perChannel = power.linear.heat / static_cast<double> (std::max<std::size_t> (1, power.ceramics.size()));
    const auto linear = inWords (perChannel) + " W of heat per channel";

    if (perChannel <= modestHeat)
        return "A linear amplifier (class B) does: " + linear
               + ". A charge amplifier does too, and makes the motion follow more exactly at high fields.";

    return "A linear amplifier (class B) needs a heat sink for " + linear
           + "; a switching amplifier that takes the energy back (class D) turns "
           + inWords (power.switching.heat / static_cast<double> (power.ceramics.size())) + " W per channel into heat.";
}

namespace
{
nlohmann::ordered_json ceramicToJson (const Ceramic& ceramic, const CeramicFlow& once, const RepeatedCeramic& repeated)
{
    nlohmann::ordered_json json { { "name", ceramic.name },
                                  { "capacitance_nF", ceramic.capacitance * nano },
                                  { "loss_factor", ceramic.lossFactor },
                                  { "peak_voltage_V", once.peakVoltage },
                                  { "peak_slew_V_per_us", once.peakSlew / micro },
                                  { "peak_current_mA", once.peakCurrent * milli },
                                  { "peak_charge_uC", once.peakCharge * micro },
                                  { "energy_drawn_uJ", once.drawn * micro },
                                  { "energy_returned_uJ", once.returned * micro },
                                  { "dielectric_loss_uJ", once.dielectricLoss * micro },
                                  { "work_on_motion_uJ", once.work * micro },
                                  { "rms_voltage_V", repeated.rmsVoltage },
                                  { "rms_current_mA", repeated.rmsCurrent * milli },
                                  { "real_power_mW", repeated.realPower * milli },
                                  { "reactive_power_mvar", repeated.reactivePower * milli },
                                  { "dielectric_power_mW", repeated.dielectricPower * milli } };

    if (ceramic.area > 0)
        json["warming_estimate_K"] = repeated.warming;

    return json;
}

nlohmann::ordered_json amplifierToJson (const AmplifierPower& amplifier)
{
    return { { "supply_mW", amplifier.supply * milli }, { "heat_mW", amplifier.heat * milli } };
}

/** The ceramic with the largest amount. */
std::size_t largestBy (const std::vector<CeramicFlow>& ceramics, double CeramicFlow::*amount)
{
    const auto less = [amount] (const auto& a, const auto& b) { return a.*amount < b.*amount; };
    return static_cast<std::size_t> (std::max_element (ceramics.begin(), ceramics.end(), less) - ceramics.begin());
}
} // namespace

FocusPower focusPower (const ModalModel& model, const Eigen::MatrixXd& voltages, Playback playback, double repetitions)
{
    FocusPower power;
    power.obstacle = powerObstacle (model);

    if (power.obstacle.empty())
        power.once = powerFlow (model, voltages, playback);

    power.repeated = repeatedPower (model, power.once, repetitions);
    return power;
}

nlohmann::ordered_json powerToJson (const ModalModel& model, const FocusPower& power)
{
    if (! power.obstacle.empty())
        return { { "unknown", power.obstacle } };

    const auto& once = power.once;
    const auto& repeated = power.repeated;
    nlohmann::ordered_json json { { "per_focus",
                                    { { "electrical_in_uJ", once.electricalIn() * micro },
                                      { "drawn_uJ", once.drawn() * micro },
                                      { "returned_uJ", once.returned() * micro },
                                      { "dielectric_loss_uJ", once.dielectricLoss() * micro },
                                      { "mechanical_loss_uJ", once.mechanicalLoss * micro },
                                      { "stored_at_end_uJ", once.storedAtEnd() * micro },
                                      { "peak_energy_of_motion_uJ", once.peakMotion * micro },
                                      { "imbalance", once.imbalance() },
                                      { "peak_current_mA", once.peakCurrent * milli },
                                      { "peak_power_mW", once.peakPower * milli } } },
                                  { "repeated",
                                    { { "per_second", repeated.rate },
                                      { "overlapping", repeated.overlaps },
                                      { "real_power_mW", repeated.realPower * milli },
                                      { "reactive_power_mvar", repeated.reactivePower * milli } } },
                                  { "amplifier",
                                    { { "linear_class_B", amplifierToJson (repeated.linear) },
                                      { "switching_class_D", amplifierToJson (repeated.switching) },
                                      { "charge", amplifierToJson (repeated.charge) },
                                      { "advice", amplifierAdvice (repeated) } } } };

    for (std::size_t i = 0; i < once.ceramics.size(); ++i)
        json["ceramics"].push_back (ceramicToJson (model.ceramics[i], once.ceramics[i], repeated.ceramics[i]));

    return json;
}

std::vector<std::string> powerInWords (const ModalModel& model, const FocusPower& power)
{
    if (! power.obstacle.empty())
        return { "unknown: " + power.obstacle };

    const auto& once = power.once;
    const auto& repeated = power.repeated;
    const auto most = largestBy (once.ceramics, &CeramicFlow::peakCurrent);
    const auto slewest = largestBy (once.ceramics, &CeramicFlow::peakSlew);
    const auto often = " at " + inWords (repeated.rate) + " events per second";
    return { inWords (once.ceramics[most].peakCurrent * milli) + " mA at most (" + model.ceramics[most].name + "), "
                 + inWords (once.peakCurrent * milli) + " mA in all; "
                 + inWords (repeated.ceramics[most].rmsCurrent * milli) + " mA RMS" + often + "; slew at most "
                 + inWords (once.ceramics[slewest].peakSlew / micro) + " V/us",
             inWords (once.electricalIn() * micro) + " uJ per event, " + inWords (once.dielectricLoss() * micro)
                 + " uJ of them heat the ceramics; " + inWords (repeated.realPower * milli) + " mW and "
                 + inWords (repeated.reactivePower * milli) + " mvar" + often
                 + (repeated.overlaps ? ", which overlap: added as if they did not" : ""),
             amplifierAdvice (repeated) };
}
} // namespace antinode
