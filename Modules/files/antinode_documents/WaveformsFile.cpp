#include "WaveformsFile.h"

#include "FileUnits.h"
#include "FingerFile.h"
#include "SharedFields.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/WaveFile.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::size_t maximumTracks = 64, maximumCorners = 1000, maximumEvents = 10000, maximumWarnings = 100;
constexpr NumberRange bandFrequency { 1, 10000 };
constexpr NumberRange signalFrequency { 1, 10000 };
constexpr NumberRange signalMilliseconds { 0.1, 600000 };
constexpr NumberRange rollMilliseconds { 0, 10000 };
constexpr NumberRange startMilliseconds { 0, 600000 };
constexpr NumberRange pathMilliseconds { -10000, 600000 };
constexpr NumberRange levelMicrometres { 1e-6, 1e6 };
constexpr NumberRange levelMillimetresPerSecond { 1e-6, 1e7 };
constexpr NumberRange levelDecibels { -60, 120 };
constexpr NumberRange depth { 0, 1 };
constexpr NumberRange eventAmplitude { 1e-6, 1e6 };
constexpr int largestSeed = 1000000000;
constexpr NumberRange signalRate { 100, 2e6 }, signalValue { -1e6, 1e6 };
constexpr std::size_t mostSignalSamples = 10'000'000, mostVibrationPoints = 1'000'000;
constexpr double micrometre = 1e-6;

double numberOr (const JsonObject& object, std::string_view key, const NumberRange& range, double usual)
{
    const auto given = object.optional (key);
    return given ? given->number (range) : usual;
}

double millisecondsOr (const JsonObject& object, std::string_view key, const NumberRange& range, double usual)
{
    const auto given = object.optional (key);
    return given ? fromMilliseconds (given->number (range)) : usual;
}

double millimetresOr (const JsonObject& object, std::string_view key, double usual)
{
    const auto given = object.optional (key);
    return given ? fromMillimetres (given->number (ranges::positionMillimetre)) : usual;
}

std::vector<PathPoint> readPath (const JsonValue& value)
{
    std::vector<PathPoint> path;

    for (const auto& item : value.items (2, maximumCorners))
    {
        const auto object = item.object ({ "time_ms", "x_mm", "y_mm" });
        PathPoint corner;
        corner.time = fromMilliseconds (object.required ("time_ms").number (pathMilliseconds));
        corner.x = fromMillimetres (object.required ("x_mm").number (ranges::positionMillimetre));
        corner.y = millimetresOr (object, "y_mm", 0);
        path.push_back (corner);
    }

    return path;
}

/** A place that stays, or a path that begins at it. @param isOptional  it may be given later */
void readPlace (const JsonObject& object, TouchedPoint& point, bool isOptional)
{
    if (isOptional && ! object.has ("x_mm") && ! object.has ("y_mm") && ! object.has ("path"))
    {
        point.x = point.y = std::numeric_limits<double>::quiet_NaN();
        return;
    }

    const auto [key, place] = object.oneOf ("x_mm", "path");

    if (key == "x_mm")
    {
        point.x = fromMillimetres (place.number (ranges::positionMillimetre));
        point.y = millimetresOr (object, "y_mm", 0);
        return;
    }

    if (object.has ("y_mm"))
        object.fail ("has both 'y_mm' and 'path'; allowed: one of them");

    point.path = readPath (place);
    point.x = point.path.front().x;
    point.y = point.path.front().y;
}

TouchedPoint readPoint (const JsonObject& object, bool mayLackPlace)
{
    TouchedPoint point;
    readPlace (object, point, mayLackPlace);

    if (const auto name = object.optional ("name"))
        point.name = name->text (ranges::maximumNameBytes);

    if (const auto finger = object.optional ("finger"))
    {
        point.finger = readFinger (*finger, point.x, point.y);

        if (point.finger->pressingForce)
            finger->fail ("has a pressing force; allowed with waveforms: fingers that stay on the surface");
    }

    return point;
}

ClickSignal readClick (const JsonValue& value)
{
    const auto object = value.object ({ "kind", "frequency_Hz" });
    ClickSignal click;
    click.frequency = numberOr (object, "frequency_Hz", signalFrequency, click.frequency);
    return click;
}

GaborSignal readGabor (const JsonValue& value)
{
    const auto object = value.object ({ "kind", "frequency_Hz", "width_ms" });
    GaborSignal gabor;
    gabor.frequency = numberOr (object, "frequency_Hz", signalFrequency, gabor.frequency);
    gabor.width = millisecondsOr (object, "width_ms", signalMilliseconds, gabor.width);
    return gabor;
}

