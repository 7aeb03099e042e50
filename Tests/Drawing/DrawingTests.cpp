#include "Support/ErrorText.h"

#include <antinode_base/WholeFile.h>
#include <antinode_outline/Drawing.h>
#include <antinode_outline/PathBuilder.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;
using std::numbers::pi;

namespace
{
Outline fileOutline (const std::string& name, const DrawingChoice& choice)
{
    return readOutlineFile (std::string (ANTINODE_TEST_DATA) + "/Drawings/" + name, choice);
}

/** A page of 100 mm x 100 mm with something on it. */
std::string page (const std::string& content)
{
    return R"(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">)" + content
           + "</svg>";
}

double areaOn (const std::string& content, const DrawingChoice& choice = {})
{
    return 1e6 * areaOf (outlineFromDrawing (page (content), "drawing", choice)); // mm^2
}

/** The area between a cubic curve and the straight line through its ends, by the shoelace formula of its control
   points: J. Gravesen's, 3/20 of a sum of cross products. */
double areaUnder (const std::array<Eigen::Vector2d, 4>& p)
{
    const auto cross = [&] (std::size_t a, std::size_t b) { return p[a].x() * p[b].y() - p[a].y() * p[b].x(); };
    return 0.05
           * (6 * cross (0, 1) + 3 * cross (0, 2) + cross (0, 3) + 3 * cross (1, 2) + 3 * cross (1, 3)
              + 6 * cross (2, 3));
}
} // namespace

TEST_CASE ("Shapes of SVG have their areas, in mm, and lie upwards from the page's lower left corner", "[drawing]")
{
    const auto circle = outlineFromDrawing (page (R"(<circle cx="30" cy="20" r="10"/>)"), "drawing", {});
    CHECK (areaOf (circle) == Approx (100e-6 * pi).epsilon (1e-12));
    CHECK (circle.contains (0.03, 0.08));
    CHECK (extentOf (circle).least.y() == Approx (0.07).epsilon (1e-12));

    CHECK (areaOn (R"(<ellipse cx="50" cy="50" rx="20" ry="10"/>)") == Approx (200 * pi).epsilon (1e-12));
    CHECK (areaOn (R"(<rect x="1" y="2" width="50" height="20"/>)") == Approx (1000).epsilon (1e-12));
    CHECK (areaOn (R"(<rect x="1" y="2" width="50" height="20" ry="4" rx="5"/>)")
           == Approx (1000 - (4 - pi) * 20).epsilon (1e-12));
    CHECK (areaOn (R"(<rect width="50" height="20" rx="70"/>)") == Approx (1000 - (4 - pi) * 250).epsilon (1e-12));
    CHECK (areaOn (R"(<polygon points="10,10 40,10 40 70+10 ,70"/>)") == Approx (1800).epsilon (1e-12));
    CHECK (areaOn (R"(<path d="M10,10h30v20H10z m5 5v5h5v-5z"/>)") == Approx (575).epsilon (1e-12));
    CHECK (areaOn (R"(<path d="M40 50A10 10 0 1160 50 10 10 0 1140 50"/>)") == Approx (100 * pi).epsilon (1e-12));
    CHECK (areaOn (R"(<path d="M10 10 a1 1 0 0 0 20 0z"/>)") == Approx (50 * pi).epsilon (1e-12)); // Radii too small.
}

TEST_CASE ("Transforms of groups and shapes multiply, and arcs stay arcs under them", "[drawing]")
{
    CHECK (
        areaOn (
            "<g transform='translate(50 50) rotate(30)'><g transform='scale(2,.5)skewX(20)'><circle r='10'/></g></g>")
        == Approx (100 * pi).epsilon (1e-12));
    const auto turned = outlineFromDrawing (
        page ("<rect transform='rotate(-90, 10, 90)' x='10' y='90' width='20' height='10'/>"), "drawing", {});
    CHECK (turned.contains (0.015, 0.029)); // Upwards on the page from (10, 10).
    CHECK_FALSE (turned.contains (0.021, 0.015));
    CHECK (areaOn ("<circle transform='matrix(0 -1 1 0 50 50)' r='10'/>") == Approx (100 * pi).epsilon (1e-12));
}

