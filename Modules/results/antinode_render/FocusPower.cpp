#include "FocusPower.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace antinode
{
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
    const auto often = " at " + inWords (repeated.rate) + " foci per second";
    return { inWords (once.ceramics[most].peakCurrent * milli) + " mA at most (" + model.ceramics[most].name + "), "
                 + inWords (once.peakCurrent * milli) + " mA in all; "
                 + inWords (repeated.ceramics[most].rmsCurrent * milli) + " mA RMS" + often + "; slew at most "
                 + inWords (once.ceramics[slewest].peakSlew / micro) + " V/us",
             inWords (once.electricalIn() * micro) + " uJ per focus, " + inWords (once.dielectricLoss() * micro)
                 + " uJ of them heat the ceramics; " + inWords (repeated.realPower * milli) + " mW and "
                 + inWords (repeated.reactivePower * milli) + " mvar" + often
                 + (repeated.overlaps ? ", which overlap: added as if they did not" : ""),
             amplifierAdvice (repeated) };
}
} // namespace antinode
