#pragma once

#include <Editor/EditorContent.h>

#include <Support/EditorTools.h>

#include <functional>
#include <memory>
#include <string>

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

    void waitUntil (const std::function<bool()>& isReached) { test::refreshUntil (content(), isReached); }

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

using test::mouseAt;
} // namespace antinode
