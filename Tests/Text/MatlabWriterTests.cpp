#include "Support/TemporaryFolder.h"

#include <antinode_base/InputError.h>
#include <antinode_text/MatlabWriter.h>
#include <antinode_text/OutputFolder.h>

#include <catch2/catch.hpp>

#include <matio.h>

#include <limits>
#include <memory>

using namespace antinode;

namespace
{
using File = std::unique_ptr<mat_t, decltype (&Mat_Close)>;
using Variable = std::unique_ptr<matvar_t, decltype (&Mat_VarFree)>;

/** A matrix of a file as libmatio reads it. */
MatlabMatrix readByMatio (const std::string& path, const std::string& name)
{
    const File file (Mat_Open (path.c_str(), MAT_ACC_RDONLY), &Mat_Close);
    REQUIRE (file != nullptr);
    CHECK (Mat_GetVersion (file.get()) == MAT_FT_MAT5);
    const Variable variable (Mat_VarRead (file.get(), name.c_str()), &Mat_VarFree);
    REQUIRE (variable != nullptr);
    REQUIRE (variable->rank == 2);
    REQUIRE (variable->class_type == MAT_C_DOUBLE);
    const auto rows = static_cast<Eigen::Index> (variable->dims[0]);
    const auto columns = static_cast<Eigen::Index> (variable->dims[1]);
    const auto matrix = [&] (const void* data)
    { return Eigen::MatrixXd (Eigen::Map<const Eigen::MatrixXd> (static_cast<const double*> (data), rows, columns)); };

    if (variable->isComplex == 0)
        return { name, rows * columns > 0 ? matrix (variable->data) : Eigen::MatrixXd (rows, columns), {} };

    const auto* const parts = static_cast<const mat_complex_split_t*> (variable->data);
    return { name, matrix (parts->Re), matrix (parts->Im) };
}
} // namespace

TEST_CASE ("libmatio reads the matrices of a MATLAB file, names of any length and complex numbers", "[text]")
{
    const TemporaryFolder folder;
    const auto path = (folder.path() / "a.mat").string();
    const std::vector<MatlabMatrix> written { { "a", Eigen::MatrixXd::Random (3, 5), {} },
                                              { "four", Eigen::MatrixXd::Constant (1, 1, 1e-300), {} },
                                              { "exactly8", Eigen::MatrixXd::Random (7, 1), {} },
                                              { "a_name_of_the_length_that_MATLAB_allows_at_most_63_characters_x",
                                                Eigen::MatrixXd::Random (2, 2), Eigen::MatrixXd::Random (2, 2) },
                                              { "empty", Eigen::MatrixXd (0, 4), {} } };
    writeWholeFile (path, encodeMatlabFile (written));

    for (const auto& each : written)
    {
        const auto found = readByMatio (path, each.name);
        CHECK (found.real.rows() == each.real.rows());
        CHECK (found.real.cols() == each.real.cols());
        CHECK (found.real == each.real);
        CHECK (found.imaginary == each.imaginary);
    }
}

TEST_CASE ("Numbers that are not finite are in no MATLAB file", "[text]")
{
    for (const auto wrong : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
    {
        CHECK_THROWS_AS (encodeMatlabFile ({ { "a", Eigen::MatrixXd::Constant (2, 2, wrong), {} } }), InputError);
        CHECK_THROWS_AS (
            encodeMatlabFile ({ { "a", Eigen::MatrixXd::Ones (2, 2), Eigen::MatrixXd::Constant (2, 2, wrong) } }),
            InputError);
    }
}

TEST_CASE ("A matrix that may lack numbers has NaN for them, and nothing infinite", "[text]")
{
    const TemporaryFolder folder;
    const auto path = (folder.path() / "a.mat").string();
    Eigen::MatrixXd partial = Eigen::MatrixXd::Ones (3, 1);
    partial (1, 0) = std::numeric_limits<double>::quiet_NaN();
    writeWholeFile (path, encodeMatlabFile ({ { "a", partial, {}, true } }));
    const auto found = readByMatio (path, "a").real;
    CHECK (found (0, 0) == 1);
    CHECK (std::isnan (found (1, 0)));
    partial (2, 0) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS (encodeMatlabFile ({ { "a", partial, {}, true } }), InputError);
}
