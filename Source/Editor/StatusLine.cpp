#include "StatusLine.h"

#include "EditorLook.h"
#include "JuceText.h"

#include <antinode_charts/Lettering.h>
#include <antinode_session/DesignSentences.h>

namespace antinode
{
namespace
{
constexpr int cornerWidth = 14; // where a window is resized

} // namespace

StatusLine::StatusLine (AntinodeProcessor& processorToShow) : processor (processorToShow)
{
    setTitle ("Status");
}

void StatusLine::say (const juce::String& sentence)
{
    said = sentence;
}

StatusLine::Message StatusLine::message (const DesignPicture* picture, bool isWorking) const
{
    const auto session = processor.session().snapshot();
    const auto progress = processor.session().progress();

    if (said.isNotEmpty())
        return { said, Level::warning };

    if (processor.session().meters().isMutedForBadNumbers())
        return { "The output is muted because a sample was not finite. Load the device again.", Level::warning };

    if (const auto warning = processor.warning(); warning.isNotEmpty())
        return { warning, Level::warning };

    if (session->isSolving || session->model == nullptr)
        return { "Solving " + fromUtf8 (processor.device()->description.name)
                 + juce::String::fromUTF8 (" \xE2\x80\xA6") };

    if (! progress.liveError.empty())
        return { fromUtf8 (progress.liveError), Level::warning };

    if (picture != nullptr && ! picture->error.empty())
        return { fromUtf8 (picture->error), Level::warning };

    if (! progress.isDone())
        return { "Designing " + juce::String (progress.designed) + " of " + juce::String (progress.wanted)
                 + juce::String::fromUTF8 (" positions \xE2\x80\xA6") };

    if (const auto sentence = unplayableNotes (progress, session->playback.sampleRate); ! sentence.empty())
        return { fromUtf8 (sentence), Level::caution };

    if (session->isAsWritten && ! isWorking)
        return { "Ready; every note plays the design as it was written, moving a parameter designs its focus again" };

    return { isWorking ? juce::String::fromUTF8 ("Ready; rendering the charts \xE2\x80\xA6") : juce::String ("Ready") };
}

void StatusLine::refresh (const DesignPicture* picture, bool isWorking)
{
    const auto now = message (picture, isWorking);
    const auto& meters = processor.session().meters();
    const auto rate = processor.session().snapshot()->playback.sampleRate;
    const auto numbers = (rate > 0 ? juce::String (rate / 1000, 1) + " kHz" : juce::String ("not playing")) + "    "
                         + "voices " + juce::String (meters.voices()) + "    triggers "
                         + juce::String (meters.triggered());

    if (now.text == shown && numbers == figures && now.level == shownLevel)
        return;

    shown = now.text;
    figures = numbers;
    shownLevel = now.level;
    setDescription (shown);
    setTooltip (shown);
    repaint();
}

void StatusLine::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    auto area = getLocalBounds().reduced (10, 0).withTrimmedRight (cornerWidth).toFloat();
    const TextStyle style { EditorLook::smallTextHeight, false, palette.mutedText };
    const auto right = area.removeFromRight (textWidth (figures.toStdString(), style) + 2);
    drawText (g, figures.toStdString(), right, juce::Justification::centredRight, style);
    const auto isCalm = shownLevel == Level::calm;
    const auto urgent = shownLevel == Level::warning ? palette.warning : palette.caution;
    g.setColour (isCalm ? palette.armed : urgent);
    g.fillEllipse (area.removeFromLeft (8).withSizeKeepingCentre (8, 8));
    area.removeFromLeft (8);
    area.removeFromRight (16);
    drawText (g, shown.toStdString(), area, juce::Justification::centredLeft,
              { EditorLook::smallTextHeight, false, isCalm ? palette.text : urgent });
}
} // namespace antinode
