#include "ScoresView.h"

#include "EditorLook.h"
#include "JuceText.h"

#include <cmath>

namespace antinode
{
namespace
{
constexpr int scoresMargin = 12;

} // namespace

int ScoresView::Page::layOut (int width)
{
    layout.createLayout (words, static_cast<float> (width - 2 * scoresMargin));
    return static_cast<int> (std::ceil (layout.getHeight())) + 2 * scoresMargin;
}

void ScoresView::Page::paint (juce::Graphics& g)
{
    layout.draw (g, getLocalBounds().reduced (scoresMargin).toFloat());
}

ScoresView::ScoresView()
{
    setTitle ("Scores and remarks");
    page.setTitle ("Scores and remarks");
    viewport.setViewedComponent (&page, false);
    viewport.setScrollBarsShown (true, false);
    addAndMakeVisible (viewport);
}

void ScoresView::setPicture (std::shared_ptr<const DesignPicture> newPicture)
{
    picture = std::move (newPicture);
    layOut();
}

void ScoresView::write()
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto plain = EditorLook::font (EditorLook::smallTextHeight), strong = EditorLook::font (15, true),
               small = EditorLook::font (5);
    auto& words = page.words;
    words.clear();
    words.setLineSpacing (2);

    if (picture != nullptr && ! picture->error.empty())
        words.append (fromUtf8 (picture->error) + "\n\n", EditorLook::font(), palette.warning);

    if (picture == nullptr || picture->rendered == nullptr)
    {
        words.append ("The render is not ready yet.", plain, palette.mutedText);
        page.setDescription (words.getText());
        return;
    }

    for (const auto& warning : picture->rendered->warnings)
    {
        words.append (fromUtf8 (warning) + "\n", plain, palette.warning);
        words.append ("\n", small);
    }

    for (const auto& score : picture->rendered->scores)
    {
        words.append (fromUtf8 (score.name) + "   ", plain, palette.mutedText);
        words.append (fromUtf8 (score.value) + "\n", strong, palette.text);
        words.append (fromUtf8 (score.sentence) + "\n", plain, palette.mutedText);
        words.append ("\n", small);
    }

    for (const auto& choice : picture->rendered->choices)
    {
        words.append (fromUtf8 (choice) + "\n", plain, palette.text);
        words.append ("\n", small);
    }

    page.setDescription (words.getText());
}

void ScoresView::layOut()
{
    write();
    const auto width = getWidth() - viewport.getScrollBarThickness();

    if (width > 0)
        page.setSize (width, std::max (page.layOut (width), viewport.getHeight()));

    page.repaint();
}

void ScoresView::resized()
{
    viewport.setBounds (getLocalBounds());
    layOut();
}
} // namespace antinode
