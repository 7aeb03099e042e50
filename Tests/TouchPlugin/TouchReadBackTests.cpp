#include <Touch/TouchProcessor.h>

#include <Support/ReadBack.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("What a host reads of Antinode Touch's parameters is what it gets back, to the bit", "[touch-plugin]")
{
    test::requireReadBack<TouchProcessor> (
        [] { return std::make_unique<TouchProcessor> (2, juce::AudioProcessor::wrapperType_Undefined); });
}
