#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <optional>
#include <vector>

namespace antinode
{
/** Of the peak field: what other repeats may leave at a focus. */
constexpr double repetitionLoss = 0.01;

/** The shortest period at which a program can be repeated without loss, that is: at this period and all longer ones
    - all other repeats together, however many, those before and those that have begun already, move the surface at
   every focus with an amplitude of at most repetitionLoss of the peak field there, and
    - the voltages of overlapping repeats, summed, keep the limits.
    @param times  of the foci, s from the trigger
    @return       s, to an eighth of a period of the program's highest frequency; none if it would be more than a minute
    [worker] Docs/Theory.md, section 6.7. */
std::optional<double> shortestPeriod (const ModalModel&, const VoltageProgram&, const std::vector<double>& times);
} // namespace antinode
