#pragma once

#include "TouchProcessor.h"

#include <Editor/ParameterPanel.h>
#include <Editor/SurfaceView.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace antinode
{
/** The controls of one finger, and of the output; a row of buttons chooses the finger. [message thread] */
class FingerPanel final : public juce::Component
{
public:
    explicit FingerPanel (TouchParameters&);

    /** Shows the controls of a finger. */
    void select (std::size_t finger);
    std::size_t selected() const { return shown; }

    /** Shows what has changed. */
    void refresh();

    /** Shows all texts again: the device is another one. */
    void refreshTexts (bool isLine);

    /** The height that all controls need. */
    static int height();

    void paint (juce::Graphics&) override;
    void resized() override;
    void lookAndFeelChanged() override;

private:
    static constexpr std::size_t perFinger = 5, ofOutput = 4;

    std::array<juce::TextButton, mostFingers> buttons;
    std::vector<std::unique_ptr<ParameterControl>> fingers; ///< perFinger of each.
    std::vector<std::unique_ptr<ParameterControl>> output;
    std::size_t shown = 0;
};

/** What a finger is to feel, as it is drawn beside its disc. */
struct AskedMotion
{
    std::vector<float> waveform; ///< m, the oldest first; empty: nothing is drawn.
    double full = 1;             ///< m, at the top of the drawing.
    juce::String words;
};

/** The surface with its fingers: discs that can be dragged, filled where they play, rings where they are
    silent; where the filters that play are for another place, a thin ring stands there. Beside each that plays stands
   what it is to feel. [message thread] */
class TouchSurface final : public SurfaceView
{
public:
    explicit TouchSurface (TouchProcessor&);

    /** Draws what has changed. @param selected  the finger whose controls are shown */
    void refresh (std::shared_ptr<const TouchSnapshot>, std::size_t selected);

    /** Shows what fingers are to feel. */
    void show (std::array<AskedMotion, mostFingers>);

    /** Called with a finger that is clicked. */
    std::function<void (std::size_t)> onSelect;

    /** Where a finger is, in pixels of this component. */
    juce::Point<float> finger (std::size_t index) const { return pixels (placeOf (index)); }

    /** Puts the first absent finger down at a place in pixels. @return  which one, if there was one */
    std::optional<std::size_t> putDown (juce::Point<float>);

    void mouseDown (const juce::MouseEvent&) override;
    void mouseDoubleClick (const juce::MouseEvent&) override;

private:
    Place placeOf (std::size_t finger) const;
    juce::Point<float> at (const FingerSettings& finger) const { return pixels (finger.xPercent, finger.yPercent); }
    std::optional<std::size_t> fingerAt (juce::Point<float>) const;
    float radiusOf (const FingerSettings&) const;
    void paintOnTop (juce::Graphics&) override;
    void paintFinger (juce::Graphics&, std::size_t index) const;
    juce::Rectangle<float> areaOfMotion (std::size_t index) const;
    void paintMotion (juce::Graphics&, std::size_t index) const;
    void showMenu (std::size_t index);

    TouchProcessor& processor;
    std::shared_ptr<const TouchSnapshot> snapshot;
    std::array<AskedMotion, mostFingers> asked;
    TouchSettings shown;
    std::size_t selected = 0;
};
} // namespace antinode
