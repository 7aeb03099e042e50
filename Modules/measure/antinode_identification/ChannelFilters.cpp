#include "ChannelFilters.h"

#include "ChannelPhases.h"
#include "ComplexModes.h"
#include "Identification.h"
#include "ModeSelection.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double smallRidge = 1e-12;

PreparedResponses inRangeOf (const IdentifiedModes& modes, const FrequencyResponses& responses)
{
    return prepare (responses, modes.minimumFrequency * (1 - 1e-9), modes.maximumFrequency * (1 + 1e-9));
}

/** Free residues at poles that are known. */
FreeResidues residuesAt (const ModalBasis& poles, const PreparedResponses& data, double delay)
{
    auto basis = makeBasis (poles.angularFrequencies, poles.dampingRatios, data);
    auto products = modalProducts (basis, data, delay);
    auto residues = complexResidues (basis, products, smallRidge);
    return { std::move (basis), std::move (products), std::move (residues), true };
}

/** exp (2 i phase) times reciprocal variances of phases, N_m x C.
    @param variance  E |error|^2 of a value of weight 1 */
Eigen::MatrixXcd doubledPhases (const FreeResidues& fit, const Eigen::VectorXd& columnWeights, double variance)
{
    constexpr double inexact = 0.01; // rad: no residue follows its channel more closely
    const auto covariances = residueCovariances (fit, variance, smallRidge);
    Eigen::MatrixXcd result (fit.residues.rows(), fit.residues.cols());

    for (Eigen::Index k = 0; k < result.rows(); ++k)
        for (Eigen::Index c = 0; c < result.cols(); ++c)
        {
            const auto power = std::max (columnWeights[c] * std::norm (fit.residues (k, c)), 1e-300);
            const auto noise = covariances[static_cast<std::size_t> (k)].trace() / 2 / power;
            result (k, c) = std::polar (1 / (noise + inexact * inexact), 2 * std::arg (fit.residues (k, c)));
        }

    return result;
}

/** Phases of residues of channels, doubled, references one after the other. */
struct ShownPhases
{
    Eigen::VectorXd omega, damping; ///< N_m: of the modes.
    Eigen::MatrixXcd doubled;       ///< N_m x C: with weights.
    Eigen::Index points = 0;
};

ShownPhases shownPhases (const FreeResidues& fit, const PreparedResponses& data, const IdentifiedModes& modes)
{
    const auto variance =
        data.responses->variances.empty() ? modes.noise * modes.noise / std::max (modes.misfit, 1.0) : 1.0;
    return { fit.basis.angularFrequencies, fit.basis.dampingRatios, doubledPhases (fit, data.columnWeights, variance),
             data.points() };
}

/** Whose turns are to be the same. */
enum class Sharing
{
    ofAll,
    ofReference,
    ofPoint
};

/** Which group a channel is in. */
Eigen::Index groupOf (Sharing sharing, Eigen::Index channel, Eigen::Index points)
{
    return sharing == Sharing::ofAll ? 0 : sharing == Sharing::ofReference ? channel / points : channel % points;
}

Eigen::Index groupCount (Sharing sharing, const ShownPhases& phases)
{
    const auto points = phases.points;
    return sharing == Sharing::ofAll ? 1 : sharing == Sharing::ofPoint ? points : phases.doubled.cols() / points;
}

/** What may turn phases, and how well it does. */
struct Hypothesis
{
    ChannelTurn turn = ChannelTurn::delay;
    Sharing sharing = Sharing::ofAll;
    double numbers = 1; ///< How many are fitted.
    TurnsOfGroups found;
};

Hypothesis tested (const ShownPhases& phases, ChannelTurn turn, Sharing sharing)
{
    const auto groups = groupCount (sharing, phases);
    GroupedPhases grouped { phases.omega, phases.damping, Eigen::MatrixXcd::Zero (phases.omega.size(), groups),
                            phases.doubled.cwiseAbs().sum() };

    for (Eigen::Index c = 0; c < phases.doubled.cols(); ++c)
        grouped.sums.col (groupOf (sharing, c, phases.points)) += phases.doubled.col (c);

    // Beside turns of another kind there is a common delay.
    const auto numbers = static_cast<double> (turn == ChannelTurn::delay ? groups : groups + 1);
    return { turn, sharing, numbers, bestTurns (grouped, turn) };
}

/** Bayes' criterion of phases whose scale is not known: the lower the better. */
double criterion (const Hypothesis& hypothesis, double phases)
{
    return phases * std::log (std::max (hypothesis.found.left, phases)) + hypothesis.numbers * std::log (phases);
}

/** Whether a hypothesis explains what a common delay leaves. */
bool explains (const Hypothesis& hypothesis, const Hypothesis& none, double phases)
{
    constexpr double mostLeft = 0.25;
    const auto left = hypothesis.found.left, numbers = hypothesis.numbers - none.numbers;
    const auto ratio = (none.found.left - left) / numbers / std::max (1.0, left / (phases - hypothesis.numbers));
    return ratio > limitOfRatio (numbers) && left < phases + mostLeft * (none.found.left - phases);
}

