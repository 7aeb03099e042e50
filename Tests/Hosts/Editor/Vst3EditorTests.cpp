#include "HostWindow.h"

#include <Hosts/RawVst3.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <cstdlib>
#include <random>
#include <thread>

// The view of the VST3 in a host that knows nothing of JUCE.

using namespace antinode::test;
using Steinberg::IPlugView;
using Steinberg::kResultFalse;
using Steinberg::kResultTrue;
using Steinberg::ViewRect;

namespace
{
const char* const x11 = Steinberg::kPlatformTypeX11EmbedWindowID;

struct Release
{
    void operator() (IPlugView* view) const { view->release(); }
};

using View = std::unique_ptr<IPlugView, Release>;

View openView (RawVst3& plugin)
{
    return View (plugin.controller->createView (Vst::ViewType::kEditor));
}

HostWindow::Size viewSize (IPlugView& view)
{
    ViewRect size;
    REQUIRE (view.getSize (&size) == kResultTrue);
    return { size.getWidth(), size.getHeight() };
}

void attach (IPlugView& view, HostWindow& window)
{
    REQUIRE (view.setFrame (&window) == kResultTrue);
    REQUIRE (view.attached (window.handle(), x11) == kResultTrue);
}

void detach (IPlugView& view)
{
    CHECK (view.removed() == kResultTrue);
    CHECK (view.setFrame (nullptr) == kResultTrue);
}

/** Plays notes and automates on a thread of its own while an instance lives. */
class Playing
{
public:
    explicit Playing (RawVst3& pluginToPlay) : plugin (pluginToPlay), parameters (plugin.parameters())
    {
        plugin.activate ({ 48000, length, false, false });
        thread = std::thread ([this] { run(); });
    }

    ~Playing()
    {
        isStopping = true;
        thread.join();
        plugin.deactivate();
    }

    bool isFinite() const { return stayedFinite; }

private:
    void run()
    {
        std::mt19937 random (3);

        while (! isStopping)
        {
            const auto played =
                plugin.play (length, length,
                             [&] (Vst3Block& block)
                             {
                                 block.events.events.push_back (noteOn (0, static_cast<int> (random() % 128)));
                                 block.changes.add (parameters[random() % parameters.size()].id, 0,
                                                    static_cast<double> (random() % 1001) / 1000);
                             });
            stayedFinite = stayedFinite && played.allFinite();
            std::this_thread::sleep_for (std::chrono::milliseconds (1));
        }
    }

    static constexpr int length = 256;
    RawVst3& plugin;
    std::vector<Vst::ParameterInfo> parameters;
    std::atomic<bool> isStopping { false }, stayedFinite { true };
    std::thread thread;
};
} // namespace

TEST_CASE ("A view says what it is before it has a window", "[view]")
{
    RawVst3 plugin;
    const auto view = openView (plugin);
    REQUIRE (view != nullptr);
    CHECK (view->isPlatformTypeSupported (x11) == kResultTrue);
    CHECK (view->isPlatformTypeSupported (Steinberg::kPlatformTypeHWND) == kResultFalse);
    CHECK (view->isPlatformTypeSupported ("nonsense") == kResultFalse);
    CHECK (view->canResize() == kResultTrue);
    CHECK ((viewSize (*view) == HostWindow::Size { 1280, 800 }));
    CHECK (plugin.controller->createView ("nonsense") == nullptr);
    CHECK (plugin.controller->createView (Vst::ViewType::kEditor) == nullptr); // One at a time.
    ViewRect tiny { 0, 0, 10, 10 }, vast { 0, 0, 100000, 100000 };
    CHECK (view->checkSizeConstraint (&tiny) == kResultTrue);
    CHECK (view->checkSizeConstraint (&vast) == kResultTrue);
    CHECK (tiny.getWidth() == 400); // Half of what its content needs: it is drawn smaller.
    CHECK (tiny.getHeight() == 250);
    CHECK (vast.getWidth() == 3840);
    CHECK (vast.getHeight() == 2400);
}

