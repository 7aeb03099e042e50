#include "HostBench.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace antinode
{
namespace
{
TakeLayout layoutFor (const ModalModel& model, const BenchSensor& sensor, bool hasSync)
{
    TakeLayout layout;
    layout.ceramics.resize (static_cast<std::size_t> (model.actuators()));
    std::iota (layout.ceramics.begin(), layout.ceramics.end(), Eigen::Index { 0 });
    layout.sensors = { 0 };
    layout.fullScale = model.fullScaleVoltage;
    layout.velocity = sensor.scale.fullScaleVelocity();
    layout.syncOutput = model.actuators();
    layout.syncInput = hasSync && sensor.syncInput >= 0 ? 1 : -1;
    return layout;
}
} // namespace

void BenchDevice::close()
{
    const std::lock_guard lock (mutex);

    if (host != nullptr)
        host->router().measure (false);

    host = nullptr;
}

void BenchDevice::allow()
{
    const std::lock_guard lock (mutex);
    stops = host->stopCommands();
}

std::int64_t BenchDevice::samplesPlayed() const
{
    const std::lock_guard lock (mutex);
    return host != nullptr ? host->callback().samplesPlayed() : 0;
}

double BenchDevice::sampleRate() const
{
    const std::lock_guard lock (mutex);
    return host != nullptr ? host->callback().sampleRate() : 0;
}

int BenchDevice::lostBlocks() const
{
    const std::lock_guard lock (mutex);
    return host != nullptr ? host->callback().lostBlocks() : 0;
}

std::string BenchDevice::obstacle() const
{
    const std::lock_guard lock (mutex);

    if (host == nullptr || ! (host->callback().sampleRate() > 0))
        return "no audio device is open; choose one in Settings, Audio device";

    if (host->router().isMuted())
        return "the outputs are muted; release them, then go on";

    if (! host->arm().get())
        return "the program is not armed; press ARM, then go on";

    return host->stopCommands() == stops ? "" : "the measurement was stopped; go on where it was";
}

void BenchDevice::play (std::shared_ptr<Take> take, int ceramics, double fullScaleVolts,
                        const std::array<int, 2>& inputs)
{
    const std::lock_guard lock (mutex);

    if (host == nullptr)
        return;

    host->router().measure (true);
    host->callback().playTake (std::move (take), stops, ceramics, fullScaleVolts, inputs);
}

void BenchDevice::stop()
{
    const std::lock_guard lock (mutex);

    if (host != nullptr)
        host->callback().stopTake();
}

void BenchDevice::release()
{
    const std::lock_guard lock (mutex);

    if (host != nullptr)
        host->router().measure (false);
}

HostBench::HostBench (std::shared_ptr<BenchDevice> deviceToUse, const BenchSensor& sensorToUse, bool hasSync,
                      const ModalModel& model)
    : TakeBench (layoutFor (model, sensorToUse, hasSync)), device (std::move (deviceToUse)), sensor (sensorToUse)
{
    if (! (device->sampleRate() > 0))
        throw InputError ("", device->obstacle());

    if (! (sensor.scale.sensitivity > 0))
        throw InputError ("sensitivity", "is missing; enter that of the sensor, mm/s per V");

    if (hasSync && sensor.syncInput == sensor.input)
        throw InputError ("input " + std::to_string (sensor.input + 1), "has two roles; allowed: one");

    if (model.actuators() > OutputRouting::maximumCeramics)
        throw InputError ("device", "has " + std::to_string (model.actuators())
                                        + " ceramics; allowed: " + std::to_string (OutputRouting::maximumCeramics));
}

void HostBench::begin (std::shared_ptr<Take> take)
{
    if (const auto obstacle = device->obstacle(); ! obstacle.empty())
        throw InputError ("", obstacle);

    device->play (std::move (take), static_cast<int> (layout.ceramics.size()), layout.fullScale,
                  { sensor.input, layout.syncInput >= 0 ? sensor.syncInput : -1 });
}

std::string HostBench::whyEnded() const
{
    const auto obstacle = device->obstacle();
    return obstacle.empty() ? "was stopped; go on where it was" : obstacle;
}

OutputRouting withRightWires (OutputRouting routing, const std::vector<WireFinding>& findings)
{
    std::vector<int> freed;
    std::vector<std::size_t> left;
    auto right = routing.outputs;

    for (const auto& found : findings)
    {
        const auto output = static_cast<std::size_t> (found.output);

        if (found.kind == WireFinding::Kind::reversed && routing.outputs[output] >= 0)
            routing.chains[static_cast<std::size_t> (routing.outputs[output])].polarity *= -1;
    }

    const auto moves = [&] (const WireFinding& found) { return found.kind == WireFinding::Kind::exchanged; };

    // Who loses its output to another one gets what is left over.
    for (const auto& found : findings)
        if (moves (found))
            right[static_cast<std::size_t> (found.ceramic)] = routing.outputs[static_cast<std::size_t> (found.output)];

    const std::set<int> taken (right.begin(), right.end());

    for (const auto output : routing.outputs)
        if (output != OutputRouting::none && taken.count (output) == 0)
            freed.push_back (output);

    for (const auto& found : findings)
        if (moves (found)
            && std::none_of (findings.begin(), findings.end(),
                             [&] (const auto& other) { return moves (other) && other.ceramic == found.output; }))
            left.push_back (static_cast<std::size_t> (found.output));

    for (std::size_t i = 0; i < left.size(); ++i)
        right[left[i]] = i < freed.size() ? freed[i] : OutputRouting::none;

    routing.outputs = right;
    return routing;
}
} // namespace antinode
