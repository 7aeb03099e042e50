#include "ApplyOptions.h"

#include <antinode_base/InputError.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <numeric>

namespace antinode
{
namespace
{
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

StandaloneSettings withOptions (StandaloneSettings settings, const StandaloneOptions& options)
{
    auto& audio = settings.audio;

    // Kept settings of another device, rate or type do not apply.
    if (! options.type.empty() || ! options.device.empty())
        audio = {};

    if (! options.type.empty())
        audio.type = options.type;

    if (! options.device.empty())
        audio.device = options.device;

    if (options.rate > 0)
        audio.sampleRate = options.rate;

    if (options.block > 0)
        audio.blockSize = options.block;

    if (options.channels > 0)
    {
        audio.outputs.resize (static_cast<std::size_t> (options.channels));
        std::iota (audio.outputs.begin(), audio.outputs.end(), 0);
    }

    settings.touch.oscPort = options.oscPort.value_or (settings.touch.oscPort);
    settings.touch.tuioPort = options.tuioPort.value_or (settings.touch.tuioPort);
    settings.touch.address = options.touchAddress.value_or (settings.touch.address);

    if (options.tuioCursors)
        settings.touch.finger = *options.tuioCursors == "foci" ? "" : *options.tuioCursors;

    return settings;
}

SettingsFile chooseSettingsFile (const StandaloneOptions& options)
{
    if (options.ignoresSettings)
        return SettingsFile ({});

    return SettingsFile (options.settings.empty() ? usualSettingsFile() : std::filesystem::absolute (options.settings));
}

void loadDocuments (StandaloneHost& host, const StandaloneOptions& options)
{
    std::shared_ptr<const DeviceDocument> device;
    std::shared_ptr<const FocusDocument> focus;

    if (const auto& name = options.instrument; ! name.empty())
        device = std::make_shared<const DeviceDocument> (
            readDeviceDocument (loadDocument (LibraryKind::device, name), documentSource (LibraryKind::device, name)));

    if (const auto& name = options.focus; ! name.empty())
        focus = std::make_shared<const FocusDocument> (
            readFocusDocument (loadDocument (LibraryKind::focus, name), documentSource (LibraryKind::focus, name)));

    if (options.opensGraph)
        host.processor().session().setGraphOpen (true);

    if (device != nullptr || focus != nullptr)
        host.processor().load (std::move (device), std::move (focus));
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
