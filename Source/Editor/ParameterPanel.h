#pragma once

#include "ParameterControl.h"

#include <Processor/AntinodeProcessor.h>

#include <memory>
#include <vector>

namespace antinode
{
/** All parameters in their groups, one below the other. [message thread] */
class ParameterPanel final : public juce::Component
{
public:
    explicit ParameterPanel (AntinodeProcessor&);

    /** Shows what has changed. */
    void refresh();

    /** Shows all texts again: the device is another one. @param isLine  then nothing is along y */
    void refreshTexts (bool isLine);

    /** Lays the controls out for a width, and fills a place at least so high. @return  the height that the controls
        need */
    int layOut (int width, int minimumHeight);

    const std::vector<std::unique_ptr<ParameterControl>>& controls() const { return all; }

    void paint (juce::Graphics&) override;

private:
    struct Group
    {
        juce::String name;
        std::size_t first = 0, count = 0; ///< Of the controls.
        juce::Rectangle<int> heading;
    };

    std::vector<Group> groups;
    std::vector<std::unique_ptr<ParameterControl>> all;
};
} // namespace antinode
