#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

#include <functional>

namespace antinode
{
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
