#include "Palette.h"

namespace antinode
{
namespace
{
juce::Colour rgb (juce::uint32 value)
{
    return juce::Colour (0xFF000000U | value);
}

Palette fromCharts (const Theme& charts)
{
    Palette palette {
        compact (charts), {}, charts.background, {}, {}, charts.text, charts.mutedText, {}, {}, {}, {}, {}, {}
    };
    palette.charts.padding = 8;
    palette.charts.labelHeight = 12;
    palette.warning = charts.limit;
    return palette;
}

Palette makeDark()
{
    auto palette = fromCharts (Theme::dark());
    palette.window = rgb (0x0C0F13);
    palette.raised = rgb (0x212831);
    palette.outline = rgb (0x2F3843);
    palette.accent = rgb (0x56B4E9);
    palette.fire = rgb (0xF5853F);
    palette.armed = rgb (0x2FC19A);
    palette.caution = rgb (0xE8B33B);
    palette.onStrong = rgb (0x0C0F13);
    return palette;
}

Palette makeLight()
{
    auto palette = fromCharts (Theme::light());
    palette.window = rgb (0xE3E8ED);
    palette.raised = rgb (0xEEF1F5);
    palette.outline = rgb (0xC6CED7);
    palette.accent = rgb (0x0072B2);
    palette.fire = rgb (0xB94F00);
    palette.armed = rgb (0x00795A);
    palette.caution = rgb (0x855E00);
    palette.onStrong = rgb (0xFFFFFF);
    palette.isDark = false;
    return palette;
}
} // namespace

const Palette& Palette::dark()
{
    static const auto palette = makeDark();
    return palette;
}

const Palette& Palette::light()
{
    static const auto palette = makeLight();
    return palette;
}
} // namespace antinode
