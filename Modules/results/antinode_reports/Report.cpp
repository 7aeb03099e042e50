#include "Report.h"

#include "ChartFile.h"
#include "Html.h"
#include "Theme.h"

#include <antinode_numerics/ParallelFor.h>

namespace antinode
{
namespace
{
/** A figure in both themes, as data URIs. */
struct Pictures
{
    std::string light, dark;
};

std::vector<const ReportFigure*> collectFigures (const ReportPage& page)
{
    std::vector<const ReportFigure*> figures;
    for (const auto& section : page.sections)
        for (const auto& figure : section.figures)
            figures.push_back (&figure);
    return figures;
}

std::string drawFigure (const ReportFigure& figure, const Theme& theme)
{
    return pngDataUri (renderPng (figure.chart, figure.width, figure.height, figure.scale, theme));
}

// Every picture is a job of its own.
std::vector<Pictures> renderPictures (const std::vector<const ReportFigure*>& figures)
{
    std::vector<Pictures> pictures (figures.size());
    parallelFor (2 * figures.size(),
                 [&] (std::size_t job)
                 {
                     auto& [light, dark] = pictures[job / 2];
                     (job % 2 == 0 ? light : dark) =
                         drawFigure (*figures[job / 2], job % 2 == 0 ? Theme::light() : Theme::dark());
                 });
    return pictures;
}

std::string element (const std::string& name, const std::string& attributes, const std::string& content)
{
    return "<" + name + (attributes.empty() ? "" : " " + attributes) + ">" + content + "</" + name + ">\n";
}

std::string textElement (const std::string& name, const std::string& attributes, const std::string& text)
{
    return text.empty() ? std::string() : element (name, attributes, escapeHtml (text));
}

std::string linkList (const std::vector<ReportLink>& links)
{
    std::string items;
    for (const auto& link : links)
        items += element ("li", "", "<a href=\"" + escapeHtml (link.file) + "\">" + escapeHtml (link.text) + "</a>");
    return items.empty() ? items : element ("nav", "aria-label=\"Pages\"", element ("ul", "", items));
}

std::string scoreCards (const std::vector<ReportScore>& scores)
{
    std::string cards;
    for (const auto& score : scores)
        cards += element ("div", "class=\"score\"",
                          textElement ("dt", "", score.name) + textElement ("dd", "class=\"value\"", score.value)
                              + textElement ("dd", "class=\"sentence\"", score.sentence));
    return cards.empty() ? cards : element ("dl", "class=\"scores\"", cards);
}

std::string warningBox (const std::vector<std::string>& warnings)
{
    std::string items;
    for (const auto& warning : warnings)
        items += textElement ("li", "", warning);
    if (items.empty())
        return items;
    return element ("section", "class=\"warnings\"", element ("h2", "", "Warnings") + element ("ul", "", items));
}

std::string figureHtml (const ReportFigure& figure, const Pictures& pictures)
{
    const auto alternative = escapeHtml (figure.alternativeText.empty() ? figure.caption : figure.alternativeText);
    const auto size =
        "width=\"" + std::to_string (figure.width) + "\" height=\"" + std::to_string (figure.height) + "\"";
    const auto dark = "<source media=\"screen and (prefers-color-scheme: dark)\" srcset=\"" + pictures.dark + "\"/>\n";
    const auto light = "<img " + size + " alt=\"" + alternative + "\" src=\"" + pictures.light + "\"/>\n";
    return element ("figure", "",
                    element ("picture", "", dark + light) + textElement ("figcaption", "", figure.caption));
}

std::string tableRow (const ReportTable& table, const std::vector<std::string>& cells, bool isHeader)
{
    std::string html;
    for (std::size_t column = 0; column < cells.size(); ++column)
    {
        std::string attributes = isHeader ? "scope=\"col\"" : "";
        if (isNumberColumn (table, column))
            attributes += isHeader ? " class=\"number\"" : "class=\"number\"";
        html += element (isHeader ? "th" : "td", attributes, escapeHtml (cells[column]));
    }
    return element ("tr", "", html);
}

std::string tableHtml (const ReportTable& table)
{
    std::string rows;
    for (const auto& row : table.rows)
        rows += tableRow (table, row, false);
    const auto head =
        table.header.empty() ? std::string() : element ("thead", "", tableRow (table, table.header, true));
    return element (
        "div", "class=\"scroll\"",
        element ("table", "", textElement ("caption", "", table.caption) + head + element ("tbody", "", rows)));
}

std::string head (const ReportPage& page)
{
    return element (
        "head", "",
        "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
            + element ("title", "", escapeHtml (page.title)) + element ("style", "", std::string (reportStyle)));
}

std::string sectionHtml (const ReportSection& section, std::vector<Pictures>::const_iterator& pictures)
{
    auto html = textElement ("h2", "", section.heading);
    for (const auto& paragraph : section.paragraphs)
        html += textElement ("p", "", paragraph);
    for (const auto& figure : section.figures)
        html += figureHtml (figure, *pictures++);
    for (const auto& table : section.tables)
        html += tableHtml (table);
    return element ("section", "", html);
}
} // namespace

bool isNumberColumn (const ReportTable& table, std::size_t column)
{
    auto any = false;
    for (const auto& row : table.rows)
    {
        if (column >= row.size() || row[column].empty())
            continue;
        if (! looksLikeNumber (row[column]))
            return false;
        any = true;
    }
    return any;
}

std::string renderReport (const ReportPage& page)
{
    const auto pictures = renderPictures (collectFigures (page));
    auto next = pictures.begin();
    auto content = element ("header", "",
                            textElement ("h1", "", page.title) + textElement ("p", "class=\"subtitle\"", page.subtitle)
                                + linkList (page.links));
    content += scoreCards (page.scores) + warningBox (page.warnings);
    for (const auto& section : page.sections)
        content += sectionHtml (section, next);
    content += textElement ("footer", "", page.footer);
    return "<!DOCTYPE html>\n"
           + element ("html", "lang=\"en\"", head (page) + element ("body", "", element ("main", "", content)));
}

namespace
{
/** Lower-case letters and digits, all else as single hyphens. */
std::string fileWord (const std::string& text)
{
    std::string word;

    for (const auto character : text)
    {
        const auto isLetter = (character >= 'a' && character <= 'z') || (character >= '0' && character <= '9');
        const auto isCapital = character >= 'A' && character <= 'Z';

        if (isLetter || isCapital)
            word += isCapital ? static_cast<char> (character - 'A' + 'a') : character;
        else if (! word.empty() && word.back() != '-')
            word += '-';
    }

    while (! word.empty() && word.back() == '-')
        word.pop_back();

    return word;
}
} // namespace

std::vector<NamedFigure> namedFigures (const ReportPage& page)
{
    std::vector<NamedFigure> figures;

    for (const auto& section : page.sections)
        for (std::size_t i = 0; i < section.figures.size(); ++i)
            figures.push_back (
                { "figure-" + fileWord (section.heading) + "-" + std::to_string (i + 1), &section.figures[i] });

    return figures;
}

void writeFigures (OutputFolder& folder, const ReportPage& page, VectorFormat format)
{
    const auto figures = namedFigures (page);
    std::vector<std::string> files (figures.size());
    parallelFor (figures.size(),
                 [&] (std::size_t i)
                 {
                     const auto& figure = *figures[i].figure;
                     files[i] = renderVector (figure.chart, figure.width, figure.height, format);
                 });

    for (std::size_t i = 0; i < figures.size(); ++i)
        folder.write (figures[i].name + (format == VectorFormat::svg ? ".svg" : ".pdf"), files[i]);
}
} // namespace antinode
