#include "AntinodeProcessor.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace antinode
{
std::function<juce::AudioProcessorEditor*(AntinodeProcessor&)> AntinodeProcessor::makeEditor;

SessionState demonstrator()
{
    return { deviceDocument ("staple"), focusDocument ("demonstrator"), {} };
}

AntinodeProcessor::AntinodeProcessor (int ceramics, WrapperType wrapper)
    : AntinodeProcessor (ceramics, wrapper, demonstrator())
{
}

AntinodeProcessor::AntinodeProcessor (int ceramics, WrapperType wrapper, const SessionState& first)
    : RoleProcessor ({ {}, { "Ceramics", ceramics }, true, true }, wrapper, SessionRole::foci, first.device),
      loadedFocus (first.focus), touchedFocus (first.focus)
{
    if (wrapper == wrapperType_VST3)
        parameters().stepReports().add (addStop());

    parameters().setFocus (settingsFromFocus (loadedFocus->description, deviceExtent (first.device->description), {}));
    start (std::tuple { *first.device, *first.focus },
           [this] (const auto& chosen, const auto& before) { return takeFocus (chosen, before); });
}

AntinodeProcessor::~AntinodeProcessor()
{
    close();
}

void AntinodeProcessor::load (std::shared_ptr<const DeviceDocument> newDevice,
                              std::shared_ptr<const FocusDocument> newFocus)
{
    {
        const juce::ScopedLock lock (documents);

        // The same device again is no other one: its focus stays.
        if (newDevice != nullptr && newFocus == nullptr && newDevice->text == device()->text)
            newFocus = loadedFocus;

        if (newFocus != nullptr)
            loadedFocus = touchedFocus = newFocus;

        keep (newDevice != nullptr ? newDevice : device());
    }

    if (newDevice != nullptr)
        mutedCeramics = 0;

    if (newDevice != nullptr && newDevice->description.requiresArming)
        parameters().arm().setValueNotifyingHost (0);

    parameters().setFocus (
        settingsFromFocus (focus()->description, deviceExtent (device()->description), parameters().settings()));
    session().load (std::move (newDevice), std::move (newFocus));
}

/** On the session's thread. Parameters follow at once, so that nothing else is designed. */
bool AntinodeProcessor::takeFocus (const std::shared_ptr<const FocusDocument>& chosen, const FocusDocument& before)
{
    {
        const juce::ScopedLock lock (documents);

        if (! sayTheSame (*touchedFocus, before))
            return false;

        loadedFocus = touchedFocus = chosen;
    }
    parameters().setFocus (
        settingsFromFocus (chosen->description, deviceExtent (device()->description), parameters().settings()));
    post();
    return true;
}

std::shared_ptr<const FocusDocument> AntinodeProcessor::focus() const
{
    const juce::ScopedLock lock (documents);
    return touchedFocus;
}

std::shared_ptr<const FocusDocument> AntinodeProcessor::keptFocus() const
{
    const juce::ScopedLock lock (documents);
    return loadedFocus;
}

SessionState AntinodeProcessor::state() const
{
    return {
        device(), keptFocus(), parameters().values(), mutes(), session().isGraphOpen(), session().following().settings()
    };
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

    parameters().setValues (values);
    mutedCeramics = wanted.mutes;
    session().setGraphOpen (wanted.isGraphOpen);
    session().following().setSettings (wanted.following);

    if (isOtherDevice)
        session().load (wanted.device, isOtherFocus ? wanted.focus : focus());
    else if (isOtherFocus)
        session().load (nullptr, wanted.focus);
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
    session().load (nullptr, isOther ? touched : nullptr);
}

DeviceProcessor::Playing AntinodeProcessor::playing() const
{
    const auto now = session().snapshot();
    return { now->model, now->error.empty() ? now->fingerError : now->error, session().latencySamples(),
             &session().meters(), &session().following() };
}

/** Those of the device before are over. */
std::vector<UserMessage> AntinodeProcessor::ownMessages() const
{
    return { { Urgency::warning, session().snapshot()->isSolving ? std::string() : session().progress().liveError } };
}

} // namespace antinode
