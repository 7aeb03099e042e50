#include "Identification.h"

#include "Attempts.h"
#include "Channels.h"
#include "ComplexModes.h"
#include "Deviations.h"
#include "FitErrors.h"
#include "ModalError.h"
#include "ModeAssessment.h"
#include "ModeKind.h"
#include "ModeSelection.h"
#include "Orthogonalisation.h"
#include "PeakPicking.h"
#include "PoleSearch.h"
#include "ShapeScales.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace antinode
{
namespace
{
/** When a fit ends: at a gain of a step in squared standard deviations, or after a number of steps. */
struct Patience
{
    double precision = 0;
    int iterations = 0;
};
constexpr Patience coarse { 1e-2, 6 }; // only has to show the noise, and which modes stand out of it
constexpr Patience fine { 1e-6, 25 };

void checkOptions (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    const auto points = responses.points.rows();
    const auto fits = [points] (const Eigen::VectorXd& values)
    {
        return values.size() == 0
               || (values.size() == points && values.allFinite() && values.minCoeff() >= 0 && values.sum() > 0);
    };

    if (! fits (options.pointWeights))
        throw InputError ("point weights", "must be one number per point, each at least 0, not all 0");

    if (! fits (options.pointMasses))
        throw InputError ("point masses", "must be one number per point, each at least 0, not all 0");

    if (options.minimumOrder < 1 || (options.maximumOrder != 0 && options.maximumOrder < options.minimumOrder)
        || options.maximumOrder > 100)
        throw InputError ("model orders", "are " + std::to_string (options.minimumOrder) + " to "
                                              + std::to_string (options.maximumOrder)
                                              + "; allowed: 1 to 100, ascending");
}

PreparedResponses weighted (PreparedResponses data, const Eigen::VectorXd& pointWeights)
{
    if (pointWeights.size() > 0)
        for (Eigen::Index c = 0; c < data.columns(); ++c)
            data.columnWeights[c] *= pointWeights[c % data.points()];

    return data;
}

/** Complex residues with the delay taken out: phi alpha. */
Eigen::MatrixXcd residuesWithout (double delay, Eigen::MatrixXcd residues, const Eigen::VectorXd& angularFrequencies)
{
    for (Eigen::Index k = 0; k < residues.rows(); ++k)
        residues.row (k) *= std::polar (1.0, angularFrequencies[k] * delay);

    return residues;
}

NormalModeStart startFrom (const PreparedResponses& data, const std::vector<PoleCluster>& clusters,
                           const IdentificationOptions& options)
{
    const auto modes = static_cast<Eigen::Index> (clusters.size());
    NormalModeStart start { Eigen::VectorXd (modes), Eigen::VectorXd (modes), {}, 0, options.delay.has_value() };

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto pole = clusters[static_cast<std::size_t> (k)].pole;
        start.angularFrequencies[k] = std::abs (pole);
        start.dampingRatios[k] = -pole.real() / std::abs (pole);
    }

    const auto basis = makeBasis (start.angularFrequencies, start.dampingRatios, data);
    const auto residues = complexResidues (basis, modalProducts (basis, data, 0), options.ridge);
    start.delay = options.delay.value_or (estimateDelay (start.angularFrequencies, residues, data.columnWeights));
    start.participation =
        strongestParticipation (residuesWithout (start.delay, residues, start.angularFrequencies).real(), data);
    return start;
}

NormalModeStart continued (const NormalModes& modes, bool delayIsKnown)
{
    return { modes.angularFrequencies, modes.dampingRatios, modes.participation, modes.delay, delayIsKnown };
}

/** E |error|^2 of a value of weight 1: as the errors are; where variances were given, at least 1. */
double estimateVariance (const NormalModeFit& fit, const PreparedResponses& data)
{
    const auto columns = static_cast<double> ((data.columnWeights.array() > 0).count());
    const auto parameters =
        static_cast<double> (fit.modes.modes() * (data.points() + data.references() + 1)) + 2 * columns;
    const auto freedom = std::max (static_cast<double> (data.lines()) * columns - parameters / 2, 1.0);
    const auto found = fit.cost / freedom;
    return data.responses->variances.empty() ? found : std::max (1.0, found);
}

/** The same of free residues. */
double freeVariance (const FreeResidues& fit, const PreparedResponses& data, double ridge)
{
    const auto columns = static_cast<double> ((data.columnWeights.array() > 0).count());
    const auto modes = static_cast<double> (fit.basis.modes());
    const auto freedom =
        std::max (static_cast<double> (data.lines()) * columns - modes * (columns + 1) - 2 * columns, 1.0);
    const auto found = freeCost (fit, data.columnWeights, ridge) / freedom;
    return data.responses->variances.empty() ? found : std::max (1.0, found);
}

/** Fits, takes out what does not stand out of the noise, and fits again, until all do. */
NormalModeFit fitWhatStandsOut (const PreparedResponses& data, NormalModeStart start,
                                std::vector<PoleCluster>& clusters, const Patience& patience, double ridge)
{
    constexpr int maximumRounds = 100;

    for (int round = 0;; ++round)
    {
        auto fit = fitNormalModes (data, start, ridge, patience.precision, patience.iterations);
        const auto kept = standOut (fit.state, estimateVariance (fit, data), ridge);

        // Modes that passed each other while they were fitted are put in order once more.
        if (kept.size() == clusters.size() && (round == maximumRounds || std::is_sorted (kept.begin(), kept.end())))
            return fit;

        if (kept.empty())
            throw InputError ("frequency responses", "contain no mode above the noise");

        clusters = chosen (clusters, kept);
        start = continued (chosen (fit.modes, kept), start.delayIsKnown);
    }
}

/** The modes that are seen at most orders, or known well. What is neither is misfit of measured data more often than a
    mode. */
std::vector<Eigen::Index> trustworthy (const NormalModeFit& fit, const PreparedResponses& data,
                                       const std::vector<PoleCluster>& clusters, const IdentificationOptions& options)
{
    constexpr double often = 0.6, uncertain = 0.1;
    const auto deviations =
        computeDeviations (fit.state, estimateVariance (fit, data), options.delay.has_value(), options.ridge);
    std::vector<Eigen::Index> kept;

    for (Eigen::Index k = 0; k < fit.modes.modes(); ++k)
        if (! options.selected.empty() || clusters[static_cast<std::size_t> (k)].presence >= often
            || deviations.dampingRatios[k] <= uncertain * fit.modes.dampingRatios[k])
            kept.push_back (k);

    return kept;
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

IdentifiedModes described (const NormalModeFit& fit, const FreeResidues& residues, PreparedResponses& data,
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
    const auto variance = estimateVariance (fit, data);
    auto deviations = stateDeviations (fit.state, variance, options.delay.has_value(), options.ridge);

    if (residues.basis.functions == complexModeFunctions)
        deviations = statedForComplex (std::move (deviations), variance, residues,
                                       freeVariance (residues, data, options.ridge), data, options.ridge);

    result.deviations = std::move (deviations.stated);
    result.noiseDeviations = std::move (deviations.noise);
    result.residuals = residualTerms (fit.state, data.points(), data.references());
    result.quality = assessResidues (residues.residues, data);
    const auto strengths = signalToNoise (fit.state, variance, options.ridge);

    for (std::size_t k = 0; k < result.quality.size(); ++k)
    {
        result.quality[k].presence = clusters[k].presence;
        result.quality[k].signalToNoise = strengths[static_cast<Eigen::Index> (k)];
    }

    const auto coefficients = residues.basis.functions == complexModeFunctions
                                  ? addComplexModes (result, residues, data)
                                  : fitCoefficients (fit.state);
    describeErrors (result, data, fitErrors (data, residues.basis, coefficients, modes.delay));
    result.modalReconstructionError = modalError (result, data);
    sortModes (result);
    scaleShapes (result, options.pointMasses);
    addWarnings (result);
    return result;
}

/** What may be picked, and which of it became a mode. */
std::vector<PoleCandidate> candidatesOf (const std::vector<PoleCluster>& found, const std::vector<PoleCluster>& fitted,
                                         const Eigen::VectorXd& fittedFrequencies)
{
    std::vector<PoleCandidate> candidates;

    for (const auto& cluster : found)
    {
        const auto frequency = std::abs (cluster.pole);
        PoleCandidate candidate {
            frequency / (2 * std::numbers::pi), -cluster.pole.real() / frequency, cluster.presence, {}
        };

        for (std::size_t k = 0; k < fitted.size() && ! candidate.mode; ++k)
            if (fitted[k].pole == cluster.pole)
                // Modes are numbered in ascending order, also where poles passed each other.
                candidate.mode = (fittedFrequencies.array() < fittedFrequencies[static_cast<Eigen::Index> (k)]).count();

        candidates.push_back (candidate);
    }

    return candidates;
}

/** What the user picked and no mode was made of is said. */
void warnOfLeftOut (IdentifiedModes& result, const std::vector<PoleCluster>& wanted,
                    const std::vector<PoleCluster>& fitted)
{
    for (const auto& cluster : wanted)
    {
        const auto isSame = [&cluster] (const PoleCluster& other) { return other.pole == cluster.pole; };

        if (std::none_of (fitted.begin(), fitted.end(), isSame))
            result.warnings.push_back ("the selected pole at "
                                       + fixedText (std::abs (cluster.pole) / (2 * std::numbers::pi), 2)
                                       + " Hz is left out: it does not stand out of noise and misfit");
    }
}

/** Weights from what a fit leaves, where the user gave none. @return  what was weighed down, as sentences */
std::vector<std::string> weighAgain (PreparedResponses& data, const FitErrors& errors,
                                     const IdentificationOptions& options)
{
    if (options.pointWeights.size() > 0)
        return {};

    weighByErrors (data, errors);
    return weighDownMisfits (data, errors);
}

/** The errors of complex modes. */
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

/** The fit of complex modes, where they are asked for or a test finds them. */
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

[[noreturn]] void throwNoModes (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    auto conjugated = responses;

    for (auto& values : conjugated.values)
        values = values.conjugate().eval();

    const auto data = prepare (conjugated, options.minimumFrequency, options.maximumFrequency);
    const auto found = searchPoles (weighted (data, options.pointWeights), options).clusters.size();
    throw InputError ("frequency responses",
                      found == 0 ? "contain no pole that is stable over model orders, hence no mode"
                                 : "contain modes that grow instead of decaying and seem to be complex conjugates; "
                                   "allowed: the convention exp (+i omega t)");
}

IdentifiedModes fitModes (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    auto data =
        weighted (prepare (responses, options.minimumFrequency, options.maximumFrequency), options.pointWeights);
    auto said = leaveOutDisturbed (data);
    auto found = searchPoles (data, options);
    auto clusters = picked (options.selected.empty() ? found.clusters : found.candidates, options);

    if (clusters.empty())
        throwNoModes (responses, options);

    const auto wanted = options.selected.empty() ? std::vector<PoleCluster> {} : clusters;
    const auto delayIsKnown = options.delay.has_value();
    auto fit = fitWhatStandsOut (data, startFrom (data, clusters, options), clusters, coarse, options.ridge);
    auto poor =
        weighAgain (data, fitErrors (data, fit.state.basis, fitCoefficients (fit.state), fit.modes.delay), options);
    fit = fitWhatStandsOut (data, continued (fit.modes, delayIsKnown), clusters, fine, options.ridge);

    if (const auto kept = trustworthy (fit, data, clusters, options); ! kept.empty() && kept.size() < clusters.size())
    {
        clusters = chosen (clusters, kept);
        fit =
            fitWhatStandsOut (data, continued (chosen (fit.modes, kept), delayIsKnown), clusters, fine, options.ridge);
    }

    auto residues = freeResidues (fit.state, options.ridge);
    auto isConverged = fit.isConverged;
    ModeKind kind;

    if (const auto complexFit = fitComplexModes (fit, residues, data, options, kind))
    {
        // What real modes left of complex ones was no noise.
        poor = weighAgain (data, complexErrors (fit, *complexFit, data), options);
        residues = fitFreeResidues (data, withPoles (fit.modes, complexFit->basis), options.ridge);
        isConverged = residues.isConverged;
        // The best real modes with the poles of the complex ones.
        fit = fitNormalModes (data, continued (withPoles (fit.modes, residues.basis), delayIsKnown), options.ridge,
                              fine.precision, 0);
    }

    said.insert (said.end(), poor.begin(), poor.end());
    auto result = described (fit, residues, data, clusters, options);
    result.kindReason = std::move (kind.reason);
    result.warnings.insert (result.warnings.begin(), said.begin(), said.end());

    if (! isConverged)
        result.warnings.emplace_back ("the fit of the modes did not converge: select modes, or limit the band");

    warnOfLeftOut (result, wanted, clusters);
    result.stabilisation = std::move (found.stabilisation);
    result.candidates = candidatesOf (found.candidates, clusters, fit.modes.angularFrequencies);
    return result;
}
} // namespace

IdentifiedModes identify (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    validate (responses);
    checkOptions (responses, options);

    auto result = options.method == IdentificationMethod::peakPicking ? pickPeaks (responses, options)
                                                                      : bestOfAttempts (responses, options, fitModes);

    if (options.gramSchmidt)
        orthogonalise (result, options.pointMasses);

    return result;
}
} // namespace antinode
