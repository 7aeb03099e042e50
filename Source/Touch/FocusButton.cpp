#include "FocusButton.h"

#include <Editor/JuceText.h>

#include <nlohmann/json.hpp>

namespace antinode
{
FocusButton::FocusButton (TouchProcessor& processorToSet)
    : LibraryButton (
        LibraryKind::focus, "focus",
        [&processorToSet] (const nlohmann::json& json, const std::string& source)
        { processorToSet.loadFocus (std::make_shared<const FocusDocument> (readFocusDocument (json, source))); }),
      processor (processorToSet)
{
    setTooltip (
        "The focus that MIDI notes play on top of the tracks: middle C at its own place, the others spread over "
        "the surface. Click to choose another, or none.");
}

void FocusButton::refresh()
{
    const auto focus = processor.focus();
    setButtonText ("Notes: " + (focus != nullptr ? fromUtf8 (focus->description.name) : juce::String ("nothing")));
}

void FocusButton::addItems (juce::PopupMenu& menu)
{
    menu.addItem ("Nothing",
                  [this]
                  {
                      clearError();
                      processor.loadFocus (nullptr);
                  });
    menu.addSeparator();
}
} // namespace antinode