TEST_CASE ("A view shows itself in the host's window and follows its size", "[view][window]")
{
    RawVst3 plugin;
    RunLoop loop;
    HostWindow window (loop);
    const auto view = openView (plugin);
    attach (*view, window);
    CHECK (loop.handlers() > 0);
    loop.runUntil ([&] { return window.children() == std::vector { viewSize (*view) }; });
    loop.runUntil ([&] { return window.colours ({ 1280, 800 }) > 50; });

    for (const auto size : { HostWindow::Size { 1000, 700 }, { 640, 400 }, { 1600, 1000 } })
    {
        ViewRect wanted { 0, 0, size.width, size.height };
        CHECK (view->checkSizeConstraint (&wanted) == kResultTrue);
        CHECK (window.resizeView (view.get(), &wanted) == kResultTrue);
        CHECK ((viewSize (*view) == size));
        loop.runUntil ([&] { return window.children() == std::vector { size }; });
        loop.runUntil ([&] { return window.colours (size) > 50; });
    }

    detach (*view);
    CHECK (window.children().empty());
    CHECK (loop.handlers() == 0);
}

TEST_CASE ("A view opens and closes while the plug-in plays and is automated", "[view][window]")
{
    RawVst3 plugin;
    RunLoop loop;
    const Playing playing (plugin);

    for (int i = 0; i < 10; ++i)
    {
        HostWindow window (loop);
        const auto view = openView (plugin);
        REQUIRE (view != nullptr);
        attach (*view, window);

        if (i % 2 == 0)
            loop.runUntil ([&] { return window.colours (viewSize (*view)) > 50; });

        detach (*view);
    }

    CHECK (playing.isFinite());
}

TEST_CASE ("A view is attached again, left by its frame early, and freed after the plug-in has stopped",
           "[view][window]")
{
    RunLoop loop;
    HostWindow window (loop);
    RawVst3 plugin;
    auto view = openView (plugin);
    attach (*view, window);
    loop.runUntil ([&] { return window.children().size() == 1; });
    detach (*view);
    loop.runUntil ([&] { return window.children().empty(); });
    attach (*view, window);
    loop.runUntil ([&] { return window.colours (viewSize (*view)) > 50; });
    plugin.component->setActive (false);
    detach (*view);
    view = nullptr;
    CHECK (openView (plugin) != nullptr);
    CHECK (loop.handlers() == 0);
}

TEST_CASE ("Two instances show their views side by side, and the one that stays goes on", "[view][window]")
{
    // A loop for each: JUCE 7.0.5 forgets a loop that two views share when the first of them leaves it.
    RunLoop firstLoop, secondLoop, moment;
    HostWindow first (firstLoop), second (secondLoop, 1290);
    RawVst3 plugin, other;
    const auto view = openView (plugin), beside = openView (other);
    attach (*view, first);
    attach (*beside, second);
    const auto isShown = [&] (const HostWindow& window)
    {
        firstLoop.runOnce();
        secondLoop.runOnce();
        return window.colours ({ 1280, 800 }) > 50;
    };
    moment.runUntil ([&] { return isShown (first) && isShown (second); });
    detach (*view);
    CHECK (firstLoop.handlers() == 0);
    CHECK (secondLoop.handlers() > 0);
    ViewRect size { 0, 0, 640, 400 };
    CHECK (second.resizeView (beside.get(), &size) == kResultTrue);
    moment.runUntil ([&] { return second.children() == std::vector { HostWindow::Size { 640, 400 } }; });
    detach (*beside);
    CHECK (secondLoop.handlers() == 0);
}

TEST_CASE ("Without a display a view does no harm", "[view][no-display]")
{
    REQUIRE (std::getenv ("DISPLAY") == nullptr);
    RawVst3 plugin;
    RunLoop loop;

    HostFrame frame (loop);
    const Playing playing (plugin);

    for (int i = 0; i < 10; ++i)
        if (const auto view = openView (plugin))
        {
            view->setFrame (&frame);
            ViewRect size { 0, 0, 900, 600 };
            view->onSize (&size);

            if (view->attached (reinterpret_cast<void*> (1), x11) == kResultTrue)
            {
                for (int turns = 0; turns < 20; ++turns)
                    loop.runOnce();

                view->removed();
            }

            view->setFrame (nullptr);
        }

    CHECK (playing.isFinite());
}
