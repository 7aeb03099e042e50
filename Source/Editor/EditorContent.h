#pragma once

#include "ChartView.h"
#include "ContentEditor.h"
#include "DesignView.h"
#include "DeviceDraft.h"
#include "DevicePanel.h"
#include "DeviceSurface.h"
#include "DraftView.h"
#include "DriftPanel.h"
#include "FieldFrames.h"
#include "FocusCommands.h"
#include "FocusSurface.h"
#include "History.h"
#include "Meters.h"
#include "Panels.h"
#include "ParameterPanel.h"
#include "PlaceSearch.h"
#include "Presets.h"

#include <antinode_session/SessionOwner.h>

#include <memory>
#include <optional>
#include <vector>

namespace antinode
{
/** What Antinode shows. [message thread] */
class EditorContent final : public WindowContent, public juce::FileDragAndDropTarget
{
public:
    explicit EditorContent (AntinodeProcessor&);

    void refresh (double seconds) override;

    /** Whether everything requested is shown and no work is in progress. */
    bool isSettled() const;

    History& history() { return past; }
    FocusSurface& surface() { return surfaceView; }
    PresetPanel& presetPanel() { return *browser; }
    ParameterPanel& parameterPanel() { return parameters; }
    MetersStrip& metersStrip() { return meters; }
    DriftPanel& driftPanel() { return drift; }
    Timeline& timeline() { return time; }
    DeviceDraft& deviceDraft() { return draft; }
    DevicePanel& devicePanel() { return device; }
    DeviceSurface& deviceSurface() { return drawing; }

    /** What the device's panel shows; none: it is not shown yet. */
    std::shared_ptr<const DraftPicture> draftShown() const { return draftPicture; }

    /** How far the search of places for its ceramics is. */
    PlaceProgress placesFound() const { return places->progress(); }

    /** A tab of its own, unless a window around shows it. */
    SettingsPanel& settingsPanel() { return settings; }
    void leaveSettingsToWindow();

    /** Opens the browser of a kind, or closes it. */
    void browse (std::optional<LibraryKind>);

    /** Loads a device in place of the one that is loaded; the focus stays. One entry of the history. */
    void changeDevice (std::shared_ptr<const DeviceDocument>);

    /** Shows one of the panels: "Spectrum", "Felt", "Probe", "Voltages", "Methods", "Bank", "Scores",
        "Drift", "Settings", or "Controls" and "Device". */
    void showPanel (const juce::String& name);

    void lookAndFeelChanged() override { commands.setPalette (look.palette()); }
    bool keyPressed (const juce::KeyPress&) override;

    /** A file that is dropped on the window is loaded: a device, a focus or a written design; a drawing (SVG, DXF) is
        the outline of the device from then on. */
    bool isInterestedInFileDrag (const juce::StringArray& files) override;
    void filesDropped (const juce::StringArray& files, int x, int y) override;

private:
    enum class Layout
    {
        none,
        narrow, ///< One group of panels, the parameters among them.
        wide    ///< Parameters and the device at the left, two groups of panels at the right.
    };

    void askForPicture();
    void showPicture();
    void showVelocityOfLevel();
    void showModel();
    void showBank();
    void showDraft();
    void searchPlaces (bool shouldRun);
    void layOut (juce::Rectangle<int>) override;
    void setLayout (Layout);
    void layOutNarrow (juce::Rectangle<int>);
    void layOutWide (juce::Rectangle<int>);
    void layOutSurface (juce::Rectangle<int>);
    int heightBelow (juce::Rectangle<int>) const;
    void layOutParameters();
    bool handleShortcut (const juce::KeyPress&);
    void undo();
    void redo();
    void fire();

    AntinodeProcessor& processor;
    History past;
    Presets presets;
    DeviceDraft draft;
    SessionThread<DesignView> designs;
    SessionThread<DraftView> drafts;
    SessionThread<PlaceSearch> places;
    FocusCommands commands;
    FocusSurface surfaceView;
    DeviceSurface drawing; ///< In place of the other surface while the device is shown.
    Timeline time;
    ChartView section, spectrum, felt, voltages, methods, bank;
    ProbePanel probe;
    DriftPanel drift;
    ScoresView scores;
    SettingsPanel settings;
    bool hasSettings = true;
    ParameterPanel parameters;
    juce::Viewport parameterView;
    DevicePanel device;
    PanelGroup left { "Controls and device" }, upper { "Charts" }, lower { "More charts" };
    MetersStrip meters;
    std::unique_ptr<PresetPanel> browser;
    Layout layout = Layout::none;
    bool wasArmed = false;
    juce::Rectangle<int> laidOutFor; ///< Of the parameters.
    std::shared_ptr<const ModalModel> model;
    std::shared_ptr<const DesignPicture> picture;
    std::optional<DesignQuestion> asked;
    std::optional<DraftQuestion> askedDraft;
    std::shared_ptr<const DraftPicture> draftPicture;
    std::optional<std::vector<PlaceVolts>> shownVolts; ///< Of the bank that is shown.
};

/** The window of Antinode. */
using Editor = RoleEditor<EditorContent>;

/** Gives every processor of this program its editor, as the last one was left. [message thread] */
void installEditor();
} // namespace antinode
