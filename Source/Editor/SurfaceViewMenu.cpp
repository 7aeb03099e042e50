#include "SurfaceView.h"

#include <algorithm>

namespace antinode
{
namespace
{
juce::String capitalised (const char* word)
{
    const juce::String text (word);
    return text.substring (0, 1).toUpperCase() + text.substring (1);
}
} // namespace

juce::PopupMenu SurfaceView::fingerMenu (juce::Point<float> place)
{
    juce::PopupMenu menu;

    if (picture == nullptr)
        return menu;

    const auto at = surfacePlace (place);
    const auto finger = fingerAt (place);
    menu.addSectionHeader (finger ? "Finger" : "Rest a finger here");

    for (const auto& kind : fingerKinds)
        menu.addItem (capitalised (kind.name), true, finger && touching.all()[*finger].name == kind.name,
                      [this, at, finger, name = std::string (kind.name)]
                      {
                          if (finger)
                              touching.setKind (*finger, name);
                          else
                              touching.rest (name, at.x, at.y);
                      });

    menu.addSeparator();

    if (finger)
    {
        const auto isKnown = touching.all()[*finger].isKnown;
        menu.addItem ("Known to the design", true, isKnown,
                      [this, finger, isKnown] { touching.setKnown (*finger, ! isKnown); });
        menu.addItem ("Lift", [this, finger] { touching.lift (*finger); });
    }
    else
        menu.addItem ("Lift all fingers", ! touching.all().empty(), false, [this] { touching.liftAll(); });

    return menu;
}

/** N rests a finger at the probe, Delete lifts the one nearest to it. */
bool SurfaceView::changeFingers (const juce::KeyPress& key)
{
    const auto isLetter = key.getTextCharacter() == 'n' || key.getTextCharacter() == 'N';
    const auto isDelete = key == juce::KeyPress::deleteKey || key == juce::KeyPress::backspaceKey;

    if (picture == nullptr || ! (isLetter || isDelete) || key.getModifiers().isCommandDown())
        return false;

    const auto& all = touching.all();

    if (isLetter)
    {
        const auto at = surfacePlace (probe());
        touching.rest ("medium", at.x, at.y);
        return true;
    }

    if (all.empty())
        return false;

    std::size_t nearest = 0;
    const auto distance = [&] (std::size_t finger)
    { return probe().getDistanceFrom (touching.middle (finger, painter.frame())); };

    for (std::size_t i = 1; i < all.size(); ++i)
        if (distance (i) < distance (nearest))
            nearest = i;

    touching.lift (nearest);
    return true;
}
} // namespace antinode
