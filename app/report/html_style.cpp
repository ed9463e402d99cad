#include "app/report/html_style.h"

#include "ui/plots/tolerance_plot.h"

#include <array>

namespace espalier {
namespace {

constexpr auto sheet = R"css(
:root{color-scheme:light dark;--ground:#fff;--panel:#f6f7f5;--text:#1f2421;--quiet:#5b635f;
--line:#d9dedb;--accent:#2f8f5b;--bar:#cfe3d8;--warn:#fff4dc;--warnline:#e6a817}
@media (prefers-color-scheme:dark){:root{--ground:#17191c;--panel:#23262a;--text:#e4e8e5;
--quiet:#a3aba7;--line:#3a3f44;--accent:#5cc48d;--bar:#2c4a3a;--warn:#3a3018;--warnline:#b98512}}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%;text-size-adjust:100%}
body{margin:0;background:var(--ground);color:var(--text);
font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif;
font-variant-numeric:tabular-nums}
main{max-width:62rem;margin:0 auto;padding:1.25rem 1rem 3rem}
header{border-bottom:3px solid var(--accent);padding-bottom:.75rem}
h1{font-size:1.6rem;line-height:1.25;margin:.5rem 0 .25rem;overflow-wrap:anywhere}
h2{font-size:1.25rem;margin:2.25rem 0 .6rem}
p{margin:.6rem 0;max-width:46rem}
.facts{color:var(--quiet);margin:0}
.note{color:var(--quiet);font-size:.875rem}
.numbers{display:grid;grid-template-columns:repeat(auto-fit,minmax(8.5rem,1fr));gap:.6rem;
margin:1rem 0 .5rem}
.numbers div{background:var(--panel);border-radius:8px;padding:.6rem .75rem}
.numbers b{display:block;font-size:1.6rem;line-height:1.2;font-weight:600}
.numbers span{display:block}
.numbers small{display:block;color:var(--quiet);font-size:.8125rem}
.warnings{background:var(--warn);border-left:4px solid var(--warnline);border-radius:4px;
padding:.6rem .9rem;margin:1rem 0}
.warnings ul{margin:.25rem 0 0;padding-left:1.2rem}
.legend{list-style:none;display:flex;flex-wrap:wrap;gap:.35rem 1.5rem;padding:0;margin:.6rem 0}
.legend i{display:inline-block;width:1.5rem;height:.35rem;border-radius:2px;margin-right:.5rem;
vertical-align:middle}
.legend span{color:var(--quiet)}
.figures{display:grid;gap:1rem;margin:1rem 0;
grid-template-columns:repeat(auto-fit,minmax(min(100%,22rem),1fr))}
.three{grid-template-columns:repeat(auto-fit,minmax(min(100%,17rem),1fr))}
figure{margin:0;break-inside:avoid}
.figures img{display:block;width:100%;height:auto;border:1px solid var(--line);border-radius:6px;
background:#fff}
figcaption{font-size:.875rem;color:var(--quiet);padding-top:.3rem}
figcaption b{color:var(--text);font-weight:600}
.plot svg{display:block;width:100%;height:auto}
.plot svg,.plot svg *{font-family:inherit}
.wide{overflow-x:auto;margin:1rem 0}
table{border-collapse:collapse;font-size:.9rem}
caption{text-align:left;font-weight:600;padding:.2rem 0 .35rem;white-space:nowrap}
th{font-weight:600;color:var(--quiet);text-align:left;vertical-align:bottom;
border-bottom:2px solid var(--line)}
th,td{padding:.28rem 1.6rem .28rem 0}
td{border-bottom:1px solid var(--line);vertical-align:top}
th:last-child,td:last-child{padding-right:.1rem}
th{white-space:nowrap}
.number{text-align:right;white-space:nowrap}
.code{min-width:17rem;font-family:ui-monospace,"DejaVu Sans Mono",monospace;font-size:.8rem;
overflow-wrap:anywhere}
.bar{display:block;min-width:4rem;height:4px;margin-top:2px;border-radius:2px;background:var(--bar)}
.bar i{display:block;height:4px;border-radius:2px;background:var(--accent)}
p.code{max-width:none}
dl{margin:.6rem 0;max-width:46rem}
dt{font-weight:600;margin-top:.7rem}
dd{margin:0}
dd cite{display:block;color:var(--quiet);font-size:.875rem;font-style:normal}
@media (max-width:40rem){table{font-size:.8rem}th.word,th.number{white-space:normal}
th,td{padding-right:.55rem}
.bar{min-width:2.2rem}caption{white-space:normal;font-size:.9rem}
.cards,.cards tbody,.cards caption{display:block}
.cards thead{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
.cards tr{display:grid;grid-template-columns:1fr 1fr;column-gap:1rem;padding:.45rem 0;
border-bottom:1px solid var(--line)}
.cards td{display:block;padding:0;border:0;min-width:0;text-align:left;overflow-wrap:anywhere}
.cards td::before{content:attr(data-name) " ";color:var(--quiet)}
.cards td:first-child,.cards .number:first-child+.word,.cards .code{grid-column:1/-1}
.cards td:first-child{font-weight:600}
.cards .bar{display:none}}
@page{size:A4;margin:16mm 15mm}
@media print{:root{color-scheme:light;--ground:#fff;--panel:#f3f4f2;--text:#000;--quiet:#444;
--line:#bbb;--accent:#2f8f5b;--bar:#dfe9e3;--warn:#fff;--warnline:#888}
body{font-size:9.5pt;-webkit-print-color-adjust:exact;print-color-adjust:exact}
main{max-width:none;padding:0}
.numbers{grid-template-columns:repeat(6,1fr);gap:.35rem}.numbers div{padding:.4rem .5rem}
.numbers b{font-size:1.3rem}h1{font-size:1.5rem}
.figures{grid-template-columns:repeat(2,1fr)}.three{grid-template-columns:repeat(3,1fr)}
section>p:not(.note),.legend{break-after:avoid}
h2{break-after:avoid;margin-top:1.4rem}
p,table,tr,figure,.legend,.numbers,.warnings,dt+dd{break-inside:avoid}
table.long{break-inside:auto}
.figures img{width:auto;max-width:100%;max-height:88mm}
dt{break-after:avoid}caption{break-after:avoid}
.wide{overflow:visible}
th,td{padding:.15rem 1rem .15rem 0}}
)css";

/// Plots are painted once, in the colors of paper; on a dark screen these are replaced.
QString darkPlots() {
  const PlotColors light = plotColors(false);
  const PlotColors dark = plotColors(true);
  const std::array<std::pair<QColor, QColor>, 5> pairs{{{light.text, dark.text},
                                                        {light.grid, dark.grid},
                                                        {light.first, dark.first},
                                                        {light.second, dark.second},
                                                        {light.third, dark.third}}};
  QString rules;
  for (const auto& [from, to] : pairs)
    for (const char* what : {"stroke", "fill"})
      rules += QStringLiteral(".plot [%1=\"%2\"]{%1:%3}").arg(what, from.name(), to.name());
  return QStringLiteral("@media screen and (prefers-color-scheme:dark){%1}\n").arg(rules);
}

} // namespace

QString htmlStyle() {
  return QString::fromLatin1(sheet) + darkPlots();
}

} // namespace espalier
