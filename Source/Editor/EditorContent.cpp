#include "EditorContent.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/BankCharts.h>
#include <antinode_session/UserMessages.h>

#include <algorithm>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double usualRate = 48000; // Hz, before a host says it

/** What goes on, where nothing else is said. */
std::string progressSentence (AntinodeProcessor& processor, bool isWorking)
{
    const auto session = processor.session().snapshot();
    const auto progress = processor.session().progress();

    if (session->isSolving || session->model == nullptr)
        return "Solving " + processor.device()->description.name + " \xE2\x80\xA6";

    if (! progress.isDone())
        return "Designing " + std::to_string (progress.designed) + " of " + std::to_string (progress.wanted)
               + " positions \xE2\x80\xA6";

    return isWorking ? "Ready; rendering the charts \xE2\x80\xA6" : "";
}

std::string restSentence (AntinodeProcessor& processor)
{
    return processor.session().snapshot()->isAsWritten
               ? "Ready; every note plays the design as it was written, moving a parameter designs its focus again"
               : "Ready";
}

/** All that the editor has to say.
    @param picture    the newest one, or none
    @param isWorking  whether a newer one is being worked out
    @param beside     what the window around has to say */
std::vector<UserMessage> editorMessages (AntinodeProcessor& processor, const DesignPicture* picture, bool isWorking,
                                         const std::vector<UserMessage>& beside)
{
    auto messages = processor.messages();
    messages.insert (messages.end(), beside.begin(), beside.end());
    const auto session = processor.session().snapshot();
    const auto isShown = picture != nullptr && ! session->isSolving && picture->question.model == session->model;

    if (isShown)
    {
        addMessage (messages, Urgency::warning, picture->error);

        for (const auto& fault : picture->faults)
            addMessage (messages, Urgency::caution, fault);
    }

    addMessage (messages, Urgency::calm, progressSentence (processor, isWorking));

    if (const auto progress = processor.session().progress(); progress.isDone() && ! session->isSolving)
        messages.push_back (unplayableNotesMessage (progress, session->playback.sampleRate));

    std::erase_if (messages, [] (const auto& message) { return message.text.empty(); });

    if (messages.empty())
        messages.push_back ({ Urgency::calm, restSentence (processor) });

    return messages;
}

/** Rate, voices and triggers, beside them. */
juce::String playedFigures (AntinodeProcessor& processor)
{
    const auto& meters = processor.session().meters();
    const auto rate = processor.session().snapshot()->playback.sampleRate;
    return (rate > 0 ? juce::String (rate / 1000, 1) + " kHz" : juce::String ("not playing")) + "    " + "voices "
           + juce::String (meters.voices()) + "    triggers " + juce::String (meters.triggered());
}
} // namespace

EditorContent::EditorContent (AntinodeProcessor& processorToShow)
    : WindowContent ("Antinode", { { 800, 500, 1700, 1000 }, 1280, 800, 60, 48 }), processor (processorToShow),
      past (processor), presets (processor, past), draft (processor, past), commands (bar, processor, past),
      surfaceView (processor, past), drawing (processor, draft), section ("Section along x"),
      spectrum ("Modal spectrum"), felt ("Sensation level over the whole event"),
      voltages ("Voltages with their limits"), methods ("Peak voltage by several methods"),
      bank ("Peak voltage of the notes' places"), probe (processor.session().probeTrace()),
      drift ({ processor.session().following(), [this] { return processor.session().snapshot()->model; },
               [this] (const auto& wanted)
               { past.record ([this, &wanted] { processor.session().following().setSettings (wanted); }); },
               [this] { past.resetDrift(); } }),
      settings ({ [this] { return processor.session().isGraphOpen(); },
                  [this] (bool isOpen) { processor.session().setGraphOpen (isOpen); } }),
      parameters (processor), device (draft), meters (processor, past),
      browser (std::make_unique<PresetPanel> (presets))
{
    setWantsKeyboardFocus (true);
    setFocusContainerType (FocusContainerType::keyboardFocusContainer);
    parameterView.setViewedComponent (&parameters, false);
    parameterView.setScrollBarsShown (true, false);
    commands.onBrowse = [this] (LibraryKind kind) { browse (kind); };
    commands.onFire = [this] { fire(); };
    commands.onStop = [this] { processor.session().stopAll(); };
    commands.onUndo = [this] { undo(); };
    commands.onRedo = [this] { redo(); };
    surfaceView.onFire = [this] { fire(); };
    surfaceView.fingers().say = draft.say = [this] (const juce::String& sentence) { status.say (sentence); };
    device.onPlace = [this] (bool shouldRun) { searchPlaces (shouldRun); };
    browser->onClose = [this] { browse (std::nullopt); };

    for (juce::Component* const child :
         std::initializer_list<juce::Component*> { &surfaceView, &section, &time, &left, &upper, &lower, &meters })
        addAndMakeVisible (child);

    addChildComponent (drawing);
    addChildComponent (*browser);
    begin();
}

