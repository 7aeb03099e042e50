#include "AntinodeProcessor.h"

#include <antinode_base/InputError.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <algorithm>

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
             false };
}

SessionState AntinodeProcessor::state() const
{
    return { device(), focus(), controls->values(), mutes(), player->isGraphOpen() };
}

void AntinodeProcessor::setState (const SessionState& wanted, bool isRestored)
{
    const auto isOtherDevice = wanted.device->text != device()->text,
               isOtherFocus = wanted.focus->text != focus()->text;
    {
        const juce::ScopedLock lock (documents);
        loadedDevice = wanted.device;
        loadedFocus = wanted.focus;
    }
    auto values = wanted.parameters;

    if (isRestored && wanted.device->description.requiresArming)
        values["arm"] = 0;

    controls->setValues (values);
    mutedCeramics = wanted.mutes;
    player->setGraphOpen (wanted.isGraphOpen);
    player->load (isOtherDevice ? wanted.device : nullptr, isOtherFocus ? wanted.focus : nullptr);
}

void AntinodeProcessor::setFingers (const std::vector<Finger>& fingers)
{
    auto wanted = state();
    wanted.focus = std::make_shared<const FocusDocument> (withFingers (*wanted.focus, fingers));
    setState (wanted, false);
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
