#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <complex>
#include <numbers>

using namespace antinode;

TEST_CASE ("Tables that are kept give the same transforms to the bit, whatever lengths came before", "[numerics]")
{
    FourierTables tables;
    RandomNumbers random (3);

    for (const auto length : { 96, 1000, 96, 360, 1000, 1009, 96, 1009 })
    {
        const auto signal = random.normal (length);
        const auto spectrum = forwardFourier (signal);
        CHECK (tables.forward (signal) == spectrum);
        CHECK (tables.forward (signal, 2 * length) == forwardFourier (signal, 2 * length));
        CHECK (tables.inverse (spectrum, length) == inverseFourier (spectrum, length));
    }
}

TEST_CASE ("Lines are those of the sum that defines them, also of lengths with large prime factors", "[numerics]")
{
    FourierTables tables;
    RandomNumbers random (5);

    for (const Eigen::Index length : { 1, 2, 97, 101, 202, 505, 720, 1009, 3 * 1013 })
    {
        CAPTURE (length);
        const auto signal = random.normal (length);
        Eigen::VectorXcd lines = Eigen::VectorXcd::Zero (length / 2 + 1);

        for (Eigen::Index k = 0; k < lines.size(); ++k)
            for (Eigen::Index n = 0; n < length; ++n)
                lines[k] += signal[n]
                            * std::polar (1.0, -2 * std::numbers::pi * static_cast<double> (k * n % length)
                                                   / static_cast<double> (length));

        // Rounding: some 1e-15 a step of the largest line.
        CHECK ((tables.forward (signal) - lines).norm() <= 1e-14 * lines.norm() + 1e-14);
    }
}

TEST_CASE ("Skipped normal numbers are those that would have been drawn, for even and odd counts", "[numerics]")
{
    for (const auto count : { 10, 11 })
    {
        RandomNumbers drawn (7), skipped (7);

        for (int call = 0; call < 3; ++call)
            drawn.normal (count);

        skipped.skipNormal (count, 3);
        CHECK (drawn.normal (count) == skipped.normal (count));
    }
}
