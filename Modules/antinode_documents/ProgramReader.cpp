#include "DesignFile.h"
#include "FileUnits.h"
#include "SurfaceReader.h"

#include <antinode_base/WordList.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/PhysicalRanges.h>

namespace antinode
{
namespace
{
constexpr std::size_t maximumOscillations = 100000;
constexpr NumberRange anyStoredNumber { -1e15, 1e15 };
constexpr NumberRange time { -1e4, 1e4 };
constexpr NumberRange frequencyOrConstant { 0, 1e8 };
constexpr std::size_t maximumSamples = 10000000;
constexpr NumberRange sampleRate { 8000, 2e6 };
constexpr WordList<Reconstruction, 2> reconstructionWords { { { "band_limited", Reconstruction::bandLimited },
                                                              { "zero_order_hold", Reconstruction::zeroOrderHold } } };
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
    oscillation.growth = object.required ("growth_per_s").number (anyStoredNumber);
    oscillation.angularFrequency = fromHertz (object.required ("frequency_Hz").number (frequencyOrConstant));
    oscillation.inPhase = object.required ("in_phase").number (anyStoredNumber);
    oscillation.quadrature = object.required ("quadrature").number (anyStoredNumber);

    if (const auto exact = object.optional ("angular_frequency_rad_s"))
        oscillation.angularFrequency = refined (oscillation.angularFrequency, *exact);

    if (const auto decay = object.optional ("free_decay_per_s"))
        oscillation.freeDecay = decay->number ({ 0, anyStoredNumber.maximum });

    if (const auto share = object.optional ("counter_share"))
    {
        const auto parts = share->numbers (2, 2, { -1, 1 });
        oscillation.counterShare = { parts[0], parts[1] };

        if (std::norm (oscillation.counterShare) >= 1)
            share->fail ("has a magnitude of 1 or more; allowed: below 1");
    }

    return oscillation;
}
/** A matrix of the size that it is to have, row by row. */
void readRows (const JsonValue& value, Eigen::MatrixXd& matrix)
{
    const auto rows = value.items (static_cast<std::size_t> (matrix.rows()), static_cast<std::size_t> (matrix.rows()));
    const auto columns = static_cast<std::size_t> (matrix.cols());

    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    {
        const auto row = rows[static_cast<std::size_t> (i)].numbers (columns, columns, anyStoredNumber);
        matrix.row (i) = Eigen::Map<const Eigen::RowVectorXd> (row.data(), matrix.cols());
    }
}

SampledVoltages readSamples (const JsonValue& value, std::size_t ceramics)
{
    const auto object = value.object ({ "reconstruction", "sample_rate_Hz", "first_time_s", "voltages_V" });
    SampledVoltages samples;
    samples.playback.reconstruction = object.required ("reconstruction").choice (reconstructionWords);
    samples.playback.sampleRate = object.required ("sample_rate_Hz").number (sampleRate);
    samples.firstTime = object.required ("first_time_s").number (time);
    const auto voltages = object.required ("voltages_V");
    const auto rows = voltages.items (ceramics, ceramics);
    const auto count = rows.empty() ? 0 : rows.front().numbers (0, maximumSamples, anyStoredNumber).size();
    samples.values.resize (static_cast<Eigen::Index> (ceramics), static_cast<Eigen::Index> (count));
    readRows (voltages, samples.values);
    return samples;
}
} // namespace

VoltageProgram readProgram (const nlohmann::json& document, const std::string& source)
{
    const JsonValue value (document, source);
    value.requireSchema ("antinode.design/1");
    VoltageProgram program;
    program.focusTime = value.required ("focus_time_s").number (time);

    const auto samples = value.find ("samples");
    const auto hasOscillations = ! samples || value.find ("oscillations").has_value();

    if (hasOscillations)
        for (const auto& item : value.required ("oscillations").items (0, maximumOscillations))
            program.oscillations.push_back (readOscillation (item));

    const auto limits = value.required ("voltage_limits_V").numbers (0, ranges::maximumCeramics, limit);
    program.voltageLimits =
        Eigen::Map<const Eigen::VectorXd> (limits.data(), static_cast<Eigen::Index> (limits.size()));
    program.allocation.resize (program.voltageLimits.size(), static_cast<Eigen::Index> (program.oscillations.size()));

    if (hasOscillations)
        readRows (value.required ("allocation"), program.allocation);

    if (samples)
        program.samples = readSamples (*samples, limits.size());

    return program;
}
} // namespace antinode
