#include "PowerSection.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

#include <cmath>

namespace antinode
{
namespace
{
std::string perSecond (const RepeatedPower& power)
{
    return inWords (power.rate) + " foci per second";
}

ReportTable onceTable (const ModalModel& model, const PowerFlow& flow)
{
    ReportTable table { "Each ceramic during one focus",
                        { "ceramic", "capacitance (nF)", "peak voltage (V)", "peak slew (V/\xC2\xB5s)",
                          "peak current (mA)",
                          "peak charge (\xC2\xB5"
                          "C)",
                          "drawn (\xC2\xB5J)", "returned (\xC2\xB5J)", "heats the ceramic (\xC2\xB5J)" },
                        {} };

    for (std::size_t i = 0; i < flow.ceramics.size(); ++i)
    {
        const auto& ceramic = flow.ceramics[i];
        table.rows.push_back ({ model.ceramics[i].name, inWords (model.ceramics[i].capacitance * 1e9),
                                inWords (ceramic.peakVoltage), inWords (ceramic.peakSlew / micro),
                                inWords (ceramic.peakCurrent * milli), inWords (ceramic.peakCharge * micro),
                                inWords (ceramic.drawn * micro), inWords (ceramic.returned * micro),
                                inWords (ceramic.dielectricLoss * micro) });
    }

    return table;
}

ReportTable repeatedTable (const ModalModel& model, const RepeatedPower& power)
{
    ReportTable table { "Each ceramic at " + perSecond (power),
                        { "ceramic", "RMS voltage (V)", "RMS current (mA)", "real power (mW)", "reactive power (mvar)",
                          "heat in the ceramic (mW)", "warming, estimate (K)" },
                        {} };

    for (std::size_t i = 0; i < power.ceramics.size(); ++i)
    {
        const auto& ceramic = power.ceramics[i];
        table.rows.push_back ({ model.ceramics[i].name, inWords (ceramic.rmsVoltage),
                                inWords (ceramic.rmsCurrent * milli), inWords (ceramic.realPower * milli),
                                inWords (ceramic.reactivePower * milli), inWords (ceramic.dielectricPower * milli),
                                model.ceramics[i].area > 0 ? inWords (ceramic.warming) : std::string ("unknown") });
    }

    return table;
}

ReportTable amplifierTable (const RepeatedPower& power)
{
    const auto row = [] (const char* kind, const AmplifierPower& amplifier) {
        return std::vector<std::string> { kind, inWords (amplifier.supply * milli), inWords (amplifier.heat * milli) };
    };
    return { "Amplifiers at " + perSecond (power) + ", all channels together, without idle currents",
             { "kind", "from the supply (mW)", "heat (mW)" },
             { row ("linear, class B, rails at the voltage limit", power.linear),
               row ("switching, class D, takes energy back at 90 % each way", power.switching),
               row ("charge, linear, sensing capacitor of ten times the ceramic", power.charge) } };
}
} // namespace

ReportSection powerSection (const RenderedFocus& focus)
{
    const auto& power = focus.power.value();
    ReportSection section;
    section.heading = "Power, energy and current";

    if (! power.obstacle.empty())
    {
        section.paragraphs = { "Unknown: " + power.obstacle + "." };
        return section;
    }

    const auto& once = power.once;
    section.paragraphs = {
        "One focus takes " + inWords (once.drawn() * micro) + " \xC2\xB5J from the amplifiers and gives back "
            + inWords (once.returned() * micro) + " \xC2\xB5J. Of the difference, "
            + inWords (once.electricalIn() * micro) + " \xC2\xB5J, dielectric loss heats the ceramics with "
            + inWords (once.dielectricLoss() * micro) + " \xC2\xB5J and damping turns "
            + inWords (once.mechanicalLoss * micro) + " \xC2\xB5J of motion into heat; "
            + inWords (once.storedAtEnd() * micro) + " \xC2\xB5J are stored at the end. This closes to "
            + inWords (100 * std::abs (once.imbalance())) + " %. The motion has at most "
            + inWords (once.peakMotion * micro) + " \xC2\xB5J. All amplifiers together give at most "
            + inWords (once.peakCurrent * milli) + " mA.",
        "At " + perSecond (power.repeated) + " the ceramics take " + inWords (power.repeated.realPower * milli)
            + " mW and " + inWords (power.repeated.reactivePower * milli) + " mvar"
            + (power.repeated.overlaps ? "; foci overlap at this rate, and their energies are added as if they did not"
                                       : "")
            + ". " + amplifierAdvice (power.repeated),
        "Dielectric loss is that of small signals; at high fields it is several times as large. The warming is a "
        "steady state in still air with 10 W/(m\xC2\xB2 K) from one face; conduction into the body lowers it."
    };
    section.tables = { onceTable (focus.model, once), repeatedTable (focus.model, power.repeated),
                       amplifierTable (power.repeated) };
    return section;
}
} // namespace antinode
