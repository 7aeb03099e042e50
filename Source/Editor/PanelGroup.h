#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

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
} // namespace antinode
