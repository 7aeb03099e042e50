#include "EditorContent.h"

#include <algorithm>
#include <utility>

namespace antinode
{
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
        ofControls { "Controls", "All parameters.", &parameterView };
    std::vector<PanelGroup::Panel> ofUpper { ofSpectrum, ofFelt, ofProbe, ofDrift },
        ofLower { ofVoltages, ofMethods, ofBank, ofScores };
    upper.setPanels ({});
    lower.setPanels ({});

    if (hasSettings)
        ofUpper.push_back ({ "Settings", "Size of the window's content, and how what plays is run.", &settings });

    if (wanted == Layout::wide)
    {
        addAndMakeVisible (parameterView);
        upper.setPanels (ofUpper);
        lower.setPanels (ofLower);
    }
    else
    {
        ofUpper.insert (ofUpper.begin(), ofControls);
        ofUpper.insert (ofUpper.end(), ofLower.begin(), ofLower.end());
        upper.setPanels (ofUpper);
    }

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
    parameterView.setBounds (area.removeFromLeft (parametersWidth));
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
