#include "HjifReader.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Reflection.h>
#include <antinode_base/Watch.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

namespace antinode
{
namespace
{
constexpr double synthesisRate = 8000;                            // Hz: bands reach 1000 Hz
constexpr double lead = 0.005;                                    // s of silence at both ends, which fade
constexpr double longestContent = 60;                             // s
constexpr double usualTransientFrequency = 2 / transientDuration; // Hz
constexpr std::size_t mostParts = 65536, mostKeyframes = 100000;
constexpr NumberRange ticks { 0, 1e9 }, tickRate { 1, 48000 };
constexpr NumberRange keyframeAmplitude { -100, 100 }, keyframeFrequency { 0, 10000 }, channelGain { -10, 10 };
constexpr NumberRange anyPhase { -1e6, 1e6 };

/** A moment of an effect: what it does not set goes on between its neighbours. */
struct Keyframe
{
    double time = 0; // s after the begin of the effect
    std::optional<double> amplitude, frequency;
};

enum class BaseSignal
{
    sine,
    square,
    triangle,
    sawToothUp,
    sawToothDown
};

constexpr WordList<BaseSignal, 5> baseSignalWords { { { "Sine", BaseSignal::sine },
                                                      { "Square", BaseSignal::square },
                                                      { "Triangle", BaseSignal::triangle },
                                                      { "SawToothUp", BaseSignal::sawToothUp },
                                                      { "SawToothDown", BaseSignal::sawToothDown } } };

struct HapticEffect
{
    double start = 0; // s
    double turns = 0; // phase at its begin
    BaseSignal signal = BaseSignal::sine;
    std::vector<Keyframe> keyframes;

    double duration() const { return keyframes.empty() ? 0 : keyframes.back().time; }
};

/** Keyframes that set one of both values, with it. */
using KeyframeLine = std::vector<std::pair<double, double>>; // s, value

KeyframeLine keyframesOf (const HapticEffect& effect, std::optional<double> Keyframe::*member)
{
    KeyframeLine line;

    for (const auto& keyframe : effect.keyframes)
        if (const auto& value = keyframe.*member)
            line.emplace_back (keyframe.time, *value);

    return line;
}

/** The value at a time; before the first and behind the last it stays. @param isCubic  without slope at keyframes */
double keyframeAt (const KeyframeLine& line, double time, bool isCubic)
{
    const auto after =
        std::upper_bound (line.begin(), line.end(), time, [] (double t, const auto& point) { return t < point.first; });

    if (after == line.begin() || after == line.end())
        return after == line.begin() ? line.front().second : line.back().second;

    const auto &from = *(after - 1), &to = *after;
    const auto share = (time - from.first) / (to.first - from.first);
    return std::lerp (from.second, to.second, isCubic ? share * share * (3 - 2 * share) : share);
}

/** A base signal at a phase in turns. */
double baseValue (BaseSignal signal, double turns)
{
    const auto part = turns - std::floor (turns);

    switch (signal)
    {
        case BaseSignal::sine:
            return std::sin (2 * std::numbers::pi * part);
        case BaseSignal::square:
            return part < 0.5 ? 1 : -1;
        case BaseSignal::triangle:
            return part < 0.25 ? 4 * part : part < 0.75 ? 2 - 4 * part : 4 * part - 4;
        case BaseSignal::sawToothUp:
            return part < 0.5 ? 2 * part : 2 * part - 2;
        case BaseSignal::sawToothDown:
            break;
    }

    return part < 0.5 ? -2 * part : 2 - 2 * part;
}

/** The samples of a channel, which effects add to. */
class ChannelSamples
{
public:
    /** @param where  what errors name */
    explicit ChannelSamples (const JsonValue& where) : channel (where) {}

    /** Calls a function with the time since a begin for each sample of a span. */
    template <typename Value>
    void add (double begin, double duration, const Value& value)
    {
        if ((synthesised += duration) > mostSynthesised)
            channel.fail ("has effects of more than " + numberText (mostSynthesised) + " s in all; allowed: less");

        const auto first = static_cast<Eigen::Index> (std::ceil ((lead + begin) * synthesisRate - rounding));
        const auto last = static_cast<Eigen::Index> (std::floor ((lead + begin + duration) * synthesisRate + rounding));
        checkWatch();

        if (last + 1 > samples.size())
            samples.conservativeResizeLike (Eigen::VectorXd::Zero (last + 1));

        for (auto n = first; n <= last; ++n)
            samples[n] += value (static_cast<double> (n) / synthesisRate - lead - begin);
    }

