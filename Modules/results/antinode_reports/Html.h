#pragma once

#include <string>
#include <string_view>

namespace antinode
{
/** A text as HTML, for content and for quoted attributes: markup escaped, malformed UTF-8 and characters that HTML
    does not
    allow replaced by U+FFFD. [any] */
std::string escapeHtml (std::string_view utf8);

/** Bytes as a PNG data URI. [any] */
std::string pngDataUri (std::string_view bytes);

/** Whether a table cell reads as a number, with or without sign, unit, thin spaces, a power of ten: such cells are
    aligned at the right. [any] */
bool looksLikeNumber (std::string_view utf8);

/** The style sheet of every report page: system fonts, light and dark as the reader's system has it, fit for narrow
   screens and for paper. Its backgrounds are those of Theme::light() and Theme::dark(). */
constexpr std::string_view reportStyle = R"css(
:root { color-scheme: light dark; --page: #f4f6f8; --card: #ffffff; --text: #1b1f24; --muted: #57606a; --line: #dde2e7;
  --accent: #0072b2; --warn: #8a4b00; --warn-back: #fff4e0; }
@media screen and (prefers-color-scheme: dark) { :root { --page: #0d1014; --card: #15191f; --text: #e8edf3; --muted: #a3aeba;
  --line: #2a313a; --accent: #56b4e9; --warn: #ffc46b; --warn-back: #2b2112; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--text);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2.5rem 1.25rem 3rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; letter-spacing: -0.01em; overflow-wrap: anywhere; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 0.6rem; }
p { margin: 0.5rem 0; max-width: 46rem; }
a { color: var(--accent); }
.subtitle { color: var(--muted); font-size: 1.05rem; margin-top: 0.4rem; overflow-wrap: anywhere; }
nav ul { list-style: none; display: flex; flex-wrap: wrap; gap: 0.4rem 1.2rem; padding: 0; margin: 1rem 0 0; }
.scores { display: grid; grid-template-columns: repeat(auto-fill, minmax(13.5rem, 1fr)); gap: 0.8rem; margin: 1.8rem 0 0; padding: 0; }
.score { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 0.85rem 1rem; }
.score dt { color: var(--muted); font-size: 0.9rem; }
.score dd { margin: 0; }
.score .value { font-size: 1.6rem; font-weight: 650; line-height: 1.3; font-variant-numeric: tabular-nums; }
.score .sentence { color: var(--muted); font-size: 0.88rem; line-height: 1.4; }
.warnings { background: var(--warn-back); border-left: 4px solid var(--warn); border-radius: 6px; margin: 1.4rem 0 0; padding: 0.7rem 1.1rem; }
.warnings h2 { margin: 0; font-size: 1rem; color: var(--warn); }
.warnings ul { margin: 0.3rem 0 0; padding-left: 1.2rem; }
figure { margin: 1.1rem 0; background: var(--card); border: 1px solid var(--line); border-radius: 10px; overflow: hidden; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto; }
figcaption { color: var(--muted); font-size: 0.92rem; padding: 0.6rem 1rem 0.8rem; border-top: 1px solid var(--line); }
.scroll { overflow-x: auto; margin: 1.1rem 0; background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
table { border-collapse: collapse; width: 100%; font-size: 0.94rem; }
caption { caption-side: bottom; text-align: left; color: var(--muted); font-size: 0.92rem; padding: 0.6rem 1rem 0.8rem; }
th, td { text-align: left; padding: 0.42rem 1rem; border-bottom: 1px solid var(--line); vertical-align: top; }
tbody tr:last-child > * { border-bottom: 0; }
th { color: var(--muted); font-weight: 600; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
footer { color: var(--muted); font-size: 0.88rem; margin-top: 3rem; border-top: 1px solid var(--line); padding-top: 0.8rem; }
@media print { body { background: #ffffff; font-size: 11pt; } main { max-width: none; padding: 0; }
  figure, .score, .scroll, .warnings { break-inside: avoid; } h2 { break-after: avoid; } nav { display: none; } }
)css";
} // namespace antinode
