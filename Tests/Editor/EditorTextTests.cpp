#include "EditorFixture.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/DesignFocus.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
void checkWidth (const juce::Component& component, const juce::Font& font, const juce::String& text, int room)
{
    INFO ("\"" << text << "\" needs " << font.getStringWidth (text) << " pixels, has " << room << ", in "
               << component.getTitle() << component.getName() << component.getComponentID());
    CHECK (font.getStringWidth (text) <= room);
    CHECK (static_cast<float> (component.getHeight()) >= font.getHeight());
}

/** What JUCE would shorten. */
void checkText (juce::Component& component)
{
    if (auto* const label = dynamic_cast<juce::Label*> (&component))
        checkWidth (*label, label->getFont(), label->getText(),
                    label->getWidth() - label->getBorderSize().getLeftAndRight());
    else if (auto* const toggle = dynamic_cast<juce::ToggleButton*> (&component))
        checkWidth (*toggle, EditorLook::font (EditorLook::smallTextHeight), toggle->getButtonText(),
                    toggle->getWidth() - 38);
    else if (auto* const button = dynamic_cast<juce::TextButton*> (&component))
        checkWidth (*button, EditorLook::font(), button->getButtonText(), button->getWidth() - 8);
}

void checkAllTexts (EditorFixture& test, int width, int height)
{
    INFO (width << " x " << height);
    test.snapshot (width, height);

    for (const auto* const panel :
         { "Controls", "Spectrum", "Probe", "Voltages", "Methods", "Bank", "Scores", "Drift", "Settings" })
    {
        test.content().showPanel (panel);
        test::forEachShown (test.content(), checkText);
    }
}
} // namespace

TEST_CASE ("No text is cut off at any size")
{
    EditorFixture test;
    checkAllTexts (test, 640, 400);
    checkAllTexts (test, 800, 500);
    checkAllTexts (test, 1080, 600);
    checkAllTexts (test, 1280, 800);
    checkAllTexts (test, 2560, 1440);
}

TEST_CASE ("All words that a parameter can have fit into its control")
{
    EditorFixture test;
    test.snapshot (800, 500);
    test.content().showPanel ("Controls");

    for (auto* const parameter : test.processor.parameters().all())
        for (const auto share : { 0.0f, 0.12345f, 0.5f, 1.0f })
        {
            parameter->setValueNotifyingHost (share);
            test.content().refresh (0);
            test::forEachShown (test.content().parameterPanel(), checkText);
        }
}

TEST_CASE ("Of a focus with a level the velocity that was found is shown, until one is chosen")
{
    EditorFixture test;
    test.snapshot (800, 500);
    test.content().showPanel ("Controls");
    auto document = loadDocument (LibraryKind::focus, "demonstrator");
    auto& target = document["targets"][0];
    target.erase ("peak_velocity_mm_s");
    target["peak_level_dB_SL"] = 20;
    test.processor.load (nullptr, std::make_shared<const FocusDocument> (readFocusDocument (document, "felt")));
    test.settle();
    const auto shown = [&]
    {
        for (const auto& control : test.content().parameterPanel().controls())
            if (auto* const bar = dynamic_cast<juce::Slider*> (&control->control());
                bar != nullptr && bar->getComponentID() == "peak_velocity")
                return bar->getTextFromValue (bar->getValue());

        return juce::String();
    };
    const auto snapshot = test.processor.session().snapshot();
    const auto described = readFocus (document, "felt");
    const auto design = designFocus (*snapshot->model, described, snapshot->playback);
    CHECK (shown().toStdString()
           == inWords (milli * design.description.targets.front().peakVelocity) + " mm/s: 20 dB SL");
    test::forEachShown (test.content().parameterPanel(), checkText);
    auto* const velocity = test.processor.parameters().ofFocus()[4];
    REQUIRE (velocity->getParameterID() == "peak_velocity");
    velocity->setValueNotifyingHost (0.5f);
    test.content().refresh (0.016);
    CHECK (shown() == velocity->getCurrentValueAsText());
    test.settle();
    CHECK (shown() == velocity->getCurrentValueAsText());
}

TEST_CASE ("The browser's texts fit")
{
    EditorFixture test;

    for (const auto width : { 800, 1280 })
    {
        test.snapshot (width, width * 5 / 8);
        test.content().browse (LibraryKind::device);
        test::forEachShown (test.content().presetPanel(), checkText);
        test.content().browse (std::nullopt);
    }
}
