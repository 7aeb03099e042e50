#include "ComplexModes.h"

#include "ChannelPhases.h"

#include <antinode_base/MessageText.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
/** The strongest product in a table of complex residues, its shape turned to the real axis and as long as the real one.
 */
void splitResidues (IdentifiedModes& modes, Eigen::Index mode, const Eigen::MatrixXcd& table)
{
    const auto direction = largestEigenpair (adjointGram (table)).vector;
    Eigen::VectorXcd shape = table * direction;
    const Eigen::VectorXd real = modes.shapes.col (mode).array().isFinite().select (modes.shapes.col (mode), 0);
    const auto squares = (shape.transpose() * shape) (0, 0);
    auto factor = std::polar (real.norm() / std::max (shape.norm(), 1e-300), -std::arg (squares) / 2);

    if ((shape * factor).real().dot (real) < 0)
        factor = -factor;

    modes.complexShapes.col (mode) = shape * factor;
    modes.complexParticipation.row (mode) = direction.adjoint() / factor;
}

/** Coefficients of the modes' functions: velocity and delay; together with a constant they are any complex residue. */
Eigen::MatrixXd functionAmplitudes (const IdentifiedModes& modes, const ModalBasis& basis)
{
    const auto points = modes.complexShapes.rows(), references = modes.complexParticipation.cols();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (basis.modalColumns(), points * references);

    for (Eigen::Index k = 0; k < basis.modes(); ++k)
    {
        const auto resonance = basis.angularFrequencies[k], damping = basis.dampingRatios[k];
        const Eigen::MatrixXcd products = modes.complexShapes.col (k) * modes.complexParticipation.row (k);
        const Eigen::RowVectorXcd flat = products.reshaped().transpose();
        const auto ofDelay = basis.column (k, ModalFunction::delay);
        result.row (ofDelay) = -flat.imag() / (resonance * std::sqrt (1 - damping * damping));
        result.row (basis.column (k, ModalFunction::velocity)) =
            flat.real() / resonance - damping * result.row (ofDelay);
    }

    return result;
}

using Indices = std::vector<Eigen::Index>;
constexpr std::array values { ModalFunction::velocity, ModalFunction::delay };
/** By the unknown, frequency or damping, and the function of which they are derivatives. */
constexpr std::array<std::array<ModalFunction, 2>, 2> derivatives {
    { { ModalFunction::frequency, ModalFunction::delayFrequency },
      { ModalFunction::damping, ModalFunction::delayDamping } }
};

void appendColumns (Indices& to, const ModalBasis& basis, ModalFunction function)
{
    for (Eigen::Index k = 0; k < basis.modes(); ++k)
        to.push_back (basis.column (k, function));
}

ModalBasis stepped (ModalBasis basis, const Eigen::VectorXd& step)
{
    for (Eigen::Index k = 0; k < basis.modes(); ++k)
    {
        basis.angularFrequencies[k] *= 1 + basis.dampingRatios[k] * std::clamp (step[k], -1.0, 1.0);
        basis.dampingRatios[k] = std::clamp (
            basis.dampingRatios[k] * std::exp (std::clamp (step[basis.modes() + k], -0.7, 0.7)), 1e-9, 0.999);
    }

    return basis;
}
} // namespace

PoleEquations poleEquations (const ModalBasis& basis, const ModalProducts& products,
                             const Eigen::VectorXd& columnWeights, double ridge)
{
    const auto reduced = withoutPowers (basis, products);
    const auto modes = basis.modes();
    Indices linear, nonlinear;

    for (const auto function : values)
        appendColumns (linear, basis, function);

    for (const auto& ofUnknown : derivatives)
        for (const auto function : ofUnknown)
            appendColumns (nonlinear, basis, function);

    const auto between = Eigen::MatrixXd (reduced.gram (linear, nonlinear));
    const auto data = Eigen::MatrixXd (reduced.data (linear, Eigen::all));
    const auto coefficients = solveEven (reduced.gram (linear, linear), data, ridge);
    const Eigen::MatrixXd gram = reduced.gram (nonlinear, nonlinear)
                                 - between.transpose() * solveEven (reduced.gram (linear, linear), between, ridge);
    const Eigen::MatrixXd errors = reduced.data (nonlinear, Eigen::all) - between.transpose() * coefficients;
    const Eigen::MatrixXd weighted = coefficients * columnWeights.asDiagonal();
    const Eigen::MatrixXd pairs = weighted * coefficients.transpose();
    PoleEquations result {
        Eigen::MatrixXd::Zero (2 * modes, 2 * modes), Eigen::MatrixXd::Zero (2 * modes, products.data.cols()),
        (reduced.energies - data.cwiseProduct (coefficients).colwise().sum().transpose()).dot (columnWeights)
    };

    // The coefficients of the functions that an unknown changes multiply what it changes of them.
    for (Eigen::Index a = 0; a < 2; ++a)
        for (Eigen::Index u = 0; u < 2; ++u)
        {
            result.scores.middleRows (a * modes, modes) +=
                errors.middleRows ((2 * a + u) * modes, modes).cwiseProduct (weighted.middleRows (u * modes, modes));

            for (Eigen::Index b = 0; b < 2; ++b)
                for (Eigen::Index v = 0; v < 2; ++v)
                    result.matrix.block (a * modes, b * modes, modes, modes) +=
                        gram.block ((2 * a + u) * modes, (2 * b + v) * modes, modes, modes)
                            .cwiseProduct (pairs.block (u * modes, v * modes, modes, modes));
        }

    return result;
}

