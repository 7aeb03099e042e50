#include "PlayedRole.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>
#include <sstream>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A page of the manual that lists parameters of many fingers or probes by the first one's. */
struct ManualPage
{
    const char *name, *numbered, *shared; ///< The row that the others share.
    std::unique_ptr<DeviceProcessor> processor;
};

/** The row of the manual's table that a parameter must have, as far as it follows from the parameter. */
std::string manualRow (const juce::RangedAudioParameter& parameter)
{
    const auto& range = parameter.getNormalisableRange();
    const auto identifier = parameter.getParameterID();
    std::ostringstream row;
    row << "| `" << identifier << "` | " << parameter.getName (100) << " | " << range.start << " to " << range.end
        << " | ";

    // The first value of a place depends on the device; in the table it is a percentage.
    if (! identifier.endsWith ("_x") && ! identifier.endsWith ("_y"))
        row << parameter.getText (parameter.getDefaultValue(), 100);

    return row.str();
}
} // namespace

TEST_CASE ("The manual lists every parameter of Touch and Plate with its name, range and first value", "[role][manual]")
{
    const ManualPage pages[] = {
        { "touch-plugin.md", "finger", "`finger2_x` to `finger8_load`", makeRole<TouchProcessor>() },
        { "plate-plugin.md", "probe", "`probe2_x` to `probe8_y`", makeRole<PlateProcessor>() }
    };

    for (const auto& [name, numbered, shared, processor] : pages)
    {
        std::ifstream stream (std::string (ANTINODE_MANUAL) + "/" + name);
        const std::string page { std::istreambuf_iterator<char> (stream), {} };
        CHECK_THAT (page, Catch::Contains (shared));

        for (const auto* const any : processor->getParameters())
        {
            const auto& parameter = *dynamic_cast<const juce::RangedAudioParameter*> (any);
            const auto identifier = parameter.getParameterID();

            if (! identifier.startsWith (numbered) || identifier.startsWith (juce::String (numbered) + "1"))
                CHECK_THAT (page, Catch::Contains (manualRow (parameter)));
        }
    }
}
