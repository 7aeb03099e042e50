#pragma once

#include <antinode_render/RenderedFocus.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The paper's experiment with two modes and two ceramics (its Fig. 4 and 9 to 11): 20 mm/s each of modes 1 and 3 at
    the centre. */
struct TwoModeCase
{
    DriveKind drive = DriveKind::paper;  ///< With its constant, or offset-free.
    double limit = 0;                    ///< V
    bool isAllocated = false;            ///< Rows (29) within the limit; else each mode by one ceramic.
    std::optional<RenderedFocus> result; ///< None if the limit cannot be met.
    double minimumPeakVoltage = 0;       ///< V: the least the drives need, where the limit cannot be met.
    double reachableVelocity = 0;        ///< m/s at the centre that the limit allows, for both modes together.
    double peakVoltage = 0;              ///< V that the design asks for, before the limiter.
};

struct TwoModeStudy
{
    std::vector<std::string> ceramics; ///< The two that play.
    std::vector<double> frequencies;   ///< Hz, of the two modes.
    std::vector<TwoModeCase> cases;    ///< Both drives, 20 V and 50 V, each without and with allocation.
};

/** The two-mode study on the demonstrator. The print does not say which ceramics were used: the pair with the least
   peak is taken.
    @param model  the demonstrator with all its ceramics
    [worker] */
TwoModeStudy evaluateTwoModes (const ModalModel&);
} // namespace antinode
