#include <antinode_base/InputError.h>
#include <antinode_identification/FrequencyResponses.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
FrequencyResponses twoLines()
{
    FrequencyResponses responses;
    responses.frequencies = Eigen::Vector2d (10, 20);
    responses.references = { { "C1", {} } };
    responses.points = Eigen::RowVector2d (0, 0);
    responses.values = { Eigen::MatrixXcd::Ones (2, 1) };
    return responses;
}
} // namespace

TEST_CASE ("Frequency responses whose sizes agree are valid, whatever was not measured")
{
    auto responses = twoLines();
    CHECK_NOTHROW (validate (responses));

    responses.values[0](1, 0) = std::numeric_limits<double>::quiet_NaN();
    CHECK_NOTHROW (validate (responses));
}

TEST_CASE ("Frequency responses name what is wrong with them")
{
    auto responses = twoLines();

    SECTION ("frequencies that do not ascend")
    {
        responses.frequencies[1] = 10;
        CHECK_THROWS_WITH (validate (responses), Catch::Contains ("do not ascend"));
    }

    SECTION ("a table of another size")
    {
        responses.values[0].resize (3, 1);
        CHECK_THROWS_WITH (validate (responses), Catch::Contains ("whose size is not lines x points"));
    }

    SECTION ("a force at a point that does not exist")
    {
        responses.references[0].point = 1;
        CHECK_THROWS_WITH (validate (responses), Catch::Contains ("point that does not exist"));
    }
}
