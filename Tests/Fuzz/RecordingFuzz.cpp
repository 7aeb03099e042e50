#include "Fuzz.h"

#include <antinode_responses/HammerMeasurement.h>

/** Recordings of a hammer test: each file is read, those of a moderate length are evaluated. */
void antinode::test::fuzz (std::string_view bytes)
{
    constexpr Eigen::Index most = 4096;
    const auto file = decodeRecordings (bytes, "file", {});

    for (const auto& recording : file.recordings)
    {
        require (! recording.signals.empty());

        for (const auto& signal : recording.signals)
        {
            require (signal.samples.size() == recording.signals.front().samples.size());

            if (signal.samples.size() > most)
                return;
        }
    }

    const auto measurement = measureByHammer ({ file }, {});
    validate (measurement.responses);
    require (! hammerSets (measurement).empty());
}
