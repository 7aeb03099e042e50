#include "CompactNumbers.h"

#include <juce_core/juce_core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace antinode
{
namespace
{
static_assert (JUCE_LITTLE_ENDIAN, "pages hold little-endian numbers");

template <typename Value>
std::string encoded (const std::vector<Value>& values)
{
    return juce::Base64::toBase64 (values.data(), values.size() * sizeof (Value)).toStdString();
}

std::uint8_t levelOf (std::complex<double> value, double largest)
{
    constexpr double highest = 254, stepsPerDecade = 40;

    if (! std::isfinite (value.real()) || ! std::isfinite (value.imag()))
        return 255;

    const auto size = std::abs (value);
    const auto level = size > 0 ? highest + stepsPerDecade * std::log10 (size / largest) : 0;
    return static_cast<std::uint8_t> (std::clamp (std::round (level), 0.0, highest));
}

std::uint8_t angleOf (std::complex<double> value)
{
    constexpr double parts = 256;
    const auto angle = std::arg (value);
    const auto turns = std::isfinite (angle) ? angle / (2 * std::numbers::pi) : 0;
    return static_cast<std::uint8_t> (static_cast<int> (std::round (turns * parts)) & 255);
}
} // namespace

std::string compactDoubles (const Eigen::VectorXd& values)
{
    return encoded (std::vector<double> (values.begin(), values.end()));
}

std::string compactFloats (const Eigen::VectorXd& values)
{
    std::vector<float> floats (static_cast<std::size_t> (values.size()));
    std::transform (values.begin(), values.end(), floats.begin(),
                    [] (double value) { return static_cast<float> (value); });
    return encoded (floats);
}

std::string compactBytes (const Eigen::VectorXi& values)
{
    std::vector<std::uint8_t> bytes (static_cast<std::size_t> (values.size()));
    std::transform (values.begin(), values.end(), bytes.begin(),
                    [] (int value) { return static_cast<std::uint8_t> (std::clamp (value, 0, 255)); });
    return encoded (bytes);
}

std::string compactComplex (const Eigen::VectorXcd& values, double largest)
{
    std::vector<std::uint8_t> bytes;

    for (const auto value : values)
    {
        bytes.push_back (levelOf (value, largest));
        bytes.push_back (angleOf (value));
    }

    return encoded (bytes);
}
} // namespace antinode