void EditorContent::refresh (double seconds)
{
    if (const auto isArmed = processor.parameters().arm().get(); ! std::exchange (wasArmed, isArmed) && isArmed)
        status.say ({});

    showModel();
    parameters.refresh();
    askForPicture();
    showPicture();
    showBank();
    showDraft();

    // A tab that was not shown has had no place before.
    if (std::exchange (laidOutFor, parameterView.getBounds()) != parameterView.getBounds())
        layOutParameters();

    time.advance (seconds);
    surfaceView.setFrame (time.frame());
    surfaceView.refresh();
    probe.refresh();
    drift.refresh();
    settings.refresh();
    meters.refresh (seconds);
    commands.refresh (presets.loadedName (LibraryKind::device), presets.loadedName (LibraryKind::focus));
    status.show (editorMessages (processor, picture.get(), ! designs->isDone(), messagesBeside()),
                 playedFigures (processor), seconds);
}

void EditorContent::showModel()
{
    auto now = processor.session().snapshot()->model;

    if (now == model)
        return;

    model = std::move (now);
    meters.setModel (model);
    bank.setChart (nullptr, "The foci of the notes are not designed yet.");
    shownVolts.reset();
    parameters.refreshTexts (model != nullptr && model->surface.kind == SurfaceKind::line);
    resized();
}

/** The parameters are looked at here rather than in the session's snapshot: before a host has prepared us there is none
    of them. */
void EditorContent::askForPicture()
{
    const auto now = processor.session().snapshot();

    if (now->model == nullptr)
        return;

    auto playback = now->playback;

    if (! (playback.sampleRate > 0))
        playback = { Reconstruction::bandLimited, usualRate };

    DesignQuestion question { now->model, processor.focus(), processor.parameters().settings(), playback };

    if (asked && *asked == question)
        return;

    asked = question;
    designs->ask (std::move (question));
}

void EditorContent::showPicture()
{
    auto newest = designs->picture();

    if (newest == picture)
        return;

    picture = std::move (newest);
    showVelocityOfLevel();
    const juce::String wording = picture->error.empty() ? "The render is not ready yet." : "There is no focus to show.";
    surfaceView.setPicture (picture);
    section.setChart (picture->section, wording);
    spectrum.setChart (picture->spectrum, wording);
    voltages.setChart (picture->rendered != nullptr ? picture->rendered->voltages : nullptr, wording);
    methods.setChart (picture->methods, wording);
    felt.setChart (picture->rendered != nullptr ? picture->rendered->felt : nullptr, wording);
    probe.designed().setChart (picture->rendered != nullptr ? picture->rendered->probe : nullptr, wording);
    scores.setPicture (picture);
}

/** A focus with a level has the velocity that its design found, not the one at which the search began. */
void EditorContent::showVelocityOfLevel()
{
    const auto& velocity = picture->velocityOfLevel;
    const auto level = picture->focus.targets.front().level;
    parameters.showInstead ("peak_velocity", velocity && level
                                                 ? inWords (milli * *velocity) + " mm/s: " + inWords (*level) + " dB SL"
                                                 : std::string());
}

