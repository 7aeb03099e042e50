#include "DevicePanel.h"

#include "EditorLook.h"

#include <antinode_base/MessageText.h>
#include <antinode_drafts/DeviceEdits.h>
#include <antinode_drafts/DeviceTemplates.h>
#include <antinode_identification/Comparison.h>
#include <antinode_reports/Lettering.h>
#include <antinode_text/JsonText.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace antinode
{
namespace
{
constexpr int panelMargin = 10, figuresHeight = 62, panelGap = 4, headingHeight = 22, buttonHeight = 24;
} // namespace

void DevicePanel::Page::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);

    for (const auto& [name, area] : headings)
        drawText (g, name.toStdString(), area.toFloat(), juce::Justification::bottomLeft,
                  { EditorLook::smallTextHeight, true, palette.mutedText });
}

DevicePanel::DevicePanel (DeviceDraft& draftToEdit) : draft (draftToEdit)
{
    setTitle ("Device");
    viewport.setViewedComponent (&page, false);
    viewport.setScrollBarsShown (true, false);
    addAndMakeVisible (viewport);

    for (auto* const button : { &modeBefore, &modeAfter })
        addAndMakeVisible (*button);

    modeBefore.setButtonText ("<");
    modeAfter.setButtonText (">");
    modeBefore.setTitle ("Mode before");
    modeAfter.setTitle ("Next mode");
    modeBefore.setTooltip ("Shows the mode before; before the first one the surface at rest");
    modeAfter.setTooltip ("Shows the next mode. Ceramics are coloured by their participation in it");
    modeBefore.onClick = [this] { stepMode (-1); };
    modeAfter.onClick = [this] { stepMode (1); };
    modeName.setFont (EditorLook::font (EditorLook::smallTextHeight));
    modeName.setJustificationType (juce::Justification::centred);
    modeName.setMinimumHorizontalScale (0.8f);
    modeName.setTitle ("Shown mode");
    modeName.setTooltip ("Frequency with the usual deviation of a device from its drawing, and quality factor");
    addAndMakeVisible (modeName);
    makeDevice();
    makeSizes();
    makeLayers();
    makeEdges();
    makeCeramics();
    makePlacing();
    makeSearch();
    makePoints();
}

void DevicePanel::begin (const std::string& nameOfTemplate)
{
    draft.begin (newDevice (nameOfTemplate));
    shownMode = 0;
}

void DevicePanel::duplicate()
{
    draft.apply (withName (draft.document(), draft.document()["name"].get<std::string>() + " copy"));
}

void DevicePanel::saveTo (const juce::File& file)
{
    const auto isWritten = file.replaceWithText (fromUtf8 (readableJson (draft.document())));

    if (draft.say)
        draft.say (isWritten ? "Saved " + file.getFullPathName() + "; 'antinode render' takes it with --device"
                             : file.getFullPathName() + " cannot be written");
}

void DevicePanel::chooseFile()
{
    chooser = std::make_unique<juce::FileChooser> (
        "Save the device", juce::File::getSpecialLocation (juce::File::userHomeDirectory).getChildFile ("device.json"),
        "*.json", false, false, this);
    chooser->launchAsync (juce::FileBrowserComponent::saveMode | juce::FileBrowserComponent::canSelectFiles
                              | juce::FileBrowserComponent::warnAboutOverwriting,
                          [this] (const juce::FileChooser& done)
                          {
                              if (const auto chosen = done.getResult(); chosen != juce::File())
                                  saveTo (chosen.withFileExtension ("json"));
                          });
}

void DevicePanel::chooseTemplate (juce::Component& at)
{
    juce::PopupMenu menu;

    for (const auto& each : deviceTemplates())
        menu.addItem (fromUtf8 (each.name), [this, name = std::string (each.name)] { begin (name); });

    menu.setLookAndFeel (&getLookAndFeel());
    menu.showMenuAsync (juce::PopupMenu::Options().withTargetComponent (at).withDeletionCheck (*this));
}

bool DevicePanel::isOfPlate() const
{
    return draft.isDrawn() && ! isLine (draft.document());
}

bool DevicePanel::hasCeramics() const
{
    return draft.isDrawn() && ! draft.document()["ceramics"].empty();
}

void DevicePanel::showMode (std::optional<int> mode)
{
    shownMode = mode;
}

void DevicePanel::stepMode (int by)
{
    const auto count = picture != nullptr ? static_cast<int> (picture->model->modes()) : 0;
    const auto next = std::clamp (shownMode.value_or (-1) + by, -1, std::max (0, count - 1));
    shownMode = next < 0 ? std::nullopt : std::optional (next);
}

juce::String DevicePanel::modeText() const
{
    if (picture == nullptr)
        return "solving";

    const auto mode = picture->question.mode;
    const auto& model = *picture->model;

    if (! mode || *mode >= model.modes())
        return "at rest";

    const auto deviation = model.frequencyHz (*mode) * usualModelError (model).value_or (0);
    return "Mode " + juce::String (*mode + 1) + " of " + juce::String (model.modes()) + ": "
           + (picture->isExact ? "" : "about ") + juce::String (juce::roundToInt (model.frequencyHz (*mode))) + " Hz"
           + (deviation > 0 ? fromUtf8 (" \xC2\xB1 ") + juce::String (juce::roundToInt (deviation)) : juce::String())
           + ", Q " + juce::String (juce::roundToInt (0.5 / model.dampingRatios[*mode]));
}

