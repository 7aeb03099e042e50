#include "ChartFile.h"

#include "Drawing.h"
#include "Theme.h"
#include "Ticks.h"
#include "VectorFile.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <juce_graphics/juce_graphics.h>
#include <png.h>

#include <stdexcept>

namespace antinode
{
namespace
{
void requireSize (int width, int height, float scale)
{
    if (width < 16 || height < 16 || width > 8192 || height > 8192)
        throw InputError ("picture", "is " + std::to_string (width) + " x " + std::to_string (height)
                                         + " pixels; allowed: 16 to 8192 in each direction");
    if (! (scale >= 0.25f && scale <= 8.0f))
        throw InputError ("picture", "has scale " + formatNumber (scale) + "; allowed: 0.25 to 8");
}

// libpng's quick setting: up to twice the bytes of JUCE's writer in a fifth of its time. Encoding, not drawing,
// dominates.
std::string encodePng (const juce::Image& image)
{
    const juce::Image::BitmapData pixels (image, juce::Image::BitmapData::readOnly);
    png_image header {};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32> (pixels.width);
    header.height = static_cast<png_uint_32> (pixels.height);
    header.format = PNG_FORMAT_BGR;
    header.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX (header);
    std::string bytes (size, '\0');
    if (png_image_write_to_memory (&header, bytes.data(), &size, 0, pixels.data, pixels.lineStride, nullptr) == 0)
        throw std::runtime_error (std::string ("the picture could not be written: ") + header.message);
    bytes.resize (size);
    bytes.shrink_to_fit();
    return bytes;
}
} // namespace

std::string renderPng (const Chart& chart, int width, int height, float scale, const Theme& theme)
{
    requireSize (width, height, scale);
    checkWatch();
    const auto image = blankImage (width, height, scale, theme.background);
    {
        juce::Graphics g (image);
        g.addTransform (juce::AffineTransform::scale (scale));
        draw (g, juce::Rectangle<int> (width, height).toFloat(), chart, theme);
    }
    checkWatch();
    return encodePng (image);
}

std::string renderVector (const Chart& chart, int width, int height, VectorFormat format)
{
    if (width < 16 || height < 16 || width > 8192 || height > 8192)
        throw InputError ("figure", "is " + std::to_string (width) + " x " + std::to_string (height)
                                        + " pixels; allowed: 16 to 8192 in each direction");

    checkWatch();
    VectorFile file (format, width, height);
    draw (file.graphics(), juce::Rectangle<int> (width, height).toFloat(), chart, Theme::print());
    return file.finish();
}
} // namespace antinode
