#include "Support/ErrorText.h"
#include "Support/GridModel.h"
#include "Support/SineBeam.h"
#include "Support/UniversalFileReader.h"
#include "Support/ViscousChain.h"

#include <antinode_documents/UniversalModes.h>
#include <antinode_responses/UniversalFile.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double printed = 5.1e-6; // Half a unit of the sixth digit, relative to a mantissa of 1, and rounding.
} // namespace

TEST_CASE ("Every line of a universal file has at most 80 columns of ASCII", "[files]")
{
    auto model = gridModel (3, 2);
    model.name = "Platte f\xc3\xbcr H\xc3\xa4nde \xe2\x82\xac\n" + std::string (100, 'x');

    for (const auto& line : splitLines (encodeUniversalFile (modeSets (model))))
    {
        CHECK (line.size() <= 80);
        CHECK (std::all_of (line.begin(), line.end(), [] (char c) { return c >= ' ' && c < 0x7f; }));
    }

    const auto name = "Device Platte f?r H?nde ??" + std::string (54, 'x');
    CHECK (readSets (encodeUniversalFile (modeSets (model)), 151)[0].records[0] == name);
    CHECK (readSets (encodeUniversalFile (modeSets (model)), 55)[0].records[0] == name);
}

TEST_CASE ("A universal file begins with header, SI units and nodes, and has a set a mode", "[files]")
{
    const auto text = encodeUniversalFile (modeSets (gridModel (3, 2)));
    const auto sets = readSets (text);
    REQUIRE (sets.size() > 6);
    CHECK (sets[0].number == 151);
    CHECK (sets[1].number == 164);
    CHECK (sets[2].number == 15);
    CHECK (sets[3].number == 82);
    CHECK (readSets (text, 55).size() == 3);
    CHECK (sets.back().number == 55);

    const auto& header = sets[0].records;
    REQUIRE (header.size() == 7);
    CHECK (header[0] == "Device pane");
    CHECK (header[2].starts_with ("Antinode "));
    CHECK (header[3] == std::string (20, ' ') + "         0         0         0"); // No dates: no clock.
    CHECK (header[4] == std::string (20, ' '));
    CHECK (header[5] == header[2]);

    // As other programs write it for metres and newtons.
    CHECK (sets[1].records
           == Lines { "         1SI: Meter (newton)           2",
                      "  1.00000000000000000D+00  1.00000000000000000D+00  1.00000000000000000D+00",
                      "  2.73149999999999977D+02" });
}

TEST_CASE ("Each record of a mode stands in the columns of the format", "[files]")
{
    auto model = sineBeam (2, 1);
    model.angularFrequencies << 2 * std::numbers::pi * 128, 2 * std::numbers::pi * 1024;
    model.dampingRatios << 0.005, 0.0025;
    model.shapes (0, 1) = -12.345678;
    model.shapes (1, 1) = 1e-120; // Would need an exponent of three digits.
    const auto mode = readSets (encodeUniversalFile (modeSets (model)), 55)[1].records;
    CHECK (mode[0] == "Device sine beam");
    CHECK (mode[2] == "NONE");
    CHECK (mode[3] == "Shape along z, normal to the surface, mass-normalised, kg^-1/2");
    CHECK (mode[4] == "Mode               2 Frequency  1.02400E+03");
    CHECK (mode[5] == "         1         2         2         8         2         3");
    CHECK (mode[6] == "         2         4         1         2");
    CHECK (mode[7] == "  1.02400E+03  1.00000E+00  2.50000E-03  0.00000E+00");
    CHECK (mode[8] == "         1");
    CHECK (mode[9] == "  0.00000E+00  0.00000E+00 -12.34567800");
    CHECK (mode[10] == "         2");
    CHECK (mode[11] == "  0.00000E+00  0.00000E+00  0.00000E+00");

    const auto nodes = readSets (encodeUniversalFile (modeSets (model)), 15)[0].records;
    CHECK (nodes[0] == "         1         0         0         8 -1.00000E-01  0.00000E+00  0.00000E+00");
    const auto line = readSets (encodeUniversalFile (modeSets (model)), 82)[0].records;
    CHECK (line[0] == "         1       125         8");
    CHECK (line[2] == "         1         2         3         4         5         6         7         8");
    CHECK (line.back() == "       121       122       123       124       125");
}

TEST_CASE ("A line's points and shapes are read back as they are", "[files]")
{
    const auto model = sineBeam (6, 2);
    const auto text = encodeUniversalFile (modeSets (model));
    const auto nodes = readNodes (text);
    REQUIRE (nodes.rows() == model.points());
    CHECK ((nodes.leftCols (2) - model.surface.points).cwiseAbs().maxCoeff() <= printed * 0.1);
    CHECK (nodes.col (2).isZero (0));

    const auto shapes = readShapes (text, nodes.rows());
    CHECK (((shapes - model.shapes).array().abs() <= printed * model.shapes.array().abs()).all());
    const auto edges = readEdges (text);
    CHECK (edges.size() == 400);

    for (int i = 1; i <= 400; ++i)
        CHECK (edges.contains ({ i, i + 1 }));
}

