#pragma once

#include <antinode_session/Documents.h>

#include <juce_gui_basics/juce_gui_basics.h>

#include <functional>
#include <memory>
#include <string>

namespace antinode
{
/** The loaded device's name; a click chooses another one of the library, or of a file. [message thread] */
class DeviceButton final : public juce::TextButton
{
public:
    explicit DeviceButton (std::function<void (std::shared_ptr<const DeviceDocument>)> load);

    void setDevice (const DeviceDocument&);

    /** Loads a device of the library, or of a file. */
    void loadDevice (const std::string& nameOrFile);

    /** What is wrong with the one that was chosen last, in one sentence; empty where nothing is. */
    juce::String error() const { return said; }

private:
    void choose();
    void chooseFile();

    std::function<void (std::shared_ptr<const DeviceDocument>)> onLoad;
    std::unique_ptr<juce::FileChooser> chooser;
    juce::String said;
};
} // namespace antinode
