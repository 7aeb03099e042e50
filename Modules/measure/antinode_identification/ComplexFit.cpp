#include "ComplexFit.h"

namespace antinode
{
FitErrors complexErrors (const NormalModeFit& fit, const FreeResidues& residues, PreparedResponses& data)
{
    IdentifiedModes modes;
    modes.shapes = fit.modes.shapes;
    const auto coefficients = addComplexModes (modes, residues, data);
    return fitErrors (data, residues.basis, coefficients, fit.modes.delay);
}

NormalModes withPoles (NormalModes modes, const ModalBasis& basis)
{
    modes.angularFrequencies = basis.angularFrequencies;
    modes.dampingRatios = basis.dampingRatios;
    return modes;
}

std::optional<FreeResidues> fitComplexModes (const NormalModeFit& fit, const FreeResidues& residues,
                                             PreparedResponses& data, const IdentificationOptions& options,
                                             ModeKind& kind)
{
    if (! options.complexModes)
        if (auto known = evidentlyReal (fit, residues, data, options.ridge))
        {
            kind = std::move (*known);
            return {};
        }

    if (! options.complexModes.value_or (true))
        return {};

    auto complexFit = fitFreeResidues (data, fit.modes, options.ridge);

    if (! options.complexModes)
    {
        const auto realErrors = fitErrors (data, fit.state.basis, fitCoefficients (fit.state), fit.modes.delay);
        kind = decideModeKind (realErrors, complexErrors (fit, complexFit, data), complexFit, fit.modes.delay, data);

        if (! kind.areComplex)
            return {};
    }

    return complexFit;
}
} // namespace antinode
