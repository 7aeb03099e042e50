#include "PlateEditor.h"

namespace antinode
{
juce::AudioProcessorEditor* PlateProcessor::createEditor()
{
    return editorAsLeft<PlateContent> (*this).release();
}
} // namespace antinode
