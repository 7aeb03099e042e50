#include "RepeatedPower.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
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
} // namespace antinode
