#include "OutputRouter.h"

#include <antinode_audio/IdentifyTone.h>
#include <antinode_base/InputError.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace antinode
{
namespace
{
bool isMonitorOutput (const OutputRouting& routing, int output)
{
    return routing.monitor != OutputRouting::none && output >= routing.monitor
           && output < routing.monitor + OutputRouting::monitors;
}

void validateMarker (const SyncMarker& marker)
{
    if (! (marker.level >= 0 && marker.level <= 1))
        throw InputError ("sync marker", "has a level of " + std::to_string (marker.level) + "; allowed: 0 to 1");

    if (! (marker.seconds > 0 && marker.seconds <= 1))
        throw InputError ("sync marker",
                          "lasts " + std::to_string (marker.seconds * 1000) + " ms; allowed: above 0 to 1000 ms");
}

void validateChains (const OutputRouting& routing)
{
    for (std::size_t i = 0; i < routing.chains.size(); ++i)
    {
        const auto& chain = routing.chains[i];
        const auto name = "output " + std::to_string (i + 1);

        if (! (chain.voltsPerFullScale >= 0 && std::isfinite (chain.voltsPerFullScale)))
            throw InputError (name, "has negative or invalid volts per full scale; allowed: 0 V or more");

        if (chain.polarity != 1 && chain.polarity != -1)
            throw InputError (name, "polarity is " + std::to_string (chain.polarity) + "; allowed: 1 or -1");
    }
}
} // namespace

OutputRouting straightRouting()
{
    OutputRouting routing;
    std::iota (routing.outputs.begin(), routing.outputs.end(), 0);
    return routing;
}

OutputRouting withOutput (OutputRouting routing, int ceramic, int output)
{
    if (output != OutputRouting::none)
        for (auto& other : routing.outputs)
            if (other == output)
                other = OutputRouting::none;

    if (isMonitorOutput (routing, output))
        routing.monitor = OutputRouting::none;

    if (output == routing.marker.output)
        routing.marker.output = OutputRouting::none;

    routing.outputs[static_cast<std::size_t> (ceramic)] = output;
    return routing;
}

OutputRouting withMonitor (OutputRouting routing, int firstOutput)
{
    routing.monitor = firstOutput;

    for (auto& output : routing.outputs)
        if (isMonitorOutput (routing, output))
            output = OutputRouting::none;

    if (isMonitorOutput (routing, routing.marker.output))
        routing.marker.output = OutputRouting::none;

    return routing;
}

OutputRouting withMarker (OutputRouting routing, const SyncMarker& marker)
{
    routing.marker = marker;

    if (marker.output == OutputRouting::none)
        return routing;

    std::replace (routing.outputs.begin(), routing.outputs.end(), marker.output, OutputRouting::none);

    if (isMonitorOutput (routing, marker.output))
        routing.monitor = OutputRouting::none;

    return routing;
}

std::vector<double> amplifierVoltages (const OutputRouting& routing)
{
    std::vector<double> volts;

    for (const auto output : routing.outputs)
        volts.push_back (
            output == OutputRouting::none ? 0 : routing.chains[static_cast<std::size_t> (output)].voltsPerFullScale);

    return volts;
}

void validate (const OutputRouting& routing)
{
    std::vector<std::string> users (OutputRouting::maximumOutputs);
    const auto use = [&] (int output, const std::string& user)
    {
        if (output < 0 || output >= OutputRouting::maximumOutputs)
            throw InputError (user, "has output " + std::to_string (output + 1) + "; allowed: 1 to "
                                        + std::to_string (OutputRouting::maximumOutputs));

        auto& other = users[static_cast<std::size_t> (output)];

        if (! other.empty())
            throw InputError (user, "has output " + std::to_string (output + 1) + ", which " + other + " uses already");

        other = user;
    };

    for (std::size_t k = 0; k < routing.outputs.size(); ++k)
        if (routing.outputs[k] != OutputRouting::none)
            use (routing.outputs[k], "ceramic " + std::to_string (k + 1));

    if (routing.monitor != OutputRouting::none)
        for (int i = 0; i < OutputRouting::monitors; ++i)
            use (routing.monitor + i, "monitor " + std::to_string (i + 1));

    if (routing.marker.output != OutputRouting::none)
        use (routing.marker.output, "sync marker");

    validateMarker (routing.marker);
    validateChains (routing);
}

namespace
{
/** The index of the first sample of any channel that is not finite, from an offset on, or `count`. */
int firstBadSample (std::span<const float* const> channels, int offset, int count)
{
    for (const auto* const channel : channels)
        for (int n = 0; n < count; ++n)
            if (! std::isfinite (channel[offset + n]))
                count = n;

    return count;
}

/** Copies samples clamped to what an output can play: finite, and within full scale. @param clamped  grows by those
    that were beyond it */
void copyWithin (const float* from, float* to, int count, double factor, std::int64_t& clamped)
{
    for (int n = 0; n < count; ++n)
    {
        // In single precision the product of a limit could come out beyond full scale.
        const auto value = static_cast<float> (static_cast<double> (from[n]) * factor);
        const auto allowed = std::isfinite (value) ? std::clamp (value, -1.0F, 1.0F) : 0.0F;
        clamped += static_cast<int> (std::abs (value) > 1.0F);
        to[n] = allowed;
    }
}

/** The largest magnitude. */
float absolutePeak (const float* samples, int count)
{
    float peak = 0;

    for (int n = 0; n < count; ++n)
        peak = std::max (peak, std::abs (samples[n]));

    return peak;
}
} // namespace

/** A routing as the audio thread wants it: what each output gives. */
struct OutputRouter::Table
{
    OutputRouting routing;
    std::array<int, OutputRouting::maximumOutputs> ceramics {};   ///< Of each output, or none.
    std::array<double, OutputRouting::maximumCeramics> limits {}; ///< V
};

/** Some samples of a block in which nothing begins or ends. */
struct OutputRouter::Part
{
    int offset = 0, count = 0;
};

OutputRouter::OutputRouter()
{
    setRouting (straightRouting(), {});
    takeTable();
}

OutputRouter::~OutputRouter()
{
    delete next.load();
    delete retired.load();
}

void OutputRouter::prepare (double sampleRate)
{
    rate = sampleRate;
    rampSamples = std::max<std::int64_t> (1, std::llround (rampTime * rate));
    takeTable();
    source = foci;
    isOnLeave = false;
    sourceLeft = 0;
    sourceRamp = SafetyRamp (1);
    isMuting = wantsMute;
    muteRamp = SafetyRamp (isMuting ? 0 : 1);
    silent = isMuting;
}

void OutputRouter::setRouting (const OutputRouting& routing, const std::vector<double>& limits)
{
    validate (routing);
    auto made = std::make_unique<Table>();
    made->routing = routing;
    made->ceramics.fill (OutputRouting::none);
    std::copy_n (limits.begin(), std::min (limits.size(), made->limits.size()), made->limits.begin());

    for (std::size_t k = 0; k < routing.outputs.size(); ++k)
        if (routing.outputs[k] != OutputRouting::none)
            made->ceramics[static_cast<std::size_t> (routing.outputs[k])] = static_cast<int> (k);

    delete next.exchange (made.release(), std::memory_order_acq_rel);
    collect();
}

void OutputRouter::collect()
{
    delete retired.exchange (nullptr, std::memory_order_acq_rel);
}

/** Whether a new table waits, and there is room for the old one. */
bool OutputRouter::hasTable() const
{
    return next.load (std::memory_order_acquire) != nullptr && retired.load (std::memory_order_acquire) == nullptr;
}

void OutputRouter::takeTable()
{
    if (! hasTable())
        return;

    retired.store (table.release(), std::memory_order_release);
    table.reset (next.exchange (nullptr, std::memory_order_acq_rel));
}

/** Requests of other threads; read once per block, so that a block is consistent. */
void OutputRouter::takeCommands (bool isArmed)
{
    if (const auto wanted = wantsMute.load(); wanted != isMuting)
    {
        isMuting = wanted;
        muteRamp.setTarget (isMuting ? 0 : 1, rampSamples);
    }

    const auto asked = wantedTone.load();
    const auto isTone = asked >= 0 && asked < OutputRouting::maximumCeramics;
    blockSource = ! isArmed ? foci : wantsMeasurement ? measurement : isTone ? asked : foci;
    hasNewTable = hasTable();
}

/** Between foci, tone and measurement, and between routings, there are 0 V. */
void OutputRouter::changeSource()
{
    if (sourceLeft > 0)
        return;

    if (isOnLeave)
    {
        takeTable();
        hasNewTable = false;
        stays += source == measurement ? 1 : 0;
        source = blockSource;
        toneSample = 0;
    }
    else if (source == blockSource && ! hasNewTable)
    {
        return;
    }

    isOnLeave = ! isOnLeave;
    sourceRamp.setTarget (isOnLeave ? 0 : 1, rampSamples);
    sourceLeft = rampSamples;
}

std::int64_t OutputRouter::markerSamples() const
{
    const auto& marker = table->routing.marker;
    return marker.output == OutputRouting::none ? 0 : std::max<std::int64_t> (1, std::llround (marker.seconds * rate));
}

void OutputRouter::latchMute()
{
    wantsMute = true;
    isMuting = true;
    muteRamp.setTarget (0, rampSamples);
}

void OutputRouter::process (const RouterBlock& block)
{
    takeCommands (block.isArmed);
    auto hasBadNumber = false;

    for (int offset = 0; offset < block.count;)
    {
        changeSource();
        auto count = block.count - offset;

        if (sourceLeft > 0)
            count = static_cast<int> (std::min<std::int64_t> (count, sourceLeft));

        const auto good = firstBadSample (block.ceramics, offset, count);
        hasBadNumber = hasBadNumber || good < count;

        if (! isMuting && good == 0)
            latchMute();

        if (! isMuting)
            count = good;

        processPart (block, { offset, count });
        sourceLeft -= std::min<std::int64_t> (sourceLeft, count);
        toneSample += count;
        offset += count;
    }

    if (hasBadNumber)
        outputMeters.noteBadNumber();

    silent = isMuting && ! muteRamp.isMoving();
}

void OutputRouter::processPart (const RouterBlock& block, const Part& part)
{
    std::array<float*, OutputRouting::maximumOutputs> open {};
    std::array<int, OutputRouting::maximumOutputs> numbers {};
    const auto outputs = std::min (block.outputs.size(), open.size());
    int opened = 0;

    for (std::size_t i = 0; i < outputs; ++i)
    {
        if (block.outputs[i] == nullptr)
            continue;

        auto* const to = block.outputs[i] + part.offset;
        fillCeramic (block, part, static_cast<int> (i), to);
        open[static_cast<std::size_t> (opened)] = to;
        numbers[static_cast<std::size_t> (opened++)] = static_cast<int> (i);
    }

    sourceRamp.process (open.data(), opened, part.count);
    muteRamp.process (open.data(), opened, part.count);

    for (std::size_t i = 0; i < static_cast<std::size_t> (opened); ++i)
        outputMeters.note (numbers[i], absolutePeak (open[i], part.count), 0);
}

/** What an output gives before the ramps. */
void OutputRouter::fillCeramic (const RouterBlock& block, const Part& part, int output, float* to)
{
    const auto index = static_cast<std::size_t> (output);
    const auto& routing = table->routing;
    const auto ceramic = table->ceramics[index];
    const auto monitor = routing.monitor == OutputRouting::none ? OutputRouting::none : output - routing.monitor;
    std::fill_n (to, part.count, 0.0F);

    if (source != foci && source != measurement)
    {
        if (source == ceramic)
            fillTone (block, part, output, to);

        return;
    }

    if (block.stay != (source == measurement ? stays : noStay))
        return;

    const auto& chain = routing.chains[index];
    const auto gain = chain.voltsPerFullScale > 0 ? block.fullScaleVolts / chain.voltsPerFullScale : 1.0;
    std::int64_t clamped = 0;

    if (ceramic != OutputRouting::none && static_cast<std::size_t> (ceramic) < block.ceramics.size())
        copyWithin (block.ceramics[static_cast<std::size_t> (ceramic)] + part.offset, to, part.count,
                    gain * chain.polarity, clamped);
    else if (monitor >= 0 && static_cast<std::size_t> (monitor) < block.monitor.size())
        copyWithin (block.monitor[static_cast<std::size_t> (monitor)] + part.offset, to, part.count, 1, clamped);
    else if (output == routing.marker.output && block.marker != nullptr && block.isArmed)
        copyWithin (block.marker + part.offset, to, part.count, routing.marker.level, clamped);

    outputMeters.note (output, 0, clamped);
}

void OutputRouter::fillTone (const RouterBlock& block, const Part& part, int output, float* to) const
{
    const auto& chain = table->routing.chains[static_cast<std::size_t> (output)];
    const auto fullScale = chain.voltsPerFullScale > 0 ? chain.voltsPerFullScale : block.fullScaleVolts;

    if (! (fullScale > 0))
        return;

    const auto volts = IdentifyTone::amplitude (table->limits[static_cast<std::size_t> (source)]);
    const auto amplitude = std::min (1.0, volts / fullScale) * chain.polarity;

    for (int n = 0; n < part.count; ++n)
        to[n] = static_cast<float> (amplitude * IdentifyTone::at (toneSample + n, rate));
}
} // namespace antinode