    Eigen::VectorXd samples;

private:
    static constexpr double rounding = 1e-6;        // samples
    static constexpr double mostSynthesised = 1200; // s of all effects together
    const JsonValue& channel;
    double synthesised = 0; // s
};

void addVectorial (ChannelSamples& channel, const HapticEffect& effect, double duration)
{
    const auto amplitudes = keyframesOf (effect, &Keyframe::amplitude),
               frequencies = keyframesOf (effect, &Keyframe::frequency);

    if (frequencies.empty())
        return;

    double turns = effect.turns, reached = 0, frequency = keyframeAt (frequencies, 0, false);
    channel.add (effect.start, duration,
                 [&] (double time)
                 {
                     // Frequencies are straight between samples, but where a keyframe lies between two of them.
                     const auto now = keyframeAt (frequencies, time, false);
                     turns += (time - reached) * (frequency + now) / 2;
                     reached = time;
                     frequency = now;
                     return (amplitudes.empty() ? 1 : keyframeAt (amplitudes, time, false))
                            * baseValue (effect.signal, turns);
                 });
}

void addTransients (ChannelSamples& channel, const HapticEffect& effect)
{
    for (const auto& keyframe : effect.keyframes)
    {
        const auto amplitude = keyframe.amplitude.value_or (0);
        const auto frequency = keyframe.frequency.value_or (usualTransientFrequency);
        channel.add (effect.start + keyframe.time, transientDuration,
                     [&] (double time)
                     {
                         const auto edge = std::min ({ time, transientDuration - time, shortestEdge }) / shortestEdge;
                         return amplitude * edge * std::sin (2 * std::numbers::pi * frequency * time);
                     });
    }
}

void addCurve (ChannelSamples& channel, const HapticEffect& effect, double duration, bool isCubic)
{
    if (const auto line = keyframesOf (effect, &Keyframe::amplitude); ! line.empty())
        channel.add (effect.start, duration, [&] (double time) { return keyframeAt (line, time, isCubic); });
}

enum class BandKind
{
    vectorial,
    transient,
    curve,
    wavelet
};

constexpr WordList<BandKind, 4> bandWords { { { "VectorialWave", BandKind::vectorial },
                                              { "Transient", BandKind::transient },
                                              { "Curve", BandKind::curve },
                                              { "WaveletWave", BandKind::wavelet } } };

/** Reads the bands of the channels of a perception. */
class PerceptionReader
{
public:
    /** @param rate  ticks per second */
    PerceptionReader (const JsonValue& perception, double rate) : secondsPerTick (1 / rate)
    {
        if (const auto library = perception.find ("effect_library"))
            for (const auto& effect : library->items (0, mostParts))
                effects.insert_or_assign (effect.required ("id").integer (0, std::numeric_limits<int>::max()),
                                          readEffect (effect));
    }

    void addBand (ChannelSamples& channel, const JsonValue& band) const
    {
        const auto type = band.required ("band_type");
        const auto kind = type.choice (bandWords);

        if (kind == BandKind::wavelet)
            type.fail ("is a coded recording; allowed: VectorialWave, Transient, Curve, or the decoded recording as a "
                       "signal of kind wav");

        auto all = effectsOf (band);

        for (std::size_t i = 0; i < all.size(); ++i)
        {
            // The later effect of a band ends an earlier one.
            const auto free = i + 1 < all.size() ? all[i + 1].start - all[i].start : longestContent;
            const auto duration = std::min (all[i].duration(), free);

            if (kind == BandKind::vectorial)
                addVectorial (channel, all[i], duration);
            else if (kind == BandKind::transient)
                addTransients (channel, all[i]);
            else
                addCurve (channel, all[i], duration, isCubic (band));
        }
    }

private:
    static bool isCubic (const JsonValue& band)
    {
        const auto type = band.find ("curve_type");
        return ! type || ! type->isWord ("Linear");
    }

    double secondsOf (const JsonValue& value) const { return secondsPerTick * value.number (ticks); }

