#include "DesignFile.h"
#include "JsonReader.h"
#include "PhysicalRanges.h"
#include "RimUnits.h"
#include "SurfaceReader.h"

namespace antinode
{
namespace
{
constexpr std::size_t maximumOscillations = 100000;
constexpr NumberRange anyNumber { -1e15, 1e15 };
constexpr NumberRange time { -1e4, 1e4 };
constexpr NumberRange frequencyOrConstant { 0, 1e8 };
constexpr NumberRange limit { 0, 1e5 };

Oscillation readOscillation (const JsonValue& value)
{
    const auto object =
        value.object ({ "mode", "start_s", "end_s", "growth_per_s", "frequency_Hz", "angular_frequency_rad_s",
                        "in_phase", "quadrature", "free_decay_per_s", "counter_share" });
    Oscillation oscillation;
    oscillation.mode = object.required ("mode").integer (0, static_cast<int> (ranges::maximumModes) - 1);
    oscillation.start = object.required ("start_s").number (time);
    oscillation.end = object.required ("end_s").number ({ oscillation.start, time.maximum });
    oscillation.growth = object.required ("growth_per_s").number (anyNumber);
    oscillation.angularFrequency = fromHertz (object.required ("frequency_Hz").number (frequencyOrConstant));
    oscillation.inPhase = object.required ("in_phase").number (anyNumber);
    oscillation.quadrature = object.required ("quadrature").number (anyNumber);

    if (const auto exact = object.optional ("angular_frequency_rad_s"))
        oscillation.angularFrequency = refined (oscillation.angularFrequency, *exact);

    if (const auto decay = object.optional ("free_decay_per_s"))
        oscillation.freeDecay = decay->number ({ 0, anyNumber.maximum });

    if (const auto share = object.optional ("counter_share"))
    {
        const auto parts = share->numbers (2, 2, { -1, 1 });
        oscillation.counterShare = { parts[0], parts[1] };

        if (std::norm (oscillation.counterShare) >= 1)
            share->fail ("is 1 or more in magnitude, allowed is less than 1");
    }

    return oscillation;
}
} // namespace

VoltageProgram readProgram (const nlohmann::json& document, const std::string& source)
{
    const JsonValue value (document, source);
    value.requireSchema ("antinode.design/1");
    VoltageProgram program;
    program.focusTime = value.required ("focus_time_s").number (time);

    for (const auto& item : value.required ("oscillations").items (0, maximumOscillations))
        program.oscillations.push_back (readOscillation (item));

    const auto limits = value.required ("voltage_limits_V").numbers (0, ranges::maximumCeramics, limit);
    const auto rows = value.required ("allocation").items (limits.size(), limits.size());
    const auto columns = program.oscillations.size();
    program.voltageLimits =
        Eigen::Map<const Eigen::VectorXd> (limits.data(), static_cast<Eigen::Index> (limits.size()));
    program.allocation.resize (program.voltageLimits.size(), static_cast<Eigen::Index> (columns));

    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const auto row = rows[i].numbers (columns, columns, anyNumber);
        program.allocation.row (static_cast<Eigen::Index> (i)) =
            Eigen::Map<const Eigen::RowVectorXd> (row.data(), program.allocation.cols());
    }

    return program;
}
} // namespace antinode
