#include "Identification.h"

#include "Attempts.h"
#include "Channels.h"
#include "ComplexModes.h"
#include "Deviations.h"
#include "FitErrors.h"
#include "ImpulseResponses.h"
#include "MeasuredQuantity.h"
#include "ModeDescription.h"
#include "ModeSelection.h"
#include "PeakPicking.h"
#include "PoleSearch.h"
#include "ShapeScales.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

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

/** Values that are all 0 have a cause that no fit can say. */
void requireVibration (const FrequencyResponses& responses)
{
    auto isMeasured = false;

    for (const auto& values : responses.values)
        for (const auto& value : values.reshaped())
            if (std::isfinite (value.real()) && std::isfinite (value.imag()))
            {
                if (value != 0.0)
                    return;

                isMeasured = true;
            }

    if (isMeasured)
        throw InputError ("frequency responses",
                          "contain no mode: all their values are 0, as of a signal that is constant; allowed: signals "
                          "that vibrate; check sensor, channel and level");
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
    const auto poles = polesOf (clusters, 0);
    NormalModeStart start { poles.angularFrequencies, poles.dampingRatios, {}, 0, options.delay.has_value() };
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
    std::vector<Eigen::Index> kept (clusters.size());
    std::iota (kept.begin(), kept.end(), 0);
    const auto isFrequent = [] (const PoleCluster& cluster) { return cluster.presence >= often; };

    if (! options.selected.empty() || std::all_of (clusters.begin(), clusters.end(), isFrequent))
        return kept;

    const auto deviations =
        computeDeviations (fit.state, estimateVariance (fit, data), options.delay.has_value(), options.ridge);
    kept.clear();

    for (Eigen::Index k = 0; k < fit.modes.modes(); ++k)
        if (isFrequent (clusters[static_cast<std::size_t> (k)])
            || deviations.dampingRatios[k] <= uncertain * fit.modes.dampingRatios[k])
            kept.push_back (k);

    return kept;
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
                                       + inWords (std::abs (cluster.pole) / (2 * std::numbers::pi))
                                       + " Hz is left out: it does not exceed noise and misfit");
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

constexpr auto noPole = "contain no pole that is stable over model orders, hence no mode";

/** Why there are no modes, by another search on some of the points. */
[[noreturn]] void explainNoModes (const FrequencyResponses& responses, const IdentificationOptions& allOptions)
{
    const auto points = samplePoints (responses);
    const auto options = atPoints (allOptions, points);
    auto conjugated = atPoints (responses, points);

    for (auto& values : conjugated.values)
        values = values.conjugate().eval();

    const auto data = prepare (conjugated, options.minimumFrequency, options.maximumFrequency);
    const auto found = searchPoles (weighted (data, options.pointWeights), options).clusters.size();
    throw InputError ("frequency responses",
                      found == 0 ? noPole
                                 : "contain modes that grow instead of decaying and seem to be complex conjugates; "
                                   "allowed: the convention exp (+i omega t)");
}

/** What is known before responses are fitted for the first time. */
struct FirstLook
{
    std::optional<FoundPoles> poles; ///< In the range of the options.
    bool explains = true; ///< Whether it is said why there are no modes: that takes as long as the search for them.
};

IdentifiedModes fitModes (const FrequencyResponses& responses, const IdentificationOptions& options, FirstLook look)
{
    auto data =
        weighted (prepare (responses, options.minimumFrequency, options.maximumFrequency), options.pointWeights);
    auto said = leaveOutDisturbed (data);
    auto found = look.poles ? std::move (*look.poles) : searchPoles (data, options);
    auto clusters = picked (options.selected.empty() ? found.clusters : found.candidates, options);

    if (clusters.empty() && look.explains)
        explainNoModes (responses, options);

    if (clusters.empty())
        throw InputError ("frequency responses", noPole);

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
    auto result = describeModes (fit, residues, data, clusters, options);
    result.kindReason = std::move (kind.reason);
    result.warnings.insert (result.warnings.begin(), said.begin(), said.end());

    if (! isConverged)
        result.warnings.emplace_back ("the fit of the modes did not converge: select modes, or limit the band");

    warnOfLeftOut (result, wanted, clusters);
    result.stabilisation = std::move (found.stabilisation);
    result.candidates = candidatesOf (found.candidates, clusters, fit.modes.angularFrequencies);
    return result;
}

/** By the method of the options. @param look  for the first attempt; the reason that it gives is said where all fail */
IdentifiedModes identifyBy (const FrequencyResponses& responses, const IdentificationOptions& options, FirstLook look)
{
    const auto fit = [&look] (const FrequencyResponses& tried, const IdentificationOptions& chosen) {
        return fitModes (tried, chosen, std::exchange (look, { {}, false }));
    };
    return options.method == IdentificationMethod::peakPicking ? pickPeaks (responses, options)
                                                               : bestOfAttempts (responses, options, fit);
}

