#pragma once

#include <Hosts/Vst3HostObjects.h>

#include <functional>
#include <vector>

namespace antinode::test
{
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor" // Interfaces of VST3 have none.

/** A host's loop: what waits for descriptors and time, and tells plug-ins. [main thread] */
class RunLoop : public HostObject<Steinberg::Linux::IRunLoop>
{
public:
    tresult PLUGIN_API registerEventHandler (Steinberg::Linux::IEventHandler*,
                                             Steinberg::Linux::FileDescriptor) override;
    tresult PLUGIN_API unregisterEventHandler (Steinberg::Linux::IEventHandler*) override;
    tresult PLUGIN_API registerTimer (Steinberg::Linux::ITimerHandler*, Steinberg::Linux::TimerInterval) override;
    tresult PLUGIN_API unregisterTimer (Steinberg::Linux::ITimerHandler*) override;

    /** Waits a moment for what comes, and tells those whom it concerns. */
    void runOnce();

    /** @throws std::runtime_error  where it does not come true */
    void runUntil (const std::function<bool()>&);

    /** How many handlers wait for something. */
    std::size_t handlers() const { return events.size(); }

private:
    struct Event
    {
        Steinberg::Linux::IEventHandler* handler;
        Steinberg::Linux::FileDescriptor descriptor;
    };

    bool isRegistered (const Event&) const;

    std::vector<Event> events;
    std::vector<Steinberg::Linux::ITimerHandler*> timers;
};

/** What views ask their host for: another size, and its loop. [main thread] */
class HostFrame : public HostObject<Steinberg::IPlugFrame>
{
public:
    explicit HostFrame (RunLoop& loopToUse) : loop (loopToUse) {}

    tresult PLUGIN_API queryInterface (const Steinberg::TUID, void**) override;
    tresult PLUGIN_API resizeView (Steinberg::IPlugView* view, Steinberg::ViewRect* size) override
    {
        return view->onSize (size);
    }

private:
    RunLoop& loop;
};

/** A window of X into which views are put, with its frame. [main thread] */
class HostWindow : public HostFrame
{
public:
    struct Size
    {
        int width = 0, height = 0;
        bool operator== (const Size&) const = default;
    };

    /** @param left  pixels: what lies under another window is not drawn
        @throws std::runtime_error  where there is no display */
    explicit HostWindow (RunLoop&, int left = 0);
    ~HostWindow();

    tresult PLUGIN_API resizeView (Steinberg::IPlugView*, Steinberg::ViewRect*) override;

    /** What a view is attached to. */
    void* handle() const;

    /** Windows in this one. */
    std::vector<Size> children() const;

    /** How many colours a part of the window shows, looking at every fourth pixel either way. */
    std::size_t colours (Size) const;

private:
    struct Connection;

    Connection* connection;
};

#pragma GCC diagnostic pop
} // namespace antinode::test
