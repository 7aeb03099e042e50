#include "BlankImage.h"

namespace antinode
{
juce::Image blankImage (int width, int height, float scale, juce::Colour colour)
{
    const auto pixels = [scale] (int length)
    { return juce::jmax (1, juce::roundToInt (static_cast<float> (length) * scale)); };
    juce::Image image (juce::Image::RGB, pixels (width), pixels (height), false, juce::SoftwareImageType());
    image.clear (image.getBounds(), colour);
    return image;
}
} // namespace antinode
