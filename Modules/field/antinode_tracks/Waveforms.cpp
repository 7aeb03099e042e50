#include "Waveforms.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_model/Surface.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto pi = std::numbers::pi;
constexpr double clickReach = 4;   // pi f t at the ends of a click: there it has fallen to 1e-6
constexpr double gaborReach = 2.2; // widths from the middle of a Gabor burst to its ends: the same
constexpr double edgeFade = 0.005; // s at both ends of a recording or a vibration
constexpr double lowSlope = 0.8;   // of the lower frequency: where its slope begins
constexpr double highSlope = 1.15; // of the upper frequency: where its slope ends

/** From 0 to 1 along a raised cosine. */
double raised (double share)
{
    return 0.5 - 0.5 * std::cos (pi * std::clamp (share, 0.0, 1.0));
}

/** Rises and falls within an attack. */
double envelope (double time, double duration, double attack)
{
    return attack > 0 ? raised (time / attack) * raised ((duration - time) / attack) : 1;
}

double durationOf (const ClickSignal& click)
{
    return 2 * clickReach / (pi * click.frequency);
}

double durationOf (const GaborSignal& gabor)
{
    return 2 * gaborReach * gabor.width;
}

double durationOf (const ToneSignal& tone)
{
    return tone.duration;
}

double durationOf (const NoiseSignal& noise)
{
    return noise.duration;
}

double durationOf (const SampledSignal& sampled)
{
    return static_cast<double> (sampled.samples.size() - 1) / sampled.sampleRate;
}

double durationOf (const VibrationSignal& vibration)
{
    return 2 * edgeFade + vibration.points.back().time;
}

double valueAt (const ClickSignal& click, double time)
{
    const auto angle = std::pow (pi * click.frequency * time - clickReach, 2);
    return (1 - 2 * angle) * std::exp (-angle);
}

double valueAt (const GaborSignal& gabor, double time)
{
    const auto fromMiddle = time - gaborReach * gabor.width;
    return std::exp (-4 * std::numbers::ln2 * std::pow (fromMiddle / gabor.width, 2))
           * std::cos (2 * pi * gabor.frequency * fromMiddle);
}

double valueAt (const ToneSignal& tone, double time)
{
    const auto swing = 0.5 + 0.5 * std::cos (2 * pi * tone.modulationFrequency * time);
    const auto amplitude = tone.modulationFrequency > 0 ? 1 - tone.modulationDepth * swing : 1;
    return envelope (time, tone.duration, tone.attack) * amplitude * std::sin (2 * pi * tone.frequency * time);
}

template <typename Signal>
Eigen::VectorXd sampled (const Signal& signal, TrackBand, double sampleRate, Eigen::VectorXd samples)
{
    for (Eigen::Index n = 0; n < samples.size(); ++n)
        if (const auto time = static_cast<double> (n) / sampleRate; time <= durationOf (signal))
            samples[n] = valueAt (signal, time);

    return samples;
}

/** Tones of equal amplitude and random phase, as many as have a whole number of periods. */
Eigen::VectorXd sampled (const NoiseSignal& noise, TrackBand band, double sampleRate, Eigen::VectorXd samples)
{
    RandomNumbers random (noise.seed);
    const auto first = static_cast<std::int64_t> (std::ceil (band.lower * noise.duration));
    const auto last = static_cast<std::int64_t> (std::floor (band.upper * noise.duration));

    for (auto line = first; line <= last; ++line)
    {
        checkWatch();
        const auto turn = std::polar (1.0, 2 * pi * static_cast<double> (line) / (noise.duration * sampleRate));
        auto phasor = std::polar (1.0, 2 * pi * random.uniform());

        for (auto& value : samples)
        {
            value += phasor.real();
            phasor *= turn;
        }
    }

    for (Eigen::Index n = 0; n < samples.size(); ++n)
        samples[n] *= envelope (static_cast<double> (n) / sampleRate, noise.duration, noise.attack);

    return samples;
}

