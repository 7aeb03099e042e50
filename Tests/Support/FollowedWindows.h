#pragma once

#include <antinode_session/Following.h>

#include <chrono>
#include <thread>

namespace antinode::test
{
/** Waits for windows of a followed drift while a test plays as quickly as they are followed: on a busy computer they
    take longer than what is played in them. */
class FollowedWindows
{
public:
    /** Waits for the next window where one is due. The first one takes 2 s of playing at most.
        @param seconds  that were played so far @param status  gives the FollowingStatus of now */
    template <typename Status>
    void await (double seconds, const Status& status)
    {
        constexpr auto hung = std::chrono::minutes (2);
        constexpr auto glance = std::chrono::milliseconds (10);
        constexpr double firstWithin = 2; // s
        const auto newest = [&] { return status().trace.empty() ? 0.0 : status().trace.back().time; };
        const auto isDue = newest() > 0 || seconds > firstWithin;

        for (auto waited = glance; isDue && waited < hung && isLearning (status().state) && newest() == seen;
             waited += glance)
            std::this_thread::sleep_for (glance);

        seen = newest();
    }

private:
    static bool isLearning (FollowingState state)
    {
        return state != FollowingState::frozen && state != FollowingState::impossible
               && state != FollowingState::paused;
    }

    double seen = 0; // s
};
} // namespace antinode::test
