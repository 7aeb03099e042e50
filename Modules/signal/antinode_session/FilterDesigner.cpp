#include "FilterDesigner.h"

#include "FocusSettings.h"

#include <antinode_base/InputError.h>
#include <antinode_tracks/FingerFilters.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr double worstQuickError = 0.1;  // of the wanted motion: -20 dB
constexpr double movingTolerance = 0.02; // of the wanted motion: -34 dB

/** The fingers that rest, those with an input first: the order of touchedPoints. */
std::vector<std::size_t> restingFingers (const TouchSettings& settings)
{
    std::vector<std::size_t> resting;

    for (std::size_t k = 0; k < settings.fingers.size(); ++k)
        if (settings.fingers[k].presence != FingerPresence::absent)
            resting.push_back (k);

    return resting;
}

TouchedPoint touchedPoint (const Surface& surface, const FingerSettings& finger)
{
    TouchedPoint point;
    std::tie (point.x, point.y) =
        placeFromPercent (surface, static_cast<double> (finger.xPercent), static_cast<double> (finger.yPercent));

    if (finger.load != FingerLoad::none)
        point.finger = builtInFinger (fingerLoadWords[static_cast<std::size_t> (finger.load)], point.x, point.y);

    return point;
}

/** What differs is designed again. */
TouchSettings placesOnly (TouchSettings settings)
{
    settings.latency = 0;

    for (auto& finger : settings.fingers)
        if (finger.presence == FingerPresence::absent)
            finger = {};
        else
            finger.presence = FingerPresence::plays;

    return settings;
}

/** A message about tracks and silent fingers, of the fingers that they are. */
std::string namingFingers (std::string text, const WaveformsDescription& description,
                           const std::vector<std::size_t>& resting)
{
    const std::string document = "waveforms: ";

    if (text.starts_with (document))
        text.erase (0, document.size());

    for (std::size_t p = 0; p < resting.size(); ++p)
    {
        const auto words = pointInWords (description, p);

        if (const auto at = text.find (words); at != std::string::npos)
            text.replace (at, words.size(), "finger " + std::to_string (resting[p] + 1));
    }

    return text;
}

std::shared_ptr<const FilterDesign> asPlayed (const FingerFilters& filters,
                                              const std::vector<Eigen::Index>& inputOfTrack, int inputs, TrackBand band)
{
    auto design = std::make_shared<FilterDesign>();
    design->bank = filterBank (filters, inputOfTrack, inputs);
    design->error = filters.error;
    design->noiseGains = Eigen::MatrixXd::Zero (design->bank.values.rows(), mostFingers);
    const auto gains = noiseGains (filters, band);

    for (std::size_t j = 0; j < inputOfTrack.size(); ++j)
        design->noiseGains.col (inputOfTrack[j]) = gains.col (static_cast<Eigen::Index> (j));

    return design;
}
} // namespace

WaveformsDescription waveformsFor (const Surface& surface, const TouchSettings& settings, int inputs)
{
    WaveformsDescription description;

    for (const auto k : restingFingers (settings))
        if (const auto point = touchedPoint (surface, settings.fingers[k]); static_cast<int> (k) < inputs)
            description.tracks.emplace_back().point = point;
        else
            description.silent.push_back (point);

    return description;
}

FilterSettings FilterDesigner::filterSettings (double sampleRate, std::size_t latency)
{
    FilterSettings settings;
    settings.sampleRate = sampleRate;
    settings.latency = touchLatencies[latency];
    return settings;
}

FilterDesigner::FilterDesigner (std::shared_ptr<const ModalModel> modelToDrive, double sampleRate, int inputsToTake)
    : model (std::move (modelToDrive)), rate (sampleRate), inputs (inputsToTake)
{
}

void FilterDesigner::setFingers (const TouchSettings& settings)
{
    if (const auto wanted = placesOnly (settings); std::exchange (places, wanted) != wanted)
        designs = {};
}

void FilterDesigner::makeDesign (std::size_t latency, const ShowProgress& progress)
{
    const auto description = waveformsFor (model->surface, places, inputs);
    const auto settings = filterSettings (rate, latency);

    if (description.tracks.empty())
    {
        auto silence = std::make_shared<FilterDesign>();
        silence->bank = silentBank (model->actuators(), inputs, filterTiming (description.band, settings));
        silence->noiseGains = Eigen::MatrixXd::Zero (model->actuators(), mostFingers);
        designs[latency] = std::move (silence);
        return;
    }

    const auto resting = restingFingers (places);

    try
    {
        const auto filters = designFingerFilters (*model, description, settings, progress);
        designs[latency] = asPlayed (filters, { resting.begin(), resting.begin() + std::ssize (description.tracks) },
                                     inputs, description.band);
    }
    catch (const InputError& failure)
    {
        throw InputError ({}, namingFingers (failure.what(), description, resting));
    }
}