ToneSignal readTone (const JsonValue& value)
{
    const auto object =
        value.object ({ "kind", "frequency_Hz", "duration_ms", "attack_ms", "modulation_Hz", "modulation_depth" });
    ToneSignal tone;
    tone.frequency = numberOr (object, "frequency_Hz", signalFrequency, tone.frequency);
    tone.duration = millisecondsOr (object, "duration_ms", signalMilliseconds, tone.duration);
    tone.attack = millisecondsOr (object, "attack_ms", signalMilliseconds, tone.attack);
    tone.modulationFrequency = numberOr (object, "modulation_Hz", signalFrequency, 0);
    tone.modulationDepth = numberOr (object, "modulation_depth", depth, tone.modulationDepth);
    return tone;
}

NoiseSignal readNoise (const JsonValue& value)
{
    const auto object = value.object ({ "kind", "duration_ms", "attack_ms", "seed" });
    NoiseSignal noise;
    noise.duration = millisecondsOr (object, "duration_ms", signalMilliseconds, noise.duration);
    noise.attack = millisecondsOr (object, "attack_ms", signalMilliseconds, noise.attack);

    if (const auto seed = object.optional ("seed"))
        noise.seed = static_cast<std::uint64_t> (seed->integer (0, largestSeed));

    return noise;
}

SampledSignal readSamples (const JsonValue& value)
{
    const auto object = value.object ({ "kind", "sample_rate_Hz", "values" });
    const auto rate = object.required ("sample_rate_Hz").number (signalRate);
    const auto values = object.required ("values").numbers (1, mostSignalSamples, signalValue);
    return { {}, rate, Eigen::Map<const Eigen::VectorXd> (values.data(), static_cast<Eigen::Index> (values.size())) };
}

VibrationSignal readVibration (const JsonValue& value)
{
    const auto object = value.object ({ "kind", "points" });
    VibrationSignal vibration;

    for (const auto& item : object.required ("points").items (2, mostVibrationPoints))
    {
        const auto numbers = item.numbers (3, 3, signalValue);
        const auto before = vibration.points.empty() ? 0 : vibration.points.back().time;
        const VibrationPoint point { fromMilliseconds (numbers[0]), numbers[1], numbers[2] };

        if (! (vibration.points.empty() ? point.time == 0 : point.time > before))
            item.fail ("is at " + numberText (numbers[0])
                       + " ms; allowed: 0 for the first point, then times that ascend");

        if (! signalFrequency.contains (point.frequency))
            item.fail ("has " + numberText (point.frequency) + " Hz; allowed: " + signalFrequency.text());

        vibration.points.push_back (point);
    }

    return vibration;
}

enum class SignalKind
{
    click,
    gabor,
    tone,
    noise,
    wav,
    samples,
    vibration
};

constexpr WordList<SignalKind, 7> signalKindWords { { { "click", SignalKind::click },
                                                      { "gabor", SignalKind::gabor },
                                                      { "tone", SignalKind::tone },
                                                      { "noise", SignalKind::noise },
                                                      { "wav", SignalKind::wav },
                                                      { "samples", SignalKind::samples },
                                                      { "vibration", SignalKind::vibration } } };

TrackSignal readSignal (const JsonValue& value, const std::filesystem::path& folder)
{
    switch (value.required ("kind").choice (signalKindWords))
    {
        case SignalKind::click:
            return readClick (value);
        case SignalKind::gabor:
            return readGabor (value);
        case SignalKind::tone:
            return readTone (value);
        case SignalKind::noise:
            return readNoise (value);
        case SignalKind::samples:
            return readSamples (value);
        case SignalKind::vibration:
            return readVibration (value);
        case SignalKind::wav:
            break;
    }

    return readRecording (value, folder);
}

TrackLevel readLevel (const JsonObject& object, const TrackLevel& usual)
{
    const auto micrometres = object.optional ("level_um");
    const auto velocity = object.optional ("level_mm_s");
    const auto sensation = object.optional ("level_dB_SL");

    if (micrometres.has_value() + velocity.has_value() + sensation.has_value() > 1)
        object.fail ("has several levels; allowed: one of 'level_um', 'level_mm_s' and 'level_dB_SL'");

    if (micrometres)
        return { LevelKind::displacement, micrometre * micrometres->number (levelMicrometres) };

    if (velocity)
        return { LevelKind::velocity, fromMillimetres (velocity->number (levelMillimetresPerSecond)) };

    return sensation ? TrackLevel { LevelKind::sensation, sensation->number (levelDecibels) } : usual;
}