/** What is in the band, without a shift in time. */
Eigen::VectorXd withinBand (const Eigen::VectorXd& samples, TrackBand band, double sampleRate)
{
    constexpr double silence = 0.1; // s, in which the filter dies away
    const auto length = quickLength (static_cast<double> (samples.size()) + silence * sampleRate);
    auto spectrum = forwardFourier (samples, length);

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
    {
        const auto frequency = static_cast<double> (k) * sampleRate / static_cast<double> (length);
        spectrum[k] *= raised ((frequency / band.lower - lowSlope) / (1 - lowSlope))
                       * raised ((highSlope - frequency / band.upper) / (highSlope - 1));
    }

    return inverseFourier (spectrum, length).head (samples.size());
}

/** What is in the band, with faded ends. */
Eigen::VectorXd fadedInBand (Eigen::VectorXd samples, TrackBand band, double sampleRate, double duration)
{
    samples = withinBand (samples, band, sampleRate);

    for (Eigen::Index n = 0; n < samples.size(); ++n)
        samples[n] *= envelope (static_cast<double> (n) / sampleRate, duration, edgeFade);

    return samples;
}

/** At another rate: the interpolation reaches so far that nothing above either Nyquist frequency is left. */
Eigen::VectorXd sampled (const SampledSignal& signal, TrackBand band, double sampleRate, Eigen::VectorXd samples)
{
    const auto ratio = signal.sampleRate / sampleRate, width = std::max (1.0, ratio);
    const auto reach = kaiserSincHalfWidth * width;

    for (Eigen::Index n = 0; n < samples.size(); ++n)
    {
        const auto centre = static_cast<double> (n) * ratio;
        const auto begin = std::max<Eigen::Index> (0, static_cast<Eigen::Index> (std::ceil (centre - reach)));
        const auto end = std::min (signal.samples.size(), static_cast<Eigen::Index> (std::floor (centre + reach)) + 1);

        for (auto m = begin; m < end; ++m)
            samples[n] += signal.samples[m] * kaiserSinc ((centre - static_cast<double> (m)) / width) / width;
    }

    return fadedInBand (std::move (samples), band, sampleRate, durationOf (signal));
}

Eigen::VectorXd sampled (const VibrationSignal& signal, TrackBand band, double sampleRate, Eigen::VectorXd samples)
{
    const auto& points = signal.points;
    std::size_t next = 1;
    double turns = 0; // at the point before the next one

    for (auto n = static_cast<Eigen::Index> (std::ceil (edgeFade * sampleRate)); n < samples.size(); ++n)
    {
        const auto time = static_cast<double> (n) / sampleRate - edgeFade;

        for (; next < points.size() && time > points[next].time; ++next)
            turns +=
                (points[next].time - points[next - 1].time) * (points[next].frequency + points[next - 1].frequency) / 2;

        if (next == points.size())
            break;

        const auto &from = points[next - 1], &to = points[next];
        const auto share = (time - from.time) / (to.time - from.time);
        const auto frequency = std::lerp (from.frequency, to.frequency, share / 2); // its mean since the point
        samples[n] = std::lerp (from.amplitude, to.amplitude, share)
                     * std::sin (2 * pi * (turns + (time - from.time) * frequency));
    }

    return fadedInBand (std::move (samples), band, sampleRate, durationOf (signal));
}
} // namespace

double signalDuration (const TrackSignal& signal)
{
    return std::visit ([] (const auto& each) { return durationOf (each); }, signal);
}

Eigen::VectorXd signalSamples (const TrackSignal& signal, TrackBand band, double sampleRate)
{
    constexpr double rounding = 1e-9; // samples
    const auto count = static_cast<Eigen::Index> (std::ceil (signalDuration (signal) * sampleRate - rounding)) + 1;
    return std::visit (
        [&] (const auto& each) { return sampled (each, band, sampleRate, Eigen::VectorXd::Zero (count)); }, signal);
}