std::unique_ptr<const FilterBank> FilterDesigner::quickBank (std::size_t latency, const TouchSettings& expected)
try
{
    const auto wanted = placesOnly (expected);
    const auto description = waveformsFor (model->surface, wanted, inputs);

    if (description.tracks.empty())
        return nullptr;

    if (quick[latency] == nullptr)
        quick[latency] =
            std::make_unique<const QuickFilterDesigner> (model, description.band, filterSettings (rate, latency));

    const auto filters =
        quick[latency]->design (description, wanted == places ? QuickFilterDesigner::usualTolerance : movingTolerance);

    if (! (filters.error <= worstQuickError))
        return nullptr;

    const auto resting = restingFingers (wanted);
    return std::make_unique<const FilterBank> (
        filterBank (filters, { resting.begin(), resting.begin() + std::ssize (description.tracks) }, inputs));
}
catch (const InputError&)
{
    return nullptr; // The design that follows says why.
}

namespace
{
using std::chrono::milliseconds;
using Seconds = std::chrono::duration<double>;

constexpr auto longestPause = milliseconds (100); // between two places of one way: slow hosts send one every 50 ms
constexpr auto wayKept = milliseconds (40);       // of a way, over which its velocity is a mean
constexpr auto shortestWay = milliseconds (5);    // that tells a velocity: x and y come one after the other
constexpr auto furthest = milliseconds (60);      // that a place is foretold from the last one seen
constexpr double leap = 400;                      // % of the surface in a second: quicker than hands go
constexpr float still = 0.5F;                     // % of the surface: a finger that rests trembles

bool isStill (const FingerSettings& one, const FingerSettings& other)
{
    return one.presence == other.presence && one.load == other.load && std::abs (one.xPercent - other.xPercent) <= still
           && std::abs (one.yPercent - other.yPercent) <= still;
}

float foretold (double from, double to, double times)
{
    return static_cast<float> (std::clamp (to + (to - from) * times, 0.0, 100.0));
}
} // namespace

void FingerMovement::note (const TouchSettings& settings, Clock::time_point time)
{
    newest = settings;

    if (! std::equal (settings.fingers.begin(), settings.fingers.end(), resting.fingers.begin(), isStill))
    {
        resting = settings;
        restsSince = time;
    }

    for (std::size_t k = 0; k < ways.size(); ++k)
        noteFinger (ways[k], settings.fingers[k], time);
}

void FingerMovement::noteFinger (Way& way, const FingerSettings& finger, Clock::time_point time)
{
    const Seen seen { time, static_cast<double> (finger.xPercent), static_cast<double> (finger.yPercent) };

    if (finger.presence == FingerPresence::absent)
        return way.clear();

    if (! way.empty())
    {
        const auto& last = way.back();
        const auto distance = std::hypot (seen.x - last.x, seen.y - last.y);

        if (distance == 0)
            return;

        if (time - last.time > longestPause || distance > leap * Seconds (time - last.time).count())
            way.clear();
    }

    way.push_back (seen);

    while (way.size() > 2 && time - way[1].time >= wayKept)
        way.erase (way.begin());
}

bool FingerMovement::isMoving (const Way& way, Clock::time_point now)
{
    if (way.size() < 2 || way.back().time - way.front().time < shortestWay)
        return false;

    const auto between = (way.back().time - way.front().time) / static_cast<Clock::rep> (way.size() - 1);
    return now - way.back().time <= 2 * between + shortestWay;
}

bool FingerMovement::isAnyMoving (Clock::time_point now) const
{
    return std::any_of (ways.begin(), ways.end(), [now] (const auto& way) { return isMoving (way, now); });
}

TouchSettings FingerMovement::expected (Clock::time_point now, Clock::duration ahead) const
{
    auto settings = newest;

    for (std::size_t k = 0; k < ways.size(); ++k)
        if (const auto& way = ways[k]; isMoving (way, now))
        {
            const auto &first = way.front(), &last = way.back();
            const auto passed = std::min<Clock::duration> (now + ahead - last.time, furthest);
            const auto times = Seconds (passed) / Seconds (last.time - first.time);
            settings.fingers[k].xPercent = foretold (first.x, last.x, times);
            settings.fingers[k].yPercent = foretold (first.y, last.y, times);
        }

    return settings;
}
} // namespace antinode
