#include "LibraryButton.h"

#include "JuceText.h"

#include <antinode_base/InputError.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
LibraryButton::LibraryButton (LibraryKind kindToChoose, const juce::String& whatIsLoaded, Take take,
                              std::function<void()> takeNothing)
    : kind (kindToChoose), what (whatIsLoaded), onTake (std::move (take)), onNothing (std::move (takeNothing))
{
    setTitle (what.substring (0, 1).toUpperCase() + what.substring (1));
    onClick = [this] { choose(); };
}

void LibraryButton::loadDocument (const std::string& nameOrFile)
{
    try
    {
        onTake (antinode::loadDocument (kind, nameOrFile), documentSource (kind, nameOrFile));
        said.clear();
    }
    catch (const InputError& failure)
    {
        said = fromUtf8 (failure.what());
    }
}

void LibraryButton::choose()
{
    juce::PopupMenu menu;

    if (onNothing)
    {
        menu.addItem ("Nothing",
                      [this]
                      {
                          said.clear();
                          onNothing();
                      });
        menu.addSeparator();
    }

    for (const auto& entry : libraryEntries (kind))
        menu.addItem (fromUtf8 (entry.name), [this, name = entry.name] { loadDocument (name); });

    menu.addSeparator();
    menu.addItem ("Open a file ...", [this] { chooseFile(); });
    menu.setLookAndFeel (&getLookAndFeel());
    menu.showMenuAsync (juce::PopupMenu::Options().withTargetComponent (*this).withDeletionCheck (*this));
}

void LibraryButton::chooseFile()
{
    chooser = std::make_unique<juce::FileChooser> ("Load a " + what, juce::File(), "*.json", false, false, this);
    chooser->launchAsync (juce::FileBrowserComponent::openMode | juce::FileBrowserComponent::canSelectFiles,
                          [this] (const juce::FileChooser& done)
                          {
                              if (const auto chosen = done.getResult(); chosen != juce::File())
                                  loadDocument (chosen.getFullPathName().toStdString());
                          });
}
} // namespace antinode
