#include "PlateScreenshot.h"

#include <Standalone/MainComponent.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

namespace
{
constexpr double sampleRate = 96000;
constexpr int blockSize = 960;

/** A picture: its file, its size, and what it shows. */
struct Screenshot
{
    std::string file;
    int width, height;
    std::string device, focus;
    bool isDark;
};

std::shared_ptr<const antinode::DeviceDocument> embeddedDevice (const std::string& name)
{
    return std::make_shared<const antinode::DeviceDocument> (
        antinode::readDeviceDocument (antinode::loadDocument (antinode::LibraryKind::device, name), name));
}

std::shared_ptr<const antinode::FocusDocument> embeddedFocus (const std::string& name)
{
    return std::make_shared<const antinode::FocusDocument> (
        antinode::readFocusDocument (antinode::loadDocument (antinode::LibraryKind::focus, name), name));
}

void waitUntilShown (antinode::EditorContent& content)
{
    do
    {
        std::this_thread::sleep_for (std::chrono::milliseconds (10));
        content.refresh (0);
    } while (! content.isSettled());
}

/** Fires a few times, so that meters and the live trace show something. */
void play (antinode::AntinodeProcessor& processor, antinode::EditorContent& content)
{
    constexpr int blocks = 50, blocksPerFocus = 16;
    juce::AudioBuffer<float> audio (processor.getTotalNumOutputChannels(), blockSize);
    juce::MidiBuffer midi;

    for (int i = 0; i < blocks; ++i)
    {
        if (i % blocksPerFocus == 0)
            processor.session().fire (0.7);

        processor.processBlock (audio, midi);
        content.refresh (static_cast<double> (blockSize) / sampleRate);
    }
}

void write (juce::Component& component, const juce::File& file)
{
    const auto image = component.createComponentSnapshot (component.getLocalBounds(), true, 1);
    file.deleteFile();
    juce::FileOutputStream stream (file);
    juce::PNGImageFormat().writeImageToStream (image, stream);
    std::printf ("%s\n", file.getFullPathName().toRawUTF8());
}

/** Loads and plays what is wanted. */
void show (const Screenshot& wanted, antinode::AntinodeProcessor& processor, antinode::Editor& editor)
{
    processor.load (embeddedDevice (wanted.device), embeddedFocus (wanted.focus));
    processor.prepareToPlay (sampleRate, blockSize);
    processor.parameters().arm().setValueNotifyingHost (1);
    processor.parameters().find ("notes")->setValueNotifyingHost (1); // no designs for unused notes
    auto& content = editor.content();
    content.setDark (wanted.isDark);
    processor.session().waitUntilSettled();
    waitUntilShown (content);
    play (processor, content);
}

void takeEditor (const Screenshot& wanted, const juce::File& folder)
{
    antinode::AntinodeProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    antinode::Editor editor (processor);
    editor.setSize (wanted.width, wanted.height);
    show (wanted, processor, editor);
    write (editor, folder.getChildFile (wanted.file + ".png"));
}

void takeStandalone (const Screenshot& wanted, const juce::File& folder)
{
    antinode::StandaloneHost host (antinode::SettingsFile ({}), false);
    antinode::MainComponent window (host);
    window.setSize (wanted.width, wanted.height);
    show (wanted, host.processor(), window.editor());
    window.showSettings ("Routing");
    window.update();
    write (window, folder.getChildFile (wanted.file + ".png"));
}
} // namespace

/** Usage: antinode_screenshots FOLDER */
int main (int argumentCount, char* arguments[])
{
    if (argumentCount != 2)
        return 2;

    const juce::ScopedJuceInitialiser_GUI juceSession;
    const auto folder = juce::File::getCurrentWorkingDirectory().getChildFile (arguments[1]);
    const Screenshot screenshots[] = {
        { "editor-800x500", 800, 500, "staple", "demonstrator", true },
        { "editor-2560x1440", 2560, 1440, "phone", "phone-thumb", true },
        { "editor-plate", 1280, 800, "glass-148x210", "glass-finger", true },
        { "editor-light", 1280, 800, "staple", "demonstrator", false },
    };

    for (const auto& screenshot : screenshots)
        takeEditor (screenshot, folder);

    antinode::takePlate (folder.getChildFile ("plate-plugin.png"));
    takeStandalone ({ "standalone", 1500, 852, "phone", "phone-thumb", true }, folder);
}