TEST_CASE ("The unit of an SVG drawing follows from its page, or is given", "[drawing]")
{
    const auto area = [] (const std::string& size, double unit)
    {
        DrawingChoice choice;
        choice.unit = unit;
        return 1e6
               * areaOf (outlineFromDrawing ("<svg " + size + R"(><rect width="1" height="1"/></svg>)", "x", choice));
    };
    CHECK (area (R"(width="10cm" height="5cm" viewBox="0 0 10 5")", 0) == Approx (100).epsilon (1e-12));
    CHECK (area (R"(width="2in" height="2in" viewBox="-1 -1 4 4")", 0) == Approx (12.7 * 12.7).epsilon (1e-12));
    CHECK (area (R"(width="72pt" height="144pt" viewBox="0 0 1 1")", 0) == Approx (25.4 * 25.4).epsilon (1e-12));
    CHECK (area (R"(width="10mm" height="20mm" viewBox="0 0 1 1" preserveAspectRatio="none")", 0)
           == Approx (200).epsilon (1e-12));
    CHECK (area (R"(width="300" height="300")", 1e-3) == Approx (1).epsilon (1e-12));
}

TEST_CASE ("Bezier curves that stand for parts of a circle become those, others arcs within a micrometre", "[drawing]")
{
    const auto* const circle = "M50,40 c5.522847498,0 10,4.477152502 10,10 s-4.477152502,10 -10,10 "
                               "-10,-4.477152502 -10,-10 4.477152502,-10 10,-10z";
    const auto round = outlineFromDrawing (page ("<path d=\"" + std::string (circle) + "\"/>"), "x", {});
    CHECK (areaOf (round) == Approx (100e-6 * pi).epsilon (1e-9));
    CHECK (lengthOfEdge (round, 0) == Approx (0.01 * pi / 2).epsilon (1e-9));

    const std::array<Eigen::Vector2d, 4> points { { { 10, 10 }, { 60, -10 }, { 20, 90 }, { 90, 20 } } };
    const auto free = outlineFromDrawing (page (R"(<path d="M10 10 C60 -10 20 90 90 20 L90 95 L10 95 Z"/>)"), "x", {});
    std::vector<Eigen::Vector2d> corners { { 10, 10 }, { 90, 20 }, { 90, 95 }, { 10, 95 } };
    double lines = 0;

    for (std::size_t i = 1; i < 4; ++i)
    {
        const auto &a = corners[i], &b = corners[(i + 1) % 4];
        lines += (a.x() * b.y() - a.y() * b.x()) / 2;
    }

    CHECK (1e6 * areaOf (free) == Approx (lines + areaUnder (points)).margin (2e-3 * 100));

    for (int i = 0; i <= 1000; ++i)
    {
        const auto t = i / 1000.0, s = 1 - t;
        const Eigen::Vector2d place =
            s * s * s * points[0] + 3 * s * s * t * points[1] + 3 * s * t * t * points[2] + t * t * t * points[3];
        REQUIRE (distanceToBoundary (free, place.x() / 1000, 0.1 - place.y() / 1000) < 1.05e-6);
    }

    // Smooth where the curve is: only its ends and the corners bend.
    int bends = 0;
    const auto& path = free.paths.front();

    for (std::size_t i = 0; i < path.size(); ++i)
    {
        const auto& next = path[(i + 1) % path.size()];
        const Eigen::Vector2d in = path[i].derivative (path[i].to) * (path[i].to < path[i].from ? -1 : 1);
        const Eigen::Vector2d out = next.derivative (next.from) * (next.to < next.from ? -1 : 1);
        bends += in.normalized().dot (out.normalized()) < 1 - 1e-6 ? 1 : 0;
    }

    CHECK (bends == 4);
    CHECK (path.size() < 100);
}

