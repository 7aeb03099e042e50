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
    require (lines > 0, "have no frequency; allowed: 1 or more");
    require (points > 0, "have no point; allowed: 1 or more");
    require (! responses.references.empty(), "have no reference; allowed: 1 or more");
    require (responses.frequencies.allFinite() && responses.frequencies[0] >= 0,
             "have a frequency that is negative or not finite");
    require (responses.values.size() == responses.references.size(), "need one table of values for each reference");
    require (responses.variances.empty() || responses.variances.size() == responses.references.size(),
             "need one table of variances for each reference");

    for (Eigen::Index f = 1; f < lines; ++f)
        require (responses.frequencies[f] > responses.frequencies[f - 1], "have frequencies that do not ascend");

    for (const auto& values : responses.values)
        require (values.rows() == lines && values.cols() == points, "have a table whose size is not lines x points");

    for (const auto& variances : responses.variances)
        require (variances.rows() == lines && variances.cols() == points,
                 "have a table of variances whose size is not lines x points");

    for (const auto& reference : responses.references)
        require (! reference.point || (*reference.point >= 0 && *reference.point < points),
                 "have a reference at a point that does not exist");
}
} // namespace antinode
