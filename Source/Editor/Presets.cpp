#include "Presets.h"

#include "EditorLook.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_session/Documents.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
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

namespace
{
/** Does something that may fail with a sentence. */
template <typename Action>
juce::String attemptAction (const Action& action)
{
    try
    {
        action();
        return {};
    }
    catch (const std::exception& failure)
    {
        return juce::String::fromUTF8 (failure.what());
    }
}

/** Puts a device or focus of the library, or of a file, into a state. */
void read (LibraryKind kind, const std::string& nameOrFile, SessionState& state)
{
    if (kind == LibraryKind::device)
        state.device = deviceDocument (nameOrFile);
    else
        state.focus = focusDocument (nameOrFile);
}

/** The loaded device under another name. */
nlohmann::ordered_json deviceNamed (const AntinodeProcessor& processor, const std::string& name)
{
    auto json = nlohmann::ordered_json::parse (processor.device()->text);
    json["name"] = name;
    return json;
}

/** The loaded focus as the parameters changed it, under another name. */
nlohmann::ordered_json focusNamed (AntinodeProcessor& processor, const std::string& name)
{
    const auto document = processor.state().focus;
    auto focus = withSettings (document->description, processor.parameters().settings(),
                               deviceExtent (processor.device()->description));

    if (writtenFor (*document, focus) != nullptr)
        throw InputError (document->design->source,
                          "is a written design, which its file and sessions keep; move a parameter to save its focus");

    focus.name = name;
    return focusToJson (focus);
}
/** A design for another device or rate changes nothing. */
void requirePlayable (AntinodeProcessor& processor, const FocusDocument& focus)
{
    const auto now = processor.session().snapshot();
    const auto& device = *processor.device();
    const auto isSolved = now->device != nullptr && now->device->text == device.text;
    requireFit (focus, device, isSolved ? now->model.get() : nullptr, now->playback);
}

LibraryKind kindOf (const nlohmann::json& document)
{
    const auto schema = document.is_object() ? document.value ("schema", nlohmann::json()) : nlohmann::json();
    const auto isDevice = schema.is_string() && schema.get<std::string>().starts_with ("antinode.device/");
    return isDevice ? LibraryKind::device : LibraryKind::focus;
}
} // namespace

Presets::Presets (AntinodeProcessor& processorToLoad, History& historyToKeep)
    : processor (processorToLoad), history (historyToKeep)
{
}

juce::String Presets::load (LibraryKind kind, const std::string& nameOrFile)
{
    return attemptAction (
        [&]
        {
            auto wanted = processor.state();
            read (kind, nameOrFile, wanted);

            if (kind == LibraryKind::device)
                history.record ([&] { processor.load (wanted.device, nullptr); });
            else
            {
                requirePlayable (processor, *wanted.focus);
                history.record ([&] { processor.load (nullptr, wanted.focus); });
            }
        });
}

juce::String Presets::loadFile (const std::string& file)
{
    auto kind = LibraryKind::focus;
    const auto failure = attemptAction ([&] { kind = kindOf (readJsonFile (file)); });
    return failure.isEmpty() ? load (kind, file) : failure;
}

juce::String Presets::save (LibraryKind kind, const std::string& name)
{
    return attemptAction (
        [&]
        {
            saveDocument (kind, name,
                          kind == LibraryKind::device ? deviceNamed (processor, name) : focusNamed (processor, name));
            auto wanted = processor.state();
            read (kind, name, wanted);
            // Not loaded: what is armed, muted and set stays.
            history.record ([&] { processor.setState (wanted, false); });
        });
}

juce::String Presets::remove (LibraryKind kind, const std::string& name)
{
    return attemptAction ([&] { removeDocument (kind, name); });
}

juce::String Presets::loadedName (LibraryKind kind) const
{
    const auto& name =
        kind == LibraryKind::device ? processor.device()->description.name : processor.focus()->description.name;
    const auto shown = name.empty() ? juce::String ("unnamed") : juce::String::fromUTF8 (name.c_str());
    const auto isWritten = kind == LibraryKind::focus && processor.session().snapshot()->isAsWritten;
    return isWritten ? shown + " (as written)" : shown;
}

