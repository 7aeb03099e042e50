#include "AhapReader.h"

#include <antinode_base/Reflection.h>
#include <antinode_base/Watch.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace antinode
{
namespace
{
constexpr std::size_t mostEntries = 10000, mostPoints = 10000;
constexpr NumberRange unclamped { -1e9, 1e9 };
constexpr std::size_t mostPatternPoints = 1000000;
constexpr NumberRange patternSeconds { 0, 600 };
constexpr int fewestSteps = 8; // of what changes along no straight line, each shortestEdge at most

/** A value that changes along straight lines. */
using ControlLine = std::vector<std::pair<double, double>>; // s, value

double controlAt (const ControlLine& line, double time)
{
    const auto after =
        std::upper_bound (line.begin(), line.end(), time, [] (double t, const auto& point) { return t < point.first; });

    if (after == line.begin() || after == line.end())
        return after == line.begin() ? line.front().second : line.back().second;

    const auto &from = *(after - 1), &to = *after;
    return std::lerp (from.second, to.second, (time - from.first) / (to.first - from.first));
}

/** What changes all events while they play: the dynamic parameters. */
enum ControlKind
{
    intensityControl,
    sharpnessControl,
    attackControl,
    decayControl,
    releaseControl,
    controlKinds
};

constexpr WordList<ControlKind, controlKinds> controlWords { { { "HapticIntensityControl", intensityControl },
                                                               { "HapticSharpnessControl", sharpnessControl },
                                                               { "HapticAttackTimeControl", attackControl },
                                                               { "HapticDecayTimeControl", decayControl },
                                                               { "HapticReleaseTimeControl", releaseControl } } };

/** A dynamic parameter or a curve of it, which replaces what was before from its begin on. */
struct ControlChange
{
    double begin = 0; // s
    ControlLine points;
};

struct Controls
{
    std::array<std::vector<ControlChange>, controlKinds> changes;
    std::array<ControlLine, controlKinds> lines;
};

double clampedNumber (const JsonValue& value, double least, double most)
{
    return std::clamp (value.number (unclamped), least, most);
}

double secondsOr (const JsonValue& object, std::string_view key, double usual)
{
    const auto given = object.find (key);
    return given ? given->number (patternSeconds) : usual;
}

/** Which control an entry sets; none where it is one of audio. */
std::optional<ControlKind> controlOf (const JsonValue& entry)
{
    const auto name = entry.required ("ParameterID");

    for (const auto& [word, kind] : controlWords)
        if (name.isWord (word))
            return kind;

    name.text (100);
    return {};
}

double controlValue (const JsonValue& entry, ControlKind kind)
{
    return clampedNumber (entry.required ("ParameterValue"), kind == intensityControl ? 0 : -1, 1);
}

void readDynamicParameter (const JsonValue& entry, Controls& controls)
{
    if (const auto kind = controlOf (entry))
    {
        const auto time = secondsOr (entry, "Time", 0);
        controls.changes[*kind].push_back ({ time, { { time, controlValue (entry, *kind) } } });
    }
}

void readParameterCurve (const JsonValue& entry, Controls& controls)
{
    const auto kind = controlOf (entry);

    if (! kind)
        return;

    ControlChange change;
    change.begin = secondsOr (entry, "Time", 0);

    for (const auto& point : entry.required ("ParameterCurveControlPoints").items (0, mostPoints))
        change.points.emplace_back (change.begin + secondsOr (point, "Time", 0), controlValue (point, *kind));

    std::stable_sort (change.points.begin(), change.points.end(),
                      [] (const auto& a, const auto& b) { return a.first < b.first; });

    if (! change.points.empty())
        controls.changes[*kind].push_back (std::move (change));
}

/** The changes one after the other. A jump ends when the change begins; a curve whose first point is later leads there.
 */
ControlLine controlLine (std::vector<ControlChange> changes, double usual)
{
    ControlLine line { { -1, usual } };
    std::stable_sort (changes.begin(), changes.end(), [] (const auto& a, const auto& b) { return a.begin < b.begin; });

    for (const auto& change : changes)
    {
        const auto first = change.points.front().first;
        const auto left = first - change.begin < shortestEdge ? first - shortestEdge : change.begin;
        const auto before = controlAt (line, left);

        while (line.size() > 1 && line.back().first >= left)
            line.pop_back();

        line.emplace_back (left, before);

        for (const auto& point : change.points)
            if (point.first > line.back().first)
                line.push_back (point);
            else
                line.back().second = point.second;
    }

    return line;
}

/** The parameters of an event, 0 to 1 each. */
struct EventParameters
{
    double intensity = 0, sharpness = 0, attack = 0, decay = 0, release = 0;
    bool isSustained = true;
};

void readAhapValue (const JsonValue& entry, EventParameters& parameters)
{
    const auto name = entry.required ("ParameterID");
    const auto value = entry.required ("ParameterValue");
    const auto words = std::to_array<std::pair<std::string_view, double EventParameters::*>> (
        { { "HapticIntensity", &EventParameters::intensity },
          { "HapticSharpness", &EventParameters::sharpness },
          { "AttackTime", &EventParameters::attack },
          { "DecayTime", &EventParameters::decay },
          { "ReleaseTime", &EventParameters::release } });

    for (const auto& [word, member] : words)
        if (name.isWord (word))
            parameters.*member = clampedNumber (value, 0, 1);

    if (name.isWord ("Sustained"))
        parameters.isSustained = value.number (unclamped) > 0.5;
}

/** How long an edge of an envelope lasts, s. Core Haptics gives no numbers: these are a choice of ours. */
double edgeDuration (double parameter)
{
    constexpr double longest = 1; // s
    const auto share = std::clamp (parameter, 0.0, 1.0);
    return shortestEdge + longest * share * share;
}

/** From the begin of a continuous event on. */
ControlLine envelopeOf (const EventParameters& parameters, const Controls& controls, double start, double duration)
{
    const auto edge = [&] (double parameter, ControlKind kind)
    { return edgeDuration (parameter + controlAt (controls.lines[kind], start)); };
    const auto attack = edge (parameters.attack, attackControl);

    if (! parameters.isSustained)
        return { { 0, 0 }, { attack, 1 }, { attack + transientDuration + edge (parameters.decay, decayControl), 0 } };

    const auto release = edge (parameters.release, releaseControl);

    if (attack >= duration)
        return { { 0, 0 }, { duration, duration / attack }, { duration + release, 0 } };

    return { { 0, 0 }, { attack, 1 }, { duration, 1 }, { duration + release, 0 } };
}

/** All times at which an envelope or a control changes its course, from the begin of the event on. */
std::vector<double> coursesOf (const ControlLine& envelope, const Controls& controls, double start)
{
    constexpr double same = 1e-6; // s
    std::vector<double> times;

    for (const auto& point : envelope)
        times.push_back (point.first);

    for (const auto kind : { intensityControl, sharpnessControl })
        for (const auto& point : controls.lines[kind])
            if (const auto time = point.first - start; time > 0 && time < envelope.back().first)
                times.push_back (time);

    std::sort (times.begin(), times.end());
    times.erase (std::unique (times.begin(), times.end(), [] (double a, double b) { return b - a < same; }),
                 times.end());
    return times;
}

std::vector<VibrationPoint> pointsOf (const EventParameters& parameters, const ControlLine& envelope,
                                      const Controls& controls, double start)
{
    const auto at = [&] (double time)
    {
        return VibrationPoint { time,
                                parameters.intensity * controlAt (envelope, time)
                                    * controlAt (controls.lines[intensityControl], start + time),
                                hapticFrequency (parameters.sharpness
                                                 + controlAt (controls.lines[sharpnessControl], start + time)) };
    };
    const auto times = coursesOf (envelope, controls, start);
    std::vector<VibrationPoint> points { at (0) };

    for (std::size_t i = 1; i < times.size(); ++i)
    {
        const auto from = points.back(), to = at (times[i]);
        const auto isStraight = from.frequency == to.frequency && from.amplitude == to.amplitude;
        const auto steps =
            isStraight ? 1
                       : std::max (fewestSteps, static_cast<int> (std::ceil ((to.time - from.time) / shortestEdge)));

        for (int step = 1; step <= steps; ++step)
            points.push_back (at (from.time + (to.time - from.time) * step / steps));
    }

    return points;
}

enum class EventKind
{
    transient,
    continuous,
    audio
};

constexpr WordList<EventKind, 4> eventWords { { { "HapticTransient", EventKind::transient },
                                                { "HapticContinuous", EventKind::continuous },
                                                { "AudioContinuous", EventKind::audio },
                                                { "AudioCustom", EventKind::audio } } };

/** What a pattern has become. */
struct PatternContent
{
    HapticContent haptic;
    int audioEvents = 0, endlessEvents = 0; // left out
};

void addAhapEvent (const JsonValue& entry, const Controls& controls, PatternContent& content)
{
    const auto kind = entry.required ("EventType").choice (eventWords);

    if (kind == EventKind::audio)
    {
        ++content.audioEvents;
        return;
    }

    const auto start = secondsOr (entry, "Time", 0), duration = secondsOr (entry, "EventDuration", 0);
    // Those of Apple's devices.
    auto parameters = kind == EventKind::transient ? EventParameters { 0.75, 0.5 } : EventParameters { 0.6, 0.422601 };

    if (const auto given = entry.find ("EventParameters"))
        for (const auto& parameter : given->items (0, mostEntries))
            readAhapValue (parameter, parameters);

    if (kind == EventKind::transient)
        addVibration (content.haptic, start,
                      transientPoints (parameters.intensity * controlAt (controls.lines[intensityControl], start),
                                       parameters.sharpness + controlAt (controls.lines[sharpnessControl], start)));
    else if (duration > 0 || ! parameters.isSustained)
        addVibration (content.haptic, start,
                      pointsOf (parameters, envelopeOf (parameters, controls, start, duration), controls, start));
    else
        ++content.endlessEvents;
}

/** "2 events are" */
std::string countedEvents (int count, const std::string& kind)
{
    return std::to_string (count) + " " + kind + (count > 1 ? " events are" : " event is");
}
} // namespace

HapticContent readAhap (const nlohmann::json& document, const std::string& source)
{
    const auto entries = JsonValue (document, source).required ("Pattern").items (1, mostEntries);
    Controls controls;

    for (const auto& entry : entries)
        if (const auto parameter = entry.find ("Parameter"))
            readDynamicParameter (*parameter, controls);
        else if (const auto curve = entry.find ("ParameterCurve"))
            readParameterCurve (*curve, controls);

    for (std::size_t kind = 0; kind < controlKinds; ++kind)
        controls.lines[kind] = controlLine (controls.changes[kind], kind == intensityControl ? 1 : 0);

    PatternContent content;
    std::size_t points = 0, events = 0;

    for (const auto& entry : entries)
        if (const auto event = entry.find ("Event"))
        {
            checkWatch();
            addAhapEvent (*event, controls, content);

            if (content.haptic.events.size() > events)
                points += std::get<VibrationSignal> (content.haptic.events[events++].signal).points.size();

            if (points > mostPatternPoints)
                event->fail ("makes the pattern too long; allowed: shorter events or fewer curves");
        }

    auto& warnings = content.haptic.warnings;

    if (content.endlessEvents > 0)
        warnings.push_back (countedEvents (content.endlessEvents, "continuous")
                            + " left out, without EventDuration and so without end.");

    if (content.audioEvents > 0)
        warnings.push_back (countedEvents (content.audioEvents, "audio") + " left out.");

    warnings.emplace_back (
        "Sharpness 0 to 1 is played as 65 to 300 Hz and a transient lasts 22 ms, as in MPEG's reference "
        "software: Apple defines neither.");
    return std::move (content.haptic);
}
} // namespace antinode
