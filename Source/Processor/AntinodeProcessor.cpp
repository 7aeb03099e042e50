#include "AntinodeProcessor.h"

#include "ParameterSet.h"
#include "ParameterTypes.h"

#include <antinode_documents/FocusFile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <tuple>
#include <utility>

namespace antinode
{
namespace
{
constexpr double silentDecibels = -60;
constexpr float silentText = -60 + 1e-3F; // below which it is called silent

ParameterRange logarithmic (double minimum, double maximum)
{
    return { minimum, maximum, true };
}

juce::String wordForHosts (std::string_view word)
{
    return juce::String (std::string (word)).replaceCharacter ('_', ' ');
}

template <typename Words>
std::vector<juce::String> wordsForHosts (const Words& words)
{
    std::vector<juce::String> texts;
    texts.reserve (std::size (words));

    for (const auto& [word, value] : words)
        texts.push_back (wordForHosts (word));

    return texts;
}

/** What an index of a host asks for. */
struct HostMethod
{
    AllocationMethod method = AllocationMethod::exact;
    const RetiredMethod* retired = nullptr;

    bool operator== (const HostMethod&) const = default;
};

/** Hosts keep the index: methods that are no longer offered stay where they were. */
constexpr auto hostMethods = []
{
    std::array<HostMethod, allocationMethodWords.size() + retiredMethods.size()> methods;
    methods[0].method = AllocationMethod::exact;
    methods[1].method = AllocationMethod::paper;

    for (std::size_t i = 0; i < retiredMethods.size(); ++i)
        methods[2 + i] = { retiredMethods[i].method, &retiredMethods[i] };

    methods.back().method = AllocationMethod::leastVoltage;
    return methods;
}();

IntegerTexts methodTexts()
{
    std::vector<juce::String> words;
    std::vector<int> retired;

    for (const auto& each : hostMethods)
    {
        if (each.retired != nullptr)
            retired.push_back (static_cast<int> (words.size()));

        words.push_back (
            wordForHosts (wordFor (allocationMethodWords, each.method))
            + (each.retired != nullptr ? " (was " + wordForHosts (each.retired->word) + ")" : juce::String()));
    }

    return wordTexts (words, std::move (retired));
}

int shapeIndex (TargetShape shape)
{
    const auto found = std::find_if (targetShapeWords.begin(), targetShapeWords.end(),
                                     [shape] (const auto& word) { return word.second == shape; });
    return static_cast<int> (found - targetShapeWords.begin());
}
} // namespace

Parameters::Parameters (juce::AudioProcessor& processor, const SurfaceSource& model)
{
    GroupBuilder focus (processor, "focus", "Focus", ordered);
    x = focus.number ("x", "Focus x", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::x));
    y = focus.number ("y", "Focus y", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::y));
    width = focus.number ("width", "Width", "mm", logarithmic (1, 200), 25, unitTexts ("mm", 2));
    shape = focus.choice ("shape", "Shape", wordsForHosts (targetShapeWords));
    peakVelocity =
        focus.number ("peak_velocity", "Peak velocity", "mm/s", logarithmic (0.1, 2000), 40, unitTexts ("mm/s", 2));
    focusTime = focus.number ("focus_time", "Focus time", "ms", logarithmic (1, 500), 25, unitTexts ("ms", 2));
    focus.addToProcessor();

    GroupBuilder drive (processor, "drive", "Drive", ordered);
    growth = drive.number ("growth", "Growth", "", { -1, 50 }, -1, unitTexts ("", 2, 0, "chosen"));
    brake = drive.number ("brake", "Brake", "", { 0, 50 }, 0, unitTexts ("", 2, 1.0F + 1e-6F, "as the focus says"));
    method = drive.integer ("method", "Allocation", static_cast<int> (hostMethods.size()) - 1, methodTexts());
    voltageLimit = drive.number ("voltage_limit", "Voltage limit", "V", { 0, 500 }, 0,
                                 unitTexts ("V", 1, 1e-6F, "as the focus says"));
    modes = drive.integer ("modes", "Controlled modes", 512, countTexts ("chosen"));
    drive.addToProcessor();

    GroupBuilder triggers (processor, "triggers", "Triggers", ordered);
    notes = triggers.choice ("notes", "Notes play", { "places over the surface", "the focus alone" });
    noteOff = triggers.choice ("note_off", "Note off", { "is ignored", "fades out", "brakes" });
    retrigger = triggers.choice ("retrigger", "Retrigger", { "overlaps", "restarts" });
    focusOnNote = triggers.flag ("focus_on_note", "Focus on the note", false, "focus on the note", "start on the note");
    triggers.addToProcessor();

    GroupBuilder monitor (processor, "monitor", "Monitor", ordered);
    probeX = monitor.number ("probe_x", "Probe x", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::x));
    probeY = monitor.number ("probe_y", "Probe y", "", { 0, 100 }, 50, placeTexts (model, SurfaceAxis::y));
    monitorGain = monitor.number ("monitor_gain", "Monitor gain", "dB", { silentDecibels, 60 }, 0,
                                  unitTexts ("dB", 1, silentText, "silent"));
    monitor.addToProcessor();

    GroupBuilder output (processor, "output", "Output", ordered);
    outputTrim = output.number ("output_trim", "Output trim", "dB", { silentDecibels, 0 }, 0,
                                unitTexts ("dB", 1, silentText, "silent"));
    armed = output.flag ("arm", "Arm", true, "armed", "disarmed", false);
    bypassed = output.flag ("bypass", "Bypass", false, "bypassed", "playing");
    output.addToProcessor();
    begin();
}

