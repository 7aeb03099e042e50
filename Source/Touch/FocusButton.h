#pragma once

#include <Editor/LibraryButton.h>

#include "TouchProcessor.h"

namespace antinode
{
/** The focus that notes play on top of the tracks; a click chooses another one, or none. [message thread] */
class FocusButton final : public LibraryButton
{
public:
    explicit FocusButton (TouchProcessor&);

    /** Shows what the processor plays. */
    void refresh();

private:
    void addItems (juce::PopupMenu&) override;

    TouchProcessor& processor;
};
} // namespace antinode
