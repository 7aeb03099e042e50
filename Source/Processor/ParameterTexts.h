#pragma once

#include <antinode_model/ModalModel.h>

#include <juce_core/juce_core.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace antinode
{
/** A parameter's value as text, and back: fromText reads what toText returns, and what a person types (typedNumber);
   none where that says nothing. */
struct NumberTexts
{
    std::function<juce::String (float value, int maximumLength)> toText;
    std::function<std::optional<float> (const juce::String&)> fromText;
};

struct IntegerTexts
{
    std::function<juce::String (int value, int maximumLength)> toText;
    std::function<std::optional<int> (const juce::String&)> fromText;
};

struct FlagTexts
{
    std::function<juce::String (bool value, int maximumLength)> toText;
    std::function<std::optional<bool> (const juce::String&)> fromText;
};

/** Which coordinate of a place on the surface. */
enum class SurfaceAxis
{
    x,
    y
};

/** A number with its unit. Values below `least` have a word instead. [any] */
NumberTexts unitTexts (const char* unit, int decimals, float minimum = -1e30F, const char* wordBelow = "");

/** A share of the surface in percent, as a place in mm: of the model that is played, or in percent if there is none.
    A text that ends in % is read as percent. [any but the audio thread] */
NumberTexts placeTexts (const std::function<std::shared_ptr<const ModalModel>()>& model, SurfaceAxis);

/** A count, with a word for 0. [any] */
IntegerTexts countTexts (const char* wordForNone);

/** Words, the first one for 0. [any] */
IntegerTexts wordTexts (const std::vector<juce::String>& words);

/** [any] */
FlagTexts flagTexts (const char* on, const char* off);
} // namespace antinode
