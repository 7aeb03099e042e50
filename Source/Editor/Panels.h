#pragma once

#include "DesignView.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** Panels that share a place: one is shown, the others wait behind their tabs. They are owned elsewhere.
    [message thread] */
class PanelGroup final : public juce::Component
{
public:
    struct Panel
    {
        juce::String name, tooltip;
        juce::Component* content = nullptr;
    };

    static constexpr int tabHeight = 28;

    explicit PanelGroup (const juce::String& title);

    /** Shows these instead of what was there; the one that was shown stays shown where it is among them. */
    void setPanels (const std::vector<Panel>&);
    void show (const juce::String& name);

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    void placeTabs (juce::Rectangle<int>);

    std::vector<Panel> panels;
    std::vector<std::unique_ptr<juce::TextButton>> tabs;
    juce::String shown;
    int rows = 1; ///< Of tabs.
};

/** The scores of the focus, warnings and choices, as sentences. [message thread] */
class ScoresView final : public juce::Component
{
public:
    ScoresView();

    void setPicture (std::shared_ptr<const DesignPicture>);

    void resized() override;
    void lookAndFeelChanged() override { layOut(); }

private:
    /** The page that is scrolled. */
    class Page : public juce::Component
    {
    public:
        juce::AttributedString words;

        /** @return  the height that it needs */
        int layOut (int width);
        void paint (juce::Graphics&) override;

    private:
        juce::TextLayout layout;
    };

    void layOut();
    void write();

    std::shared_ptr<const DesignPicture> picture;
    Page page;
    juce::Viewport viewport;
};

/** What is chosen seldom: how large the window is drawn, and how what plays is run. [message thread] */
class SettingsPanel final : public juce::Component
{
public:
    /** Whether what plays runs by separate nodes, and what makes it so; none: there is no choice. */
    struct SeparateNodes
    {
        std::function<bool()> areOn;
        std::function<void (bool)> turn;
    };

    explicit SettingsPanel (SeparateNodes);

    /** 0: as large as suits the window. */
    void setScale (double);

    /** Called after another scale was chosen. */
    std::function<void (double)> onScale;

    void refresh();

    void resized() override;

private:
    SeparateNodes nodes;
    juce::Label scaleName { {}, "Size of text and controls" };
    juce::ComboBox scale;
    juce::ToggleButton separate { "Separate nodes, for custom nodes only" };
};
} // namespace antinode
