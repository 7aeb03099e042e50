#include "EditorFixture.h"

#include <catch2/catch.hpp>

#include <algorithm>

#include <atomic>
#include <cstdio>
#include <set>

using namespace antinode;

TEST_CASE ("The installed editor opens without a display and shows its first picture")
{
    installEditor();
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    const auto start = juce::Time::getMillisecondCounterHiRes();
    const std::unique_ptr<juce::AudioProcessorEditor> editor (processor.createEditorIfNeeded());
    const auto made = juce::Time::getMillisecondCounterHiRes();
    const auto image = editor->createComponentSnapshot (editor->getLocalBounds(), true, 1);
    const auto drawn = juce::Time::getMillisecondCounterHiRes();
    std::printf ("editor: made in %.1f ms, first picture in %.1f ms\n", made - start, drawn - made);
    CHECK (editor->isResizable());
    CHECK (image.getWidth() == 1280);
    CHECK (test::countColours (image) > 20);
    processor.editorBeingDeleted (editor.get());
}

TEST_CASE ("Every parameter has a control that takes the keyboard, with a title and a tooltip")
{
    EditorFixture test;
    std::set<juce::String> controlled;

    for (const auto& control : test.content().parameterPanel().controls())
    {
        auto& input = control->control();
        auto* const tip = dynamic_cast<juce::TooltipClient*> (&input);
        INFO (input.getComponentID());
        controlled.insert (input.getComponentID());
        CHECK (input.getWantsKeyboardFocus());
        CHECK (input.getTitle().isNotEmpty());
        REQUIRE (tip != nullptr);
        // More than the range alone: each parameter has a sentence of its own.
        CHECK (tip->getTooltip().containsChar ('\n'));
        CHECK (input.isAccessible());
    }

    for (const auto* const parameter : test.processor.parameters().all())
        CHECK (controlled.count (parameter->getParameterID()) == 1);
}

TEST_CASE ("The editor opens and closes while blocks are processed")
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    processor.prepareToPlay (EditorFixture::sampleRate, EditorFixture::blockSize);
    std::atomic<bool> isStopping { false };
    std::thread audio (
        [&]
        {
            juce::AudioBuffer<float> buffer (processor.getTotalNumOutputChannels(), EditorFixture::blockSize);
            juce::MidiBuffer midi;

            while (! isStopping)
            {
                processor.processBlock (buffer, midi);
                std::this_thread::sleep_for (std::chrono::milliseconds (1));
            }
        });

    for (int i = 0; i < 20; ++i)
    {
        Editor editor (processor);
        editor.content().refresh (0.016);
        processor.session().fire (1);
        std::this_thread::sleep_for (std::chrono::milliseconds (5 * (i % 4)));
        editor.content().refresh (0.016);
    }

    isStopping = true;
    audio.join();
    CHECK (processor.session().meters().triggered() > 0);
}

TEST_CASE ("The editor looks on while a host prepares on another thread")
{
    AntinodeProcessor processor (8, juce::AudioProcessor::wrapperType_Undefined);
    Editor editor (processor);
    std::atomic<bool> isDone { false };
    std::thread host (
        [&]
        {
            for (int i = 0; i < 6; ++i)
            {
                processor.prepareToPlay (i % 2 == 0 ? 48000 : 96000, EditorFixture::blockSize);
                juce::AudioBuffer<float> buffer (processor.getTotalNumOutputChannels(), EditorFixture::blockSize);
                juce::MidiBuffer midi;
                processor.processBlock (buffer, midi);
                juce::MemoryBlock state;
                processor.getStateInformation (state);
                processor.setStateInformation (state.getData(), static_cast<int> (state.getSize()));
            }

            isDone = true;
        });

    while (! isDone)
    {
        editor.content().refresh (0.016);
        std::this_thread::sleep_for (std::chrono::milliseconds (1));
    }

    host.join();
    CHECK (processor.warning().isEmpty());
}