namespace
{
void requirePath (const Surface& surface, const TouchedPoint& point, const std::string& which)
{
    constexpr double fastest = 2, longest = 10; // m/s, m
    double length = 0;

    if (point.finger && ! point.path.empty())
        throw InputError (which + " finger", "moves, and so does its load; allowed: a path "
                                             "without a finger, or a finger that stays");

    for (std::size_t i = 0; i < point.path.size(); ++i)
    {
        const auto& to = point.path[i];
        const auto where = which + " path " + std::to_string (i + 1);
        requireOnSurface (surface, to.x, to.y, where);

        if (i == 0)
            continue;

        const auto& from = point.path[i - 1];
        const auto distance = std::hypot (to.x - from.x, to.y - from.y), duration = to.time - from.time;
        length += distance;

        if (! (duration > 0))
            throw InputError (where + " time", "is " + inWords (to.time * milli)
                                                   + " ms, not after the one before; "
                                                     "allowed: times that ascend");

        if (distance > fastest * duration)
            throw InputError (where, "is reached at " + inWords (distance / duration * milli)
                                         + " mm/s; allowed: " + inWords (fastest * milli) + " mm/s or less");
    }

    if (length > longest)
        throw InputError (which + " path",
                          "is " + inWords (length) + " m long; allowed: " + inWords (longest) + " m or less");
}

bool isAtOnePlace (const TouchedPoint& a, const TouchedPoint& b)
{
    constexpr double same = 1e-6; // m
    const auto isSameCorner = [] (const PathPoint& p, const PathPoint& q)
    { return p.time == q.time && std::hypot (p.x - q.x, p.y - q.y) < same; };
    return std::hypot (a.x - b.x, a.y - b.y) < same
           && std::equal (a.path.begin(), a.path.end(), b.path.begin(), b.path.end(), isSameCorner);
}

/** How far all points together have moved at the corners of their paths. */
struct Travel
{
    std::vector<double> times, distances; ///< Ascending, s; from the first time on, m.
};

Travel travelOf (const std::vector<TouchedPoint>& points)
{
    Travel travel;

    for (const auto& point : points)
        for (const auto& corner : point.path)
            travel.times.push_back (corner.time);

    std::sort (travel.times.begin(), travel.times.end());
    travel.times.erase (std::unique (travel.times.begin(), travel.times.end()), travel.times.end());

    for (std::size_t i = 0; i < travel.times.size(); ++i)
    {
        double distance = i > 0 ? travel.distances.back() : 0;

        for (const auto& point : points)
            if (i > 0)
            {
                const auto from = placeAt (point, travel.times[i - 1]), to = placeAt (point, travel.times[i]);
                distance += std::hypot (to.x - from.x, to.y - from.y);
            }

        travel.distances.push_back (distance);
    }

    return travel;
}
} // namespace

WaveformsDescription withSummedTracks (WaveformsDescription description)
{
    std::vector<Track> kept;
    const auto given = std::move (description.tracks);

    for (std::size_t i = 0; i < given.size(); ++i)
    {
        const auto& track = given[i];
        const auto same = std::find_if (kept.begin(), kept.end(),
                                        [&] (const Track& other) { return isAtOnePlace (other.point, track.point); });

        if (same == kept.end())
        {
            kept.push_back (track);
            continue;
        }

        same->events.insert (same->events.end(), track.events.begin(), track.events.end());

        if (! same->point.finger)
            same->point.finger = track.point.finger;

        description.warnings.push_back ("Track " + std::to_string (i + 1)
                                        + " is at the place of another track: the waveform there is their sum.");
    }

    description.tracks = std::move (kept);
    return description;
}

std::vector<TouchedPoint> touchedPoints (const WaveformsDescription& description)
{
    std::vector<TouchedPoint> points;

    for (const auto& track : description.tracks)
        points.push_back (track.point);

    points.insert (points.end(), description.silent.begin(), description.silent.end());
    return points;
}

