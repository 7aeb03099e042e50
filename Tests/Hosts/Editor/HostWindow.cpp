#include "HostWindow.h"

#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <poll.h>

namespace
{
/** Asks for the names that every toolkit asks for before a host loads anything. On a server where nobody has, JUCE goes
   on with none, and X ends the program. */
struct UsualNames : Catch::TestEventListenerBase
{
    using Catch::TestEventListenerBase::TestEventListenerBase;

    void testRunStarting (const Catch::TestRunInfo&) override
    {
        display = XOpenDisplay (nullptr);

        if (display != nullptr)
            for (const auto* const name : { "WM_PROTOCOLS", "WM_TAKE_FOCUS", "WM_DELETE_WINDOW", "WM_STATE",
                                            "WM_CHANGE_STATE", "_NET_WM_PING", "_NET_WM_STATE", "_NET_WM_WINDOW_TYPE" })
                XInternAtom (display, name, False);
    }

    void testRunEnded (const Catch::TestRunStats&) override
    {
        if (display != nullptr)
            XCloseDisplay (display);
    }

    Display* display = nullptr;
};

CATCH_REGISTER_LISTENER (UsualNames)
} // namespace

namespace antinode::test
{
using Steinberg::kResultOk;

tresult PLUGIN_API RunLoop::registerEventHandler (Steinberg::Linux::IEventHandler* handler,
                                                  Steinberg::Linux::FileDescriptor descriptor)
{
    events.push_back ({ handler, descriptor });
    return kResultOk;
}

tresult PLUGIN_API RunLoop::unregisterEventHandler (Steinberg::Linux::IEventHandler* handler)
{
    std::erase_if (events, [handler] (const Event& event) { return event.handler == handler; });
    return kResultOk;
}

tresult PLUGIN_API RunLoop::registerTimer (Steinberg::Linux::ITimerHandler* handler, Steinberg::Linux::TimerInterval)
{
    timers.push_back (handler);
    return kResultOk;
}

tresult PLUGIN_API RunLoop::unregisterTimer (Steinberg::Linux::ITimerHandler* handler)
{
    std::erase (timers, handler);
    return kResultOk;
}

bool RunLoop::isRegistered (const Event& event) const
{
    return std::any_of (events.begin(), events.end(),
                        [&] (const Event& other)
                        { return other.handler == event.handler && other.descriptor == event.descriptor; });
}

void RunLoop::runOnce()
{
    constexpr int patience = 5; // ms
    const auto asked = events;  // Whoever is told may register anew.
    const auto due = timers;
    std::vector<pollfd> waiting;

    for (const auto& event : asked)
        waiting.push_back ({ event.descriptor, POLLIN, 0 });

    poll (waiting.data(), waiting.size(), patience);

    for (std::size_t i = 0; i < asked.size(); ++i)
        if (waiting[i].revents != 0 && isRegistered (asked[i]))
            asked[i].handler->onFDIsSet (asked[i].descriptor);

    for (auto* const timer : due)
        timer->onTimer();
}

void RunLoop::runUntil (const std::function<bool()>& isReached)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds (30);

    while (! isReached())
    {
        if (std::chrono::steady_clock::now() > end)
            throw std::runtime_error ("the view does not come to what is waited for");

        runOnce();
    }
}

tresult PLUGIN_API HostFrame::queryInterface (const Steinberg::TUID identifier, void** object)
{
    if (Steinberg::FUnknownPrivate::iidEqual (identifier, Steinberg::Linux::IRunLoop::iid))
        return loop.queryInterface (identifier, object);

    return HostObject::queryInterface (identifier, object);
}

struct HostWindow::Connection
{
    Display* display;
    Window window;
};

HostWindow::HostWindow (RunLoop& loopToUse, int left) : HostFrame (loopToUse)
{
    auto* const display = XOpenDisplay (nullptr);

    if (display == nullptr)
        throw std::runtime_error ("there is no display");

    const auto window = XCreateSimpleWindow (display, DefaultRootWindow (display), left, 0, 1280, 800, 0, 0, 0);
    XMapWindow (display, window);
    XSync (display, False);
    connection = new Connection { display, window };
}

HostWindow::~HostWindow()
{
    XDestroyWindow (connection->display, connection->window);
    XCloseDisplay (connection->display);
    delete connection;
}

tresult PLUGIN_API HostWindow::resizeView (Steinberg::IPlugView* view, Steinberg::ViewRect* wanted)
{
    XResizeWindow (connection->display, connection->window, static_cast<unsigned> (wanted->getWidth()),
                   static_cast<unsigned> (wanted->getHeight()));
    XSync (connection->display, False);
    return view->onSize (wanted);
}

void* HostWindow::handle() const
{
    return reinterpret_cast<void*> (connection->window); // As VST3 hands over an identifier.
}

std::vector<HostWindow::Size> HostWindow::children() const
{
    XSync (connection->display, False);
    Window root = 0, parent = 0, *found = nullptr;
    unsigned count = 0;
    XQueryTree (connection->display, connection->window, &root, &parent, &found, &count);
    std::vector<Size> sizes;

    for (unsigned i = 0; i < count; ++i)
    {
        XWindowAttributes attributes;
        XGetWindowAttributes (connection->display, found[i], &attributes);
        sizes.push_back ({ attributes.width, attributes.height });
    }

    XFree (found);
    return sizes;
}

std::size_t HostWindow::colours (Size part) const
{
    auto* const image = XGetImage (connection->display, connection->window, 0, 0, static_cast<unsigned> (part.width),
                                   static_cast<unsigned> (part.height), AllPlanes, ZPixmap);
    std::set<unsigned long> seen;

    if (image == nullptr)
        return 0;

    for (int y = 0; y < part.height; y += 4)
        for (int x = 0; x < part.width; x += 4)
            seen.insert (XGetPixel (image, x, y));

    XDestroyImage (image);
    return seen.size();
}
} // namespace antinode::test
