#pragma once

#include "Presets.h"

#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** The browser of devices or focuses: the factory's and the user's own, to be loaded, kept and removed. [message thread] */
class PresetPanel final : public juce::Component, private juce::ListBoxModel
{
public:
    explicit PresetPanel (Presets&);

    /** Shows what there is of a kind. */
    void open (LibraryKind);

    LibraryKind kind() const { return shownKind; }

    /** Closes it. */
    std::function<void()> onClose;

    /** The sentence about what was done last, or why it was not. */
    juce::String message() const { return sentence.getText(); }

    /** What the buttons do; the selected row and the name that was typed say with what. */
    void select (const juce::String& name);
    void loadSelected();
    void saveAs (const juce::String& name);
    void removeSelected();
    void loadFile (const juce::File&);

    void paint (juce::Graphics&) override;
    void resized() override;
    bool keyPressed (const juce::KeyPress&) override;

private:
    /** A row: an entry, or a heading where there is none. */
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
