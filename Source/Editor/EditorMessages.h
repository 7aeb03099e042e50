#pragma once

#include "DesignPicture.h"

#include <Processor/AntinodeProcessor.h>

#include <vector>

namespace antinode
{
/** All that the editor has to say.
    @param picture    the newest one, or none
    @param isWorking  whether a newer one is being worked out
    @param beside     what the window around has to say
    [message thread] */
std::vector<UserMessage> editorMessages (AntinodeProcessor&, const DesignPicture* picture, bool isWorking,
                                         const std::vector<UserMessage>& beside);

/** Rate, voices and triggers, beside them. [message thread] */
juce::String playedFigures (AntinodeProcessor&);
} // namespace antinode
