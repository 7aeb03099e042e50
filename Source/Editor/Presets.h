#pragma once

#include "History.h"

#include <antinode_documents/Library.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** A button with the name of something that is loaded; a click chooses another one of the library, or of a file, or
    nothing. [message thread] */
class LibraryButton final : public juce::TextButton
{
public:
    using Take = std::function<void (const nlohmann::json&, const std::string& source)>;

    /** @param what         is loaded: "device"
        @param take         gets what was chosen; an InputError of it becomes error()
        @param takeNothing  called where nothing was chosen; none: it cannot be */
    LibraryButton (LibraryKind, const juce::String& what, Take take, std::function<void()> takeNothing = {});

    /** Loads one of the library, or of a file. */
    void loadDocument (const std::string& nameOrFile);

    /** What is wrong with the one that was chosen last, in one sentence; empty where nothing is. */
    juce::String error() const { return said; }

private:
    void choose();
    void chooseFile();

    LibraryKind kind;
    juce::String what;
    Take onTake;
    std::function<void()> onNothing;
    std::unique_ptr<juce::FileChooser> chooser;
    juce::String said;
};

/** Actions on the devices and focuses of the library. Each returns one sentence if it failed; then nothing has
    changed. [message thread] */
class Presets
{
public:
    Presets (AntinodeProcessor&, History&);

    /** @param nameOrFile  as loadDocument; as a focus a written design too, where it fits the loaded device */
    juce::String load (LibraryKind, const std::string& nameOrFile);

    /** A device, a focus or a written design, as its file says. */
    juce::String loadFile (const std::string& file);

    /** Saves the device, or the focus with its parameter changes, as a user preset, and continues with that. */
    juce::String save (LibraryKind, const std::string& name);

    /** Removes a user preset. */
    juce::String remove (LibraryKind, const std::string& name);

    /** The name of the loaded preset. */
    juce::String loadedName (LibraryKind) const;

private:
    AntinodeProcessor& processor;
    History& history;
};

/** The browser of devices or focuses: loads factory and user presets, saves and deletes user presets. [message thread]
 */
class PresetPanel final : public juce::Component, private juce::ListBoxModel
{
public:
    explicit PresetPanel (Presets&);

    /** Lists the presets of a kind. */
    void open (LibraryKind);

    LibraryKind kind() const { return shownKind; }

    /** Closes it. */
    std::function<void()> onClose;

    /** The result of the last action, or why it failed. */
    juce::String message() const { return sentence.getText(); }

    /** The actions of the buttons on the selected row and the typed name. */
    void select (const juce::String& name);
    void loadSelected();
    void saveAs (const juce::String& name);
    void removeSelected();
    void loadFile (const juce::File&);

    void paint (juce::Graphics&) override;
    void resized() override;
    bool keyPressed (const juce::KeyPress&) override;

private:
    /** A row: an entry, or a heading if there is none. */
    struct Row
    {
        juce::String heading;
        LibraryEntry entry;
    };

    int getNumRows() override { return static_cast<int> (rows.size()); }
    void paintListBoxItem (int row, juce::Graphics&, int width, int height, bool isSelected) override;
    juce::String getNameForRow (int row) override;
    void selectedRowsChanged (int) override { updateButtons(); }
    void listBoxItemDoubleClicked (int, const juce::MouseEvent&) override { loadSelected(); }
    void returnKeyPressed (int) override { loadSelected(); }

    const LibraryEntry* selected() const;
    void fill();
    void report (const juce::String& failure, const juce::String& success);
    void closeAfter (const juce::String& failure);
    void updateButtons();
    void chooseFile();

    Presets& presets;
    LibraryKind shownKind = LibraryKind::focus;
    std::vector<Row> rows;
    juce::Label title, sentence;
    juce::ListBox list;
    juce::TextEditor name;
    juce::TextButton load { "Load" }, remove { "Delete" }, file { "From file" }, save { "Save as" }, close { "Close" };
    std::unique_ptr<juce::FileChooser> chooser;
};
} // namespace antinode