namespace
{
constexpr int presetMargin = 14, presetRowHeight = 26, presetGap = 8;

} // namespace

PresetPanel::PresetPanel (Presets& presetsToShow) : presets (presetsToShow)
{
    setFocusContainerType (FocusContainerType::keyboardFocusContainer);
    title.setFont (EditorLook::font (15, true));
    sentence.setFont (EditorLook::font (EditorLook::smallTextHeight));
    sentence.setJustificationType (juce::Justification::topLeft);
    sentence.setMinimumHorizontalScale (1);
    list.setModel (this);
    list.setRowHeight (presetRowHeight);
    list.setTitle ("Presets");
    name.setFont (EditorLook::font());
    name.setTitle ("Name to save as");
    name.setTooltip ("1 to 64 letters, digits, spaces, '-', '_' and '.'; not the name of a factory preset.");
    name.onReturnKey = [this] { saveAs (name.getText()); };
    load.onClick = [this] { loadSelected(); };
    load.setTooltip ("Loads the selected preset. Also: Return or double click.");
    remove.onClick = [this] { removeSelected(); };
    remove.setTooltip ("Deletes the selected user preset.");
    file.onClick = [this] { chooseFile(); };
    file.setTooltip (
        "Loads a JSON file; as a focus also a design.json, which plays as it was written. Or drop it on the window.");
    save.onClick = [this] { saveAs (name.getText()); };
    save.setTooltip ("Saves the loaded preset with its parameter changes under the name at the left.");
    close.onClick = [this]
    {
        if (onClose)
            onClose();
    };
    close.setTooltip ("Key: Escape");
    addAndMakeVisible (title);

    for (juce::Component* const child :
         { static_cast<juce::Component*> (&list), static_cast<juce::Component*> (&load),
           static_cast<juce::Component*> (&remove), static_cast<juce::Component*> (&file),
           static_cast<juce::Component*> (&name), static_cast<juce::Component*> (&save),
           static_cast<juce::Component*> (&close), static_cast<juce::Component*> (&sentence) })
        addAndMakeVisible (child);
}

void PresetPanel::open (LibraryKind kind)
{
    shownKind = kind;
    const auto word = kind == LibraryKind::device ? "Devices" : "Focuses";
    title.setText (word, juce::dontSendNotification);
    setTitle (word);
    name.setText ({}, false);
    sentence.setText ({}, juce::dontSendNotification);
    fill();
    select (presets.loadedName (kind));
}

void PresetPanel::fill()
{
    rows.clear();
    const auto entries = libraryEntries (shownKind);

    for (const auto isFactory : { true, false })
    {
        rows.push_back ({ isFactory ? "Factory" : "Own", {} });

        for (const auto& entry : entries)
            if (entry.isFactory == isFactory)
                rows.push_back ({ {}, entry });
    }

    list.updateContent();
    list.repaint();
    updateButtons();
}

const LibraryEntry* PresetPanel::selected() const
{
    const auto row = list.getSelectedRow();
    const auto isEntry =
        row >= 0 && row < static_cast<int> (rows.size()) && rows[static_cast<std::size_t> (row)].heading.isEmpty();
    return isEntry ? &rows[static_cast<std::size_t> (row)].entry : nullptr;
}

void PresetPanel::select (const juce::String& wanted)
{
    const auto found =
        std::find_if (rows.begin(), rows.end(),
                      [&] (const auto& row) { return row.heading.isEmpty() && fromUtf8 (row.entry.name) == wanted; });

    if (found == rows.end())
        list.deselectAllRows();
    else
        list.selectRow (static_cast<int> (found - rows.begin()));
}

void PresetPanel::updateButtons()
{
    const auto* const entry = selected();
    load.setEnabled (entry != nullptr);
    remove.setEnabled (entry != nullptr && ! entry->isFactory);
}

void PresetPanel::report (const juce::String& failure, const juce::String& success)
{
    const auto& palette = EditorLook::findPalette (*this);
    sentence.setColour (juce::Label::textColourId, failure.isEmpty() ? palette.mutedText : palette.warning);
    sentence.setText (failure.isEmpty() ? success : failure, juce::dontSendNotification);
    sentence.setTooltip (sentence.getText());
}

