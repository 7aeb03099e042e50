#pragma once

#include "TouchProcessor.h"

#include <vector>

namespace antinode
{
/** What Antinode Touch does just now that somebody has to wait for or to know; empty where it simply plays. [message
    thread] */
std::vector<UserMessage> touchSentences (TouchProcessor&, const TouchSnapshot&);
} // namespace antinode
