#pragma once

#include "DesignView.h"
#include "DriftPanel.h"
#include "EditorLook.h"
#include "History.h"
#include "LocalTooltips.h"
#include "MetersStrip.h"
#include "PanelGroup.h"
#include "ParameterPanel.h"
#include "PresetPanel.h"
#include "ProbePanel.h"
#include "ScoresView.h"
#include "SettingsPanel.h"
#include "StatusLine.h"
#include "SurfaceView.h"
#include "Timeline.h"
#include "TopBar.h"
#include "WindowScale.h"

#include <antinode_base/BackgroundThread.h>

#include <functional>
#include <optional>

namespace antinode
{
/** The content of the editor as a plain component for any window. Nothing in it runs by itself except the design view's
    thread: whoever has it calls refresh(). [message thread] */
class EditorContent final : public juce::Component, public juce::FileDragAndDropTarget
{
public:
    static constexpr ContentSizes sizes { 800, 500, 1700, 1000 };
    static constexpr int usualWidth = 1280, usualHeight = 800, framesPerSecond = 60;

    explicit EditorContent (AntinodeProcessor&);
    ~EditorContent() override;

    /** Shows what has changed. @param seconds  since the last call */
    void refresh (double seconds);

    /** Whether everything requested is shown and no work is in progress. */
    bool isSettled() const;

    void setDark (bool isDark);
    bool isDark() const { return look.palette().isDark; }

    /** Called after it has become dark or light. */
    std::function<void()> onTheme;

    History& history() { return past; }
    SurfaceView& surface() { return surfaceView; }
    PresetPanel& presetPanel() { return *browser; }
    ParameterPanel& parameterPanel() { return parameters; }
    MetersStrip& metersStrip() { return meters; }
    DriftPanel& driftPanel() { return drift; }
    StatusLine& statusLine() { return status; }
    Timeline& timeline() { return time; }

    /** A tab of its own, unless a window around shows it. */
    SettingsPanel& settingsPanel() { return settings; }
    void leaveSettingsToWindow();

    /** What the window around has to say beside it; none: nothing. */
    std::function<std::vector<UserMessage>()> moreMessages;

    /** Opens the browser of a kind, or closes it. */
    void browse (std::optional<LibraryKind>);

    /** Shows one of the panels at the right: "Spectrum", "Felt", "Probe", "Voltages", "Methods", "Bank", "Scores",
        "Drift", "Settings", "Controls". */
    void showPanel (const juce::String& name);

    void paint (juce::Graphics&) override;
    void resized() override;
    bool keyPressed (const juce::KeyPress&) override;

    /** A file that is dropped on the window is loaded: a device, a focus or a written design. */
    bool isInterestedInFileDrag (const juce::StringArray& files) override;
    void filesDropped (const juce::StringArray& files, int x, int y) override;

private:
    enum class Layout
    {
        none,
        narrow, ///< One group of panels, the parameters among them.
        wide    ///< Parameters at the left, two groups of panels at the right.
    };

    void askForPicture();
    void showPicture();
    void showModel();
    void showBank();
    void showMessages (double seconds);
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
    juce::SharedResourcePointer<EditorLook> fonts; ///< Of JUCE's own windows: menus and alerts.
    EditorLook look;
    History past;
    Presets presets;
    std::shared_ptr<DesignView> designs = std::make_shared<DesignView>();
    BackgroundThread designThread { [kept = designs] { kept->run(); } };
    TopBar top;
    SurfaceView surfaceView;
    Timeline time;
    ChartView section, spectrum, felt, voltages, methods, bank;
    ProbePanel probe;
    DriftPanel drift;
    ScoresView scores;
    SettingsPanel settings;
    bool hasSettings = true;
    ParameterPanel parameters;
    juce::Viewport parameterView;
    PanelGroup upper { "Charts" }, lower { "More charts" };
    MetersStrip meters;
    StatusLine status;
    std::unique_ptr<PresetPanel> browser;
    LocalTooltips tooltips;
    Layout layout = Layout::none;
    bool wasArmed = false;
    std::shared_ptr<const ModalModel> model;
    std::shared_ptr<const DesignPicture> picture;
    std::optional<DesignQuestion> asked;
    std::optional<std::vector<PlaceVolts>> shownVolts; ///< Of the bank that is shown.
};
} // namespace antinode
