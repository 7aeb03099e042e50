#pragma once

#include "ComplexModes.h"
#include "FitErrors.h"

#include <string>

namespace antinode
{
/** Whether a device's modes are complex, and why. */
struct ModeKind
{
    bool areComplex = false;
    std::string reason; ///< A sentence.
};

/** What F with so many numbers, and many more values, exceeds with a probability of 0.1 %: Wilson and Hilferty's cube.
    [any] */
double limitOfRatio (double numbers);

/** Whether complex modes are worth a fit: real ones leave more than rounding and traces, and free
   residues at the same poles leave less by more than noise.
    @return  nothing if they are, else the reason why modes are real
    [worker] Docs/Theory.md, section 8.4. */
std::optional<ModeKind> evidentlyReal (const NormalModeFit&, const FreeResidues&, const PreparedResponses&,
                                       double ridge);

/** Whether modes are complex: by an F test of the errors of both fits, with a risk of 0.1 % to call real modes complex
   under white noise; if complex shapes explain at least two thirds of what real ones leave above the noise; and if the
   phases are not those of channels.
    @param realErrors, complexErrors  of the best fits of the same modes
    @param complexFit                 its free residues, behind the delay
    [worker] Docs/Theory.md, section 8.4; Docs/Design/identification.md */
ModeKind decideModeKind (const FitErrors& realErrors, const FitErrors& complexErrors, const FreeResidues& complexFit,
                         double delay, const PreparedResponses&);
} // namespace antinode
