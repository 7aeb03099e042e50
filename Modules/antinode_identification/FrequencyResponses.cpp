#include "FrequencyResponses.h"

#include <antinode_base/InputError.h>

#include <string>

namespace antinode
{
namespace
{
void require (bool fulfilled, const std::string& what)
{
    if (! fulfilled)
        throw InputError ("frequency responses", what);
}
} // namespace

void validate (const FrequencyResponses& responses)
{
    const auto lines = responses.frequencies.size(), points = responses.points.rows();
    require (lines > 0, "have no frequency, allowed is at least 1");
    require (points > 0, "have no point, allowed is at least 1");
    require (! responses.drivers.empty(), "have no driver, allowed is at least 1");
    require (responses.frequencies.allFinite() && responses.frequencies[0] >= 0,
             "have a frequency that is negative or not finite");
    require (responses.values.size() == responses.drivers.size(), "have not one table of values for each driver");
    require (responses.variances.empty() || responses.variances.size() == responses.drivers.size(),
             "have not one table of variances for each driver");

    for (Eigen::Index f = 1; f < lines; ++f)
        require (responses.frequencies[f] > responses.frequencies[f - 1], "have frequencies that do not ascend");

    for (const auto& values : responses.values)
        require (values.rows() == lines && values.cols() == points, "have a table of another size than lines x points");

    for (const auto& variances : responses.variances)
        require (variances.rows() == lines && variances.cols() == points,
                 "have a table of variances of another size than lines x points");

    for (const auto& driver : responses.drivers)
        require (! driver.point || (*driver.point >= 0 && *driver.point < points),
                 "have a driver at a point that does not exist");
}
} // namespace antinode
