#include "ChartView.h"

#include "EditorLook.h"

#include <antinode_reports/BlankImage.h>
#include <antinode_reports/Drawing.h>
#include <antinode_reports/Lettering.h>

namespace antinode
{
ChartView::ChartView (const juce::String& title)
{
    setTitle (title);
    setInterceptsMouseClicks (false, false);
}

void ChartView::setChart (std::shared_ptr<const Chart> newChart, const juce::String& wording)
{
    if (newChart == chart && wording == waiting)
        return;

    waiting = wording;

    chart = std::move (newChart);
    image = {};
    repaint();
}

void ChartView::lookAndFeelChanged()
{
    image = {};
    repaint();
}

void ChartView::drawImage (float scale)
{
    const auto& theme = EditorLook::findPalette (*this).charts;
    image = blankImage (getWidth(), getHeight(), scale, theme.background);
    imageScale = scale;
    juce::Graphics g (image);
    g.addTransform (juce::AffineTransform::scale (scale));
    draw (g, getLocalBounds().toFloat(), *chart, theme);
}

void ChartView::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);

    if (chart == nullptr)
    {
        g.fillAll (palette.panel);
        drawText (g, waiting.toStdString(), getLocalBounds().toFloat(), juce::Justification::centred,
                  { EditorLook::textHeight, false, palette.mutedText });
        return;
    }

    const auto scale = g.getInternalContext().getPhysicalPixelScaleFactor();

    if (! image.isValid() || scale != imageScale)
        drawImage (scale);

    g.drawImage (image, getLocalBounds().toFloat());
}
} // namespace antinode