void EditorContent::showBank()
{
    const auto now = processor.session().snapshot();
    auto volts = processor.session().progress().volts;

    if (volts == shownVolts || now->model == nullptr || volts.size() != now->notePlaces.size())
        return;

    BankVolts shown { now->notePlaces, {}, {}, voltageLimits (*now->model).maxCoeff() };

    for (const auto& [peak, bound] : volts)
    {
        shown.peaks.push_back (peak);
        shown.bounds.push_back (bound);
    }

    if (const auto& limit = now->focus.allocation.voltageLimit)
        shown.limit = std::min (shown.limit, *limit);

    bank.setChart (volts.empty() ? nullptr : std::make_shared<const Chart> (bankVoltsChart (*now->model, shown)),
                   "All notes play the focus at its own place.");
    shownVolts = std::move (volts);
}

void EditorContent::searchPlaces (bool shouldRun)
{
    const auto now = processor.session().snapshot();

    if (! shouldRun || now->model == nullptr || ! askedDraft)
        return places->stop();

    places->ask ({ draft.device(),
                   withSettings (processor.focus()->description, processor.parameters().settings(),
                                 deviceExtent (draft.device()->description)),
                   askedDraft->playback });
}

/** The device is drawn while its panel is shown. */
void EditorContent::showDraft()
{
    const auto isShown = device.isVisible();
    drawing.setVisible (isShown);
    surfaceView.setVisible (! isShown);
    time.setVisible (! isShown);
    draft.refresh();

    if (! isShown)
        return;

    const auto now = processor.session().snapshot();
    const auto isExact = ! draft.isEdited() && ! now->isSolving && now->model != nullptr && now->device != nullptr
                         && now->device->text == draft.device()->text;
    auto playback = now->playback;

    if (! (playback.sampleRate > 0))
        playback = { Reconstruction::bandLimited, usualRate };

    const auto modes = now->model != nullptr ? static_cast<int> (now->model->modes()) : 0;
    DraftQuestion question { draft.device(),    isExact ? now->model : nullptr,
                             processor.focus(), processor.parameters().settings(),
                             playback,          modes,
                             device.mode() };

    if (! askedDraft || ! (*askedDraft == question))
    {
        askedDraft = question;
        drafts->ask (std::move (question));
    }

    if (auto newest = drafts->picture(); newest != draftPicture)
    {
        draftPicture = std::move (newest);
        drawing.show (draftPicture);
    }

    device.refresh (draftPicture, places->progress());
    drawing.refresh();
}

bool EditorContent::isSettled() const
{
    const auto now = processor.session().snapshot();
    const auto isShown =
        picture != nullptr && asked && picture->question == *asked && picture->stage == DesignPicture::Stage::complete;
    return ! now->isSolving && now->model != nullptr && now->device->text == processor.device()->text && isShown
           && designs->isDone() && drafts->isDone() && draftPicture == drafts->picture();
}

void EditorContent::fire()
{
    if (processor.parameters().arm().get())
        processor.session().fire (1);
    else
        status.say ("Nothing was fired: the output is disarmed. Arm it first.");
}

void EditorContent::undo()
{
    past.undo();
    refresh (0);
}

void EditorContent::redo()
{
    past.redo();
    refresh (0);
}

void EditorContent::leaveSettingsToWindow()
{
    hasSettings = false;
    layout = Layout::none;
    resized();
}

void EditorContent::browse (std::optional<LibraryKind> kind)
{
    const auto closes = ! kind || (browser->isVisible() && browser->kind() == *kind);
    browser->setVisible (! closes);

    if (closes)
        return;

    browser->open (*kind);
    browser->toFront (true);
    resized();
}

void EditorContent::showPanel (const juce::String& name)
{
    const auto isLower =
        layout == Layout::wide && (name == "Voltages" || name == "Methods" || name == "Bank" || name == "Scores");
    const auto isLeft = layout == Layout::wide && (name == "Controls" || name == "Device");
    (isLower ? lower : isLeft ? left : upper).show (name);
    refresh (0);
}

