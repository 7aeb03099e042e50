#include "FeltLevels.h"

#include "Brake.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_model/Surface.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace antinode
{
namespace
{
constexpr double levelTolerance = 0.02; // dB

double amplitudeOf (double decibels)
{
    return std::pow (10, decibels / 20);
}

std::vector<std::pair<double, double>> placesOf (const std::vector<Target>& targets)
{
    std::vector<std::pair<double, double>> places (targets.size());
    std::transform (targets.begin(), targets.end(), places.begin(),
                    [] (const auto& target) { return std::pair (target.x, target.y); });

    return places;
}

/** Designs are played at the rate that they are for; those for none at one that holds all modes. */
Playback playedAt (const ModalModel& model, Playback playback)
{
    constexpr double lowestRate = 48000, samplesPerPeriod = 2.5;

    if (! (playback.sampleRate > 0))
        playback.sampleRate = std::max (lowestRate, samplesPerPeriod * model.frequencyHz (model.modes() - 1));

    return playback;
}

double endOf (const FocusDescription& focus)
{
    auto latest = focus.focusTime;

    for (const auto& target : focus.targets)
        latest = std::max (latest, target.time.value_or (focus.focusTime));

    return 2 * latest + focus.transients.brakeDuration.value_or (0) + (focus.felt ? focus.felt->after : 0);
}

/** Takes the velocities nearer to what the levels need.
    @return  the largest step, dB */
double correct (std::vector<Target>& targets, const std::vector<double>& reached)
{
    constexpr double furthest = 60; // dB at once, where hardly anything moves
    double largest = 0;

    for (std::size_t i = 0; i < targets.size(); ++i)
        if (targets[i].level)
        {
            const auto step = std::clamp (*targets[i].level - reached[i], -furthest, furthest);
            targets[i].peakVelocity *= amplitudeOf (step);
            largest = std::max (largest, std::abs (step));
        }

    return largest;
}

double largestVelocity (const std::vector<Target>& targets)
{
    double largest = 0;

    for (const auto& target : targets)
        largest = std::max (largest, target.peakVelocity);

    return largest;
}

FocusDescription withoutLevels (FocusDescription focus)
{
    for (auto& target : focus.targets)
        target.level.reset();

    return focus;
}

FocusDesign withBrake (FocusDesign design, const ModalModel& model)
{
    if (hasBrake (design.description.transients))
        appendBrake (design, model);

    return design;
}

[[noreturn]] void refuseLevel (const FocusDescription& asked, const LimitError& failure, double share)
{
    const auto level = *std::find_if (asked.targets.begin(), asked.targets.end(),
                                      [] (const auto& target) { return target.level.has_value(); })
                            ->level;
    throw LimitError ("focus: peak level",
                      "is " + inWords (level) + " dB SL, which the limits do not allow; allowed: up to about "
                          + fixedText (std::floor (10 * (level + 20 * std::log10 (share))) / 10, 1) + " dB SL there. "
                          + failure.what(),
                      failure.minimumPeakVoltage, failure.reachableVelocity);
}

void sayVelocities (FocusDesign& design, const FocusDescription& asked)
{
    for (std::size_t i = 0; i < asked.targets.size(); ++i)
        if (const auto level = asked.targets[i].level)
            design.choices.push_back ("Target " + std::to_string (i + 1) + ": a level of " + inWords (*level)
                                      + " dB SL takes " + inWords (design.description.targets[i].peakVelocity * milli)
                                      + " mm/s.");
}
} // namespace

std::vector<double> feltLevels (const ModalModel& model, const VoltageProgram& program, Playback playback,
                                double duration, const std::vector<std::pair<double, double>>& places,
                                const SkinThreshold& threshold)
{
    const auto render = renderOffline (
        model, program, { playedAt (model, playback), duration, 512, Eigen::MatrixXd (0, model.coordinates()) });
    const auto felt = feltMotion (model, render.modalVelocities, render.sampleRate, threshold);
    std::vector<double> levels (places.size());
    std::transform (places.begin(), places.end(), levels.begin(),
                    [&] (const auto& place)
                    {
                        const auto shapes = shapesAt (model, place.first, place.second);
                        return sensationLevel (feltAmount (shapes * felt.modal, felt.sampleRate));
                    });
    return levels;
}

bool asksForLevels (const FocusDescription& focus)
{
    return std::any_of (focus.targets.begin(), focus.targets.end(),
                        [] (const auto& target) { return target.level.has_value(); });
}

FocusDesign designLevels (const ModalModel& model, const FocusDescription& asked, Playback playback,
                          const std::function<FocusDesign (const FocusDescription&)>& allocate)
{
    constexpr int mostRounds = 12;
    constexpr double shareBelowLimit = 0.5; // of what limits allow, where the first guess is too much
    auto wanted = asked;                    // with velocities that come nearer from round to round
    auto areLevelsKnown = false;

    for (int round = 0; round < mostRounds; ++round)
    {
        checkWatch();

        try
        {
            auto design = allocate (withoutLevels (wanted));
            const auto reached = feltLevels (model, withBrake (design, model).program, playback, endOf (asked),
                                             placesOf (asked.targets), asked.threshold);
            areLevelsKnown = true;

            if (correct (wanted.targets, reached) <= levelTolerance)
            {
                sayVelocities (design, asked);
                return design;
            }
        }
        catch (const LimitError& failure)
        {
            const auto share = failure.reachableVelocity / largestVelocity (wanted.targets);

            if (areLevelsKnown || ! (share > 0))
                refuseLevel (asked, failure, share);

            for (auto& target : wanted.targets)
                target.peakVelocity *= target.level ? shareBelowLimit * share : 1;
        }
    }

    throw InputError ("focus: peak level", "cannot be reached: targets keep each other from their levels; allowed: "
                                           "levels that lie nearer to each other, or targets farther apart");
}
} // namespace antinode
