#include "OptionValues.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace antinode
{
namespace
{
/** The numbers of "24:-3.5:2", one or more with colons between them; none where something is no finite number. */
std::optional<std::vector<double>> colonNumbers (std::string_view text)
{
    std::vector<double> numbers;
    const auto* at = text.data();
    const auto* const end = at + text.size();

    for (;;)
    {
        auto& number = numbers.emplace_back();
        const auto [behind, error] = std::from_chars (at, end, number);

        if (error != std::errc() || ! std::isfinite (number) || (behind != end && *behind != ':'))
            return std::nullopt;

        if (behind == end)
            return numbers;

        at = behind + 1;
    }
}

[[noreturn]] void refuseFollowing (const std::string& text, const std::string& wrong)
{
    throw InputError ("--follow " + text, wrong
                                              + "; allowed: velocity:X:Y or displacement:X:Y, in mm, ceramic_current:N "
                                                "or ceramic_charge:N, from 1 to "
                                              + std::to_string (OutputRouting::maximumCeramics) + ", or none");
}

constexpr int highestNote = 127, fullVelocity = 127;

/** A whole number up to 127 from the front of some text; what is left of it stays. */
int takeNumber (std::string_view& text, int minimum, const std::string& option)
{
    int value = -1;
    const auto [end, error] = std::from_chars (text.data(), text.data() + text.size(), value);

    if (error != std::errc() || value < minimum || value > highestNote)
        throw InputError (option,
                          "is not a note; allowed: NOTE or NOTE:VELOCITY, with notes 0 to 127 and velocities 1 to 127");

    text.remove_prefix (static_cast<std::size_t> (end - text.data()));
    return value;
}

juce::MidiMessage noteFrom (const std::string& text)
{
    std::string_view left = text;
    const auto option = "--note " + text;
    const auto note = takeNumber (left, 0, option);
    auto velocity = fullVelocity;

    if (left.starts_with (':'))
    {
        left.remove_prefix (1);
        velocity = takeNumber (left, 1, option);
    }

    if (! left.empty())
        throw InputError (option, "has trailing text; allowed: NOTE or NOTE:VELOCITY");

    return juce::MidiMessage::noteOn (1, note, static_cast<juce::uint8> (velocity));
}
} // namespace

FollowingSettings readFollowing (const std::string& text)
{
    FollowingSettings settings;

    if (text == "none")
        return settings;

    const auto colon = static_cast<std::size_t> (std::find (text.begin(), text.end(), ':') - text.begin());
    const auto* const sensor = std::find_if (followingSensorWords.begin(), followingSensorWords.end(),
                                             [word = std::string_view (text).substr (0, colon)] (const auto& entry)
                                             { return entry.first == word; });

    if (sensor == followingSensorWords.end())
        refuseFollowing (text, "is no sensor");

    settings.sensor = sensor->second;
    const std::optional<std::vector<double>> behind =
        colon < text.size() ? colonNumbers (std::string_view (text).substr (colon + 1)) : std::vector<double>();

    if (! behind)
        refuseFollowing (text, "has something that is no number");

    const auto& numbers = *behind;

    if (numbers.size() != (settings.isCeramic() ? 1 : 2))
        refuseFollowing (text, settings.isCeramic() ? "does not say one ceramic" : "does not say one place");

    if (! settings.isCeramic())
    {
        settings.xMillimetres = numbers[0];
        settings.yMillimetres = numbers[1];
        return settings;
    }

    if (! (numbers[0] >= 1 && numbers[0] <= OutputRouting::maximumCeramics) || numbers[0] != std::floor (numbers[0]))
        refuseFollowing (text, "is no number of a ceramic");

    settings.ceramic = static_cast<int> (numbers[0]) - 1;
    return settings;
}

FingerInputs readFingerInputs (const std::string& list)
{
    FingerInputs read;
    read.inputs.fill (FingerInputs::none);
    const auto* at = list.data();
    const auto* const end = at + list.size();

    for (std::size_t k = 0;; ++k, ++at)
    {
        int number = 0;
        const auto [behind, error] = std::from_chars (at, end, number);
        const auto isLast = behind == end;

        if (error != std::errc() || number < 0 || number > OutputRouting::maximumOutputs || k >= read.inputs.size()
            || (! isLast && *behind != ','))
            throw InputError ("--inputs " + list,
                              "is no list of inputs; allowed: up to " + std::to_string (FingerInputs::fingers)
                                  + " numbers from 0 (none) to " + std::to_string (OutputRouting::maximumOutputs)
                                  + " with commas, the input of finger 1 first");

        read.inputs[k] = number - 1;
        at = behind;

        if (isLast)
            return read;
    }
}

WantedFinger readFinger (const std::string& text)
{
    constexpr double highest = 100; // um, as the parameter has it
    const auto read = colonNumbers (text);

    if (! read || read->size() > 3)
        throw InputError ("--finger " + text, "is no finger; allowed: X:Y or X:Y:UM, numbers in mm, mm and um");

    const auto& numbers = *read;

    if (numbers.size() < 2)
        throw InputError ("--finger " + text, "has no y; allowed: X:Y or X:Y:UM, numbers in mm, mm and um");

    WantedFinger finger { numbers[0] / milli, numbers[1] / milli };

    if (numbers.size() > 2)
        finger.level = numbers[2] / micro;

    if (! (finger.level >= 0 && finger.level * micro <= highest))
        throw InputError ("--finger " + text, "has a level of " + inWords (finger.level * micro)
                                                  + " um; allowed: 0 (silent) to " + inWords (highest) + " um");

    return finger;
}

std::vector<TimedNote> readNotes (const StandaloneOptions& options)
{
    std::vector<TimedNote> notes;

    for (std::size_t i = 0; i < options.notes.size(); ++i)
        notes.push_back ({ i < options.times.size() ? options.times[i] : 0.0, noteFrom (options.notes[i]) });

    if (! options.midiFile.empty())
        for (auto& note : readMidiFile (options.midiFile))
            notes.push_back (std::move (note));

    return notes;
}
} // namespace antinode