    std::vector<HapticEffect> effectsOf (const JsonValue& band) const
    {
        std::vector<HapticEffect> all;

        for (const auto& value : band.required ("effects").items (0, mostKeyframes))
        {
            const auto start = secondsOf (value.required ("position"));
            all.push_back (referred (value));
            all.back().start = start;

            if (start + all.back().duration() > longestContent)
                value.fail ("ends after more than " + numberText (longestContent) + " s; allowed: earlier");
        }

        std::stable_sort (all.begin(), all.end(), [] (const auto& a, const auto& b) { return a.start < b.start; });
        return all;
    }

    /** The effect itself, or the one of the library that it names. */
    HapticEffect referred (const JsonValue& value) const
    {
        if (const auto type = value.find ("effect_type"); ! type || type->isWord ("Basis"))
            return readEffect (value);
        else if (! type->isWord ("Reference"))
            type->fail (type->description() + "; allowed: Basis, Reference");

        const auto id = value.required ("id");
        const auto found = effects.find (id.integer (0, std::numeric_limits<int>::max()));

        if (found == effects.end())
            id.fail (id.description() + ", which the effect_library does not have");

        return found->second;
    }

    HapticEffect readEffect (const JsonValue& value) const
    {
        HapticEffect effect;

        if (const auto phase = value.find ("phase"))
            effect.turns = phase->number (anyPhase) / (2 * std::numbers::pi);

        if (const auto signal = value.find ("base_signal"))
            effect.signal = signal->choice (baseSignalWords);

        if (const auto keyframes = value.find ("keyframes"))
            for (const auto& item : keyframes->items (0, mostKeyframes))
                effect.keyframes.push_back (readKeyframe (item));

        std::stable_sort (effect.keyframes.begin(), effect.keyframes.end(),
                          [] (const auto& a, const auto& b) { return a.time < b.time; });
        return effect;
    }

    Keyframe readKeyframe (const JsonValue& value) const
    {
        Keyframe keyframe;

        if (const auto position = value.find ("relative_position"))
            keyframe.time = secondsOf (*position);

        if (const auto amplitude = value.find ("amplitude_modulation"))
            keyframe.amplitude = amplitude->number (keyframeAmplitude);

        if (const auto frequency = value.find ("frequency_modulation"))
            keyframe.frequency = frequency->number (keyframeFrequency);

        return keyframe;
    }

    double secondsPerTick;
    std::map<int, HapticEffect> effects;
};

/** The channels of a perception, each limited to -1 to 1. */
void addPerception (Eigen::VectorXd& sum, const JsonValue& perception, double rate)
{
    const PerceptionReader reader (perception, rate);

    for (const auto& value : perception.required ("channels").items (0, mostParts))
    {
        ChannelSamples channel (value);

        for (const auto& band : value.required ("bands").items (0, mostParts))
            reader.addBand (channel, band);

        const auto gain = value.find ("gain");
        const auto size = std::max (sum.size(), channel.samples.size());
        sum.conservativeResizeLike (Eigen::VectorXd::Zero (size));
        sum.head (channel.samples.size()) +=
            (gain ? gain->number (channelGain) : 1) * channel.samples.cwiseMax (-1).cwiseMin (1);
    }
}
} // namespace

HapticContent readHjif (const nlohmann::json& document, const std::string& source)
{
    const JsonValue value (document, source);
    const auto timescale = value.find ("timescale");
    const auto rate = timescale ? timescale->number (tickRate) : 1000;
    HapticContent content;
    Eigen::VectorXd sum;
    int leftOut = 0;

    for (const auto& perception : value.required ("perceptions").items (0, mostParts))
        if (const auto modality = perception.required ("perception_modality"); modality.isWord ("Vibrotactile"))
            addPerception (sum, perception, rate);
        else
            ++leftOut;

    if (leftOut > 0)
        content.warnings.push_back (std::to_string (leftOut)
                                    + (leftOut > 1 ? " perceptions that are" : " perception that is")
                                    + " not vibrotactile: left out.");

    if (sum.size() == 0 || sum.isZero (leastIntensity))
        return content;

    const auto amplitude = sum.cwiseAbs().maxCoeff();
    sum.conservativeResizeLike (Eigen::VectorXd::Zero (sum.size() + static_cast<Eigen::Index> (lead * synthesisRate)));
    // In place: g++ 12 takes a move of the variant for a use of what is not set.
    auto& event = content.events.emplace_back();
    event.signal.emplace<SampledSignal> (SampledSignal { {}, synthesisRate, std::move (sum) });
    event.amplitude = amplitude;
    return content;
}
} // namespace antinode
