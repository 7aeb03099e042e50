#pragma once

#include <Editor/EditorContent.h>

#include <Support/EditorTools.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

namespace antinode
{
/** A processor with its editor, without a display or a message loop: tests step it. */
class EditorFixture
{
public:
    EditorFixture() : processor (8, juce::AudioProcessor::wrapperType_Undefined)
    {
        processor.prepareToPlay (sampleRate, blockSize);
        editor = std::make_unique<Editor> (processor);
    }

    EditorContent& content() { return editor->content(); }

    /** Refreshes until all that was asked for is shown. */
    void settle()
    {
        waitUntil ([this] { return content().isSettled(); });
    }

    void waitUntil (const std::function<bool()>& isReached)
    {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds (60);

        do
        {
            if (std::chrono::steady_clock::now() > end)
                throw std::runtime_error ("the editor does not come to rest");

            std::this_thread::sleep_for (std::chrono::milliseconds (2));
            content().refresh (0.002);
        } while (! isReached());
    }

    void playBlock()
    {
        juce::AudioBuffer<float> audio (processor.getTotalNumOutputChannels(), blockSize);
        juce::MidiBuffer midi;
        processor.processBlock (audio, midi);
    }

    std::string stateText() const { return stateToText (processor.state()); }

    juce::Image snapshot (int width, int height)
    {
        editor->setSize (width, height);
        settle();
        return editor->createComponentSnapshot (editor->getLocalBounds(), true, 1);
    }

    static constexpr double sampleRate = 96000;
    static constexpr int blockSize = 480;

    AntinodeProcessor processor;
    std::unique_ptr<Editor> editor;
};

/** A component and all that is visible in it. */
inline void forEachVisible (juce::Component& component, const std::function<void (juce::Component&)>& look)
{
    look (component);

    for (auto* const child : component.getChildren())
        if (child->isVisible())
            forEachVisible (*child, look);
}

using test::mouseAt;
} // namespace antinode