/** One event, of a list or as the track itself gives it. @param usual  its level where it gives none */
TrackEvent readEvent (const JsonObject& object, const TrackLevel& usual, const std::filesystem::path& folder)
{
    TrackEvent event;
    event.signal = readSignal (object.required ("signal"), folder);
    event.level = readLevel (object, usual);
    event.amplitude = numberOr (object, "amplitude", eventAmplitude, event.amplitude);
    event.start = millisecondsOr (object, "start_ms", startMilliseconds, 0);
    return event;
}

Track readTrack (const JsonValue& value, const std::filesystem::path& folder)
{
    constexpr TrackLevel usual { LevelKind::sensation, 25 };
    const auto object = value.object ({ "name", "x_mm", "y_mm", "path", "finger", "signal", "level_um", "level_mm_s",
                                        "level_dB_SL", "amplitude", "start_ms", "events" });
    Track track;
    track.point = readPoint (object, true);

    if (object.oneOf ("signal", "events").first == "signal")
    {
        track.events = { readEvent (object, usual, folder) };
        return track;
    }

    if (object.has ("amplitude") || object.has ("start_ms"))
        object.fail ("has 'events' and of its own 'amplitude' or 'start_ms'; allowed: in each event");

    const auto level = readLevel (object, usual);
    track.events.clear();

    for (const auto& event : object.required ("events").items (1, maximumEvents))
        track.events.push_back (
            readEvent (event.object ({ "signal", "level_um", "level_mm_s", "level_dB_SL", "amplitude", "start_ms" }),
                       level, folder));

    return track;
}

TrackBand readBand (const JsonValue& value)
{
    const auto numbers = value.numbers (2, 2, bandFrequency);

    if (! (numbers[0] < numbers[1]))
        value.fail ("does not ascend; allowed: a lower and a higher frequency, Hz");

    return { numbers[0], numbers[1] };
}
} // namespace

SampledSignal readRecording (const JsonValue& value, const std::filesystem::path& folder)
{
    constexpr std::size_t longestPath = 4000;
    const auto object = value.object ({ "kind", "file", "channel" });
    const auto file = object.required ("file").text (longestPath);
    const auto recorded = readWaveFile (folder / file);
    const auto channels = static_cast<int> (recorded.samples.rows());
    const auto channel = object.has ("channel") ? object.required ("channel").integer (1, channels) : 1;
    return { file, recorded.sampleRate, recorded.samples.row (channel - 1).transpose() };
}

WaveformsDescription readWaveforms (const nlohmann::json& document, const std::string& source,
                                    const std::filesystem::path& folder)
{
    const JsonValue value (document, source);
    value.requireSchema ("antinode.waveforms/1");
    const auto object = value.object ({ "schema", "name", "description", "device", "band_Hz", "pre_roll_ms",
                                        "post_roll_ms", "tracks", "silent", "warnings" });
    WaveformsDescription description;

    if (const auto name = object.optional ("name"))
        description.name = name->text (ranges::maximumNameBytes);

    if (const auto text = object.optional ("description"))
        text->text (ranges::maximumDescriptionBytes, true);

    readNamedDevice (object.optional ("device"));

    if (const auto band = object.optional ("band_Hz"))
        description.band = readBand (*band);

    description.preRoll = millisecondsOr (object, "pre_roll_ms", rollMilliseconds, description.preRoll);
    description.postRoll = millisecondsOr (object, "post_roll_ms", rollMilliseconds, description.postRoll);

    for (const auto& track : object.required ("tracks").items (1, maximumTracks))
        description.tracks.push_back (readTrack (track, folder));

    if (const auto silent = object.optional ("silent"))
        for (const auto& finger : silent->items (0, maximumTracks))
            description.silent.push_back (
                readPoint (finger.object ({ "name", "x_mm", "y_mm", "path", "finger" }), false));

    if (const auto warnings = object.optional ("warnings"))
        for (const auto& warning : warnings->items (0, maximumWarnings))
            description.warnings.push_back (warning.text (ranges::maximumDescriptionBytes));

    return withSummedTracks (std::move (description));
}
} // namespace antinode