std::string hertz (double timeConstant)
{
    return inWords (1 / (2 * std::numbers::pi * timeConstant)) + " Hz";
}

/** What a group is called. */
std::string groupName (Sharing sharing, std::size_t group, const std::vector<Reference>& references)
{
    return sharing == Sharing::ofReference ? "driver " + references[group].name : "point " + std::to_string (group + 1);
}

/** Which groups have one, by name. */
std::string describe (const Eigen::VectorXd& timeConstants, Sharing sharing, const std::vector<Reference>& references)
{
    if (sharing == Sharing::ofAll)
        return "a low-pass of first order at " + hertz (timeConstants[0])
               + " (amplifier or sensor) is removed from all responses";

    constexpr int most = 8;
    std::string text;
    int count = 0;

    for (Eigen::Index g = 0; g < timeConstants.size(); ++g)
        if (timeConstants[g] > 0 && count++ < most)
            text += (count > 1 ? ", " : "") + groupName (sharing, static_cast<std::size_t> (g), references) + " at "
                    + hertz (timeConstants[g]);

    return "low-passes of first order are removed from the responses: " + text
           + (count > most ? " and " + std::to_string (count - most) + " more" : "");
}

/** Low-passes that explain phases best: better than delays or resonances that differ from channel to channel. */
std::optional<Hypothesis> bestLowPasses (const ShownPhases& phases)
{
    const auto count = static_cast<double> (phases.doubled.size());
    const auto none = tested (phases, ChannelTurn::delay, Sharing::ofAll);
    auto best = none;
    const auto isBetter = [&] (const Hypothesis& other)
    { return explains (other, none, count) && criterion (other, count) < criterion (best, count); };

    for (const auto sharing : { Sharing::ofAll, Sharing::ofReference, Sharing::ofPoint })
        if (sharing == Sharing::ofAll || groupCount (sharing, phases) > 1)
            if (auto other = tested (phases, ChannelTurn::lowPass, sharing); isBetter (other))
                best = std::move (other);

    if (best.turn != ChannelTurn::lowPass)
        return {};

    for (const auto sharing : { Sharing::ofReference, Sharing::ofPoint })
        for (const auto turn : { ChannelTurn::delay, ChannelTurn::shift })
            if (groupCount (sharing, phases) > 1 && isBetter (tested (phases, turn, sharing)))
                return {};

    return best;
}

/** Time constants of groups, s; 0 of those that are hardly any, or not sure. */
Eigen::VectorXd certainTimeConstants (const TurnsOfGroups& found, double highest)
{
    constexpr double weak = 0.02;  // rad at the highest mode
    constexpr double unknown = 11; // chi squared of one number exceeds this once in a thousand times
    return (found.gains.array() > unknown && found.values.array() * highest > weak).select (found.values, 0);
}
} // namespace

std::optional<ChannelFilters> findChannelFilters (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    constexpr Eigen::Index fewest = 4;

    if (modes.modes() < fewest)
        return {};

    // A few points tell. Poles of real modes are wrong where phases are not theirs.
    const auto sample = atPoints (responses, samplePoints (responses));
    const auto ofSample = inRangeOf (modes, sample);
    const auto fit =
        fitFreeResidues (ofSample, { modes.angularFrequencies, modes.dampingRatios, {}, {}, modes.delay }, smallRidge);
    auto best = bestLowPasses (shownPhases (fit, ofSample, modes));

    if (! best)
        return {};

    if (sample.points.rows() < responses.points.rows())
    {
        const auto data = inRangeOf (modes, responses);
        const auto ofAll = residuesAt (fit.basis, data, modes.delay);
        best = tested (shownPhases (ofAll, data, modes), ChannelTurn::lowPass, best->sharing);
    }

    const auto values = certainTimeConstants (best->found, modes.angularFrequencies.maxCoeff());

    if (values.maxCoeff() <= 0)
        return {};

    const auto points = responses.points.rows();
    ChannelFilters result { Eigen::MatrixXd (points, responses.references.size()),
                            describe (values, best->sharing, responses.references) };

    for (Eigen::Index c = 0; c < result.timeConstants.size(); ++c)
        result.timeConstants.reshaped()[c] = values[groupOf (best->sharing, c, points)];

    return result;
}

FrequencyResponses withoutLowPasses (FrequencyResponses responses, const Eigen::MatrixXd& timeConstants)
{
    const Eigen::ArrayXd omega = 2 * std::numbers::pi * responses.frequencies.array();

    for (Eigen::Index i = 0; i < timeConstants.cols(); ++i)
        for (Eigen::Index p = 0; p < timeConstants.rows(); ++p)
        {
            checkWatch();
            const Eigen::ArrayXcd factor = 1.0 + std::complex<double> (0, timeConstants (p, i)) * omega;
            responses.values[static_cast<std::size_t> (i)].col (p).array() *= factor;

            if (! responses.variances.empty())
                responses.variances[static_cast<std::size_t> (i)].col (p).array() *= factor.abs2();
        }

    return responses;
}
} // namespace antinode
