#include "FocusPower.h"

#include <antinode_base/NumberText.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr double thousand = 1e3, million = 1e6, billion = 1e9;

nlohmann::ordered_json ceramicToJson (const Ceramic& ceramic, const CeramicFlow& once, const RepeatedCeramic& repeated)
{
    nlohmann::ordered_json json { { "name", ceramic.name },
                                  { "capacitance_nF", ceramic.capacitance * billion },
                                  { "loss_factor", ceramic.lossFactor },
                                  { "peak_voltage_V", once.peakVoltage },
                                  { "peak_slew_V_per_us", once.peakSlew / million },
                                  { "peak_current_mA", once.peakCurrent * thousand },
                                  { "peak_charge_uC", once.peakCharge * million },
                                  { "energy_drawn_uJ", once.drawn * million },
                                  { "energy_returned_uJ", once.returned * million },
                                  { "dielectric_loss_uJ", once.dielectricLoss * million },
                                  { "work_on_motion_uJ", once.work * million },
                                  { "rms_voltage_V", repeated.rmsVoltage },
                                  { "rms_current_mA", repeated.rmsCurrent * thousand },
                                  { "real_power_mW", repeated.realPower * thousand },
                                  { "reactive_power_mvar", repeated.reactivePower * thousand },
                                  { "dielectric_power_mW", repeated.dielectricPower * thousand } };

    if (ceramic.area > 0)
        json["warming_estimate_K"] = repeated.warming;

    return json;
}

nlohmann::ordered_json amplifierToJson (const AmplifierPower& amplifier)
{
    return { { "supply_mW", amplifier.supply * thousand }, { "heat_mW", amplifier.heat * thousand } };
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
                                    { { "electrical_in_uJ", once.electricalIn() * million },
                                      { "drawn_uJ", once.drawn() * million },
                                      { "returned_uJ", once.returned() * million },
                                      { "dielectric_loss_uJ", once.dielectricLoss() * million },
                                      { "mechanical_loss_uJ", once.mechanicalLoss * million },
                                      { "stored_at_end_uJ", once.storedAtEnd() * million },
                                      { "peak_energy_of_motion_uJ", once.peakMotion * million },
                                      { "imbalance", once.imbalance() },
                                      { "peak_current_mA", once.peakCurrent * thousand },
                                      { "peak_power_mW", once.peakPower * thousand } } },
                                  { "repeated",
                                    { { "per_second", repeated.rate },
                                      { "overlapping", repeated.overlaps },
                                      { "real_power_mW", repeated.realPower * thousand },
                                      { "reactive_power_mvar", repeated.reactivePower * thousand } } },
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
    const auto often = " at " + inWords (repeated.rate) + " foci per second";
    return { inWords (once.ceramics[most].peakCurrent * thousand) + " mA at most (" + model.ceramics[most].name + "), "
                 + inWords (once.peakCurrent * thousand) + " mA in all; "
                 + inWords (repeated.ceramics[most].rmsCurrent * thousand) + " mA RMS" + often + "; slew at most "
                 + inWords (once.ceramics[slewest].peakSlew / million) + " V/us",
             inWords (once.electricalIn() * million) + " uJ per focus, " + inWords (once.dielectricLoss() * million)
                 + " uJ of them heat the ceramics; " + inWords (repeated.realPower * thousand) + " mW and "
                 + inWords (repeated.reactivePower * thousand) + " mvar" + often
                 + (repeated.overlaps ? ", which overlap: added as if they did not" : ""),
             amplifierAdvice (repeated) };
}
} // namespace antinode
