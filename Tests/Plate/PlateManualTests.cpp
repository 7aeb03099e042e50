#include <Plate/PlateProcessor.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

using namespace antinode;

namespace
{
/** The row of the manual's table that a parameter must have, as far as it follows from the parameter; probes 2 to 8
    share one. */
std::string manualRow (const juce::RangedAudioParameter& parameter)
{
    const auto& range = parameter.getNormalisableRange();
    std::ostringstream row;
    row << "| `" << parameter.getParameterID() << "` | " << parameter.getName (100) << " | " << range.start << " to "
        << range.end << " | ";

    // The first value of a place depends on the device; in the table it is a percentage.
    if (! parameter.getParameterID().startsWith ("probe"))
        row << parameter.getText (parameter.getDefaultValue(), 100);

    return row.str();
}
} // namespace

TEST_CASE ("The manual lists every parameter of the plate with its name, range and first value", "[plate][manual]")
{
    std::ifstream stream (ANTINODE_MANUAL "/plate-plugin.md");
    const std::string page { std::istreambuf_iterator<char> (stream), {} };
    const PlateProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);

    for (const auto* const any : processor.getParameters())
    {
        const auto& parameter = *dynamic_cast<const juce::RangedAudioParameter*> (any);
        const auto identifier = parameter.getParameterID();

        if (! identifier.startsWith ("probe") || identifier.startsWith ("probe1"))
            CHECK_THAT (page, Catch::Contains (manualRow (parameter)));
        else
            CHECK_THAT (page, Catch::Contains ("`probe2_x` to `probe8_y`"));
    }
}