TEST_CASE ("A computed plate is sampled evenly from edge to edge, eight points a wavelength", "[files]")
{
    constexpr int modes = 6;
    const auto model = gridModel (modes, 2, 20);
    const auto text = encodeUniversalFile (modeSets (model));
    const auto nodes = readNodes (text);
    // Six half-waves along x, two along y, four steps each.
    constexpr Eigen::Index nx = 25, ny = 9;
    REQUIRE (nodes.rows() == nx * ny);
    const auto shapes = readShapes (text, nodes.rows());
    const auto amplitude = 2 / std::sqrt (2.7 * 0.2 * 0.12);

    for (Eigen::Index p = 0; p < nodes.rows(); ++p)
    {
        const auto x = 0.2 * static_cast<double> (p % nx) / (nx - 1),
                   y = 0.12 * static_cast<double> (p / nx) / (ny - 1);
        CHECK (nodes (p, 0) == Approx (x).epsilon (printed).margin (1e-12));
        CHECK (nodes (p, 1) == Approx (y).epsilon (printed).margin (1e-12));

        for (int k = 0; k < modes; ++k) // 20 places in less than four half-waves: interpolated to 2e-8.
            CHECK (shapes (p, k)
                   == Approx (amplitude * std::sin ((k + 1) * std::numbers::pi * x / 0.2)
                              * std::sin ((k % 2 + 1) * std::numbers::pi * y / 0.12))
                          .epsilon (printed)
                          .margin (1e-7));
    }

    const auto edges = readEdges (text);
    CHECK (edges.size() == (nx - 1) * ny + nx * (ny - 1));

    for (int j = 0; j < ny; ++j)
        for (int i = 1; i < nx; ++i)
            CHECK (edges.contains ({ i + j * nx, i + 1 + j * nx }));
}

TEST_CASE ("No plate has more than 4000 nodes, however rippled its modes are", "[files]")
{
    const auto nodes = readNodes (encodeUniversalFile (modeSets (gridModel (120, 1, 90))));
    CHECK (nodes.rows() <= 4000);
    CHECK (nodes.rows() > 3600);
    CHECK (nodes.col (0).maxCoeff() == 0.2);
    CHECK (nodes.col (1).maxCoeff() == 0.12);
}

TEST_CASE ("Measured points keep their places, those in rows and columns are joined", "[files]")
{
    ModalModel model = gridModel (2, 1, 2);
    model.surface.grid.reset();
    model.surface.points.row (5) << 0.15, 0.1; // One of 6 x 4 lies apart from all rows and columns.
    const auto text = encodeUniversalFile (modeSets (model));
    const auto nodes = readNodes (text);
    REQUIRE (nodes.rows() == 24);
    CHECK ((nodes.leftCols (2) - model.surface.points).cwiseAbs().maxCoeff() <= printed * 0.2);
    CHECK (((readShapes (text, 24) - model.shapes).array().abs() <= printed * model.shapes.array().abs()).all());
    const auto edges = readEdges (text);
    CHECK (edges.size() == 5 * 4 + 6 * 3 - 2);
    CHECK (std::none_of (edges.begin(), edges.end(), [] (auto edge) { return edge.first == 6 || edge.second == 6; }));
}

TEST_CASE ("A universal file with a number that is not finite is refused", "[files]")
{
    auto model = sineBeam (2, 1);
    model.shapes (3, 1) = std::numeric_limits<double>::quiet_NaN();
    CHECK (errorText ([&] { encodeUniversalFile (modeSets (model)); })
           == "universal file: has a value that is not finite");
}

TEST_CASE ("A complex mode is written with its pole, its modal A and B, and complex values", "[files][complex]")
{
    const auto model = complexModel (viscousChain (8, 3, 40));
    const auto sets = readSets (encodeUniversalFile (modeSets (model)), 55);
    REQUIRE (sets.size() == 8);
    const auto& mode = sets[1].records;
    CHECK (mode[5] == "         1         3         2         8         5         3");
    CHECK (mode[6] == "         2         6         1         2");
    const auto number = [&] (std::size_t record, std::size_t which)
    { return std::stod (mode[record].substr (13 * which, 13)); };
    const std::complex<double> pole (number (7, 0), number (7, 1)), modalA (number (7, 2), number (7, 3)),
        modalB (number (7, 4), number (7, 5));
    CHECK (std::abs (pole) == Approx (model.angularFrequencies[1]).epsilon (1e-5));
    CHECK (-pole.real() / std::abs (pole) == Approx (model.dampingRatios[1]).epsilon (1e-4));
    CHECK (std::abs (modalB + pole * modalA) < 1e-4 * std::abs (modalB));
    CHECK (modalA.imag() == Approx (2 * pole.imag()).epsilon (1e-5));
    CHECK (number (9, 4) == Approx (model.shapes (0, 1)).epsilon (1e-5));
    CHECK (number (9, 5) == Approx (model.shapes (0, 9)).epsilon (1e-5));
}
