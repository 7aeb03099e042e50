#pragma once

#include "PowerFlow.h"

namespace antinode
{
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
} // namespace antinode
