#include "Theme.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr int tableSize = 256;

double linearFromSrgb (double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow ((value + 0.055) / 1.055, 2.4);
}

double srgbFromLinear (double value)
{
    const auto inside = std::clamp (value, 0.0, 1.0);
    return inside <= 0.0031308 ? 12.92 * inside : 1.055 * std::pow (inside, 1 / 2.4) - 0.055;
}

Eigen::Vector3d linearRgb (juce::Colour colour)
{
    return { linearFromSrgb (colour.getRed() / 255.0), linearFromSrgb (colour.getGreen() / 255.0),
             linearFromSrgb (colour.getBlue() / 255.0) };
}

// The two matrices of Oklab: B. Ottosson, "A perceptual color space for image processing", 2020.
Eigen::Matrix3d coneResponse()
{
    return (Eigen::Matrix3d() << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566,
            0.0883024619, 0.2817188376, 0.6299787005)
        .finished();
}

Eigen::Matrix3d opponents()
{
    return (Eigen::Matrix3d() << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050, 0.4505937099,
            0.0259040371, 0.7827717662, -0.8086757660)
        .finished();
}

Eigen::Vector3d toOklab (juce::Colour colour)
{
    const Eigen::Vector3d cones = coneResponse() * linearRgb (colour);
    return opponents() * cones.unaryExpr ([] (double c) { return std::cbrt (c); });
}

juce::Colour fromOklab (const Eigen::Vector3d& oklab)
{
    const Eigen::Vector3d roots = opponents().inverse() * oklab;
    const Eigen::Vector3d rgb = coneResponse().inverse() * roots.array().cube().matrix();
    const auto byte = [] (double linear)
    { return static_cast<juce::uint8> (std::lround (255 * srgbFromLinear (linear))); };
    return { byte (rgb[0]), byte (rgb[1]), byte (rgb[2]) };
}
} // namespace

ColourMap::ColourMap (const std::vector<juce::Colour>& stops)
{
    const auto segments = static_cast<double> (stops.size() - 1);
    for (int k = 0; k < tableSize; ++k)
    {
        const auto position = segments * k / (tableSize - 1);
        const auto left = std::min (static_cast<std::size_t> (position), stops.size() - 2);
        const auto share = position - static_cast<double> (left);
        table.push_back (fromOklab ((1 - share) * toOklab (stops[left]) + share * toOklab (stops[left + 1])));
    }
}

juce::Colour ColourMap::at (double value) const
{
    const auto inside = value >= 0 ? std::min (value, 1.0) : 0.0;
    return table[static_cast<std::size_t> (std::lround (inside * (tableSize - 1)))];
}

namespace
{
juce::Colour rgb (juce::uint32 value)
{
    return juce::Colour (0xFF000000U | value);
}

std::vector<juce::Colour> rgbList (std::initializer_list<juce::uint32> values)
{
    std::vector<juce::Colour> colours;
    for (const auto value : values)
        colours.push_back (rgb (value));
    return colours;
}

// Nine samples of matplotlib's viridis (S. van der Walt and N. Smith, CC0).
ColourMap viridis()
{
    return ColourMap (
        rgbList ({ 0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725 }));
}

Theme makeLight()
{
    return { .background = rgb (0xFFFFFF),
             .plotBackground = rgb (0xFFFFFF),
             .grid = rgb (0xE4E7EB),
             .axis = rgb (0x8A939E),
             .text = rgb (0x1B1F24),
             .mutedText = rgb (0x57606A),
             .limit = rgb (0xB3261E),
             .span = rgb (0xE6A23C).withAlpha (0.17f),
             .series = rgbList ({ 0x0072B2, 0xD55E00, 0x009E73, 0xB5608F, 0xA87400, 0x6E7781 }),
             .sequential = viridis(),
             .diverging =
                 ColourMap (rgbList ({ 0x053E6E, 0x2B7BBA, 0x9CC7E3, 0xF7F7F7, 0xF0AE90, 0xC4502F, 0x76100F })) };
}

Theme makeDark()
{
    return { .background = rgb (0x15191F),
             .plotBackground = rgb (0x15191F),
             .grid = rgb (0x2A313A),
             .axis = rgb (0x6B7683),
             .text = rgb (0xE8EDF3),
             .mutedText = rgb (0xA3AEBA),
             .limit = rgb (0xFF7B6E),
             .span = rgb (0xE6A23C).withAlpha (0.16f),
             .series = rgbList ({ 0x56B4E9, 0xF5853F, 0x2FC19A, 0xDB94BC, 0xF0E442, 0xAAB4BF }),
             .sequential = viridis(),
             .diverging =
                 ColourMap (rgbList ({ 0xC5E6FA, 0x5FB0E6, 0x24608F, 0x171B21, 0x944028, 0xEC8A63, 0xFBDCCB })) };
}
} // namespace

const Theme& Theme::light()
{
    static const auto theme = makeLight();
    return theme;
}

const Theme& Theme::dark()
{
    static const auto theme = makeDark();
    return theme;
}

const Theme& Theme::print()
{
    static const auto theme = []
    {
        auto made = makeLight();
        made.axis = made.text = made.mutedText = juce::Colours::black;
        made.grid = rgb (0xD0D0D0);
        made.titleHeight = made.labelHeight;
        made.boldTitle = false;
        made.lineWidth = 1.2f;
        made.padding = 4;
        return made;
    }();
    return theme;
}

Theme compact (Theme theme)
{
    theme.titleHeight = 13;
    theme.boldTitle = false;
    theme.labelHeight = 13;
    theme.tickHeight = 11;
    theme.lineWidth = 1.3f;
    theme.padding = 3;
    return theme;
}

juce::Colour seriesColour (const Theme& theme, int colour, std::size_t order)
{
    if (colour == series_colour::neutral)
        return theme.text;
    const auto index = colour < 0 ? order : static_cast<std::size_t> (colour);
    return theme.series[index % theme.series.size()];
}
} // namespace antinode
