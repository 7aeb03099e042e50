#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

#include <map>
#include <string>
#include <vector>

namespace antinode
{
/** A value in the unit of the parameter's text, to the bit. [any] */
double parameterValue (const juce::RangedAudioParameter&);

/** Sets what parameterValue gave, to the bit; values beyond the range to its end, one that is not finite
   not at all. Tells the host where it changes. [any
    but the audio thread] */
void setValue (juce::RangedAudioParameter&, double value);

/** The values of all by identifier. [any] */
std::map<std::string, double> parameterValues (const std::vector<juce::RangedAudioParameter*>&);

/** Sets all: those that are not named to their defaults. [any but the audio thread] */
void setParameterValues (const std::vector<juce::RangedAudioParameter*>&, const std::map<std::string, double>& named);
} // namespace antinode
