#include <antinode_reports/ChartFile.h>
#include <antinode_reports/Html.h>
#include <antinode_reports/Report.h>
#include <antinode_reports/Theme.h>
#include <antinode_reports/Utf8.h>

#include <juce_core/juce_core.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
const std::string oddName = "Plate <b>\"A&B\"</b> 'β' 東京 \U0001F600";

ReportPage page()
{
    LineChart chart;
    chart.title = "Field";
    chart.series = { { "reached", Eigen::VectorXd::LinSpaced (9, 0, 1), Eigen::VectorXd::LinSpaced (9, 0, 4) } };
    ReportPage report;
    report.title = oddName;
    report.subtitle = "sinc of 25 mm, 40 mm/s after 25 ms";
    report.links = { { "Fields & spectra", "paper.html" } };
    report.scores = { { "v-score", "0.99997", "Correlation of the reached with the wanted field: 1 is best." } };
    report.warnings = { "Mode 7 < limit" };
    report.sections = {
        { "Field", { "First.", "Second." }, { { "The field.", "A rising line", chart, 300, 150 } }, {} },
        { "Table", {}, {}, { { "Modes", { "mode", "frequency (Hz)" }, { { "one", "963" }, { "two", "3 907" } } } } }
    };
    report.footer = "Antinode";
    return report;
}

std::size_t occurrences (const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (auto at = text.find (part); at != std::string::npos; at = text.find (part, at + part.size()))
        ++count;
    return count;
}

std::unique_ptr<juce::XmlElement> parsed (const std::string& html)
{
    const auto body = html.substr (html.find ("<html"));
    return juce::parseXML (juce::String::fromUTF8 (body.data(), static_cast<int> (body.size())));
}

const juce::XmlElement* find (const juce::XmlElement& parent, const juce::String& tag)
{
    for (const auto* child : parent.getChildIterator())
    {
        if (child->hasTagName (tag))
            return child;
        if (const auto* found = find (*child, tag))
            return found;
    }
    return nullptr;
}
} // namespace

TEST_CASE ("Markup in text is escaped, malformed UTF-8 and control characters are replaced")
{
    CHECK (escapeHtml ("<a href=\"x\">&'") == "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
    CHECK (escapeHtml ("β √ 東京 \U0001F600") == "β √ 東京 \U0001F600");
    CHECK (escapeHtml ("a\xff"
                       "b")
           == "a\uFFFD"
              "b");
    CHECK (escapeHtml (std::string_view ("a\0b", 3))
           == "a\uFFFD"
              "b");
    CHECK (escapeHtml ("\x1b[31m") == "\uFFFD[31m");
}

TEST_CASE ("Decoding UTF-8 refuses overlong forms, surrogates and cut sequences, and encoding reverses it")
{
    CHECK (decodeUtf8 ("\xc0\xaf") == U"\uFFFD\uFFFD");
    CHECK (decodeUtf8 ("\xed\xa0\x80") == U"\uFFFD\uFFFD\uFFFD");
    CHECK (decodeUtf8 ("\xe2\x82") == U"\uFFFD\uFFFD");
    CHECK (decodeUtf8 ("\xf5\x80\x80\x80").size() == 4);
    for (const char32_t codePoint : { U'A', U'\u07FF', U'\u0800', U'\uFFFF', U'\U00010000', U'\U0010FFFF' })
    {
        std::string text;
        appendUtf8 (text, codePoint);
        CHECK (decodeUtf8 (text) == std::u32string (1, codePoint));
    }
}

TEST_CASE ("Cells that read as numbers are told from words")
{
    for (const auto* number :
         { "12", "-3.5", "\u22120.25", "1.2×10⁻⁶", "38.2 V", "4.1 %", "12\u202F345", "± 0.3 mm/s", "\u2013", "<0.1" })
        CHECK (looksLikeNumber (number));
    for (const auto* word : { "", "mode 1", "V", "2 of 3 modes", "exact", "3 rows and more" })
        CHECK_FALSE (looksLikeNumber (word));
}

TEST_CASE ("A report is well formed and shows any name as it is")
{
    const auto html = renderReport (page());
    CHECK (html.rfind ("<!DOCTYPE html>", 0) == 0);
    const auto document = parsed (html);
    REQUIRE (document != nullptr);
    const auto* heading = find (*document, "h1");
    const auto* title = find (*document, "title");
    REQUIRE (heading != nullptr);
    REQUIRE (title != nullptr);
    CHECK (heading->getAllSubText().toStdString() == oddName);
    CHECK (title->getAllSubText().toStdString() == oddName);
    CHECK (find (*document, "a")->getStringAttribute ("href") == "paper.html");
    CHECK (find (*document, "img")->getStringAttribute ("alt") == "A rising line");
}

TEST_CASE ("A report needs no network and no scripts")
{
    const auto html = renderReport (page());
    CHECK (html.find ("http") == std::string::npos);
    CHECK (html.find ("//") >= html.find ("base64"));
    CHECK (html.find ("<script") == std::string::npos);
    CHECK (html.find ("url(") == std::string::npos);
    CHECK (html.find ("@import") == std::string::npos);
}

TEST_CASE ("Each figure is there in light and in dark")
{
    const auto report = page();
    const auto& figure = report.sections[0].figures[0];
    const auto html = renderReport (report);
    for (const auto* theme : { &Theme::light(), &Theme::dark() })
    {
        const auto uri = pngDataUri (renderPng (figure.chart, figure.width, figure.height, 2, *theme));
        CHECK (uri.rfind ("data:image/png;base64,iVBORw0KGgo", 0) == 0);
        CHECK (occurrences (html, uri) == 1);
    }
    CHECK (occurrences (html, "prefers-color-scheme: dark") == 2);
}

TEST_CASE ("Pictures have the background of the cards they lie on")
{
    for (const auto* theme : { &Theme::light(), &Theme::dark() })
    {
        const auto colour = theme->background.toDisplayString (false).toLowerCase().toStdString();
        CHECK (reportStyle.find ("--card: #" + colour) != std::string_view::npos);
    }
}

TEST_CASE ("Scores, warnings, captions and tables appear, columns of numbers aligned at the right")
{
    const auto html = renderReport (page());
    for (const auto* text : { "0.99997", "1 is best", "Mode 7 &lt; limit", "The field.",
                              "<th scope=\"col\" class=\"number\">frequency (Hz)</th>", "<td class=\"number\">963</td>",
                              "<td>one</td>", "Fields &amp; spectra" })
        CHECK (html.find (text) != std::string::npos);
}

TEST_CASE ("A report is the same each time, and an empty page is a page")
{
    CHECK (renderReport (page()) == renderReport (page()));
    CHECK (parsed (renderReport ({})) != nullptr);
}