TEST_CASE ("Space fires where the device is armed and says so where it is not")
{
    EditorFixture test;
    test.settle();
    auto& arm = test.processor.parameters().arm();
    arm.setValueNotifyingHost (0);
    CHECK (test.content().keyPressed (juce::KeyPress (juce::KeyPress::spaceKey)));
    test.playBlock();
    test.content().refresh (0);
    CHECK (test.processor.session().meters().triggered() == 0);
    CHECK (test.content().statusLine().text().contains ("disarmed"));
    CHECK (test.content().keyPressed (juce::KeyPress ('a')));
    CHECK (arm.get());
    test.content().refresh (0);
    CHECK_FALSE (test.content().statusLine().text().contains ("disarmed"));
    CHECK (test.content().surface().keyPressed (juce::KeyPress (juce::KeyPress::spaceKey)));
    test.playBlock();
    CHECK (test.processor.session().meters().triggered() == 1);
}

TEST_CASE ("A focus that cannot be met is said in a sentence, and the next one is shown again")
{
    EditorFixture test;
    test.settle();
    auto& velocity = *test.processor.parameters().find ("peak_velocity");
    velocity.setValueNotifyingHost (1);
    const auto& status = test.content().statusLine();
    test.waitUntil ([&] { return status.urgency() == Urgency::warning; });
    INFO (status.text());
    CHECK (status.text().contains (" V, too low for "));
    CHECK (status.text() != "Ready");
    velocity.setValueNotifyingHost (velocity.convertTo0to1 (20));
    test.settle();
    test.waitUntil ([&] { return status.text() == "Ready"; });
}

TEST_CASE ("A note that cannot be played at this rate is said calmly, the focus itself is a warning")
{
    EditorFixture test;
    test.processor.prepareToPlay (48000, EditorFixture::blockSize);
    const auto& status = test.content().statusLine();
    test.waitUntil ([&] { return status.text().contains ("cannot be played"); });
    CHECK (status.urgency() == Urgency::calm);
    INFO (status.text());
    CHECK (status.text().matchesWildcard ("1 of 128 notes cannot be played at 48 kHz (note *): *", false));
    test.processor.prepareToPlay (8000, EditorFixture::blockSize);
    test.waitUntil ([&] { return status.urgency() == Urgency::warning; });
    test.processor.prepareToPlay (EditorFixture::sampleRate, EditorFixture::blockSize);
    test.waitUntil ([&] { return status.text() == "Ready"; });
    CHECK (status.urgency() == Urgency::calm);
}

TEST_CASE ("What is wrong with a focus is said in the words of the window, and goes when it is mended")
{
    EditorFixture test;
    test.settle();
    const auto& status = test.content().statusLine();
    const auto set = [&] (const char* name, float value)
    {
        auto& parameter = *test.processor.parameters().find (name);
        parameter.setValueNotifyingHost (parameter.convertTo0to1 (value));
    };
    const auto says = [&] (const char* words)
    {
        const auto& messages = status.messages();
        return std::any_of (messages.begin(), messages.end(),
                            [&] (const auto& message) {
                                return message.urgency == Urgency::caution
                                       && message.text.find (words) != std::string::npos;
                            });
    };
    const auto isCalm = [&] { return status.urgency() == Urgency::calm; };
    test.waitUntil (isCalm);
    set ("width", 12); // narrower than six modes represent
    test.waitUntil ([&] { return says ("of the focus (good: 0.9 or more). Raise Width"); });
    set ("width", 25);
    test.waitUntil (isCalm);
    set ("x", 99); // of the way: 1.5 mm from the right end
    test.waitUntil ([&] { return says ("lies on an edge: 1.5 mm from it"); });
    set ("x", 66);
    set ("peak_velocity", 0.1F);
    test.waitUntil ([&] { return says ("is not felt: ") && says ("Raise Peak velocity"); });
}

TEST_CASE ("The field is played through time and goes back to the focus")
{
    EditorFixture test;
    test.settle();
    auto& time = test.content().timeline();
    CHECK (time.frame() == FieldFrames::atFocus);
    time.setPlaying (true);
    test.content().refresh (0.5);
    CHECK (time.frame() != FieldFrames::atFocus);
    test.content().refresh (1000.25);
    CHECK (time.frame() >= 0);
    CHECK (time.frame() < FieldFrames::count);
    time.setPlaying (false);
    const auto frame = time.frame();
    test.content().refresh (1);
    CHECK (time.frame() == frame);
}
