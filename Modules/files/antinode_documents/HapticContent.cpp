#include "HapticContent.h"

#include "AhapReader.h"
#include "FileUnits.h"
#include "HjifReader.h"
#include "VibrationEffectReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace antinode
{
namespace
{
constexpr double lowestFrequency = 65, highestFrequency = 300; // Hz
constexpr auto xmlBegins = '<';

nlohmann::json signalToJson (const TrackSignal& signal)
{
    if (const auto* const sampled = std::get_if<SampledSignal> (&signal))
        return { { "kind", "samples" },
                 { "sample_rate_Hz", sampled->sampleRate },
                 { "values", std::vector<double> (sampled->samples.begin(), sampled->samples.end()) } };

    auto points = nlohmann::json::array();

    for (const auto& point : std::get<VibrationSignal> (signal).points)
        points.push_back ({ toMilliseconds (point.time), point.amplitude, point.frequency });

    return { { "kind", "vibration" }, { "points", std::move (points) } };
}

nlohmann::json eventsToJson (const HapticContent& content)
{
    auto events = nlohmann::json::array();

    for (const auto& event : content.events)
        events.push_back ({ { "start_ms", toMilliseconds (event.start) },
                            { "amplitude", event.amplitude },
                            { "signal", signalToJson (event.signal) } });

    return events;
}

/** The first letter that is no blank, 0 where there is none; a mark of the byte order is none. */
char firstLetter (std::string_view bytes)
{
    const auto first = bytes.find_first_not_of ("\xEF\xBB\xBF \t\r\n");
    return first == std::string_view::npos ? '\0' : bytes[first];
}

/** The haptic content of a file. @param other  JSON that is none: then nothing is returned */
std::optional<HapticContent> contentOf (std::string_view bytes, const std::string& source, nlohmann::json& other)
{
    HapticContent content;

    if (firstLetter (bytes) == xmlBegins)
        content = readVibrationEffect (bytes, source);
    else
    {
        other = parseJson (bytes, source);
        const auto has = [&] (const char* key) { return other.is_object() && other.contains (key); };

        if (! has ("schema") && has ("Pattern"))
            content = readAhap (other, source);
        else if (! has ("schema") && has ("perceptions"))
            content = readHjif (other, source);
        else if (! has ("schema") && has ("timings"))
            content = readVibrationTimings (other, source);
        else
            return {};
    }

    if (content.events.empty())
        throw InputError (source, "has no vibration; allowed: at least one with an intensity above 0");

    return content;
}
} // namespace

double hapticFrequency (double sharpness)
{
    return std::lerp (lowestFrequency, highestFrequency, std::clamp (sharpness, 0.0, 1.0));
}

std::vector<VibrationPoint> transientPoints (double intensity, double sharpness)
{
    const auto frequency = hapticFrequency (sharpness);
    return { { 0, 0, frequency },
             { shortestEdge, intensity, frequency },
             { transientDuration - shortestEdge, intensity, frequency },
             { transientDuration, 0, frequency } };
}

void addVibration (HapticContent& content, double start, std::vector<VibrationPoint> points)
{
    double amplitude = 0;

    for (const auto& point : points)
        amplitude = std::max (amplitude, std::abs (point.amplitude));

    if (amplitude >= leastIntensity)
        content.events.push_back ({ VibrationSignal { std::move (points) }, {}, amplitude, start });
}

nlohmann::json waveformsDocument (std::string_view bytes, const std::string& source)
{
    nlohmann::json other;

    if (const auto content = contentOf (bytes, source, other))
        return { { "schema", "antinode.waveforms/1" },
                 { "tracks", { { { "finger", "medium" }, { "events", eventsToJson (*content) } } } },
                 { "warnings", content->warnings } };

    return other;
}

nlohmann::json withHapticFiles (nlohmann::json document, const std::filesystem::path& folder)
{
    if (! document.is_object() || ! document.contains ("tracks") || ! document["tracks"].is_array())
        return document;

    for (auto& track : document["tracks"])
        if (track.is_object() && track.contains ("events") && track["events"].is_string())
        {
            const auto file = folder / track["events"].get<std::string>();
            nlohmann::json other;
            const auto content = contentOf (readWholeFile (file, { "haptic content" }), file.string(), other);

            if (! content)
                throw InputError (file.string(), "is no haptic content; allowed: AHAP, HJIF, VibrationEffect");

            track["events"] = eventsToJson (*content);
            auto& warnings = document["warnings"];

            if (warnings.is_null() || warnings.is_array())
                for (const auto& warning : content->warnings)
                    warnings.push_back (warning);
        }

    return document;
}
} // namespace antinode
