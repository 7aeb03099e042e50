#include "ChannelFilters.h"

#include "ChannelPhases.h"
#include "ChannelTurns.h"
#include "ComplexModes.h"
#include "ModeAssessment.h"
#include "ModeKind.h"
#include "PointSample.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
/** Free residues of all channels, at poles that suit them. */
FreeResidues residuesOfChannels (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    const auto range = [&modes] (const FrequencyResponses& of)
    { return prepare (of, modes.minimumFrequency * (1 - 1e-9), modes.maximumFrequency * (1 + 1e-9)); };
    NormalModes poles { modes.angularFrequencies, modes.dampingRatios, {}, {}, modes.delay };
    constexpr double ridge = 1e-12;

    // Poles of real modes are wrong where phases are not theirs.
    const auto sample = atPoints (responses, samplePoints (responses));
    const auto found = fitFreeResidues (range (sample), poles, ridge).basis;
    const auto data = range (responses);
    auto basis = makeBasis (found.angularFrequencies, found.dampingRatios, data);
    auto products = modalProducts (basis, data, modes.delay);
    auto residues = complexResidues (basis, products, ridge);
    return { std::move (basis), std::move (products), std::move (residues), true };
}

/** exp (2 i phase) times reciprocal variances of phases, N_m x C. */
Eigen::MatrixXcd doubledPhases (const FreeResidues& fit, double variance)
{
    constexpr double inexact = 0.01; // rad: no residue follows its channel more closely
    const auto covariances = residueCovariances (fit, variance, 1e-12);
    Eigen::MatrixXcd result (fit.residues.rows(), fit.residues.cols());

    for (Eigen::Index k = 0; k < result.rows(); ++k)
        for (Eigen::Index c = 0; c < result.cols(); ++c)
        {
            const auto power = std::max (std::norm (fit.residues (k, c)), 1e-300);
            const auto noise = covariances[static_cast<std::size_t> (k)].trace() / 2 / power;
            result (k, c) = std::polar (1 / (noise + inexact * inexact), 2 * std::arg (fit.residues (k, c)));
        }

    return result;
}

/** Which group every channel is in. */
using Groups = std::vector<Eigen::Index>;

GroupedPhases grouped (const FreeResidues& fit, const Eigen::MatrixXcd& phases, const Groups& groups)
{
    GroupedPhases result { fit.basis.angularFrequencies, fit.basis.dampingRatios,
                           Eigen::MatrixXcd::Zero (phases.rows(), 1 + *std::max_element (groups.begin(), groups.end())),
                           phases.cwiseAbs().sum() };

    for (std::size_t c = 0; c < groups.size(); ++c)
        result.sums.col (groups[c]) += phases.col (static_cast<Eigen::Index> (c));

    return result;
}

/** A hypothesis, and how it does. */
struct Hypothesis
{
    ChannelTurn turn = ChannelTurn::delay;
    Groups groups;
    double numbers = 1; ///< How many are fitted.
    TurnsOfGroups found;
};

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
    return fixedText (1 / (2 * std::numbers::pi * timeConstant), 0) + " Hz";
}

/** Which groups have one, by name; none where all are one. */
std::string describe (const Eigen::VectorXd& timeConstants, const std::vector<std::string>& names)
{
    if (names.empty())
        return "a low-pass of first order at " + hertz (timeConstants[0])
               + " (amplifier or sensor) is taken off all responses";

    constexpr std::size_t most = 8;
    std::string text;
    std::size_t count = 0;

    for (std::size_t g = 0; g < names.size(); ++g)
        if (const auto value = timeConstants[static_cast<Eigen::Index> (g)]; value > 0 && count++ < most)
            text += (count > 1 ? ", " : "") + names[g] + " at " + hertz (value);

    return "low-passes of first order are taken off the responses: " + text
           + (count > most ? " and " + std::to_string (count - most) + " more" : "");
}

/** The hypotheses of one low-pass for all, for each reference and for each point, with what may look like them. */
std::vector<Hypothesis> hypotheses (Eigen::Index points, Eigen::Index references)
{
    Groups one, byReference, byPoint;

    for (Eigen::Index i = 0; i < references; ++i)
        for (Eigen::Index p = 0; p < points; ++p)
        {
            one.push_back (0);
            byReference.push_back (i);
            byPoint.push_back (p);
        }

    std::vector<Hypothesis> result { { ChannelTurn::lowPass, one, 2, {} } };
    const auto add = [&result] (const Groups& groups, Eigen::Index count)
    {
        if (count < 2)
            return;

        result.push_back ({ ChannelTurn::lowPass, groups, 1.0 + static_cast<double> (count), {} });
        result.push_back ({ ChannelTurn::delay, groups, static_cast<double> (count), {} });
        result.push_back ({ ChannelTurn::shift, groups, 1.0 + static_cast<double> (count), {} });
    };
    add (byReference, references);
    add (byPoint, points);
    return result;
}

std::vector<std::string> groupNames (const FrequencyResponses& responses, std::size_t groups)
{
    std::vector<std::string> names;

    if (groups > 1 && groups == responses.references.size())
        for (const auto& reference : responses.references)
            names.push_back ("driver " + reference.name);
    else if (groups > 1)
        for (std::size_t p = 0; p < groups; ++p)
            names.push_back ("point " + std::to_string (p + 1));

    return names;
}
} // namespace

std::optional<ChannelFilters> findChannelFilters (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    constexpr Eigen::Index fewest = 4;
    constexpr double weak = 0.02;  // rad at the highest mode
    constexpr double unknown = 11; // chi squared of one number exceeds this once in a thousand times

    if (modes.modes() < fewest)
        return {};

    const auto fit = residuesOfChannels (responses, modes);
    const auto variance = responses.variances.empty() ? modes.noise * modes.noise / std::max (modes.misfit, 1.0) : 1.0;
    const auto phases = doubledPhases (fit, variance);
    const auto count = static_cast<double> (phases.size());
    const auto solve = [&] (Hypothesis hypothesis)
    {
        hypothesis.found = bestTurns (grouped (fit, phases, hypothesis.groups), hypothesis.turn);
        return hypothesis;
    };
    const auto none = solve ({ ChannelTurn::delay, Groups (static_cast<std::size_t> (phases.cols()), 0), 1, {} });
    auto best = none;

    for (auto& hypothesis : hypotheses (responses.points.rows(), fit.residues.cols() / responses.points.rows()))
        if (auto solved = solve (std::move (hypothesis));
            explains (solved, none, count) && criterion (solved, count) < criterion (best, count))
            best = std::move (solved);

    auto& values = best.found.values;
    const auto isKnown = best.found.gains.array() > unknown;
    values = (isKnown && values.array() * modes.angularFrequencies.maxCoeff() > weak).select (values, 0);

    if (best.turn != ChannelTurn::lowPass || values.maxCoeff() <= 0)
        return {};

    ChannelFilters result { Eigen::MatrixXd (responses.points.rows(), responses.references.size()),
                            describe (values, groupNames (responses, static_cast<std::size_t> (values.size()))) };

    for (Eigen::Index c = 0; c < phases.cols(); ++c)
        result.timeConstants.reshaped()[c] = values[best.groups[static_cast<std::size_t> (c)]];

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
