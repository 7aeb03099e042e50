#include "AntinodeProcessor.h"

#include <antinode_base/InputError.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace antinode
{
SessionState demonstrator()
{
    const auto focus = loadDocument (LibraryKind::focus, "demonstrator");
    const auto device = loadDocument (LibraryKind::device, "staple");
    return { std::make_shared<const DeviceDocument> (readDeviceDocument (device, "device 'staple'")),
             std::make_shared<const FocusDocument> (readFocusDocument (focus, "focus 'demonstrator'")),
             {},
             0,
             false,
             {} };
}

SessionState AntinodeProcessor::state() const
{
    return {
        device(), keptFocus(), controls->values(), mutes(), player->isGraphOpen(), player->following().settings()
    };
}

std::shared_ptr<const FocusDocument> AntinodeProcessor::keptFocus() const
{
    const juce::ScopedLock lock (documents);
    return loadedFocus;
}

void AntinodeProcessor::setState (const SessionState& wanted, bool isRestored)
{
    const auto isOtherDevice = wanted.device->text != device()->text,
               isOtherFocus = ! sayTheSame (*wanted.focus, *keptFocus());
    {
        const juce::ScopedLock lock (documents);
        loadedDevice = wanted.device;
        loadedFocus = wanted.focus;

        // Whoever put touches down sees which of them fit beside the fingers of another focus.
        if (isOtherFocus)
            touchedFocus = wanted.focus;
    }
    auto values = wanted.parameters;

    if (isRestored && wanted.device->description.requiresArming)
        values["arm"] = 0;

    controls->setValues (values);
    mutedCeramics = wanted.mutes;
    player->setGraphOpen (wanted.isGraphOpen);
    player->following().setSettings (wanted.following);

    if (isOtherDevice)
        player->load (wanted.device, isOtherFocus ? wanted.focus : focus());
    else if (isOtherFocus)
        player->load (nullptr, wanted.focus);
}

void AntinodeProcessor::setFingers (const std::vector<Finger>& fingers)
{
    auto own = fingers;
    const auto known = touches();
    const auto firstTouch = std::stable_partition (
        own.begin(), own.end(),
        [&known] (const auto& finger) { return std::find (known.begin(), known.end(), finger) == known.end(); });
    const std::vector<Finger> touching (firstTouch, own.end());
    own.erase (firstTouch, own.end());
    putDown (own, touching);
}

void AntinodeProcessor::setTouches (const std::vector<Finger>& touching)
{
    putDown (keptFocus()->description.fingers, touching);
}

std::vector<Finger> AntinodeProcessor::touches() const
{
    const juce::ScopedLock lock (documents);
    const auto& all = touchedFocus->description.fingers;
    return { all.begin() + std::ssize (loadedFocus->description.fingers), all.end() };
}

void AntinodeProcessor::putDown (const std::vector<Finger>& own, const std::vector<Finger>& touching)
{
    auto kept = keptFocus();

    if (own != kept->description.fingers)
        kept = std::make_shared<const FocusDocument> (withFingers (*kept, own));

    auto touched = kept;

    if (! touching.empty())
    {
        auto all = own;
        all.insert (all.end(), touching.begin(), touching.end());
        touched = std::make_shared<const FocusDocument> (withFingers (*kept, all));
    }

    const auto isOther = touched->text != focus()->text;
    {
        const juce::ScopedLock lock (documents);
        loadedFocus = std::move (kept);
        touchedFocus = touched;
    }
    player->load (nullptr, isOther ? touched : nullptr);
}

void AntinodeProcessor::getStateInformation (juce::MemoryBlock& block)
{
    const auto text = stateToText (state());
    block.replaceAll (text.data(), text.size());
}

void AntinodeProcessor::setStateInformation (const void* data, int size)
{
    try
    {
        setState (readState ({ static_cast<const char*> (data), static_cast<std::size_t> (std::max (0, size)) }), true);
        setWarning ({});
    }
    catch (const InputError& failure)
    {
        setWarning ("The saved state could not be read; nothing was changed: "
                    + juce::String::fromUTF8 (failure.what()));
    }
}
} // namespace antinode