void PresetPanel::loadSelected()
{
    if (const auto* const entry = selected())
    {
        const auto failure = presets.load (shownKind, entry->name);
        report (failure, "Loaded " + fromUtf8 (entry->name) + ".");
        closeAfter (failure);
    }
}

/** It would cover what was loaded. */
void PresetPanel::closeAfter (const juce::String& failure)
{
    if (failure.isEmpty() && onClose)
        onClose();
}

void PresetPanel::saveAs (const juce::String& wanted)
{
    const auto trimmed = wanted.trim();
    const auto failure = presets.save (shownKind, trimmed.toStdString());
    fill();

    if (failure.isEmpty())
        select (trimmed);

    report (failure, "Saved " + trimmed + ".");
}

void PresetPanel::removeSelected()
{
    if (const auto* const entry = selected())
    {
        const auto removed = entry->name;
        const auto failure = presets.remove (shownKind, removed);
        fill();
        report (failure, "Deleted " + fromUtf8 (removed) + ".");
    }
}

void PresetPanel::loadFile (const juce::File& wanted)
{
    const auto failure = presets.load (shownKind, wanted.getFullPathName().toStdString());
    report (failure, "Loaded " + wanted.getFileName() + ".");
    closeAfter (failure);
}

void PresetPanel::chooseFile()
{
    chooser = std::make_unique<juce::FileChooser> ("Load a file", juce::File(), "*.json", false, false, this);
    chooser->launchAsync (juce::FileBrowserComponent::openMode | juce::FileBrowserComponent::canSelectFiles,
                          [this] (const juce::FileChooser& done)
                          {
                              if (const auto chosen = done.getResult(); chosen != juce::File())
                                  loadFile (chosen);
                          });
}

juce::String PresetPanel::getNameForRow (int row)
{
    const auto& shown = rows[static_cast<std::size_t> (row)];
    return shown.heading.isNotEmpty() ? shown.heading : fromUtf8 (shown.entry.name);
}

void PresetPanel::paintListBoxItem (int row, juce::Graphics& g, int width, int height, bool isSelected)
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto isHeading = rows[static_cast<std::size_t> (row)].heading.isNotEmpty();
    const auto area = juce::Rectangle<int> (width, height);

    if (isSelected && ! isHeading)
    {
        g.setColour (palette.accent.withAlpha (0.3f));
        g.fillRect (area.reduced (4, 1));
    }

    g.setFont (EditorLook::font (isHeading ? EditorLook::smallTextHeight : EditorLook::textHeight, isHeading));
    g.setColour (isHeading ? palette.mutedText : palette.text);
    g.drawText (getNameForRow (row), area.withTrimmedLeft (isHeading ? 10 : 22), juce::Justification::centredLeft);
}

void PresetPanel::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto area = getLocalBounds().toFloat();
    g.setColour (palette.panel);
    g.fillRoundedRectangle (area, 6);
    g.setColour (palette.outline);
    g.drawRoundedRectangle (area.reduced (0.5f), 6, 1);
}

void PresetPanel::resized()
{
    auto area = getLocalBounds().reduced (presetMargin);
    auto top = area.removeFromTop (presetRowHeight);
    close.setBounds (top.removeFromRight (70));
    title.setBounds (top);
    area.removeFromTop (presetGap);
    sentence.setBounds (area.removeFromBottom (2 * presetRowHeight));
    area.removeFromBottom (presetGap);
    auto saving = area.removeFromBottom (presetRowHeight);
    save.setBounds (saving.removeFromRight (90));
    saving.removeFromRight (presetGap);
    name.setBounds (saving);
    area.removeFromBottom (presetGap);
    auto buttons = area.removeFromBottom (presetRowHeight);
    load.setBounds (buttons.removeFromLeft (90));
    buttons.removeFromLeft (presetGap);
    remove.setBounds (buttons.removeFromLeft (90));
    buttons.removeFromLeft (presetGap);
    file.setBounds (buttons.removeFromRight (90));
    area.removeFromBottom (presetGap);
    list.setBounds (area);
}

bool PresetPanel::keyPressed (const juce::KeyPress& key)
{
    if (key != juce::KeyPress::escapeKey || ! onClose)
        return false;

    onClose();
    return true;
}
} // namespace antinode
