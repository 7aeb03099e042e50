#include "DraftControls.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int draftNameWidth = 92;
}

DraftRow::DraftRow (DeviceDraft& draftToEdit, const juce::String& nameToShow)
    : juce::Component (nameToShow), draft (draftToEdit), name ({}, nameToShow)
{
    name.setFont (EditorLook::font (EditorLook::smallTextHeight));
    name.setMinimumHorizontalScale (1);
    name.setBorderSize ({});
    addAndMakeVisible (name);
}

void DraftRow::addInput (juce::Component& made)
{
    input = &made;
    made.setTitle (getName());
    made.setWantsKeyboardFocus (true);
    addAndMakeVisible (made);
}

void DraftRow::resized()
{
    auto area = getLocalBounds();
    name.setBounds (area.removeFromLeft (draftNameWidth));
    input->setBounds (area.reduced (0, 1));
}

DraftNumber::DraftNumber (DeviceDraft& draftToEdit, Kind kindToEdit)
    : DraftRow (draftToEdit, kindToEdit.name), kind (std::move (kindToEdit))
{
    bar.setRange (kind.least, kind.most, kind.step);
    bar.setSkewFactorFromMidPoint (kind.middle);

    if (kind.step == 0)
        bar.setNumDecimalPlacesToDisplay (2);

    bar.setTextValueSuffix (kind.unit.isEmpty() ? juce::String() : " " + kind.unit);
    bar.setTooltip (kind.tooltip);
    bar.setSliderSnapsToMousePosition (false);
    bar.setScrollWheelEnabled (false); // The wheel scrolls the panel.
    bar.onDragStart = [this]
    {
        heldDocument = draft.document();
        isDragged = true;
    };
    bar.onDragEnd = [this]
    {
        isDragged = false;
        draft.drop();
    };
    bar.onValueChange = [this] { change(); };
    addInput (bar);
}

void DraftNumber::change()
{
    if (isDragged)
        draft.drag (kind.write (heldDocument, bar.getValue()));
    else
        draft.apply (kind.write (draft.document(), bar.getValue()));
}

bool DraftNumber::refresh()
{
    const auto value = kind.read (draft.document());

    if (value && ! isDragged)
    {
        // A device of a file may have more or less than is usual.
        bar.setRange (std::min (kind.least, *value), std::max (kind.most, *value), kind.step);
        bar.setValue (*value, juce::dontSendNotification);
    }

    return value.has_value();
}

DraftChoice::DraftChoice (DeviceDraft& draftToEdit, Kind kindToEdit)
    : DraftRow (draftToEdit, kindToEdit.name), kind (std::move (kindToEdit))
{
    list.setTooltip (kind.tooltip);
    list.setTextWhenNothingSelected ("own values");
    list.onChange = [this]
    {
        if (list.getSelectedId() > 0)
            kind.choose (list.getSelectedId() - 1);
    };
    addInput (list);
}

bool DraftChoice::refresh()
{
    const auto now = kind.read (draft.document());

    if (! now)
        return false;

    if (auto words = kind.words (draft.document()); words != shown)
    {
        shown = std::move (words);
        list.clear (juce::dontSendNotification);
        list.addItemList (shown, 1);
    }

    list.setSelectedId (*now + 1, juce::dontSendNotification);
    return true;
}

int MaterialWords::indexOf (const nlohmann::json& material) const
{
    const auto found =
        material.is_string() ? std::find (names.begin(), names.end(), material.get<std::string>()) : names.end();
    return found != names.end() ? static_cast<int> (found - names.begin()) : -1;
}
} // namespace antinode
