#include "DeviceButton.h"

#include "JuceText.h"

#include <antinode_base/InputError.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
DeviceButton::DeviceButton (std::function<void (std::shared_ptr<const DeviceDocument>)> load)
    : onLoad (std::move (load))
{
    setTitle ("Device");
    onClick = [this] { choose(); };
}

void DeviceButton::setDevice (const DeviceDocument& device)
{
    setButtonText ("Device: " + fromUtf8 (device.description.name));
}

void DeviceButton::loadDevice (const std::string& nameOrFile)
{
    try
    {
        onLoad (std::make_shared<const DeviceDocument> (readDeviceDocument (
            loadDocument (LibraryKind::device, nameOrFile), documentSource (LibraryKind::device, nameOrFile))));
        said.clear();
    }
    catch (const InputError& failure)
    {
        said = fromUtf8 (failure.what());
    }
}

void DeviceButton::choose()
{
    juce::PopupMenu menu;

    for (const auto& entry : libraryEntries (LibraryKind::device))
        menu.addItem (fromUtf8 (entry.name), [this, name = entry.name] { loadDevice (name); });

    menu.addSeparator();
    menu.addItem ("Open a file ...", [this] { chooseFile(); });
    menu.setLookAndFeel (&getLookAndFeel());
    menu.showMenuAsync (juce::PopupMenu::Options().withTargetComponent (*this).withDeletionCheck (*this));
}

void DeviceButton::chooseFile()
{
    chooser = std::make_unique<juce::FileChooser> ("Load a device", juce::File(), "*.json", false, false, this);
    chooser->launchAsync (juce::FileBrowserComponent::openMode | juce::FileBrowserComponent::canSelectFiles,
                          [this] (const juce::FileChooser& done)
                          {
                              if (const auto chosen = done.getResult(); chosen != juce::File())
                                  loadDevice (chosen.getFullPathName().toStdString());
                          });
}
} // namespace antinode
