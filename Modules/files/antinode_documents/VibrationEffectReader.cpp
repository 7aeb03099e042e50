#include "VibrationEffectReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_outline/XmlTree.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace antinode
{
namespace
{
constexpr std::size_t mostSteps = 10000;
constexpr double largestAmplitude = 255;
constexpr double usualSharpness = 0.5; // of what has no frequency
constexpr NumberRange stepMilliseconds { 0, 600000 }, stepAmplitude { 0, largestAmplitude }, vibrationShare { 0, 1 };
constexpr NumberRange envelopeHertz { 1, 10000 };

constexpr auto noFrequency = "Vibrations without a frequency are played with that of sharpness 0.5, 182.5 Hz.";

/** What a vibrator does for a while. */
struct VibrationStep
{
    double duration = 0, amplitude = 0; // s, 0 to 1
};

/** Steps one after the other, each reached along a short edge. */
std::vector<VibrationPoint> stepPoints (const std::vector<VibrationStep>& steps)
{
    const auto frequency = hapticFrequency (usualSharpness);
    std::vector<VibrationPoint> points { { 0, 0, frequency } };
    double time = 0;

    for (const auto& step : steps)
    {
        if (step.duration > 2 * shortestEdge)
            points.push_back ({ time + shortestEdge, step.amplitude, frequency });

        if (step.duration > 0)
            points.push_back ({ time += step.duration, step.amplitude, frequency });
    }

    points.push_back ({ time + shortestEdge, 0, frequency });
    return points;
}

/** A vibration that Android names and leaves to each device: it rises to its intensity and falls. */
struct NamedVibration
{
    std::string_view name;
    double intensity, sharpness;
    double rise, hold, fall; // s

    double duration() const { return rise + hold + fall; }
};

constexpr double clickHold = transientDuration - 2 * shortestEdge;

constexpr std::array namedVibrations {
    NamedVibration { "click", 1, 0.5, shortestEdge, clickHold, shortestEdge },
    NamedVibration { "tick", 0.5, 1, shortestEdge, clickHold, shortestEdge },
    NamedVibration { "low_tick", 0.5, 0, shortestEdge, clickHold, shortestEdge },
    NamedVibration { "thud", 1, 0, shortestEdge, 0, 0.3 },
    NamedVibration { "spin", 1, 0.25, 0.075, 0, 0.075 },
    NamedVibration { "quick_rise", 1, 0.5, 0.15, 0, shortestEdge },
    NamedVibration { "slow_rise", 1, 0.5, 0.5, 0, shortestEdge },
    NamedVibration { "quick_fall", 1, 0.5, shortestEdge, 0, 0.1 },
    NamedVibration { "heavy_click", 1, 0.25, shortestEdge, clickHold, shortestEdge },
};

constexpr double doubleClickPeriod = 0.1; // s

/** Reads the elements of an effect one after the other. */
class VibrationReader
{
public:
    explicit VibrationReader (const std::string& sourceOfErrors) : source (sourceOfErrors) {}

    HapticContent read (const XmlNode& root)
    {
        const auto* effect = &root;

        if (root.name == "vibration-select" && ! root.children.empty())
            effect = &root.children.front();

        if (effect->name != "vibration-effect" && effect->name != "vibration")
            fail (*effect, "is no effect; allowed: vibration-effect, or vibration-select with one in it");

        addAll (*effect);

        if (isRepeating)
            content.warnings.emplace_back ("What repeats is played once.");

        if (hasSteps)
            content.warnings.emplace_back (noFrequency);

        if (isNamed)
            content.warnings.emplace_back (
                "Android leaves primitives and predefined effects to each device: here they are "
                "those that Docs/FileFormats.md lists.");

        return std::move (content);
    }

private:
    [[noreturn]] void fail (const XmlNode& node, const std::string& wrong) const
    {
        throw InputError (source + ": line " + std::to_string (node.line) + ": " + printable (node.name, 60), wrong);
    }

    /** @param usual  of an attribute that is not given; none: it is needed */
    double number (const XmlNode& node, const char* name, const NumberRange& range,
                   std::optional<double> usual = {}) const
    {
        const auto text = node.attribute (name);

        if (text.empty() && usual)
            return *usual;

        double value = 0;
        const auto [end, error] = std::from_chars (text.data(), text.data() + text.size(), value);

        if (error != std::errc() || end != text.data() + text.size() || ! range.contains (value))
            fail (node, std::string (name) + (text.empty() ? " is missing" : " is " + inQuotes (std::string (text)))
                            + "; allowed: " + range.text());

        return value;
    }

    double milliseconds (const XmlNode& node, const char* name, std::optional<double> usual = {}) const
    {
        return 1e-3 * number (node, name, stepMilliseconds, usual);
    }

    void add (double start, std::vector<VibrationPoint> points, double duration)
    {
        addVibration (content, start, std::move (points));
        time = start + duration;

        if (time > 1e-3 * stepMilliseconds.maximum || content.events.size() > mostSteps)
            throw InputError (source, "is too long; allowed: 600 s and " + std::to_string (mostSteps) + " vibrations");
    }

    void addAll (const XmlNode& parent)
    {
        for (const auto& node : parent.children)
            if (node.name == "waveform-effect")
                addSteps (node);
            else if (node.name == "waveform-entry")
                return addSteps (parent); // of a preamble or what repeats
            else if (node.name == "primitive-effect")
                addPrimitive (node);
            else if (node.name == "predefined-effect")
                addPredefined (node);
            else if (node.name == "basic-envelope-effect" || node.name == "waveform-envelope-effect")
                addEnvelope (node);
            else if (node.name == "repeating-effect" || node.name == "preamble" || node.name == "repeating")
            {
                isRepeating |= node.name == "repeating";
                addAll (node);
            }
            else
                fail (node, "is not known; allowed: waveform-effect, primitive-effect, predefined-effect, "
                            "basic-envelope-effect, waveform-envelope-effect, repeating-effect");
    }

    void collectSteps (const XmlNode& parent, std::vector<VibrationStep>& steps)
    {
        for (const auto& node : parent.children)
            if (node.name == "waveform-entry")
            {
                const auto amplitude = node.attribute ("amplitude") == "default"
                                           ? largestAmplitude
                                           : number (node, "amplitude", stepAmplitude);
                steps.push_back ({ milliseconds (node, "durationMs"), amplitude / largestAmplitude });
            }
            else if (node.name == "repeating")
            {
                isRepeating = true;
                collectSteps (node, steps);
            }
            else
                fail (node, "is not known; allowed: waveform-entry, repeating");
    }

    void addSteps (const XmlNode& node)
    {
        std::vector<VibrationStep> steps;
        collectSteps (node, steps);
        double duration = 0;

        for (const auto& step : steps)
            duration += step.duration;

        add (time, stepPoints (steps), duration);
        hasSteps = true;
    }

    void addNamed (const NamedVibration& named, double start, double scale)
    {
        const auto frequency = hapticFrequency (named.sharpness);
        const auto intensity = scale * named.intensity;
        std::vector<VibrationPoint> points { { 0, 0, frequency }, { named.rise, intensity, frequency } };

        if (named.hold > 0)
            points.push_back ({ named.rise + named.hold, intensity, frequency });

        points.push_back ({ named.duration(), 0, frequency });
        add (start, std::move (points), named.duration());
        isNamed = true;
    }

    const NamedVibration& namedBy (const XmlNode& node) const
    {
        const auto name = node.attribute ("name");
        const auto found = std::find_if (namedVibrations.begin(), namedVibrations.end(),
                                         [&] (const auto& named) { return named.name == name; });

        if (found != namedVibrations.end())
            return *found;

        std::vector<std::string_view> words;
        words.reserve (namedVibrations.size());

        for (const auto& named : namedVibrations)
            words.push_back (named.name);

        fail (node, "is " + inQuotes (std::string (name)) + "; allowed: double_click, " + listed (words));
    }

    void addPrimitive (const XmlNode& node)
    {
        const auto delay = milliseconds (node, "delayMs", 0);
        const auto& named = namedBy (node);
        const auto isOffset = node.attribute ("delayType") == "relative_start_offset";
        const auto start = isOffset ? std::max (time, primitiveStart + delay) : time + delay;
        addNamed (named, start, number (node, "scale", vibrationShare, 1));
        primitiveStart = start;
    }

    void addPredefined (const XmlNode& node)
    {
        if (node.attribute ("name") != "double_click")
            return addNamed (namedBy (node), time, 1);

        const auto& click = namedVibrations.front();
        const auto start = time;
        addNamed (click, start, 1);
        addNamed (click, start + doubleClickPeriod, 1);
    }

    void addEnvelope (const XmlNode& node)
    {
        const auto isBasic = node.name == "basic-envelope-effect";
        const auto frequencyOf = [&] (const XmlNode& at, const char* sharpness, const char* hertz) {
            return isBasic ? hapticFrequency (number (at, sharpness, vibrationShare))
                           : number (at, hertz, envelopeHertz);
        };

        if (node.children.empty())
            fail (node, "is empty; allowed: at least one control-point");

        const auto& first = node.children.front();
        const auto hasInitial = ! node.attribute (isBasic ? "initialSharpness" : "initialFrequencyHz").empty();
        double duration = 0;
        std::vector<VibrationPoint> points { { 0, 0,
                                               hasInitial ? frequencyOf (node, "initialSharpness", "initialFrequencyHz")
                                                          : frequencyOf (first, "sharpness", "frequencyHz") } };

        for (const auto& point : node.children)
        {
            if (point.name != "control-point")
                fail (point, "is not known; allowed: control-point");

            duration += std::max (milliseconds (point, "durationMs"), shortestEdge);
            points.push_back ({ duration, number (point, isBasic ? "intensity" : "amplitude", vibrationShare),
                                frequencyOf (point, "sharpness", "frequencyHz") });
        }

        points.push_back ({ duration + shortestEdge, 0, points.back().frequency });
        add (time, std::move (points), duration);
    }

    const std::string& source;
    HapticContent content;
    double time = 0, primitiveStart = 0; // s
    bool isRepeating = false, isNamed = false, hasSteps = false;
};
} // namespace

HapticContent readVibrationEffect (std::string_view xml, const std::string& source)
{
    return VibrationReader (source).read (readXml (xml, source));
}

HapticContent readVibrationTimings (const nlohmann::json& document, const std::string& source)
{
    const JsonValue value (document, source);
    const auto timings = value.required ("timings").numbers (1, mostSteps, stepMilliseconds);
    const auto given = value.find ("amplitudes");
    const auto amplitudes =
        given ? given->numbers (timings.size(), timings.size(), stepAmplitude) : std::vector<double>();
    std::vector<VibrationStep> steps;

    for (std::size_t i = 0; i < timings.size(); ++i)
    {
        const auto usual = i % 2 == 0 ? 0 : largestAmplitude; // off, on and so on
        steps.push_back ({ 1e-3 * timings[i], (given ? amplitudes[i] : usual) / largestAmplitude });
    }

    HapticContent content;
    addVibration (content, 0, stepPoints (steps));
    content.warnings.emplace_back (noFrequency);
    return content;
}
} // namespace antinode
