#include "ModeDescription.h"

#include "Deviations.h"
#include "FitErrors.h"
#include "ModeSelection.h"
#include "ShapeScales.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace antinode
{
namespace
{
/** As estimateVariance, of free residues. */
double freeVariance (const FreeResidues& fit, const PreparedResponses& data, double ridge)
{
    const auto columns = static_cast<double> ((data.columnWeights.array() > 0).count());
    const auto modes = static_cast<double> (fit.basis.modes());
    const auto freedom = std::max (static_cast<double> (data.lines()) * columns - modes * (columns + 1)
                                       - static_cast<double> (fit.basis.powers.size()) / 2 * columns,
                                   1.0);
    const auto found = freeCost (fit, data.columnWeights, ridge) / freedom;
    return data.responses->variances.empty() ? found : std::max (1.0, found);
}

std::vector<ResidualTerm> residualTerms (const FitState& state, Eigen::Index points, Eigen::Index references)
{
    const auto coefficients = residualCoefficients (state);
    std::vector<ResidualTerm> terms;
    Eigen::Index row = 0;

    for (const auto power : state.basis.powers)
        terms.push_back (
            { power, coefficients.row (row++).reshaped (points, references) / std::pow (state.basis.scale, power) });

    return terms;
}

void describeData (IdentifiedModes& result, const PreparedResponses& data)
{
    result.drive = data.responses->drive;
    result.integrations = data.responses->integrations;
    result.references = data.responses->references;
    result.points = data.responses->points;
    result.minimumFrequency = data.omega[0] / (2 * std::numbers::pi);
    result.maximumFrequency = data.omega[data.lines() - 1] / (2 * std::numbers::pi);
}

void describeErrors (IdentifiedModes& result, const PreparedResponses& data, const FitErrors& errors)
{
    const Eigen::VectorXd active = (data.columnWeights.array() > 0).cast<double>();
    const auto energy = errors.energies.colwise().sum().dot (active);
    result.noise = std::sqrt (energy / (active.sum() * static_cast<double> (data.lines())));
    const auto decibels = [&active] (double left, const Eigen::VectorXd& all)
    { return 10 * std::log10 (std::max (left / all.dot (active), 1e-32)); };
    result.measuredReconstructionError = decibels (energy, errors.dataEnergies);
    result.reconstructionError = decibels (errors.velocityEnergies.dot (active), errors.velocityDataEnergies);
    result.misfit = ((errors.energies.array() / errors.roughness.array().max (1e-300)).matrix() * active).sum()
                    / (active.sum() * static_cast<double> (errors.energies.rows()));
}

/** In ascending frequency: fits let modes pass each other. */
void sortModes (IdentifiedModes& modes)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (modes.modes()));
    std::iota (order.begin(), order.end(), 0);
    const auto isLower = [&] (auto a, auto b) { return modes.angularFrequencies[a] < modes.angularFrequencies[b]; };

    if (std::is_sorted (order.begin(), order.end(), isLower))
        return;

    std::stable_sort (order.begin(), order.end(), isLower);
    const auto sortVector = [&] (Eigen::VectorXd& values) { values = values (order).eval(); };
    const auto sortColumns = [&] (auto& values) { values = values (Eigen::all, order).eval(); };
    const auto sortRows = [&] (auto& values) { values = values (order, Eigen::all).eval(); };
    const auto quality = modes.quality;

    for (std::size_t k = 0; k < order.size(); ++k)
        modes.quality[k] = quality[static_cast<std::size_t> (order[k])];

    sortVector (modes.angularFrequencies);
    sortVector (modes.dampingRatios);
    sortColumns (modes.shapes);
    sortRows (modes.participation);

    for (auto* const deviations : { &modes.deviations, &modes.noiseDeviations })
    {
        sortVector (deviations->angularFrequencies);
        sortVector (deviations->dampingRatios);
        sortColumns (deviations->shapes);
        sortRows (deviations->participation);
    }

    if (modes.complexShapes.size() > 0)
    {
        sortColumns (modes.complexShapes);
        sortRows (modes.complexParticipation);
    }
}

/** Points at which nothing was measured have no shape. */
void blankUnmeasured (Eigen::MatrixXd& shapes, const PreparedResponses& data)
{
    for (Eigen::Index p = 0; p < shapes.rows(); ++p)
        if (data.columnWeights (Eigen::seqN (p, data.references(), data.points())).maxCoeff() <= 0)
            shapes.row (p).setConstant (std::numeric_limits<double>::quiet_NaN());
}
} // namespace

double estimateVariance (const NormalModeFit& fit, const PreparedResponses& data)
{
    const auto columns = static_cast<double> ((data.columnWeights.array() > 0).count());
    const auto parameters = static_cast<double> (fit.modes.modes() * (data.points() + data.references() + 1))
                            + static_cast<double> (fit.state.basis.powers.size()) * columns;
    const auto freedom = std::max (static_cast<double> (data.lines()) * columns - parameters / 2, 1.0);
    const auto found = fit.cost / freedom;
    return data.responses->variances.empty() ? found : std::max (1.0, found);
}

IdentifiedModes describeModes (const NormalModeFit& fit, const FreeResidues& residues, PreparedResponses& data,
                               const std::vector<PoleCluster>& clusters, const IdentificationOptions& options)
{
    IdentifiedModes result;
    describeData (result, data);
    const auto& modes = fit.modes;
    result.angularFrequencies = modes.angularFrequencies;
    result.dampingRatios = modes.dampingRatios;
    result.shapes = modes.shapes;
    blankUnmeasured (result.shapes, data);
    result.participation = modes.participation;
    result.delay = modes.delay;
    // Weights are reciprocal variances of noise, unless the user gave them.
    const auto variances = [&options] (double left) {
        return ErrorVariances { left, options.pointWeights.size() > 0 ? left : std::min (left, 1.0) };
    };
    const auto ofReal = variances (estimateVariance (fit, data));
    auto deviations = stateDeviations (fit.state, ofReal, options.delay.has_value(), options.ridge);

    if (residues.basis.functions == complexModeFunctions)
        deviations = statedForComplex (std::move (deviations), ofReal, residues,
                                       variances (freeVariance (residues, data, options.ridge)), data, options.ridge);

    result.deviations = std::move (deviations.stated);
    result.noiseDeviations = std::move (deviations.noise);
    result.residuals = residualTerms (fit.state, data.points(), data.references());
    result.quality = assessResidues (residues, data, ofReal.noise, options.ridge);
    const auto strengths = signalToNoise (fit.state, ofReal.left, options.ridge);

    for (std::size_t k = 0; k < result.quality.size(); ++k)
    {
        result.quality[k].presence = clusters[k].presence;
        result.quality[k].signalToNoise = strengths[static_cast<Eigen::Index> (k)];
    }

    const auto coefficients = residues.basis.functions == complexModeFunctions
                                  ? addComplexModes (result, residues, data)
                                  : fitCoefficients (fit.state);
    describeErrors (result, data, fitErrors (data, residues.basis, coefficients, modes.delay));
    auto rest = modalRest (result, data);
    result.modalReconstructionError = rest.error;
    result.staticShare = std::move (rest.staticShare);
    sortModes (result);
    scaleShapes (result, options.pointMasses);
    addWarnings (result);
    return result;
}
} // namespace antinode
