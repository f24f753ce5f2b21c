#include "core/study/report_page.h"

#include <fmt/format.h>

#include <cctype>

#include "core/scene/base64.h"
#include "core/study/markup.h"
#include "core/study/palette.h"

namespace eyeray {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--text); font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; }
main { max-width: 76rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; padding-bottom: .3rem; border-bottom: 1px solid var(--border); }
p { max-width: 52rem; margin: .5rem 0; }
.summary, figcaption { color: var(--dimmed); }
figcaption { font-size: .875rem; padding: .5rem .75rem .75rem; }
figcaption b { display: block; color: var(--text); }
figure { margin: 1rem 0; background: var(--panel); border: 1px solid var(--border); border-radius: 8px; overflow: hidden; }
figure > svg { display: block; width: 100%; height: auto; }
.pictures { display: grid; gap: 1rem; margin: 1rem 0; grid-template-columns: repeat(auto-fill, minmax(19rem, 1fr)); }
.charts { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(30rem, 100%), 1fr)); margin: 1rem 0; }
.pictures figure, .charts figure { margin: 0; }
.pictures img { display: block; width: 100%; image-rendering: auto; }
.table { overflow-x: auto; margin: 1rem 0; background: var(--panel); border: 1px solid var(--border); border-radius: 8px; }
table { border-collapse: collapse; width: 100%; font-size: .875rem; font-variant-numeric: tabular-nums; }
th, td { padding: .35rem .75rem; text-align: left; border-bottom: 1px solid var(--border); white-space: nowrap; }
th { color: var(--dimmed); font-weight: 600; white-space: normal; vertical-align: bottom; }
tr:last-child td { border-bottom: 0; }
tr.marked td { background: var(--marked); font-weight: 600; }
td.number, th.number { text-align: right; }
td.long { white-space: normal; min-width: 16rem; }
@media print {
  body { font-size: 10pt; background: none; }
  main { max-width: none; padding: 0; }
  figure, tr, h2 { break-inside: avoid; }
  h2, h2 + p { break-after: avoid; }
  .table { overflow: visible; }
  .charts { grid-template-columns: 1fr 1fr; }
  th, td { padding: .15rem .4rem; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

constexpr std::size_t kLongCell = 40; // bytes; longer ones may break into lines

std::string variables(const Ground& ground) {
    return fmt::format(
        "--paper: #{:06x}; --panel: #{:06x}; --text: #{:06x}; --dimmed: #{:06x}; --border: #{:06x};",
        ground.paper, ground.panel, ground.text, ground.dimmed, ground.border);
}

/// The light colours first, which the dark ones replace on screens that prefer them.
std::string style() {
    return fmt::format(":root {{ {} --marked: #e3ecf8; }}\n"
                       "@media screen and (prefers-color-scheme: dark) {{ :root {{ {} --marked: "
                       "#2b3346; }} }}",
                       variables(groundOf(false)), variables(groundOf(true))) +
           kStyle;
}

bool looksLikeNumber(std::string_view cell) {
    if (cell.starts_with("≤ ")) return true;
    const std::size_t sign = cell.starts_with("-") || cell.starts_with("+") ? 1 : 0;
    return cell == "-" || cell.starts_with("∞") ||
           (cell.size() > sign && std::isdigit(static_cast<unsigned char>(cell[sign])) != 0);
}

std::string classOf(std::string_view cell) {
    if (looksLikeNumber(cell)) return " class=\"number\"";
    return cell.size() > kLongCell ? " class=\"long\"" : "";
}

}

ReportPage::ReportPage(std::string_view title, std::string_view summary)
    : body_(fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                        "<title>{0}</title>\n<style>{2}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n"
                        "<p class=\"summary\">{1}</p>\n",
                        escaped(title), escaped(summary), style())) {}

void ReportPage::section(std::string_view heading) {
    body_ += fmt::format("<h2>{}</h2>\n", escaped(heading));
}

void ReportPage::paragraph(std::string_view text) { body_ += fmt::format("<p>{}</p>\n", escaped(text)); }

void ReportPage::table(const ReportTable& table) {
    body_ += "<div class=\"table\"><table>\n<thead><tr>";
    for (std::size_t i = 0; i < table.head.size(); ++i) {
        const bool number = !table.rows.empty() && i < table.rows.front().cells.size() &&
                            looksLikeNumber(table.rows.front().cells[i]);
        body_ += fmt::format("<th{}>{}</th>", number ? " class=\"number\"" : "", escaped(table.head[i]));
    }
    body_ += "</tr></thead>\n<tbody>\n";
    for (const ReportTable::Row& row : table.rows) {
        body_ += row.marked ? "<tr class=\"marked\">" : "<tr>";
        for (const std::string& cell : row.cells)
            body_ += fmt::format("<td{}>{}</td>", classOf(cell), escaped(cell));
        body_ += "</tr>\n";
    }
    body_ += "</tbody>\n</table></div>\n";
}

void ReportPage::figure(std::string_view svg, std::string_view caption) {
    body_ += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", svg, escaped(caption));
}

void ReportPage::figures(std::span<const ReportFigure> figures) {
    body_ += "<div class=\"charts\">\n";
    for (const ReportFigure& figure : figures)
        body_ += fmt::format("<figure>{}<figcaption><b>{}</b>{}</figcaption></figure>\n", figure.svg,
                             escaped(figure.title), escaped(figure.caption));
    body_ += "</div>\n";
}

void ReportPage::pictures(std::span<const ReportPicture> pictures) {
    body_ += "<div class=\"pictures\">\n";
    for (const ReportPicture& picture : pictures)
        body_ +=
            fmt::format("<figure><img src=\"data:image/png;base64,{}\" alt=\"{}\"><figcaption><b>{}</b>{}"
                        "</figcaption></figure>\n",
                        encodeBase64(picture.png), escaped(picture.title), escaped(picture.title),
                        escaped(picture.caption));
    body_ += "</div>\n";
}

}