TEST_CASE ("Drawings of Inkscape and ezdxf give the plate that was drawn", "[drawing]")
{
    DrawingChoice millimetres;
    millimetres.unit = 1e-3;
    // The free curve: two cubic curves from (150, 30) over (175, 60) and back.
    const auto free = std::abs (areaUnder ({ { { 150, 30 }, { 170, 30 }, { 160, 50 }, { 175, 60 } } })
                                + areaUnder ({ { { 175, 60 }, { 190, 70 }, { 140, 70 }, { 150, 30 } } }));
    const auto area = 190 * 130 - (4 - pi) * 100 - (64 + 50 + 100) * pi - free;

    for (const auto& outline : { fileOutline ("inkscape.svg", {}), fileOutline ("inkscape.dxf", millimetres) })
    {
        CHECK (outline.paths.size() == 5);
        CHECK (1e6 * areaOf (outline) == Approx (area).margin (0.2)); // The path along all edges is 800 mm long.
        CHECK ((extentOf (outline).least - Eigen::Vector2d (0.01, 0.01)).norm() < 1e-6);
        CHECK ((extentOf (outline).largest - Eigen::Vector2d (0.2, 0.14)).norm() < 1e-6);
    }

    DrawingChoice choice;
    choice.layer = "Outline";
    const auto plate = 200 * 140 - (4 - pi) * 100 - 64 * pi - 300 - 25 * pi;
    CHECK (1e6 * areaOf (fileOutline ("ezdxf-R2000.dxf", choice)) == Approx (plate - pi * 84.5).epsilon (1e-9));
    choice.unit = 1e-3;
    CHECK (1e6 * areaOf (fileOutline ("ezdxf-R12.dxf", choice)) == Approx (plate).epsilon (1e-6));
}

TEST_CASE ("Layers, groups and elements are chosen by name, and what is hidden is not read", "[drawing]")
{
    const std::string drawing = R"(<g id="layer1" inkscape:label="Outline"><circle cx="50" cy="50" r="40"/>
        <circle id="camera" cx="50" cy="50" r="5"/></g>
        <g id="layer2" inkscape:label="Sketch"><path d="M0 0 L100 100"/></g>
        <g style="display: none"><path d="M0 0 L100 100"/></g><text>Plate</text>)";
    DrawingChoice choice;

    for (const auto* name : { "Outline", "layer1" })
    {
        choice.layer = name;
        CHECK (areaOn (drawing, choice) == Approx (1575 * pi).epsilon (1e-12));
    }

    choice.layer = "camera";
    CHECK (areaOn (drawing, choice) == Approx (25 * pi).epsilon (1e-12));
    choice.layer = "Outlines";
    CHECK_THAT (errorText ([&] { areaOn (drawing, choice); }), Catch::Contains ("did you mean 'Outline'"));
}

TEST_CASE ("Loose lines and arcs are joined in whatever order and direction they were drawn", "[drawing]")
{
    const std::string loose = R"(<path d="M20 10 H80"/><path d="M90 80.004 V20.003"/>
        <path d="M80 10 A10 10 0 0 1 90 20"/><path d="M80 90 A10 10 0 0 0 90 80"/><line x1="80" y1="90" x2="20" y2="90"/>
        <polyline points="20,10 10,20 10,80 20,90"/>)";
    CHECK (areaOn (loose) == Approx (6400 - 100 - 2 * 25 * (4 - pi)).epsilon (1e-4));
    DrawingChoice choice;
    choice.joint = 1e-6;
    CHECK_THAT (errorText ([&] { areaOn (loose, choice); }), Catch::Contains ("is open at (90, 20) mm, 0.00"));
}

TEST_CASE ("Edges count from the outer path on, one for every line, arc or curve", "[drawing]")
{
    const auto outline = outlineFromDrawing (
        page (R"(<circle cx="50" cy="50" r="5"/><rect x="10" y="20" width="80" height="60" rx="8"/>)"), "x", {});
    CHECK (lengthOfEdge (outline, 0) == Approx (0.064)); // The rectangle's upper side, at which SVG begins.
    CHECK (lengthOfEdge (outline, 1) == Approx (0.004 * pi));
    CHECK (lengthOfEdge (outline, 2) == Approx (0.044));
    CHECK (lengthOfEdge (outline, 8) == Approx (0.01 * pi));
    CHECK (lengthOfEdge (outline, 9) == 0);
}
