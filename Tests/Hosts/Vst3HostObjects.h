#pragma once

#include "Vst3Headers.h"

#include <atomic>
#include <deque>
#include <utility>
#include <vector>

namespace antinode::test
{
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor" // Interfaces of VST3 have none.

/** An object of the host that lives longer than every use of it: so nobody counts. */
template <typename Interface>
class HostObject : public Interface
{
public:
    tresult PLUGIN_API queryInterface (const Steinberg::TUID identifier, void** object) override
    {
        const auto isOurs = Steinberg::FUnknownPrivate::iidEqual (identifier, Interface::iid)
                            || Steinberg::FUnknownPrivate::iidEqual (identifier, Steinberg::FUnknown::iid);
        *object = isOurs ? static_cast<Interface*> (this) : nullptr;
        return isOurs ? Steinberg::kResultOk : Steinberg::kNoInterface;
    }

    Steinberg::uint32 PLUGIN_API addRef() override { return 1; }
    Steinberg::uint32 PLUGIN_API release() override { return 1; }
};

class EventList : public HostObject<Vst::IEventList>
{
public:
    std::vector<Vst::Event> events;

    Steinberg::int32 PLUGIN_API getEventCount() override { return static_cast<Steinberg::int32> (events.size()); }

    tresult PLUGIN_API getEvent (Steinberg::int32 index, Vst::Event& event) override
    {
        if (index < 0 || index >= getEventCount())
            return Steinberg::kInvalidArgument;

        event = events[static_cast<std::size_t> (index)];
        return Steinberg::kResultOk;
    }

    tresult PLUGIN_API addEvent (Vst::Event& event) override
    {
        events.push_back (event);
        return Steinberg::kResultOk;
    }
};

/** The points of one parameter in a block. */
class ValueQueue final : public HostObject<Vst::IParamValueQueue>
{
public:
    explicit ValueQueue (Vst::ParamID identifier) : parameter (identifier) {}

    Vst::ParamID PLUGIN_API getParameterId() override { return parameter; }
    Steinberg::int32 PLUGIN_API getPointCount() override { return static_cast<Steinberg::int32> (points.size()); }

    tresult PLUGIN_API getPoint (Steinberg::int32 index, Steinberg::int32& offset, Vst::ParamValue& value) override
    {
        if (index < 0 || index >= getPointCount())
            return Steinberg::kInvalidArgument;

        std::tie (offset, value) = points[static_cast<std::size_t> (index)];
        return Steinberg::kResultOk;
    }

    tresult PLUGIN_API addPoint (Steinberg::int32 offset, Vst::ParamValue value, Steinberg::int32& index) override
    {
        index = getPointCount();
        points.emplace_back (offset, value);
        return Steinberg::kResultOk;
    }

private:
    Vst::ParamID parameter;
    std::vector<std::pair<Steinberg::int32, double>> points;
};

class ParameterChanges : public HostObject<Vst::IParameterChanges>
{
public:
    /** Adds a point of a parameter. */
    void add (Vst::ParamID parameter, int offset, double value)
    {
        Steinberg::int32 index = 0;
        addParameterData (parameter, index)->addPoint (offset, value, index);
    }

    Steinberg::int32 PLUGIN_API getParameterCount() override { return static_cast<Steinberg::int32> (queues.size()); }

    Vst::IParamValueQueue* PLUGIN_API getParameterData (Steinberg::int32 index) override
    {
        return index < 0 || index >= getParameterCount() ? nullptr : &queues[static_cast<std::size_t> (index)];
    }

    Vst::IParamValueQueue* PLUGIN_API addParameterData (const Vst::ParamID& parameter, Steinberg::int32& index) override
    {
        for (index = 0; index < getParameterCount(); ++index)
            if (auto& queue = queues[static_cast<std::size_t> (index)]; queue.getParameterId() == parameter)
                return &queue;

        return &queues.emplace_back (parameter);
    }

private:
    std::deque<ValueQueue> queues; // Their addresses stay.
};

/** Notes what a controller tells its host; it may do so on any thread. */
class ComponentHandler : public HostObject<Vst::IComponentHandler>
{
public:
    std::atomic<int> edits { 0 }, restartFlags { 0 };

    tresult PLUGIN_API beginEdit (Vst::ParamID) override { return Steinberg::kResultOk; }
    tresult PLUGIN_API endEdit (Vst::ParamID) override { return Steinberg::kResultOk; }

    tresult PLUGIN_API performEdit (Vst::ParamID, Vst::ParamValue) override
    {
        ++edits;
        return Steinberg::kResultOk;
    }

    tresult PLUGIN_API restartComponent (Steinberg::int32 flags) override
    {
        restartFlags |= flags;
        return Steinberg::kResultOk;
    }
};

/** Stands between a component and its controller, as hosts do that keep the two apart: only messages come through. */
class ConnectionProxy final : public HostObject<Vst::IConnectionPoint>
{
public:
    explicit ConnectionProxy (Vst::IConnectionPoint* to) : destination (to) {}

    tresult PLUGIN_API connect (IConnectionPoint*) override { return Steinberg::kResultOk; }
    tresult PLUGIN_API disconnect (IConnectionPoint*) override { return Steinberg::kResultOk; }
    tresult PLUGIN_API notify (Vst::IMessage* message) override { return destination->notify (message); }

private:
    Vst::IConnectionPoint* destination;
};

#pragma GCC diagnostic pop
} // namespace antinode::test
