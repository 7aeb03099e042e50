#pragma once

#include "DesignPicture.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>

namespace antinode
{
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
} // namespace antinode
