#include "LearningVerdict.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double mostUnexplained = 0.3; // of the signals, RMS
constexpr double farthest = 30;         // standard deviations that a frequency may be moved
constexpr double wellPredicted = 0.5;   // of what the nominal model does not predict, beyond the noise, RMS
constexpr double wellNearNoise = 0.5;   // of its power, where it is at most twice the noise, RMS
constexpr double surelyPredicted = 0.1; // of what the nominal model does not predict, RMS
constexpr double misled = 3;            // of the same: such a model is not played by again
constexpr double farFromPredicted = 10; // times louder or less loud: no device differs so much from its model
constexpr double leastBeyond = 0.1;     // of the noise's power: less is nothing to learn from
constexpr double stuck = 3;             // of the noise is not explained
constexpr double sameMove = 1.1;        // times: a move that is no farther is the one of before
constexpr double clearlyBetter = 0.5;   // of the first play's error

/** How many of its standard deviations the frequency that was moved most was moved. */
double farthestMove (const LearntModes& learnt, const ModalModel& nominal, const ModeSpread& deviations)
{
    const auto moves = (learnt.model.angularFrequencies.array() / nominal.angularFrequencies.array()).log();
    const auto expected = (deviations.frequencies.array().square() + deviations.drift * deviations.drift).sqrt();
    return (moves.abs() / expected.max (1e-9)).maxCoeff();
}

bool isClearlyBetter (const std::vector<LearningPass>& passes, std::size_t pass)
{
    return passes[pass].estimatedError < clearlyBetter * passes.front().estimatedError;
}

/** Whether what was learnt before a play predicts it much better than the nominal model, in powers beyond the noise,
    which nothing predicts.
    @param residual  of the noise that was said, what the fit leaves: less where the noise is smaller than that */
bool isWellPredicted (const LearningPass& pass, double residual)
{
    const auto noise = std::min (1.0, residual * residual);
    const auto learnt = pass.surprise * pass.surprise - noise;
    const auto nominal = pass.nominalSurprise * pass.nominalSurprise - noise;
    const auto share = std::clamp (1 / pass.nominalSurprise, wellPredicted * wellPredicted, wellNearNoise);
    return nominal > leastBeyond * noise && learnt < share * nominal;
}
} // namespace

std::string doubtOf (const LearningPass& pass, const LearntModes& learnt, const ModalModel& nominal,
                     const ModeSpread& deviations)
{
    constexpr double percent = 100;

    // Before what a fit says: a sensor that is dead is explained by ceramics that do nothing, or by nothing.
    if (! (pass.loudness > 1 / farFromPredicted && pass.loudness < farFromPredicted))
        return "Sensors hear " + inWords (percent * pass.loudness)
               + " % of what the previous device predicts; allowed: " + inWords (percent / farFromPredicted) + " to "
               + inWords (percent * farFromPredicted) + " %. Check sensors, channels and units.";

    if (! (learnt.unexplained < mostUnexplained))
        return "The model does not explain " + inWords (percent * learnt.unexplained)
               + " % of the signals; allowed: below " + inWords (percent * mostUnexplained)
               + " %. Check sensors, channels and places.";

    if (learnt.heldBackBefore > 0 && ! (learnt.heldBack < learnt.heldBackBefore))
        return "The model learnt from the other sensors leaves " + inWords (percent * learnt.heldBack)
               + " % of a held-back sensor unexplained, the previous device "
               + inWords (percent * learnt.heldBackBefore)
               + " %: it would make the device worse. Check places and channels, or measure at more points.";

    if (const auto move = farthestMove (learnt, nominal, deviations); ! (move < farthest))
        return "A frequency would be " + inWords (move) + " standard deviations off the previous device; allowed: "
               + inWords (farthest) + ". Check sensors, channels and places.";

    return {};
}

std::string refusalOf (const LearntFocus& learnt, const ModalModel& nominal, const ModeSpread& deviations)
{
    const auto& last = learnt.passes.back();

    if (auto doubt = doubtOf (last, learnt.learnt, nominal, deviations); ! doubt.empty())
        return doubt;

    if (learnt.passes.size() > 1 && ! isWellPredicted (last, learnt.learnt.residual))
        return "The learnt model did not predict the last play much better than the previous device.";

    // What predicts so well needs no other proof, whatever was left to gain.
    const auto isSure = last.surprise < surelyPredicted * last.nominalSurprise;

    if (learnt.passes.size() > 1 && ! isSure && ! isClearlyBetter (learnt.passes, learnt.passes.size() - 1))
        return "According to the learnt model the last play was hardly better than the first.";

    return {};
}

std::string warningOf (const LearntFocus& learnt)
{
    if (! learnt.refusal.empty() || ! isUnlikelyMove (learnt.learnt.largestMove))
        return {};

    return "A frequency is more than 6 of its standard deviations off the previous device. Give larger "
           "deviations "
           "of the frequencies, or retune the device first.";
}

bool isStuck (const LearntModes& learnt, double settledMove)
{
    return learnt.residual > stuck
           || (isUnlikelyMove (learnt.largestMove) && ! (learnt.largestMove < sameMove * settledMove));
}

bool isMisled (const LearningPass& pass, const LearntModes& learnt)
{
    return pass.surprise > misled * pass.nominalSurprise && isStuck (learnt);
}

std::size_t bestPredicted (const std::vector<LearningPass>& passes)
{
    const auto best =
        std::min_element (passes.begin(), passes.end(),
                          [] (const auto& one, const auto& other) { return one.surprise < other.surprise; });
    const auto index = static_cast<std::size_t> (best - passes.begin());
    const auto isMuchBetter =
        best->surprise < wellPredicted * passes.front().surprise && isClearlyBetter (passes, index);
    return isMuchBetter ? index : 0;
}
} // namespace antinode
