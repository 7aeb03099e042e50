#include <Standalone/HeadlessRun.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("another state and a jump are news, once each")
{
    FollowingReport report;
    FollowingStatus now;
    CHECK (report.news (now).empty());
    CHECK (report.summary().empty());

    now.state = FollowingState::waiting;
    CHECK (report.news (now) == "drift unknown, waiting");
    CHECK (report.news (now).empty());

    now.state = FollowingState::following;
    now.trace.push_back ({ 0.5, FollowingState::following, 0.00421, 1e-5, 0.02 });
    CHECK (report.news (now) == "drift +0.42 %, following");
    now.trace.push_back ({ 1.0, FollowingState::following, -0.00104, 1e-5, 0.02 });
    CHECK (report.news (now).empty());
    CHECK (report.summary() == "drift -0.10 %, following");

    now.reason = "All frequencies have jumped by 1 % at 1.5 s.";
    CHECK (report.news (now) == "drift -0.10 %, following: " + now.reason);
    CHECK (report.news (now).empty());
    now.reason.clear();
    CHECK (report.news (now).empty());
}

TEST_CASE ("of windows that are lost only the first is news")
{
    FollowingReport report;
    FollowingStatus now;
    now.state = FollowingState::lost;
    now.reason = "62 % are not explained.";
    CHECK (report.news (now) == "drift unknown, lost: 62 % are not explained.");
    now.reason = "63 % are not explained.";
    CHECK (report.news (now).empty());
    now.state = FollowingState::off;
    now.reason.clear();
    CHECK (report.news (now) == "following off");
    CHECK (report.summary().empty());
}