FreeResidues fitFreeResidues (const PreparedResponses& data, const NormalModes& start, double ridge)
{
    constexpr int maximumIterations = 12;
    constexpr int maximumHalvings = 6;
    constexpr double minimumGain = 1e-9; // relative, of the cost
    constexpr double negligible = 1e-7;  // the same, of what a step promises
    auto basis = makeBasis (start.angularFrequencies, start.dampingRatios, data);
    basis.functions = complexModeFunctions;
    const auto moments = lineMoments (data, start.delay);
    auto products = modalProducts (basis, data, moments, start.delay);
    auto equations = poleEquations (basis, products, data.columnWeights, ridge);

    auto isConverged = false;

    for (int iteration = 0; iteration < maximumIterations && ! isConverged; ++iteration)
    {
        const Eigen::VectorXd gradient = equations.scores.rowwise().sum();
        Eigen::VectorXd step = solveEven (equations.matrix, gradient, 1e-9);
        const auto promised = step.dot (gradient);
        auto isBetter = false;

        // Where poles are far from theirs, a whole step may lead away.
        for (int halved = 0; halved < maximumHalvings && ! isBetter && ! isConverged; ++halved, step *= 0.5)
        {
            const auto next = stepped (basis, step);
            auto nextProducts = modalProducts (next, data, moments, start.delay);
            auto nextEquations = poleEquations (next, nextProducts, data.columnWeights, ridge);
            isBetter = nextEquations.cost <= equations.cost * (1 - minimumGain);

            if (isBetter)
            {
                basis = next;
                products = std::move (nextProducts);
                equations = std::move (nextEquations);
            }
            else
                isConverged = promised <= negligible * equations.cost;
        }

        if (! isBetter)
            break;
    }

    auto residues = complexResidues (basis, products, ridge);
    return { std::move (basis), std::move (products), std::move (residues), isConverged };
}

FreeResidues freeResidues (const FitState& state, double ridge)
{
    return { state.basis, state.products, complexResidues (state.basis, state.products, ridge), true };
}

double freeCost (const FreeResidues& fit, const Eigen::VectorXd& columnWeights, double ridge)
{
    const auto reduced = withoutPowers (fit.basis, fit.products);
    Indices linear;

    for (const auto function : values)
        appendColumns (linear, fit.basis, function);

    const Eigen::MatrixXd data = reduced.data (linear, Eigen::all);
    const auto coefficients = solveEven (reduced.gram (linear, linear), data, ridge);
    return (reduced.energies - data.cwiseProduct (coefficients).colwise().sum().transpose()).dot (columnWeights);
}

Eigen::MatrixXd addComplexModes (IdentifiedModes& modes, const FreeResidues& fit, const PreparedResponses& data)
{
    const auto points = data.points(), references = data.references();
    const auto& basis = fit.basis;
    modes.complexShapes.resize (points, basis.modes());
    modes.complexParticipation.resize (basis.modes(), references);

    for (Eigen::Index k = 0; k < basis.modes(); ++k)
        splitResidues (modes, k, fit.residues.row (k).reshaped (points, references));

    const auto amplitudes = functionAmplitudes (modes, basis);
    Eigen::MatrixXd coefficients (basis.size(), data.columns());
    coefficients << amplitudes, powerCoefficients (basis, fit.products, amplitudes);
    modes.residuals.clear();

    for (std::size_t n = 0; n < basis.powers.size(); ++n)
    {
        const auto power = basis.powers[n];
        Eigen::RowVectorXd row = coefficients.row (basis.modalColumns() + static_cast<Eigen::Index> (n));

        // omega^2 / D tends to -1, residues alone to 0: the constant makes up for it.
        if (power == 0)
            for (Eigen::Index k = 0; k < basis.modes(); ++k)
                row -= amplitudes.row (basis.column (k, ModalFunction::delay));

        modes.residuals.push_back ({ power, row.reshaped (points, references) / std::pow (basis.scale, power) });
    }

    return coefficients;
}