/** As the quantity that is stated or, where none is, as that which explains the responses best. */
IdentifiedModes identifyQuantity (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    if (responses.isQuantityStated)
        return identifyBy (responses, options, {});

    auto data =
        weighted (prepare (responses, options.minimumFrequency, options.maximumFrequency), options.pointWeights);
    leaveOutDisturbed (data);
    // What was measured has the same poles whatever it is.
    auto found = searchPoles (data, options);
    const auto clusters = picked (options.selected.empty() ? found.clusters : found.candidates, options);

    if (clusters.empty())
        return identifyBy (responses, options, { std::move (found), true });

    const auto likely = likelyQuantity (fitQuantities (responses, options, clusters), responses);
    auto result = identifyBy (asQuantity (responses, likely.integrations), options, { std::move (found), true });
    result.warnings.insert (result.warnings.begin(), likely.said);
    return result;
}

/** Whether some quantity makes modes of what is no impulse response by its course: what is narrow in much noise. */
bool holdsModes (const FrequencyResponses& all, const IdentificationOptions& allOptions)
{
    constexpr double fair = -6; // dB
    const auto points = samplePoints (all);
    const auto responses = atPoints (all, points);
    const auto options = atPoints (allOptions, points);
    const auto data = prepare (responses, options.minimumFrequency, options.maximumFrequency);
    const auto clusters = searchPoles (data, options).clusters;
    return ! clusters.empty() && fitQuantities (responses, options, clusters).front().error < fair;
}
/** Without a delay, which is taken out before anything else: a long one hides poles. */
IdentifiedModes identifyAfter (double delay, const FrequencyResponses& responses, const IdentificationOptions& options)
{
    auto without = options;
    without.delay = options.delay ? std::optional (0.0) : std::nullopt;
    auto result =
        delay != 0 ? identifyQuantity (delayed (responses, -delay), without) : identifyQuantity (responses, without);
    result.delay += delay;
    return result;
}

/** Noise may look like an onset: where the responses are not explained well after it, they are fitted as they are, too.
 */
IdentifiedModes identifyAfterOnset (double delay, const FrequencyResponses& responses,
                                    const IdentificationOptions& options)
{
    constexpr double good = -20; // dB
    std::optional<IdentifiedModes> late;

    try
    {
        late = identifyAfter (delay, responses, options);
    }
    catch (const InputError&)
    {
        return identifyAfter (0, responses, options);
    }

    if (late->reconstructionError <= good)
        return std::move (*late);

    try
    {
        auto unchanged = identifyAfter (0, responses, options);
        return unchanged.reconstructionError < late->reconstructionError ? std::move (unchanged) : std::move (*late);
    }
    catch (const InputError&)
    {
        return std::move (*late);
    }
}
} // namespace

IdentifiedModes identify (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    validate (responses);
    checkOptions (responses, options);
    requireVibration (responses);

    const auto impulse = impulseEnergy (responses, options.minimumFrequency, options.maximumFrequency);

    if (impulse && seemsStationary (*impulse) && ! holdsModes (responses, options))
        throw InputError ("frequency responses",
                          "contain no mode: their impulse responses neither begin nor decay, as noise or a record of "
                          "ambient vibration without a force; allowed: impulse responses, responses per voltage or "
                          "force, and recordings with their force, from which 'antinode frf' makes responses");

    const auto delay = options.delay.value_or (impulse ? onsetDelay (*impulse) : 0);
    auto result = options.delay || delay == 0 ? identifyAfter (delay, responses, options)
                                              : identifyAfterOnset (delay, responses, options);

    if (options.gramSchmidt)
        orthogonalise (result, options.pointMasses);

    return result;
}

std::vector<Eigen::Index> samplePoints (const FrequencyResponses& responses)
{
    constexpr Eigen::Index enough = 24; // as many directions as the search for poles keeps
    const auto all = responses.points.rows(), count = std::min (all, enough);
    std::vector<Eigen::Index> points;

    for (Eigen::Index n = 0; n < count; ++n)
        points.push_back ((2 * n + 1) * all / (2 * count));

    return points;
}

FrequencyResponses atPoints (const FrequencyResponses& responses, const std::vector<Eigen::Index>& points)
{
    auto result = FrequencyResponses { responses.frequencies,
                                       responses.drive,
                                       responses.references,
                                       responses.points (points, Eigen::all),
                                       {},
                                       {},
                                       responses.integrations,
                                       responses.isQuantityStated };

    for (const auto& values : responses.values)
        result.values.emplace_back (values (Eigen::all, points));

    for (const auto& variances : responses.variances)
        result.variances.emplace_back (variances (Eigen::all, points));

    return result;
}

IdentificationOptions atPoints (IdentificationOptions options, const std::vector<Eigen::Index>& points)
{
    if (options.pointWeights.size() > 0)
        options.pointWeights = options.pointWeights (points).eval();

    if (options.pointMasses.size() > 0)
        options.pointMasses = options.pointMasses (points).eval();

    return options;
}
} // namespace antinode
