#include "Fuzz.h"

#include <antinode_documents/HapticContent.h>

#include <nlohmann/json.hpp>

#include <cmath>

/** Haptic content of any kind. */
void antinode::test::fuzz (std::string_view bytes)
{
    const auto document = waveformsDocument (bytes, "file");

    if (! document.is_object() || ! document.contains ("warnings") || document.contains ("name"))
        return;

    for (const auto& event : document["tracks"][0]["events"])
    {
        const auto& signal = event["signal"];
        require (event["amplitude"] > 0 && event["start_ms"] >= 0);
        double before = -1;

        if (signal["kind"] == "vibration")
            for (const auto& point : signal["points"])
            {
                require (point[0] > before && point[2] >= 1);
                before = point[0];
            }
        else
            for (const auto& value : signal["values"])
                require (std::isfinite (value.get<double>()));
    }
}
