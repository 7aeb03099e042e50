#include "Support/ErrorText.h"

#include <antinode_text/TfwFile.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace antinode;

namespace
{
unsigned long number (const std::string& bytes, std::size_t position, std::size_t count)
{
    unsigned long value = 0;

    for (std::size_t i = 0; i < count; ++i)
        value = value << 8 | static_cast<unsigned char> (bytes.at (position + i));

    return value;
}
} // namespace

TEST_CASE ("A TFW file has its header of 512 bytes and big-endian codes from 0 to 16382", "[files]")
{
    const auto file = encodeTfw (Eigen::Vector4d (-10, 30, 10, 0), 1e6);
    REQUIRE (file.bytes.size() == 512 + 8);
    CHECK (file.bytes.substr (0, 16) == std::string ("TEKAFG3000\0\0\0\0\0\0", 16));
    CHECK (number (file.bytes, 16, 4) == 20050114);
    CHECK (number (file.bytes, 20, 4) == 4);
    CHECK (number (file.bytes, 24, 4) == 0);
    CHECK (file.bytes.substr (28, 484) == std::string (484, '\0'));
    CHECK (number (file.bytes, 512, 2) == 0);
    CHECK (number (file.bytes, 514, 2) == 16382);
    CHECK (number (file.bytes, 516, 2) == 8191);
    CHECK (number (file.bytes, 518, 2) == 4096); // 16382 / 4 = 4095.5
    CHECK (file.highVoltage == 30);
    CHECK (file.lowVoltage == -10);
    CHECK (file.amplitudePeakToPeak == 40);
    CHECK (file.offset == 10);
    CHECK (file.period == 4e-6);
}

TEST_CASE ("A TFW file gives its samples back within half a step", "[files]")
{
    const Eigen::VectorXd samples = Eigen::VectorXd::LinSpaced (65536, 0, 40).array().sin() * 12.5 + 3;
    const auto file = encodeTfw (samples, 2.5e8);
    REQUIRE (file.bytes.size() == 512 + 2 * 65536);
    const auto step = (file.highVoltage - file.lowVoltage) / 16382;
    double largest = 0;

    for (Eigen::Index n = 0; n < samples.size(); ++n)
    {
        const auto code = static_cast<double> (number (file.bytes, 512 + 2 * static_cast<std::size_t> (n), 2));
        largest = std::max (largest, std::abs (file.lowVoltage + step * code - samples[n]));
    }

    CHECK (largest <= 0.500001 * step);
}

TEST_CASE ("A constant lies in the middle of a TFW file's range", "[files]")
{
    const auto file = encodeTfw (Eigen::Vector2d (7, 7), 1000);
    CHECK (number (file.bytes, 512, 2) == 8191);
    CHECK (file.amplitudePeakToPeak == 0);
    CHECK (file.offset == 7);
}

TEST_CASE ("TFW files that cannot be are refused", "[files]")
{
    CHECK (errorText ([] { encodeTfw (Eigen::VectorXd::Zero (1), 1e6); }) == "TFW: has 1 samples; allowed: 2 to 65536");
    CHECK (errorText ([] { encodeTfw (Eigen::VectorXd::Zero (65537), 1e6); })
           == "TFW: has 65537 samples; allowed: 2 to 65536");
    CHECK (errorText ([] { encodeTfw (Eigen::Vector2d (0, 1), 0); })
           == "TFW: has a sample rate of 0 Hz; allowed: above 0 Hz");

    for (const auto wrong : { std::nan (""), std::numeric_limits<double>::infinity() })
        CHECK (errorText ([=] { encodeTfw (Eigen::Vector3d (0, wrong, 1), 1e6); })
               == "TFW: has a value that is not finite");

    CHECK_FALSE (errorText ([] { encodeTfw (Eigen::Vector2d (-1e308, 1e308), 1e6); }).empty());
}
