#include "Theme.h"

namespace antinode
{
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
