#include "ContentEditor.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/Library.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
namespace
{
constexpr auto schema = "antinode.editor/1";

std::optional<std::filesystem::path> preferencesFile()
{
    const auto folder = userConfigFolder();
    return folder ? std::optional (*folder / "editor.json") : std::nullopt;
}
} // namespace

EditorPreferences readPreferences()
{
    const auto file = preferencesFile();
    std::error_code ignored;

    if (file)
        removeAbandoned (file->parent_path());

    if (! file || ! std::filesystem::exists (*file, ignored))
        return {};

    try
    {
        const auto json = readJsonFile (*file);
        const JsonValue value (json, file->string());
        value.requireSchema (schema);
        const auto object = value.object ({ "schema", "theme", "scale" });
        const auto scale = object.optional ("scale");
        return { object.required ("theme").choice (themeWords), scale ? scale->number (scaleRange) : 0 };
    }
    catch (const InputError&)
    {
        return {}; // It is rewritten with the next choice.
    }
}

void keepPreferences (const EditorPreferences& preferences)
{
    const auto file = preferencesFile();

    if (! file)
        return;

    nlohmann::ordered_json json { { "schema", schema }, { "theme", wordFor (themeWords, preferences.isDark) } };

    if (preferences.scale > 0)
        json["scale"] = preferences.scale;

    try
    {
        writeWholeFile (*file, json.dump (2) + "\n");
    }
    catch (const InputError&)
    {
        // A home that cannot be written to is no reason to disturb a host.
    }
}

ContentEditor::ContentEditor (juce::AudioProcessor& processorToShow, std::unique_ptr<WindowContent> content)
    : AudioProcessorEditor (processorToShow), shown (std::move (content))
{
    const auto& shape = shown->shape();
    addAndMakeVisible (*shown);
    setResizable (true, true);
    setResizeLimits (shape.sizes.leastWidth / 2, shape.sizes.leastHeight / 2, shape.usualWidth * 3,
                     shape.usualHeight * 3);
    setSize (shape.usualWidth, shape.usualHeight);
}

void ContentEditor::setContentScale (double wanted)
{
    wantedScale = wanted;
    resized();
}

void ContentEditor::resized()
{
    const auto scale = windowScale (getWidth(), getHeight(), shown->shape().sizes, wantedScale);
    shown->setTransform (juce::AffineTransform::scale (static_cast<float> (scale)));
    shown->setBounds (0, 0, juce::roundToInt (getWidth() / scale), juce::roundToInt (getHeight() / scale));
}

void ContentEditor::parentHierarchyChanged()
{
    if (getPeer() == nullptr)
        stopTimer();
    else if (! isTimerRunning())
    {
        lastTime = juce::Time::getMillisecondCounterHiRes();
        startTimerHz (shown->shape().framesPerSecond);
    }
}

void ContentEditor::timerCallback()
{
    const auto now = juce::Time::getMillisecondCounterHiRes();
    shown->refresh ((now - lastTime) / 1000);
    lastTime = now;
}

void showAsLeft (ContentEditor& editor)
{
    auto& content = editor.content();
    const auto preferences = readPreferences();
    content.setDark (preferences.isDark);
    editor.setContentScale (preferences.scale);
    content.onTheme = [&content] { keepPreferences ({ content.isDark(), readPreferences().scale }); };
}
} // namespace antinode
