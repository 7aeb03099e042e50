#include <antinode_engine/FocusEvents.h>

#include <catch2/catch.hpp>

#include <memory>
#include <utility>
#include <vector>

using namespace antinode;

namespace
{
/** Samples and places of what comes out, of events at these samples. */
std::vector<std::pair<int, int>> delayed (const std::vector<int>& samples, int block, int delay, int length)
{
    const auto line = std::make_unique<EventDelay>();
    std::vector<std::pair<int, int>> out;

    for (int done = 0; done < length; done += block)
    {
        std::vector<FocusEvent> events;

        for (std::size_t k = 0; k < samples.size(); ++k)
            if (samples[k] >= done && samples[k] < done + block)
                events.push_back ({ samples[k] - done, FocusEventKind::trigger, static_cast<int> (k), 1 });

        for (const auto& event : line->process (events, block, delay))
            out.emplace_back (done + event.offset, event.place);
    }

    return out;
}
} // namespace

TEST_CASE ("Events come out late by the delay, for all blocks", "[engine]")
{
    const std::vector<int> samples { 0, 5, 5, 63, 64, 200 };
    const std::vector<std::pair<int, int>> expected { { 100, 0 }, { 105, 1 }, { 105, 2 },
                                                      { 163, 3 }, { 164, 4 }, { 300, 5 } };

    for (const auto block : { 1, 64, 100, 512 })
        CHECK (delayed (samples, block, 100, 512) == expected);

    CHECK (delayed (samples, 64, 0, 512).front() == std::pair (0, 0));
}

TEST_CASE ("A shorter delay lets no event overtake another one", "[engine]")
{
    const auto line = std::make_unique<EventDelay>();
    const FocusEvent on { 10, FocusEventKind::trigger, 1, 1 }, off { 0, FocusEventKind::release, 1, 0 };
    CHECK (line->process ({ &on, 1 }, 64, 1000).empty());
    CHECK (line->process ({ &off, 1 }, 64, 10).empty());
    const auto out = line->process ({}, 2000, 10);
    REQUIRE (out.size() == 2);
    CHECK (out[0].kind == FocusEventKind::trigger);
    CHECK (out[0].offset == 1010 - 128);
    CHECK (out[1].offset == out[0].offset);
}

TEST_CASE ("More events than fit are left out, and a reset forgets all", "[engine]")
{
    const auto line = std::make_unique<EventDelay>();
    const std::vector<FocusEvent> many (EventDelay::mostWaiting + 7);
    CHECK (line->process (many, 1, 10).empty());
    std::size_t heard = 0;

    for (int k = 0; k < 20; ++k)
        heard += line->process ({}, 4, 10).size();

    CHECK (heard == EventDelay::mostWaiting);
    line->process (many, 1, 10);
    line->reset();
    CHECK (line->process ({}, 1000, 0).empty());
}

TEST_CASE ("A stop does not wait, and what waits then is void, for all blocks", "[engine]")
{
    for (const auto block : { 1, 64, 100, 512 })
    {
        const auto line = std::make_unique<EventDelay>();
        std::vector<std::pair<int, bool>> out; // Sample, and whether it is a stop.

        for (int done = 0; done < 1024; done += block)
        {
            std::vector<FocusEvent> events;

            for (const auto& [sample, isStopping] :
                 { std::pair (0, false), { 90, false }, { 120, true }, { 130, false } })
                if (sample >= done && sample < done + block)
                    events.push_back (
                        { sample - done, isStopping ? FocusEventKind::stopAll : FocusEventKind::trigger, 0, 1 });

            for (const auto& event : line->process (events, block, 100))
                out.emplace_back (done + event.offset, isStop (event));
        }

        CHECK (out == std::vector<std::pair<int, bool>> { { 100, false }, { 120, true }, { 230, false } });
    }
}
