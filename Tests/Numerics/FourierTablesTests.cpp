#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Tables that are kept give the same transforms to the bit, whatever lengths came before", "[numerics]")
{
    FourierTables tables;
    RandomNumbers random (3);

    for (const auto length : { 96, 1000, 96, 360, 1000 })
    {
        const auto signal = random.normal (length);
        const auto spectrum = forwardFourier (signal);
        CHECK (tables.forward (signal) == spectrum);
        CHECK (tables.forward (signal, 2 * length) == forwardFourier (signal, 2 * length));
        CHECK (tables.inverse (spectrum, length) == inverseFourier (spectrum, length));
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