std::vector<Finger> restingFingers (const WaveformsDescription& description)
{
    std::vector<Finger> fingers;

    for (const auto& point : touchedPoints (description))
        if (point.finger)
            fingers.push_back (*point.finger);

    return fingers;
}

std::string pointInWords (const WaveformsDescription& description, std::size_t point)
{
    const auto tracks = description.tracks.size();
    return point < tracks ? "track " + std::to_string (point + 1)
                          : "silent finger " + std::to_string (point - tracks + 1);
}

PathPoint placeAt (const TouchedPoint& point, double time)
{
    const auto& path = point.path;

    if (path.empty())
        return { time, point.x, point.y };

    const auto after =
        std::upper_bound (path.begin(), path.end(), time, [] (double t, const PathPoint& p) { return t < p.time; });

    if (after == path.begin() || after == path.end())
    {
        const auto& end = after == path.begin() ? path.front() : path.back();
        return { time, end.x, end.y };
    }

    const auto &from = *(after - 1), &to = *after;
    const auto share = (time - from.time) / (to.time - from.time);
    return { time, from.x + share * (to.x - from.x), from.y + share * (to.y - from.y) };
}

WaveformsDescription stillAt (const WaveformsDescription& description, double time)
{
    auto still = description;
    const auto stay = [&] (TouchedPoint& point)
    {
        const auto place = placeAt (point, time);
        point.x = place.x;
        point.y = place.y;
        point.path.clear();
    };

    for (auto& track : still.tracks)
        stay (track.point);

    for (auto& point : still.silent)
        stay (point);

    return still;
}

std::vector<double> timesOfPlaces (const WaveformsDescription& description, double step, int mostSteps)
{
    const auto travel = travelOf (touchedPoints (description));

    if (travel.times.empty())
        return { 0 };

    const auto steps = static_cast<int> (std::min<double> (mostSteps, std::ceil (travel.distances.back() / step)));
    std::vector<double> times { travel.times.front() };

    for (int i = 1; i <= steps; ++i)
    {
        const auto distance = travel.distances.back() * i / steps;
        const auto after = std::lower_bound (travel.distances.begin() + 1, travel.distances.end() - 1, distance)
                           - travel.distances.begin();
        const auto last = static_cast<std::size_t> (after);
        const auto span = travel.distances[last] - travel.distances[last - 1];
        const auto share = span > 0 ? std::min (1.0, (distance - travel.distances[last - 1]) / span) : 1;
        times.push_back (travel.times[last - 1] + share * (travel.times[last] - travel.times[last - 1]));
    }

    return times;
}

double tracksDuration (const WaveformsDescription& description)
{
    double duration = 0;

    for (const auto& track : description.tracks)
        for (const auto& event : track.events)
            duration = std::max (duration, event.start + signalDuration (event.signal));

    return duration;
}

void requirePlaces (const Surface& surface, const WaveformsDescription& description)
{
    const auto points = touchedPoints (description);

    for (std::size_t p = 0; p < points.size(); ++p)
    {
        const auto which = "waveforms: " + pointInWords (description, p);

        if (std::isnan (points[p].x))
            throw InputError (which, "has no place; allowed: --at X,Y, or x_mm and y_mm");

        requireOnSurface (surface, points[p].x, points[p].y, which);
        requirePath (surface, points[p], which);
    }
}

Eigen::MatrixXd touchedShapes (const ModalModel& model, const WaveformsDescription& description)
{
    requirePlaces (model.surface, description);
    const auto points = touchedPoints (description);
    Eigen::MatrixXd shapes (static_cast<Eigen::Index> (points.size()), model.coordinates());

    for (std::size_t p = 0; p < points.size(); ++p)
        shapes.row (static_cast<Eigen::Index> (p)) = shapesAt (model, points[p].x, points[p].y);

    return shapes;
}
} // namespace antinode
