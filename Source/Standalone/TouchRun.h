#pragma once

#include "HeadlessRun.h"
#include "TouchHost.h"

namespace antinode
{
/** Antinode Touch without windows, from when its filters are designed. */
class TouchRun : public HeadlessRun
{
public:
    /** As HeadlessRun. [message thread] */
    TouchRun (TouchHost& hostToPlay, double seconds, bool isArmed)
        : HeadlessRun (hostToPlay, seconds, isArmed), touch (hostToPlay)
    {
    }

private:
    bool isReady() override;
    std::string waitingFor() const override;
    std::string designsText() const override;
    std::string playedText() override;

    TouchHost& touch;
};
} // namespace antinode
