#include "JuceText.h"

namespace antinode
{
juce::String fromUtf8 (const std::string& text)
{
    return juce::String::fromUTF8 (text.c_str());
}
} // namespace antinode
