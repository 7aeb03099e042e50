#include "Support/ErrorText.h"

#include <antinode_outline/Drawing.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;
using std::numbers::pi;

namespace
{
/** Codes and values by lines, of entities in mm. */
std::string dxf (const std::string& entities, const std::string& unit = "4")
{
    return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + unit + "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities
           + "0\nENDSEC\n0\nEOF\n";
}

double areaOfDxf (const std::string& entities, const std::string& unit = "4")
{
    return 1e6 * areaOf (outlineFromDrawing (dxf (entities, unit), "drawing", {})); // mm^2
}

std::string line (int x1, int y1, int x2, int y2)
{
    return "0\nLINE\n8\n0\n10\n" + std::to_string (x1) + "\n20\n" + std::to_string (y1) + "\n11\n" + std::to_string (x2)
           + "\n21\n" + std::to_string (y2) + "\n";
}

std::string circle (const std::string& more = "")
{
    return "0\nCIRCLE\n8\n0\n10\n50\n20\n50\n40\n10\n" + more;
}

/** Half of a circle of radius 10 about (50, 50), from below to above. */
const std::string halfCircle = "0\nARC\n8\n0\n10\n50\n20\n50\n40\n10\n50\n-90\n51\n90\n";

/** What a drawing in SVG or DXF does wrong, and words of the sentence that is due. */
struct DrawingFault
{
    std::string bytes, words;
};

std::string svg (const std::string& content)
{
    return R"(<svg width="100mm" height="100mm" viewBox="0 0 100 100">)" + content + "</svg>";
}
} // namespace

TEST_CASE ("Entities of DXF have their areas, in mm", "[drawing]")
{
    CHECK (areaOfDxf (circle()) == Approx (100 * pi).epsilon (1e-12));
    CHECK (areaOfDxf (circle(), "1") == Approx (100 * pi * 25.4 * 25.4).epsilon (1e-12));
    CHECK (areaOfDxf (line (50, 60, 0, 60) + halfCircle + line (0, 60, 0, 40) + line (0, 40, 50, 40))
           == Approx (1000 + 50 * pi).epsilon (1e-12));
    CHECK (areaOfDxf ("0\nELLIPSE\n10\n0\n20\n0\n11\n3\n21\n4\n40\n0.5\n41\n0\n42\n6.283185307179586\n")
           == Approx (12.5 * pi).epsilon (1e-12));
    // Half of one, and its axis.
    CHECK (areaOfDxf ("0\nELLIPSE\n10\n0\n20\n0\n11\n4\n21\n0\n40\n0.5\n41\n0\n42\n3.141592653589793\n"
                      + line (-4, 0, 4, 0))
           == Approx (4 * pi).epsilon (1e-9));
    // A stadium: two straight sides and two half circles, as both kinds of polylines.
    CHECK (
        areaOfDxf (
            "0\nLWPOLYLINE\n90\n4\n70\n1\n10\n0\n20\n0\n10\n30\n20\n0\n42\n1\n10\n30\n20\n10\n10\n0\n20\n10\n42\n1\n")
        == Approx (300 + 25 * pi).epsilon (1e-12));
    CHECK (areaOfDxf ("0\nPOLYLINE\n66\n1\n70\n1\n0\nVERTEX\n10\n0\n20\n0\n0\nVERTEX\n10\n30\n20\n0\n42\n1\n"
                      "0\nVERTEX\n10\n30\n20\n10\n0\nVERTEX\n10\n0\n20\n10\n42\n1\n0\nSEQEND\n")
           == Approx (300 + 25 * pi).epsilon (1e-12));
}

TEST_CASE ("What is seen from behind is mirrored, as DXF has it", "[drawing]")
{
    const auto mirrored = outlineFromDrawing (dxf (circle ("210\n0\n220\n0\n230\n-1\n")), "x", {});
    CHECK (mirrored.contains (-0.05, 0.05));
    CHECK_FALSE (mirrored.contains (0.05, 0.05));
}