PlaySettings Parameters::settings() const
{
    PlaySettings now;
    now.xPercent = static_cast<float> (x->get());
    now.yPercent = static_cast<float> (y->get());
    now.widthMillimetres = static_cast<float> (width->get());
    now.shape = targetShapeWords[static_cast<std::size_t> (shape->get())].second;
    now.peakVelocityMillimetresPerSecond = static_cast<float> (peakVelocity->get());
    now.focusTimeMilliseconds = static_cast<float> (focusTime->get());
    now.growth = static_cast<float> (growth->get());
    now.brake = static_cast<float> (brake->get());
    const auto& asked = hostMethods[static_cast<std::size_t> (method->get())];
    now.method = asked.method;
    now.retired = asked.retired;
    now.voltageLimitVolts = static_cast<float> (voltageLimit->get());
    now.modeCount = modes->get();
    now.probeXPercent = static_cast<float> (probeX->get());
    now.probeYPercent = static_cast<float> (probeY->get());
    now.noteLayout = static_cast<NoteLayout> (notes->get());
    now.focusOnNote = *focusOnNote;
    return now;
}

PlayControls Parameters::controls() const
{
    const auto gain = [] (const NumberParameter* decibels)
    { return juce::Decibels::decibelsToGain (decibels->get(), silentDecibels); };

    PlayControls now;
    now.notes.noteOff = static_cast<NoteOffBehaviour> (noteOff->get());
    now.notes.retrigger = static_cast<RetriggerBehaviour> (retrigger->get());
    now.notes.focusOnNote = *focusOnNote;
    now.isArmed = *armed && ! *bypassed;
    now.outputTrim = gain (outputTrim);
    now.monitorGain = gain (monitorGain);

    if (const auto limit = voltageLimit->get(); limit > 0)
        now.voltageLimit = limit;

    return now;
}

std::vector<juce::RangedAudioParameter*> Parameters::ofFocus() const
{
    return { x, y, width, shape, peakVelocity, focusTime, growth, brake, method, voltageLimit, modes, probeX, probeY };
}

void Parameters::setFocus (const PlaySettings& settings)
{
    const auto asked =
        std::find (hostMethods.begin(), hostMethods.end(), HostMethod { settings.method, settings.retired });
    const std::array wanted { settings.xPercent,
                              settings.yPercent,
                              settings.widthMillimetres,
                              static_cast<float> (shapeIndex (settings.shape)),
                              settings.peakVelocityMillimetresPerSecond,
                              settings.focusTimeMilliseconds,
                              settings.growth,
                              settings.brake,
                              static_cast<float> (asked - hostMethods.begin()),
                              settings.voltageLimitVolts,
                              static_cast<float> (settings.modeCount),
                              settings.probeXPercent,
                              settings.probeYPercent };
    const auto parameters = ofFocus();

    for (std::size_t i = 0; i < wanted.size(); ++i)
        setValue (*parameters[i], static_cast<double> (wanted[i]));
}

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
    const auto now = session().snapshot();
    const auto settings = parameters().settings();
    const auto choice = withMethod (focus()->description, settings.method, settings.retired).allocation;
    const auto isDesigned = now->model != nullptr && ! now->isAsWritten;
    return { { Urgency::warning, now->isSolving ? std::string() : session().progress().liveError },
             { Urgency::caution, isDesigned ? retirementInWords (suitedTo (*now->model, choice)) : std::string() } };
}

} // namespace antinode
