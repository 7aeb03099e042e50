#include <Editor/EditorContent.h>
#include <Plate/PlateContent.h>
#include <Touch/TouchContent.h>

#include <Support/BlockingActions.h>
#include <Support/EditorTools.h>
#include <Support/LargestDevice.h>

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <memory>
#include <random>
#include <string>
#include <thread>

// What is so in the window of every role.

using namespace antinode;
using namespace antinode::test;

namespace
{
std::shared_ptr<const DeviceDocument> documentOf (const nlohmann::json& json)
{
    return std::make_shared<const DeviceDocument> (readDeviceDocument (json, "device"));
}

/** How a role loads a device, whether it is shown, and something that can be dragged. */
template <typename Content>
struct Role;

template <>
struct Role<EditorContent>
{
    using Processor = AntinodeProcessor;
    static constexpr std::array place { "probe_x", "probe_y" };
    static void load (Processor& processor, std::shared_ptr<const DeviceDocument> device)
    {
        processor.load (std::move (device), nullptr);
    }
    static void loadFile (EditorContent& content, const juce::String& file) { content.filesDropped ({ file }, 0, 0); }
    static bool isShown (EditorContent& content) { return content.isSettled(); }
    static juce::Point<float> handle (EditorContent& content) { return content.surface().probe(); }
};

template <>
struct Role<PlateContent>
{
    using Processor = PlateProcessor;
    static constexpr std::array place { "probe1_x", "probe1_y" };
    static void load (Processor& processor, std::shared_ptr<const DeviceDocument> device)
    {
        processor.load (std::move (device));
    }
    static void loadFile (PlateContent& content, const juce::String& file)
    {
        content.deviceButton().loadDocument (file.toStdString());
    }
    static bool isShown (PlateContent& content) { return content.picture() != nullptr; }
    static juce::Point<float> handle (PlateContent& content) { return content.surface().probe (0); }
};

template <>
struct Role<TouchContent>
{
    using Processor = TouchProcessor;
    static constexpr std::array place { "finger1_x", "finger1_y" };
    static void load (Processor& processor, std::shared_ptr<const DeviceDocument> device)
    {
        processor.load (std::move (device));
        processor.parameters().setValues ({ { "finger1_state", 2 } });
    }
    static void loadFile (TouchContent& content, const juce::String& file)
    {
        content.deviceButton().loadDocument (file.toStdString());
    }
    static bool isShown (TouchContent& content) { return content.hasPicture(); }
    static juce::Point<float> handle (TouchContent& content) { return content.surface().finger (0); }
};

/** A window with a device that is solved and shown. */
template <typename Content>
class ShownWindow : private juce::AudioProcessorListener
{
public:
    explicit ShownWindow (const std::string& device)
    {
        Role<Content>::load (processor, documentOf (loadDocument (LibraryKind::device, device)));
        processor.prepareToPlay (48000, 480);
        processor.session().waitUntilSettled();
        editor = std::make_unique<RoleEditor<Content>> (processor);
        refreshUntil (content(), [this] { return Role<Content>::isShown (content()); });
        processor.addListener (this);
    }

    ~ShownWindow() override { processor.removeListener (this); }

    Content& content() { return editor->content(); }
    juce::Image picture (int width, int height)
    {
        editor->setSize (width, height);
        return editor->createComponentSnapshot (editor->getLocalBounds(), true, 1);
    }

    typename Role<Content>::Processor processor { 8, juce::AudioProcessor::wrapperType_Undefined };
    std::unique_ptr<RoleEditor<Content>> editor;
    int begun = 0, ended = 0; ///< Gestures.

private:
    void audioProcessorParameterChanged (juce::AudioProcessor*, int, float) override {}
    void audioProcessorChanged (juce::AudioProcessor*, const ChangeDetails&) override {}
    void audioProcessorParameterChangeGestureBegin (juce::AudioProcessor*, int) override { ++begun; }
    void audioProcessorParameterChangeGestureEnd (juce::AudioProcessor*, int) override { ++ended; }
};
} // namespace

