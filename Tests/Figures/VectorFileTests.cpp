#include "Charts/ExampleCharts.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_reports/CairoContext.h>
#include <antinode_reports/ChartFile.h>
#include <antinode_reports/Drawing.h>
#include <antinode_reports/Report.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace antinode;
using namespace antinode::example_charts;

namespace
{
constexpr int width = 600, height = 400;

/** What Cairo draws into pixels. */
juce::Image drawnByCairo (const Chart& chart)
{
    const CairoSurface surface (cairo_image_surface_create (CAIRO_FORMAT_RGB24, width, height));
    const CairoDrawing drawing (cairo_create (surface.get()));
    CairoContext context (drawing.get());
    juce::Graphics g (context);
    draw (g, juce::Rectangle<int> (width, height).toFloat(), chart, Theme::print());
    cairo_surface_flush (surface.get());
    juce::Image image (juce::Image::RGB, width, height, true, juce::SoftwareImageType());

    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
        {
            const auto* pixel = cairo_image_surface_get_data (surface.get())
                                + y * cairo_image_surface_get_stride (surface.get()) + 4 * x;
            image.setPixelAt (x, y, juce::Colour (pixel[2], pixel[1], pixel[0]));
        }

    return image;
}

juce::Image drawnByJuce (const Chart& chart)
{
    auto image = blankImage (width, height, 1, Theme::print().background);
    juce::Graphics g (image);
    draw (g, juce::Rectangle<int> (width, height).toFloat(), chart, Theme::print());
    return image;
}

/** Of the brightness of all pixels, 0 to 1. */
double meanDifference (const juce::Image& a, const juce::Image& b)
{
    double sum = 0;

    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum += std::abs (static_cast<double> (a.getPixelAt (x, y).getPerceivedBrightness()
                                                  - b.getPixelAt (x, y).getPerceivedBrightness()));

    return sum / (width * height);
}

bool contains (const std::string& text, const std::string& part)
{
    return text.find (part) != std::string::npos;
}
} // namespace

TEST_CASE ("Cairo draws every kind of chart as JUCE does", "[figures]")
{
    const auto charts = everyKind();

    for (std::size_t i = 0; i < charts.size(); ++i)
    {
        CAPTURE (i);
        const auto cairo = drawnByCairo (charts[i]), juce = drawnByJuce (charts[i]);

        // Edges and text are smoothed in other ways; another chart differs ten times as much.
        CHECK (meanDifference (cairo, juce) < 0.012);
        CHECK (meanDifference (cairo, drawnByJuce (charts[(i + 1) % charts.size()])) > 0.03);
    }
}

TEST_CASE ("A figure for print is a file of lines and text with its fonts, the same on every run", "[figures]")
{
    const auto charts = everyKind();
    std::vector<std::string> svg (charts.size()), pdf (charts.size());
    parallelFor (charts.size(),
                 [&] (std::size_t i)
                 {
                     svg[i] = renderVector (charts[i], width, height, VectorFormat::svg);
                     pdf[i] = renderVector (charts[i], width, height, VectorFormat::pdf);
                 });

    for (std::size_t i = 0; i < charts.size(); ++i)
    {
        CAPTURE (i);
        const auto xml = juce::parseXML (juce::String::fromUTF8 (svg[i].c_str()));
        REQUIRE (xml != nullptr);
        CHECK (xml->hasTagName ("svg"));
        CHECK (contains (svg[i], "<path"));
        CHECK (pdf[i].starts_with ("%PDF-1."));
        CHECK (contains (pdf[i], "%%EOF"));
        CHECK (contains (pdf[i], "DejaVuSans"));
        CHECK (contains (pdf[i], "/FontFile2"));
        const auto again = renderVector (charts[i], width, height, VectorFormat::svg);
        CHECK (svg[i] == again);
        CHECK (pdf[i] == renderVector (charts[i], width, height, VectorFormat::pdf));
    }
}

TEST_CASE ("900 pixels are 180 mm of a page", "[figures]")
{
    const auto svg = renderVector (lines(), 900, 450, VectorFormat::svg);
    const auto xml = juce::parseXML (juce::String::fromUTF8 (svg.c_str()));
    REQUIRE (xml != nullptr);
    CHECK (xml->getStringAttribute ("width").endsWith ("pt"));
    CHECK (xml->getDoubleAttribute ("width") == Approx (180 / 25.4 * 72).epsilon (1e-5));
    CHECK (xml->getDoubleAttribute ("height") == Approx (90 / 25.4 * 72).epsilon (1e-5));
    CHECK_THROWS_AS (renderVector (lines(), 10, 450, VectorFormat::svg), InputError);
    CHECK_THROWS_AS (renderVector (lines(), 900, 9000, VectorFormat::pdf), InputError);
}

TEST_CASE ("Figures are named after their section and their place in it", "[figures]")
{
    ReportPage page;
    page.sections = { { "Field at the focus", {}, { { "", "", lines() }, { "", "", bars() } }, {} },
                      { "Modes (1-3), all", {}, { { "", "", lines() } }, {} } };
    const auto figures = namedFigures (page);
    REQUIRE (figures.size() == 3);
    CHECK (figures[0].name == "figure-field-at-the-focus-1");
    CHECK (figures[1].name == "figure-field-at-the-focus-2");
    CHECK (figures[2].name == "figure-modes-1-3-all-1");
}

TEST_CASE ("A report for print has as many sheets as it needs, with its figures and the head of its table on each",
           "[figures]")
{
    const auto sheetsOf = [] (const std::string& pdf)
    {
        const auto pages = pdf.find ("/Count ", pdf.find ("/Type /Pages"));
        return std::stoi (pdf.substr (pages + 7));
    };
    ReportPage page;
    page.title = "A page of one sheet";
    page.sections = { { "Numbers", { "First." }, {}, { { "Modes", { "mode", "in words" }, { { "1", "one" } } } } } };
    const auto one = renderReportPdf (page);
    CHECK (one.starts_with ("%PDF-1."));
    CHECK (contains (one, "/MediaBox [ 0 0 595.2"));
    CHECK (sheetsOf (one) == 1);
    CHECK (sheetsOf (renderReportPdf ({})) == 1);

    // 4 figures of 72 mm are more than one sheet of 267 mm; 200 rows of 4.9 mm more than three.
    page.sections.push_back ({ "Figures", {}, std::vector<ReportFigure> (4, { "Bars.", "", bars() }), {} });
    page.sections.front().tables.front().rows.resize (200, { "1", "word" });
    const auto many = renderReportPdf (page);
    CHECK (sheetsOf (many) == 6);
    CHECK (many == renderReportPdf (page));
}