bool EditorContent::keyPressed (const juce::KeyPress& key)
{
    if (key == juce::KeyPress ('z', juce::ModifierKeys::commandModifier, 0))
        undo();
    else if (key == juce::KeyPress ('z', juce::ModifierKeys::commandModifier | juce::ModifierKeys::shiftModifier, 0)
             || key == juce::KeyPress ('y', juce::ModifierKeys::commandModifier, 0))
        redo();
    else if (key == juce::KeyPress::escapeKey && browser->isVisible())
        browse (std::nullopt);
    else
        return handleShortcut (key);

    return true;
}

bool EditorContent::handleShortcut (const juce::KeyPress& key)
{
    if (key.getModifiers().isCommandDown() || key.getModifiers().isAltDown())
        return false;

    auto& arm = processor.parameters().arm();
    const auto code = key.getKeyCode();
    const auto isLetter = [code] (int letter) { return code == letter || code == letter - 'a' + 'A'; };

    if (code == juce::KeyPress::spaceKey)
        fire();
    else if (code == juce::KeyPress::escapeKey)
        processor.session().stopAll();
    else if (isLetter ('a'))
        arm.setValueNotifyingHost (arm.get() ? 0.0f : 1.0f);
    else if (isLetter ('t'))
        setDark (! isDark());
    else if (isLetter ('p'))
        time.setPlaying (! time.isPlaying());
    else if (isLetter ('f'))
        time.showFocus();
    else
        return false;

    return true;
}

bool EditorContent::isInterestedInFileDrag (const juce::StringArray& files)
{
    return files.size() == 1
           && (files[0].endsWithIgnoreCase (".json") || files[0].endsWithIgnoreCase (".svg")
               || files[0].endsWithIgnoreCase (".dxf"));
}

void EditorContent::changeDevice (std::shared_ptr<const DeviceDocument> device)
{
    past.record (
        [&]
        {
            auto wanted = processor.state();
            wanted.device = std::move (device);
            processor.setState (wanted, true);
        });
}

void EditorContent::filesDropped (const juce::StringArray& files, int, int)
{
    if (! isInterestedInFileDrag (files))
        return;

    if (files[0].endsWithIgnoreCase (".json"))
        status.say (presets.loadFile (files[0].toStdString()));
    else
        draft.takeOutline (files[0].toStdString());
}

void installEditor()
{
    AntinodeProcessor::makeEditor = [] (AntinodeProcessor& processor)
    {
        auto editor = editorAsLeft<EditorContent> (processor);
        auto& content = editor->content();
        auto& settings = content.settingsPanel();
        settings.setScale (readPreferences().scale);
        settings.onScale = [&content, shown = editor.get()] (double scale)
        {
            shown->setContentScale (scale);
            keepPreferences ({ content.isDark(), scale });
        };
        return editor.release();
    };
}

namespace
{
constexpr int timeHeight = 38, metersHeight = 62;
constexpr int parametersWidth = 290, wideFrom = 1080, wideFromHeight = 600;
constexpr int besidePlate = 150, belowPlate = 70, minimumSectionHeight = 130; // what axes and colours take
} // namespace