TEMPLATE_TEST_CASE ("Every window is drawn at its least and at a large size, dark and light, for plates and lines",
                    "[window]", EditorContent, PlateContent, TouchContent)
{
    ShownWindow<TestType> window (GENERATE ("staple", "aluminium-200x120"));
    const auto& least = window.content().shape().sizes;

    for (const auto isDark : { true, false })
    {
        window.content().setDark (isDark);
        CHECK (countColours (window.picture (least.leastWidth, least.leastHeight)) > 100);
        CHECK (countColours (window.picture (2560, 1440)) > 100);
    }
}

TEMPLATE_TEST_CASE ("All buttons of every window have a title and a tooltip", "[window]", EditorContent, PlateContent,
                    TouchContent)
{
    ShownWindow<TestType> window ("staple");
    forEachShown (*window.editor,
                  [] (juce::Component& component)
                  {
                      if (auto* const button = dynamic_cast<juce::Button*> (&component);
                          button != nullptr && button->getWantsKeyboardFocus())
                      {
                          INFO (button->getName() << ' ' << button->getTitle());
                          CHECK (button->getTooltip().isNotEmpty());
                          CHECK ((button->getTitle() + button->getButtonText()).isNotEmpty());
                      }
                  });
}

TEMPLATE_TEST_CASE ("What is dragged on any surface goes with the mouse, as one gesture of each parameter", "[window]",
                    EditorContent, PlateContent, TouchContent)
{
    const auto* const device = GENERATE ("staple", "aluminium-200x120");
    ShownWindow<TestType> window (device);

    for (const auto* const name : Role<TestType>::place)
        window.processor.parameters().find (name)->setValueNotifyingHost (0.3F);

    window.content().refresh (0);
    window.picture (1280, 800); // It is laid out where it is painted.
    auto& surface = window.content().surface();
    const auto isLine = window.processor.session().snapshot()->model->surface.kind == SurfaceKind::line;
    const auto from = Role<TestType>::handle (window.content());
    const juce::Point<float> offset (3, -2), by (40, isLine ? 0.0F : -30.0F);
    surface.mouseDown (mouseAt (surface, from + offset));
    surface.mouseDrag (mouseAt (surface, from + offset + by / 2, from + offset));
    surface.mouseDrag (mouseAt (surface, from + offset + by, from + offset));
    surface.mouseUp (mouseAt (surface, from + offset + by, from + offset));
    CHECK (Role<TestType>::handle (window.content()).getDistanceFrom (from + by) < 0.5F);
    CHECK (window.begun == 2);
    CHECK (window.ended == 2);
}

TEMPLATE_TEST_CASE ("Every window says in its status line why a device cannot be loaded", "[window]", EditorContent,
                    PlateContent, TouchContent)
{
    ShownWindow<TestType> window ("staple");
    Role<TestType>::loadFile (window.content(), "/no/such/device.json");
    window.content().refresh (0);
    juce::StringArray said;

    for (const auto& message : window.content().statusLine().messages())
        said.add (message.text);

    CHECK (said.joinIntoString ("\n").contains ("/no/such/device.json"));
}

TEMPLATE_TEST_CASE ("Closing a plug-in or its window does not wait for what is computed", "[window][blocking]",
                    PlateContent, TouchContent)
{
    BlockingTimes times;
    std::mt19937 random (3);

    for (int i = 0; i < blockingRounds (10); ++i)
    {
        auto processor =
            std::make_unique<typename Role<TestType>::Processor> (64, juce::AudioProcessor::wrapperType_Undefined);
        auto editor = std::make_unique<RoleEditor<TestType>> (*processor);
        Role<TestType>::load (
            *processor,
            documentOf (i % 3 == 0 ? largestDevice (50 + i) : loadDocument (LibraryKind::device, "glass-148x210")));
        times.measure ("prepared", [&] { processor->prepareToPlay (48000, 512); });
        std::this_thread::sleep_for (std::chrono::milliseconds (random() % 400));
        editor->content().refresh (0.02);
        times.measure ("sample rate changed", [&] { processor->prepareToPlay (96000, 512); });
        times.measure ("editor closed", [&] { editor.reset(); });
        times.measure ("plug-in destroyed", [&] { processor.reset(); });
    }

    times.print();
    CHECK (times.longest() <= BlockingTimes::allowed());
}
