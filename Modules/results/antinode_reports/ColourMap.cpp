#include "ColourMap.h"

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
} // namespace antinode