namespace
{
constexpr double negligible = 1e-4;      // of the energy: a hundredth of the velocities
constexpr double evident = 1e-7;         // the same, weighted: lines with much misfit count little then
constexpr double mostOfMisfit = 2.0 / 3; // resonances that differ from point to point look complex by half

struct ActiveChannels
{
    double points = 0, references = 0, columns = 0;
};

ActiveChannels activeChannels (const PreparedResponses& data)
{
    const Eigen::MatrixXd table =
        (data.columnWeights.array() > 0).cast<double>().reshaped (data.points(), data.references());
    return { table.rowwise().maxCoeff().sum(), table.colwise().maxCoeff().sum(), table.sum() };
}

ModeKind real (const std::string& reason)
{
    return { false, "Modes are real: " + reason + "." };
}

std::string ratioInWords (double ratio, double limit)
{
    return "F " + fixedText (ratio, 2) + ", of real modes once in a thousand above " + fixedText (limit, 2);
}

ModeKind noGain (double ratio, double limit)
{
    return real ("complex shapes describe the responses no better than noise allows ("
                 + ratioInWords (std::max (ratio, 0.0), limit) + ")");
}
} // namespace

double limitOfRatio (double numbers)
{
    constexpr double normalQuantile = 3.0902;
    const auto spread = 2 / (9 * numbers);
    return std::pow (1 - spread + normalQuantile * std::sqrt (spread), 3);
}

std::optional<ModeKind> evidentlyReal (const NormalModeFit& fit, const FreeResidues& residues,
                                       const PreparedResponses& data, double ridge)
{
    const auto energy = residues.products.energies.dot (data.columnWeights);

    if (fit.cost < evident * energy)
        return real ("real shapes leave only " + fixedText (10 * std::log10 (std::max (fit.cost / energy, 1e-30)), 0)
                     + " dB of the responses");

    const auto active = activeChannels (data);
    const auto modes = static_cast<double> (fit.modes.modes());
    const auto freeNumbers = 2 * modes * active.columns;
    const auto numbers = std::max (1.0, freeNumbers - modes * (active.points + active.references - 1));
    const auto values = 2 * static_cast<double> (data.lines()) * active.columns;
    const auto left = std::max (freeCost (residues, data.columnWeights, ridge), 1e-30 * energy);
    const auto variance = left / std::max (values - freeNumbers, 1.0);
    const auto ratio = (fit.cost - left) / numbers / variance, limit = limitOfRatio (numbers);
    return ratio > limit ? std::optional<ModeKind>() : noGain (ratio, limit);
}

ModeKind decideModeKind (const FitErrors& realErrors, const FitErrors& complexErrors, const FreeResidues& complexFit,
                         double delay, const PreparedResponses& data)
{
    const Eigen::VectorXd isActive = (data.columnWeights.array() > 0).cast<double>();
    const auto total = [&] (const Eigen::MatrixXd& values) { return values.colwise().sum().dot (isActive); };
    // The noise of each span and column is seen from line to line, free of what a fit leaves smoothly.
    const Eigen::MatrixXd variances =
        (complexErrors.roughness.array().colwise() / complexErrors.lines.array()).max (1e-300);
    const auto leftByReal = total (realErrors.energies.cwiseQuotient (variances));
    const auto left = total (complexErrors.energies.cwiseQuotient (variances));
    const auto active = activeChannels (data);
    const auto values = complexErrors.lines.sum() * active.columns;
    const auto numbers = static_cast<double> (complexFit.basis.modes()) * (active.points + active.references - 1);
    const auto ratio = 2 * (leftByReal - left) / numbers / std::max (1.0, left / values);
    const auto limit = limitOfRatio (numbers);

    if (ratio <= limit)
        return noGain (ratio, limit);

    if (const auto gain =
            (total (realErrors.energies) - total (complexErrors.energies)) / realErrors.dataEnergies.dot (isActive);
        gain < negligible)
        return real ("complex shapes would explain no more than "
                     + fixedText (10 * std::log10 (std::max (gain, 1e-30)), 0) + " dB of the responses");

    const auto energy = total (realErrors.energies), noise = total (complexErrors.roughness);
    const auto share = (energy - total (complexErrors.energies)) / std::max (energy - noise, 1e-300);
    const auto percent = fixedText (100 * std::min (share, 1.0), 0) + " %";

    if (share < mostOfMisfit)
        return real ("complex shapes explain only " + percent
                     + " of the residual of real ones above the noise; complex modes explain 67 % or more");

    const auto& omega = complexFit.basis.angularFrequencies;
    const Eigen::MatrixXcd residues =
        (omega.array() * std::complex<double> (0, delay)).exp().matrix().asDiagonal() * complexFit.residues;

    if (phasesAreOfChannels (residues, omega, data.columnWeights)
        || channelAgreements (residues, data.points()).minCoeff() < oppositeAgreement)
        return real ("phases differ from channel to channel, not from mode to mode");

    return { true, "Modes are complex: complex shapes explain " + percent + " of what real ones leave above the noise ("
                       + ratioInWords (ratio, limit) + ")." };
}

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