void DevicePanel::refresh (const std::shared_ptr<const DraftPicture>& newest, const PlaceProgress& searched)
{
    const auto isOther = std::exchange (picture, newest) != newest;

    if (isOther)
    {
        modeName.setText (modeText(), juce::dontSendNotification);
        repaint();
    }

    showSearch (searched);

    if (seenChange == draft.changes() && seenCeramics == draft.ceramics && seenPoint == draft.point
        && seenEdge == draft.edge)
        return;

    seenChange = draft.changes();
    seenCeramics = draft.ceramics;
    seenPoint = draft.point;
    seenEdge = draft.edge;
    deviceName.setText (fromUtf8 (draft.document().value ("name", "")), juce::dontSendNotification);
    const auto isDrawn = draft.isDrawn();

    for (auto& row : rows)
        row->setVisible (isDrawn && row->refresh());

    for (auto& [button, isThere] : offers)
        button->setVisible (isThere());

    searchText.setVisible (isDrawn);

    layOut();
    repaint();
}

void DevicePanel::resized()
{
    auto area = getLocalBounds().withTrimmedTop (figuresHeight);
    auto row = area.removeFromTop (DraftRow::height).reduced (panelMargin, 0);
    modeBefore.setBounds (row.removeFromLeft (DraftRow::height));
    modeAfter.setBounds (row.removeFromRight (DraftRow::height));
    modeName.setBounds (row);
    viewport.setBounds (area.withTrimmedTop (panelGap));
    layOut();
}

void DevicePanel::layOut()
{
    const auto width = viewport.getWidth() - viewport.getScrollBarThickness();
    auto area = juce::Rectangle<int> (panelMargin, 0, std::max (0, width - panelMargin), 10000);
    page.headings.clear();

    for (const auto& section : sections)
    {
        const auto isAnyShown =
            std::any_of (section.rows.begin(), section.rows.end(), [] (const auto* row) { return row->isVisible(); })
            || std::any_of (section.buttons.begin(), section.buttons.end(),
                            [] (const auto* button) { return button->isVisible(); });

        if (! isAnyShown)
            continue;

        if (section.name.isNotEmpty())
            page.headings.emplace_back (section.name, area.removeFromTop (headingHeight).withTrimmedBottom (3));

        for (auto* const row : section.rows)
            if (row->isVisible())
                row->setBounds (area.removeFromTop (DraftRow::height));

        std::vector<juce::Component*> shown;
        std::copy_if (section.buttons.begin(), section.buttons.end(), std::back_inserter (shown),
                      [] (const auto* button) { return button->isVisible(); });

        if (shown.empty())
            continue;

        auto line = area.removeFromTop (buttonHeight + panelGap).withTrimmedTop (panelGap);
        const auto each = (line.getWidth() + panelGap) / static_cast<int> (shown.size());

        for (auto* const button : shown)
            button->setBounds (line.removeFromLeft (each).withTrimmedRight (panelGap));
    }

    page.setSize (width, area.getY() + panelMargin);
    page.repaint();
}

void DevicePanel::paint (juce::Graphics& g)
{
    g.fillAll (EditorLook::findPalette (*this).panel);
    paintFigures (g, getLocalBounds().removeFromTop (figuresHeight).reduced (panelMargin, 6));
}

/** What the present focus is on this device. */
void DevicePanel::paintFigures (juce::Graphics& g, juce::Rectangle<int> area) const
{
    const auto& palette = EditorLook::findPalette (*this);
    constexpr float large = 26, small = 11;
    const auto paintOne =
        [&] (juce::Rectangle<int> place, const juce::String& figure, const juce::String& caption, juce::Colour colour)
    {
        drawText (g, caption.toStdString(), place.removeFromBottom (16).toFloat(), juce::Justification::centredLeft,
                  { small, false, palette.mutedText });
        drawText (g, figure.toStdString(), place.toFloat(), juce::Justification::centredLeft, { large, true, colour });
    };
    constexpr double wellCaptured = 0.9;
    const auto about = picture != nullptr && ! picture->isExact ? fromUtf8 ("\xE2\x89\x88 ") : juce::String();
    const auto captured = picture != nullptr ? picture->captured.value_or (0) : 0.0; // 0: not known
    const auto volts = picture != nullptr ? picture->volts.value_or (0) : 0.0;
    const auto limit = draft.isDrawn() ? voltageLimitOf (draft.document()) : 0.0;
    const auto unknown = fromUtf8 ("\xE2\x80\x93");
    paintOne (area.removeFromLeft (area.getWidth() / 2),
              captured > 0 ? about + fromUtf8 (fixedText (100 * captured, 1)) + " %" : unknown, "captured of the focus",
              captured > 0 && captured < wellCaptured ? palette.caution : palette.text);
    paintOne (area, volts > 0 ? about + fromUtf8 (fixedText (volts, volts < 10 ? 1 : 0)) + " V" : unknown,
              "needed" + (limit > 0 ? fromUtf8 (", limit " + numberText (limit) + " V") : juce::String()),
              limit > 0 && volts > limit ? palette.warning : palette.text);
}
} // namespace antinode
