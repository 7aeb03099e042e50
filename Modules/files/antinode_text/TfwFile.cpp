#include "TfwFile.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <cmath>
#include <cstdint>

namespace antinode
{
namespace
{
constexpr Eigen::Index fewestSamples = 2, maximumSamples = 65536;
constexpr std::size_t headerBytes = 512;
constexpr double largestCode = 16382;

template <typename Integer>
void appendBigEndian (std::string& bytes, Integer value)
{
    for (std::size_t i = sizeof (Integer); i-- > 0;)
        bytes += static_cast<char> (value >> (8 * i) & 0xff);
}

std::string header (Eigen::Index samples)
{
    constexpr std::uint32_t version = 20050114, noPreview = 0;
    std::string bytes = "TEKAFG3000";
    bytes.append (6, '\0');
    appendBigEndian (bytes, version);
    appendBigEndian (bytes, static_cast<std::uint32_t> (samples));
    appendBigEndian (bytes, noPreview);
    bytes.resize (headerBytes, '\0');
    return bytes;
}

void validate (const Eigen::VectorXd& samples, double sampleRate)
{
    if (samples.size() < fewestSamples || samples.size() > maximumSamples)
        throw InputError ("TFW", "has " + std::to_string (samples.size()) + " samples; allowed: "
                                     + std::to_string (fewestSamples) + " to " + std::to_string (maximumSamples));

    if (! std::isfinite (samples.maxCoeff() - samples.minCoeff()) || ! samples.allFinite())
        throw InputError ("TFW", "has a value that is not finite");

    if (! (std::isfinite (sampleRate) && sampleRate > 0))
        throw InputError ("TFW", "has a sample rate of " + numberText (sampleRate) + " Hz; allowed: above 0 Hz");
}
} // namespace

TfwFile encodeTfw (const Eigen::VectorXd& samples, double sampleRate)
{
    validate (samples, sampleRate);
    TfwFile file;
    file.highVoltage = samples.maxCoeff();
    file.lowVoltage = samples.minCoeff();
    file.amplitudePeakToPeak = file.highVoltage - file.lowVoltage;
    file.offset = file.lowVoltage + file.amplitudePeakToPeak / 2;
    file.period = static_cast<double> (samples.size()) / sampleRate;
    file.bytes = header (samples.size());

    for (const auto sample : samples)
    {
        // A constant has no amplitude: it lies in the middle, where the offset is.
        const auto level = file.amplitudePeakToPeak > 0 ? (sample - file.lowVoltage) / file.amplitudePeakToPeak : 0.5;
        appendBigEndian (file.bytes, static_cast<std::uint16_t> (std::lround (level * largestCode)));
    }

    return file;
}
} // namespace antinode
