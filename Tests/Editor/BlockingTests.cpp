#include <Editor/EditorContent.h>
#include <antinode_base/BackgroundThread.h>

#include <Support/BlockingActions.h>
#include <Support/LargestDevice.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <thread>

// Whatever is being solved, designed or rendered: a host never waits for it.

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A host that does what users do to a plug-in, at random moments of its work. */
class HastyHost
{
public:
    HastyHost() { open(); }

    void act()
    {
        sleep (std::exp (between (0, 6))); // 1 to 400 ms

        switch (static_cast<int> (between (0, 7)))
        {
            case 0:
                times.measure ("editor closed", [this] { editor.reset(); });
                break;
            case 1:
                times.measure ("sample rate changed", [this] { prepare(); });
                break;
            case 2:
                times.measure ("released", [this] { plugin->releaseResources(); });
                break;
            case 3:
                restore();
                break;
            case 4:
                changeDevice();
                break;
            case 5:
                close();
                break;
            default:
                automate();
                break;
        }

        if (plugin == nullptr)
            open();

        if (editor == nullptr)
            editor = std::make_unique<Editor> (*plugin);

        editor->content().refresh (0.02);
    }

    void close()
    {
        times.measure ("editor closed", [this] { editor.reset(); });
        times.measure ("plug-in destroyed", [this] { plugin.reset(); });
    }

    BlockingTimes times;

private:
    void open()
    {
        plugin = std::make_unique<AntinodeProcessor> (64, juce::AudioProcessor::wrapperType_Undefined);
        plugin->load (device(), focus());
        automate();
        prepare();
    }

    void prepare() { plugin->prepareToPlay (between (0, 2) < 1 ? 48000 : 96000, 512); }

    void automate()
    {
        plugin->parameters().find ("method")->setValueNotifyingHost (static_cast<float> (between (0, 1)));
        plugin->parameters().find ("width")->setValueNotifyingHost (static_cast<float> (between (0, 1)));
    }

    void changeDevice()
    {
        const auto other = device();
        times.measure ("device changed", [&] { plugin->load (other, nullptr); });
    }

    void restore()
    {
        juce::MemoryBlock kept;
        times.measure ("state kept", [&] { plugin->getStateInformation (kept); });
        automate();
        plugin->load (device(), focus());
        times.measure ("state set",
                       [&] { plugin->setStateInformation (kept.getData(), static_cast<int> (kept.getSize())); });
    }

    std::shared_ptr<const DeviceDocument> device()
    {
        static const std::vector<std::string> embedded { "staple", "beam", "phone-bare", "glass-148x210",
                                                         "aluminium-200x120" };
        const auto index = static_cast<std::size_t> (between (0, 6));
        auto json = index < embedded.size() ? loadDocument (LibraryKind::device, embedded[index]) : largestDevice (80);

        // No cache knows it.
        if (json.contains ("quality_factor") && between (0, 2) < 1)
            json["quality_factor"] = between (50, 100);

        return std::make_shared<const DeviceDocument> (readDeviceDocument (json, "device"));
    }

    std::shared_ptr<const FocusDocument> focus()
    {
        const auto* const name = between (0, 2) < 1 ? "demonstrator" : "aluminium-centre";
        return std::make_shared<const FocusDocument> (
            readFocusDocument (loadDocument (LibraryKind::focus, name), name));
    }

    double between (double from, double to) { return std::uniform_real_distribution<double> (from, to) (random); }
    static void sleep (double milliseconds)
    {
        std::this_thread::sleep_for (std::chrono::duration<double, std::milli> (milliseconds));
    }

    std::mt19937 random { 3 };
    std::unique_ptr<AntinodeProcessor> plugin;
    std::unique_ptr<Editor> editor;
};
} // namespace

TEST_CASE ("No call of a host waits for what is being computed", "[editor][blocking]")
{
    HastyHost host;

    for (int i = 0; i < blockingRounds (60); ++i)
        host.act();

    host.close();
    std::printf ("%d threads end on their own\n", BackgroundThread::left());
    host.times.print();
    CHECK (host.times.longest() <= BlockingTimes::allowed());
    BackgroundThread::joinLeft();
}
