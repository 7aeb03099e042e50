#include <Plate/PlateProcessor.h>

#include <Support/ReadBack.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("What a host reads of Antinode Plate's parameters is what it gets back, to the bit", "[plate]")
{
    test::requireReadBack<PlateProcessor> (
        [] { return std::make_unique<PlateProcessor> (2, juce::AudioProcessor::wrapperType_Undefined); });
}
