#include <antinode_reports/Theme.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace antinode;

namespace
{
/** Of red, green and blue, linear: IEC 61966-2-1. */
std::array<double, 3> linear (juce::Colour colour)
{
    const auto part = [] (juce::uint8 byte)
    {
        const auto value = byte / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow ((value + 0.055) / 1.055, 2.4);
    };
    return { part (colour.getRed()), part (colour.getGreen()), part (colour.getBlue()) };
}

/** Lightness as seen, 0 black to 1 white: Oklab's L (B. Ottosson, "A perceptual color space for image processing",
    2020). */
double perceivedLightness (juce::Colour colour)
{
    const auto [r, g, b] = linear (colour);
    return 0.2104542553 * std::cbrt (0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b)
           + 0.7936177850 * std::cbrt (0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b)
           - 0.0040720468 * std::cbrt (0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

/** WCAG 2.1 contrast ratio of two opaque colours, 1 to 21. */
double contrastRatio (juce::Colour one, juce::Colour other)
{
    const auto luminance = [] (juce::Colour colour)
    {
        const auto [r, g, b] = linear (colour);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const auto ratio = (luminance (one) + 0.05) / (luminance (other) + 0.05);
    return std::max (ratio, 1 / ratio);
}
} // namespace

TEST_CASE ("Oklab's lightness is 0 for black and 1 for white")
{
    CHECK (perceivedLightness (juce::Colours::black) == Approx (0).margin (1e-9));
    CHECK (perceivedLightness (juce::Colours::white) == Approx (1).margin (1e-6));
    // Oklab of pure sRGB red: L = 0.62796 (B. Ottosson's reference implementation).
    CHECK (perceivedLightness (juce::Colour (255, 0, 0)) == Approx (0.62796).epsilon (1e-4));
}

TEST_CASE ("Black on white has WCAG's largest contrast, 21")
{
    CHECK (contrastRatio (juce::Colours::black, juce::Colours::white) == Approx (21));
}

TEST_CASE ("Series stand out from the background by 3 to 1 and text by 4.5 to 1, as WCAG 2.1 asks")
{
    for (const auto* theme : { &Theme::light(), &Theme::dark() })
    {
        for (const auto colour : theme->series)
            CHECK (contrastRatio (colour, theme->background) >= 3);
        for (const auto colour : { theme->text, theme->mutedText, theme->limit })
            CHECK (contrastRatio (colour, theme->background) >= 4.5);
    }
}

TEST_CASE ("The sequential map grows lighter by nearly equal steps")
{
    const auto& map = Theme::light().sequential;
    constexpr int steps = 8;
    const auto whole = perceivedLightness (map.at (1)) - perceivedLightness (map.at (0));
    for (int k = 0; k < steps; ++k)
    {
        const auto step =
            perceivedLightness (map.at ((k + 1.0) / steps)) - perceivedLightness (map.at (1.0 * k / steps));
        CHECK (step == Approx (whole / steps).epsilon (0.35));
    }
}

TEST_CASE ("The diverging maps are neutral in the middle and equally light on both sides")
{
    for (const auto* theme : { &Theme::light(), &Theme::dark() })
    {
        CHECK (contrastRatio (theme->diverging.at (0.5), theme->background) < 1.15);
        for (const auto offset : { 0.1, 0.2, 0.3, 0.4, 0.5 })
        {
            const auto below = perceivedLightness (theme->diverging.at (0.5 - offset));
            const auto above = perceivedLightness (theme->diverging.at (0.5 + offset));
            CHECK (below == Approx (above).margin (0.06));
        }
    }
}

TEST_CASE ("A colour map gives its ends for all that lies outside")
{
    const auto& map = Theme::dark().sequential;
    CHECK (map.at (-3) == map.at (0));
    CHECK (map.at (7) == map.at (1));
    CHECK (map.at (NAN) == map.at (0));
}