TEST_CASE ("A rational spline that is a circle has its area, and arcs lie on it within a micrometre", "[drawing]")
{
    // Nine control points on a square: Piegl and Tiller, The NURBS Book, example 7.2.
    const std::array<Eigen::Vector2d, 9> points {
        { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { -1, -1 }, { 0, -1 }, { 1, -1 }, { 1, 0 } }
    };
    std::string text = "0\nSPLINE\n8\n0\n70\n12\n71\n2\n";

    for (const auto knot : { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 })
        text += "40\n" + std::to_string (knot) + "\n";

    for (std::size_t i = 0; i < points.size(); ++i)
        text += "10\n" + std::to_string (40 * points[i].x()) + "\n20\n" + std::to_string (40 * points[i].y()) + "\n41\n"
                + (i % 2 == 0 ? "1" : "0.70710678118654752") + "\n";

    const auto outline = outlineFromDrawing (dxf (text), "x", {});
    CHECK (1e6 * areaOf (outline) == Approx (1600 * pi).epsilon (1e-4));

    for (int i = 0; i < 360; ++i)
        REQUIRE (distanceToBoundary (outline, 0.04 * std::cos (i * pi / 180), 0.04 * std::sin (i * pi / 180))
                 < 1.05e-6);
}

TEST_CASE ("Every fault of a drawing has one sentence that says what is wrong and what is allowed", "[drawing]")
{
    const std::vector<DrawingFault> faults {
        { "", "has no section ENTITIES" },
        { "hello\nworld\n", "'hello' stands there" },
        { "\x1f\x8b", "is compressed" },
        { "AutoCAD Binary DXF\r\n", "is a binary DXF file" },
        { dxf (circle(), "0"), "does not say its unit" },
        { dxf (circle(), "9999"), "does not say its unit" },
        { dxf (""), "shows no closed path" },
        { dxf (line (0, 0, 1, 1)), "is open at (0, 0) mm" },
        { dxf (line (0, 0, 9, 0) + line (9, 0, 9, 9) + line (9, 9, 0, 0) + line (0, 0, 5, 5)),
          "3 ends meet at (0, 0) mm" },
        { dxf (circle() + circle()), "cross or touch" },
        { dxf (circle() + "0\nCIRCLE\n10\n500\n20\n50\n40\n1\n"), "hole 1 lies outside" },
        { dxf ("0\nCIRCLE\n10\n50\n20\n50\n40\n-1\n"), "has a radius of -1; allowed: above 0" },
        { dxf ("0\nCIRCLE\n10\n50\n20\nx\n40\n1\n"), "'x' stands in group 20; allowed: a number" },
        { dxf ("0\nCIRCLE\n10\n1e9\n20\n0\n40\n1\n"), "farther than 1000 m" },
        { dxf (circle ("210\n1\n220\n0\n230\n0\n")), "lies in a plane of its own" },
        { dxf (circle() + "0\nINSERT\n2\nBLOCK\n"), "INSERT in line" },
        { dxf ("0\nSPLINE\n71\n3\n11\n0\n21\n0\n"), "has no control points" },
        { dxf ("0\nSPLINE\n71\n3\n40\n0\n10\n0\n20\n0\n"), "has 1 control points, 1 knots and degree 3" },
        { "<svg", "is not XML" },
        { "<html/>", "its first element is 'html'" },
        { "<svg><circle r=\"1\"/></svg>", "has no viewBox" },
        { R"(<svg width="100px" height="100" viewBox="0 0 1 1"><circle r="1"/></svg>)", "width is '100px'" },
        { R"(<svg width="100mm" height="100mm" viewBox="0 0 0 1"/>)", "viewBox is '0 0 0 1'" },
        { svg (""), "shows no closed path" },
        { svg (R"(<path d="M0 0 L10 0 10 10"/>)"), "is open at (0, 100) mm" },
        { svg (R"(<path id="a" d="M0 0 L10 0 x"/>)"), "path 'a': has no SVG path where" },
        { svg (R"(<path d="L10 0"/>)"), "has no SVG path where" },
        { svg (R"(<path d="M0 0 L10 1e999"/>)"), "has no SVG path where '1e999'" },
        { svg (R"(<path d="M0 0 L30 30 30 0 0 30z"/>)"), "crosses or touches itself at (15, 85) mm" },
        { svg (R"(<circle r="1cm"/>)"), "r is '1cm'; allowed: a number without unit" },
        { svg ("<g transform='turn(3)'><circle r='1'/></g>"), "transform is 'turn(3)'" },
        { svg (R"(<polygon points="1 2 3"/>)"), "points are not a list of pairs" },
        { svg (R"(<use href="#a"/>)"), "is a clone" },
    };

    for (const auto& fault : faults)
    {
        const auto sentence = errorText ([&] { outlineFromDrawing (fault.bytes, "plate", {}); });
        CHECK_THAT (sentence, Catch::Contains (fault.words) && Catch::StartsWith ("plate: "));
        CHECK (sentence.find ('\n') == std::string::npos);
    }
}
