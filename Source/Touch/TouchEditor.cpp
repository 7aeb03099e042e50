#include "TouchEditor.h"

namespace antinode
{
juce::AudioProcessorEditor* TouchProcessor::createEditor()
{
    return editorAsLeft<TouchContent> (*this).release();
}
} // namespace antinode