void EditorContent::setLayout (Layout wanted)
{
    if (std::exchange (layout, wanted) == wanted)
        return;

    const PanelGroup::Panel ofSpectrum { "Spectrum", "Wanted and reached velocity of each mode.", &spectrum },
        ofFelt { "Felt", "What skin feels of the whole event, everywhere: dB over threshold, a model.", &felt },
        ofProbe { "Probe", "Velocity at the probe over time: designed and live.", &probe },
        ofVoltages { "Voltages", "Voltage of each ceramic with its limits.", &voltages },
        ofMethods { "Methods", "What this focus needs by several methods, and what no waveform goes below.", &methods },
        ofBank { "Bank", "What the foci of the notes' places need, over the surface.", &bank },
        ofDrift { "Drift", "The sensor that follows the drift of the device, and what it says.", &drift },
        ofScores { "Scores", "Scores of the focus, warnings and choices.", &scores },
        ofControls { "Controls", "All parameters.", &parameterView },
        ofDevice { "Device", "The device itself: drawn, changed and solved.", &device };
    std::vector<PanelGroup::Panel> ofUpper { ofSpectrum, ofFelt, ofProbe, ofDrift },
        ofLower { ofVoltages, ofMethods, ofBank, ofScores };
    left.setPanels ({});
    upper.setPanels ({});
    lower.setPanels ({});

    if (hasSettings)
        ofUpper.push_back ({ "Settings", "Size of the window's content, and how what plays is run.", &settings });

    if (wanted == Layout::wide)
    {
        left.setPanels ({ ofControls, ofDevice });
        upper.setPanels (ofUpper);
        lower.setPanels (ofLower);
    }
    else
    {
        ofUpper.insert (ofUpper.begin(), { ofControls, ofDevice });
        ofUpper.insert (ofUpper.end(), ofLower.begin(), ofLower.end());
        upper.setPanels (ofUpper);
    }

    left.setVisible (wanted == Layout::wide);
    lower.setVisible (wanted == Layout::wide);
}

void EditorContent::layOut (juce::Rectangle<int> area)
{
    area.removeFromBottom (1);
    meters.setBounds (area.removeFromBottom (metersHeight));
    area = area.reduced (gap);

    if (getWidth() >= wideFrom && getHeight() >= wideFromHeight)
        layOutWide (area);
    else
        layOutNarrow (area);

    layOutParameters();
    browser->setBounds (surfaceView.getBounds()
                            .getUnion (time.getBounds())
                            .withSizeKeepingCentre (std::min (420, surfaceView.getWidth()), surfaceView.getHeight())
                            .withTrimmedTop (gap)
                            .withTrimmedBottom (gap));
}

void EditorContent::layOutNarrow (juce::Rectangle<int> area)
{
    setLayout (Layout::narrow);
    upper.setBounds (area.removeFromRight (std::max (352, area.getWidth() * 2 / 5)));
    area.removeFromRight (gap);
    layOutSurface (area);
}

void EditorContent::layOutWide (juce::Rectangle<int> area)
{
    setLayout (Layout::wide);
    left.setBounds (area.removeFromLeft (parametersWidth));
    area.removeFromLeft (gap);
    auto right = area.removeFromRight (area.getWidth() * 21 / 50);
    area.removeFromRight (gap);
    upper.setBounds (right.removeFromTop ((right.getHeight() - gap) * 9 / 20));
    right.removeFromTop (gap);
    lower.setBounds (right);
    layOutSurface (area);
}

void EditorContent::layOutSurface (juce::Rectangle<int> area)
{
    const auto left = heightBelow (area.withTrimmedBottom (timeHeight));
    section.setVisible (left >= minimumSectionHeight);

    if (section.isVisible())
        section.setBounds (area.removeFromBottom (left));

    drawing.setBounds (area);
    time.setBounds (area.removeFromBottom (timeHeight));
    surfaceView.setBounds (area);
}

/** What a plate leaves free of a place for it; nothing of a line, whose field takes any height. */
int EditorContent::heightBelow (juce::Rectangle<int> area) const
{
    if (model == nullptr || model->surface.kind == SurfaceKind::line)
        return 0;

    const auto& surface = model->surface;
    const auto aspect = (surface.yMaximum - surface.yMinimum) / (surface.xMaximum - surface.xMinimum);
    const auto needed = juce::roundToInt ((area.getWidth() - besidePlate) * aspect) + belowPlate;
    return juce::jlimit (0, area.getHeight() * 2 / 5, area.getHeight() - needed);
}

void EditorContent::layOutParameters()
{
    const auto height = parameterView.getHeight();

    if (parameters.layOut (parameterView.getWidth(), height) > height)
        parameters.layOut (parameterView.getWidth() - parameterView.getScrollBarThickness(), height);
}
} // namespace antinode
