#include "BenchPanel.h"

#include <Editor/EditorLook.h>
#include <antinode_audio/IdentifyTone.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/JsonReader.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace antinode
{
namespace
{
constexpr int refreshHz = 10;
constexpr int noSync = OutputRouting::maximumOutputs + 1; // identifiers of a choice cannot be 0
constexpr double usualShare = 20;                         // % of the limits
} // namespace

BenchPanel::BenchPanel (AudioHost& hostToUse) : host (hostToUse), audio (std::make_shared<BenchDevice> (host))
{
    setTitle ("Bench");
    folder = juce::File::getSpecialLocation (juce::File::userDocumentsDirectory)
                 .getChildFile ("Antinode")
                 .getFullPathName()
                 .toStdString();
    viewport.setViewedComponent (&page, false);
    viewport.setScrollBarsShown (true, false);
    addAndMakeVisible (viewport);
    makeSensor();
    makeActions();

    for (auto* const child : std::initializer_list<juce::Component*> { &heading, &text, &surface, &chart, &checklist })
        page.addAndMakeVisible (child);

    heading.setFont (EditorLook::font (EditorLook::textHeight + 2, true));
    text.setFont (EditorLook::font());
    text.setJustificationType (juce::Justification::topLeft);
    text.setMinimumHorizontalScale (1);
    checklist.setMultiLine (true, false);
    checklist.setReadOnly (true);
    checklist.setEscapeAndReturnKeysConsumed (false);
    checklist.setTitle ("Checklist");
    checklist.setFont (EditorLook::font (EditorLook::smallTextHeight));
    chooseTour (true);
    startTimerHz (refreshHz);
}

BenchPanel::~BenchPanel()
{
    work->leave();
    audio->close();
}

void BenchPanel::makeSensor()
{
    const std::array<const char*, 6> words { "Bench",
                                             "Input of the sensor",
                                             "Input of the sync loop",
                                             "Sensitivity, mm/s per V",
                                             "Full scale of an input, V",
                                             "Level, % of the limits" };
    bench.addItem ("Tour: simulated, drives nothing", tour);
    bench.addItem ("Audio device of this program", real);
    bench.setTitle ("Bench");
    bench.onChange = [this] { chooseTour (isTour()); };
    input.setTooltip ("Input of the audio device that the vibrometer or accelerometer is wired to");
    syncInput.setTooltip ("Input that is wired to the output of the sync marker (Settings, Routing): it measures the "
                          "latency. Without it the latency is what the driver says");
    sensitivity.setTooltip ("Sensor: mm/s per V");
    inputRange.setTooltip ("Voltage of a full-scale sample of the input, V");
    level.setTooltip ("Peak of what each ceramic plays, % of the limit of the ceramic and its amplifier");
    const auto& sensor = host.settings().bench;
    sensitivity.setText (sensor.scale.sensitivity > 0 ? juce::String (inWords (sensor.scale.sensitivity)) : "", false);
    inputRange.setText (inWords (sensor.scale.inputFullScale), false);
    level.setText (inWords (usualShare), false);
    input.onChange = syncInput.onChange = [this] { takeSensor(); };

    for (auto* const editor : { &sensitivity, &inputRange, &level })
    {
        editor->setInputRestrictions (12, "0123456789.,%mVs/ ");
        editor->onReturnKey = editor->onFocusLost = [this] { takeSensor(); };
    }

    for (auto* const editor : { &sensitivity, &inputRange, &level, &deviceName })
    {
        editor->setEscapeAndReturnKeysConsumed (false);
        editor->setFont (EditorLook::font (EditorLook::smallTextHeight));
        editor->setJustification (juce::Justification::centredLeft);
        page.addAndMakeVisible (editor);
    }

    for (auto* const choice : { &bench, &input, &syncInput })
        page.addAndMakeVisible (choice);

    for (std::size_t i = 0; i < names.size(); ++i)
    {
        names[i].setText (words[i], juce::dontSendNotification);
        names[i].setFont (EditorLook::font (EditorLook::smallTextHeight));
        page.addAndMakeVisible (names[i]);
    }
}

void BenchPanel::makeActions()
{
    beginButton.setTooltip (
        "Chooses the points and writes the checklist; nothing is played yet. A measurement that was "
        "interrupted goes on");
    stopButton.setTooltip ("Ramps to 0 V and ends; what is measured is kept");
    measureButton.setTooltip ("The sensor is at the cross: plays each ceramic and records");
    skipButton.setTooltip ("Goes on without this point");
    againButton.setTooltip ("Measures the previous point again");
    correctButton.setTooltip ("Gives exchanged ceramics each other's outputs and reversed ones the other polarity in "
                              "Settings, Routing, then measures the first point again");
    goOnButton.setTooltip ("Leaves the wires as they are");
    saveButton.setTooltip ("Writes the retuned device as a file and loads it; the focus stays");
    beginButton.onClick = [this] { begin(); };
    stopButton.onClick = [this] { stop(); };
    measureButton.onClick = goOnButton.onClick = [this] { answer (PointAnswer::measure); };
    skipButton.onClick = [this] { answer (PointAnswer::skip); };
    againButton.onClick = [this] { answer (PointAnswer::again); };
    correctButton.onClick = [this] { correctRouting(); };
    saveButton.onClick = [this] { save (deviceName.getText()); };

    for (auto* const button : { &beginButton, &stopButton, &measureButton, &skipButton, &againButton, &correctButton,
                                &goOnButton, &saveButton })
    {
        button->setMouseClickGrabsKeyboardFocus (false); // The keys stay with the window.
        page.addAndMakeVisible (button);
    }
}

void BenchPanel::chooseTour (bool isTourWanted)
{
    stop();
    state = {};
    bench.setSelectedId (isTourWanted ? tour : real, juce::dontSendNotification);
    tourRouting = straightRouting();
    openInputs = -1;
    refresh();
}

/** What is no number stays as it was. */
void BenchPanel::takeSensor()
{
    auto sensor = host.settings().bench;
    const auto typed = [] (const juce::TextEditor& editor, std::initializer_list<std::string_view> units, double before)
    {
        const auto value = typedNumber (editor.getText().trim().toStdString(), units).value_or (0);
        return value > 0 ? value : before;
    };
    sensor.scale.sensitivity = typed (sensitivity, { "mm/s/V", "mm/s per V" }, sensor.scale.sensitivity);
    sensor.scale.inputFullScale = typed (inputRange, { "V" }, sensor.scale.inputFullScale);

    if (input.getSelectedId() > 0)
        sensor.input = input.getSelectedId() - 1;

    if (syncInput.getSelectedId() > 0)
        sensor.syncInput = syncInput.getSelectedId() == noSync ? -1 : syncInput.getSelectedId() - 1;

    host.setBench (sensor);
}

/** The inputs that are open: others record nothing. */
void BenchPanel::fillInputs()
{
    auto* const opened = host.devices().getCurrentAudioDevice();
    const auto open = opened != nullptr ? opened->getActiveInputChannels() : juce::BigInteger();

    if (std::exchange (openInputs, open.toInteger() + 1) == open.toInteger() + 1)
        return;

    for (auto* const choice : { &input, &syncInput })
    {
        choice->clear (juce::dontSendNotification);

        for (auto channel = open.findNextSetBit (0); channel >= 0; channel = open.findNextSetBit (channel + 1))
            choice->addItem (juce::String (channel + 1), channel + 1);

        choice->setTextWhenNothingSelected ("not open");
    }

    syncInput.addItem ("none", noSync);
    const auto& sensor = host.settings().bench;
    input.setSelectedId (open[sensor.input] ? sensor.input + 1 : 0, juce::dontSendNotification);
    syncInput.setSelectedId (sensor.syncInput < 0     ? noSync
                             : open[sensor.syncInput] ? sensor.syncInput + 1
                                                      : 0,
                             juce::dontSendNotification);
}

BenchQuestion BenchPanel::question()
{
    takeSensor();
    BenchQuestion asked;
    asked.device = device();
    asked.folder = isTour() ? folder / "Tour" : folder;
    asked.conditions = begunUnder = conditions();
    asked.levelShare =
        std::clamp (typedNumber (level.getText().trim().toStdString(), { "%" }).value_or (usualShare), 0.1, 100.0)
        / 100;
    asked.syncOutput = routing().marker.output;

    if (isTour())
    {
        asked.open = simulatedTour (tourRouting);
        return asked;
    }

    const auto sensor = host.settings().bench;
    const auto hasSync = asked.syncOutput >= 0 && sensor.syncInput >= 0;
    asked.sensor = sensor;
    asked.hasSync = hasSync;
    asked.sampleRate = host.callback().sampleRate();

    if (auto* const opened = host.devices().getCurrentAudioDevice(); opened != nullptr && asked.sampleRate > 0)
        asked.latency =
            std::max (0, opened->getOutputLatencyInSamples() + opened->getInputLatencyInSamples()) / asked.sampleRate;

    const auto& limits = begunLimits = host.limits();
    asked.limits.assign (limits.begin(), limits.end());
    asked.outputs.assign (routing().outputs.begin(),
                          routing().outputs.begin()
                              + std::min<std::ptrdiff_t> (OutputRouting::maximumCeramics, limits.size()));
    asked.rest = [kept = audio] { kept->release(); };
    asked.open = [kept = audio, sensor, hasSync] (const ModalModel& model,
                                                  const Eigen::MatrixX2d&) -> std::unique_ptr<Bench>
    { return std::make_unique<HostBench> (kept, sensor, hasSync, model); };
    return asked;
}

/** Of what counts as one measurement. */
std::string BenchPanel::conditions() const
{
    StandaloneSettings now;
    now.routing = routing();
    now.bench = isTour() ? BenchSensor() : host.settings().bench;
    return settingsToText (now);
}

/** Why the sensor cannot be heard, or empty. */
juce::String BenchPanel::closedInputs() const
{
    auto* const opened = host.devices().getCurrentAudioDevice();
    const auto& sensor = host.settings().bench;
    const auto isOpen = [open = opened != nullptr ? opened->getActiveInputChannels() : juce::BigInteger()] (int input)
    { return input >= 0 && open[input]; };

    const auto hasSync = routing().marker.output >= 0 && sensor.syncInput >= 0;

    if (isOpen (sensor.input) && (! hasSync || isOpen (sensor.syncInput)))
        return {};

    return "An input of the bench is not open. Choose it in Settings, Audio device, then here.";
}

/** Whether what was chosen at the beginning, levels among it, is not right any more. */
bool BenchPanel::isOutdated() const
{
    return conditions() != begunUnder || device() != state.device || (! isTour() && host.limits() != begunLimits);
}

bool BenchPanel::hasPoint() const
{
    return std::find (state.measured.begin(), state.measured.end(), true) != state.measured.end();
}

void BenchPanel::answer (PointAnswer answer)
{
    saved = {};

    if (answer == PointAnswer::measure && state.step == BenchStep::aiming)
        saved = isOutdated()
                    ? "Device, routing, limits or sensor have changed since this measurement began. Stop, then "
                      "begin."
                : isTour() ? juce::String()
                           : closedInputs();

    if (saved.isEmpty())
    {
        audio->allow();
        work->answer (answer, state.step, state.point);
    }

    refresh();
}

void BenchPanel::begin()
{
    saved = {};

    if (! isTour() && ! (host.callback().sampleRate() > 0))
    {
        saved = "No audio device is open. Choose one in Settings, Audio device, with the input of the sensor.";
        return refresh();
    }

    work->ask (question());
    refresh();
}

void BenchPanel::stop()
{
    work->stop();
    refresh();
}

void BenchPanel::setRouting (const OutputRouting& routing)
{
    if (isTour())
        tourRouting = routing;
    else
        host.setRouting (routing);
}

void BenchPanel::correctRouting()
{
    setRouting (withRightWires (routing(), state.findings));
    begin();
}

void BenchPanel::scaleAmplifier (std::size_t ceramic, double ratio)
{
    auto wanted = routing();
    const auto output = wanted.outputs[ceramic];

    if (output == OutputRouting::none || state.picture == nullptr)
        return;

    auto& volts = wanted.chains[static_cast<std::size_t> (output)].voltsPerFullScale;
    volts = ratio * (volts > 0 ? volts : state.picture->model->fullScaleVoltage);
    setRouting (wanted);
    begin(); // By the new gain.
}

void BenchPanel::save (const juce::String& name)
{
    if (state.retuned == nullptr)
        return;

    try
    {
        const auto wanted = name.trim().toStdString();
        const auto file = folder / (wanted + ".json");

        if (wanted.empty() || wanted.find_first_of ("/\\") != std::string::npos)
            throw InputError ("name", "is empty or has a slash; allowed: the name of a file without its ending");

        if (std::error_code ignored; std::filesystem::exists (file, ignored))
            throw InputError (file.string(), "already exists; choose another name");

        const auto written = namedDeviceText (*state.retuned, wanted);
        writeWholeFile (file, written);
        saved = "Saved " + fromUtf8 (file.string()) + " and loaded.";

        if (onSaved)
            onSaved (std::make_shared<const DeviceDocument> (
                readDeviceDocument (nlohmann::json::parse (written), file.string())));
    }
    catch (const InputError& failure)
    {
        saved = fromUtf8 (failure.what());
    }

    refresh();
}

void BenchPanel::refresh()
{
    auto now = work->state();
    const auto isOther = std::exchange (state, std::move (now)).step != state.step;

    if (! isTour())
        fillInputs();

    makeRows();
    showRows();
    surface.show (state);

    if (isOther && state.step == BenchStep::aiming && checklist.isEmpty())
        checklist.setText (fromUtf8 (state.checklist), false);

    if (state.step == BenchStep::preparing || state.step == BenchStep::none)
        checklist.clear();

    if (isOther && state.step == BenchStep::done)
    {
        chart.setChart (state.chart, {});
        deviceName.setText (fromUtf8 (state.retuned->before.name) + " retuned", false);
    }

    showWords();
    layOut();
}

void BenchPanel::makeRows()
{
    // What was read of the wires stays while the same device is measured again.
    if (state.picture == nullptr || std::exchange (rowsOf, state.device) == state.device)
        return;

    const auto ceramics = state.picture->model->ceramics.size();

    rows.clear();

    for (std::size_t k = 0; k < ceramics; ++k)
    {
        rows.push_back (std::make_unique<WireRow> (k));
        rows.back()->onTone = [this, k] (double ratio) { scaleAmplifier (k, ratio); };
        rows.back()->onIdentify = [this, k]
        {
            const auto ceramic = static_cast<int> (k);
            host.router().identify (host.router().identified() == ceramic ? OutputRouting::none : ceramic);
        };
        page.addAndMakeVisible (*rows.back());
    }
}

void BenchPanel::showRows()
{
    if (state.picture == nullptr)
        return;

    // What the tone has now: the limits may have changed.
    if (const auto limits = isTour() ? Eigen::VectorXd() : host.limits(); limits.size() == std::ssize (state.toneVolts))
        std::transform (limits.begin(), limits.end(), state.toneVolts.begin(), IdentifyTone::amplitude);

    const auto canIdentify = ! isTour() && host.arm().get() && state.step != BenchStep::playing;

    for (std::size_t k = 0; k < rows.size(); ++k)
        rows[k]->show (state, canIdentify, ! hasPoint() && state.step == BenchStep::aiming,
                       host.router().identified() == static_cast<int> (k));
}
} // namespace antinode
