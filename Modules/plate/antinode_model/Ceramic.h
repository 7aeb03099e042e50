#pragma once

#include <antinode_outline/Outline.h>

#include <string>

namespace antinode
{
/** The dielectric loss factor of soft ceramics (PZT-5A) at low fields: taken where none is given. */
inline constexpr double usualLossFactor = 0.02;

/** By how much a ceramic's motion comes after the voltage that is asked for, beside what all modes do. Docs/Theory.md,
   section 7.9. */
struct InputLag
{
    double delay = 0;        ///< s, 0 or more: after the ceramic that is first.
    double timeConstant = 0; ///< s, of a low-pass of first order.
    double angle = 0;        ///< rad, the same at all frequencies: hysteresis.

    bool operator== (const InputLag&) const = default;
};

/** A ceramic (bimorph): its extent and limits. Ceramic k is output channel k. */
struct Ceramic
{
    std::string name;
    double xMinimum = 0, xMaximum = 0;   ///< Extent, m.
    double yMinimum = 0, yMaximum = 0;   ///< Extent, m; both 0 on a line.
    double voltageLimit = 0;             ///< U_max, V, at least 0.
    double slewLimit = 0;                ///< max |dU/dt|, V/s, whatever it follows from; 0: none.
    double capacitance = 0;              ///< What its amplifier charges, F; 0: unknown.
    double lossFactor = usualLossFactor; ///< tan delta of the capacitance.
    double area = 0;                     ///< Of one face, m^2; 0: unknown.
    double currentLimit = 0;     ///< Of its amplifier, A; 0: none. With the capacitance it limits the slew rate.
    double amplifierVoltage = 0; ///< What its amplifier gives for a full-scale sample, V; 0: the device's full scale.
    InputLag lag {};             ///< Undone before the outputs.
    Outline outline {}; ///< m, of one that does not fill its extent: a disc, a ring, a turned rectangle; else empty.
};
} // namespace antinode
