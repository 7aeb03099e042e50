#pragma once

#include "Presets.h"

#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
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
