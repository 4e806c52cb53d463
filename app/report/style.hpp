#pragma once

namespace app::report {

/// Style sheet of report.html. Blue and orange stay apart for every common colour blindness, and each is doubled by a
/// sign or a word.
inline constexpr const char* style = R"css(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1c2126; --faint: #5b6670; --rule: #d5dade;
  --good: #0b5cad; --bad: #b34700; --curve: #0b5cad; --fill: #cfe3f6; --shade: #f4f6f8; }
@media (prefers-color-scheme: dark) { :root { --paper: #15191d; --ink: #e6eaee; --faint: #9aa6b1; --rule: #38414a;
  --good: #7fbcff; --bad: #ffa25c; --curve: #7fbcff; --fill: #24486b; --shade: #1d2328; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem; max-width: 64rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .6rem; }
h2 { font-size: 1.15rem; margin: 2.2rem 0 .6rem; } h3 { font-size: 1rem; margin: 0; }
details { margin: 1.2rem 0 0; } summary { cursor: pointer; } summary h2 { display: inline; }
section.missed { display: flex; flex-wrap: wrap; gap: 1rem; padding: .8rem 0; border-top: 1px solid var(--rule);
  break-inside: avoid; }
section.missed > div { flex: 1 1 20rem; } section.missed p { margin: .3rem 0 0; }
section.missed h3 { color: var(--bad); } section.missed figure { flex: 0 1 22rem; }
.verdict { display: inline-block; margin: 0; padding: .3rem .9rem; border: 2px solid; border-radius: .4rem;
  font-size: 1.25rem; font-weight: 700; }
.pass { color: var(--good); } .fail { color: var(--bad); }
.verdict.fail { border-style: dashed; }
.tied { margin: .7rem 0 0; } .note { color: var(--faint); margin: .2rem 0 0; font-size: .9rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; min-width: 42rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .4rem .7rem .4rem 0; border-bottom: 1px solid var(--rule); }
thead th { color: var(--faint); font-weight: 600; font-size: .85rem; }
tbody th { font-weight: 600; }
td.number { white-space: nowrap; }
td.sign { white-space: nowrap; font-weight: 700; }
tr.missed { background: var(--shade); }
.moments { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; }
figure { margin: 0; break-inside: avoid; }
figure img { display: block; width: 100%; height: auto; border: 1px solid var(--rule); border-radius: .3rem; }
figcaption { margin-top: .3rem; font-size: .9rem; }
svg { display: block; width: 100%; min-width: 40rem; height: auto; font: 12px system-ui, "DejaVu Sans", sans-serif; }
svg text { fill: var(--ink); }
svg .label { text-anchor: end; fill: var(--faint); } svg .tick, svg .moment-number { text-anchor: middle; }
svg .peak { font-weight: 600; } svg .late { text-anchor: end; } svg .moment-number { font-weight: 700; }
svg .rule { stroke: var(--rule); } svg .grid { stroke: var(--rule); stroke-width: .6; }
svg .moment { stroke: var(--faint); stroke-dasharray: 4 3; }
svg .curve { fill: none; stroke: var(--curve); stroke-width: 1.3; stroke-linejoin: round; }
svg .named { fill: var(--fill); stroke: var(--curve); stroke-width: .8; }
svg .held { fill: var(--curve); } svg .event { fill: var(--ink); }
@media print {
  :root { color-scheme: light; --paper: #ffffff; --ink: #000000; --faint: #444444; --rule: #bbbbbb; --good: #0b5cad;
    --bad: #b34700; --curve: #0b5cad; --fill: #cfe3f6; --shade: #ffffff; }
  @page { margin: 15mm; }
  body { padding: 0; max-width: none; font-size: 10.5pt; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  details::details-content { content-visibility: visible; display: block; }
  .moments { grid-template-columns: repeat(3, 1fr); } h2 { break-after: avoid; }
  tr, svg { break-inside: avoid; } .scroll { overflow: visible; } svg, table { min-width: 0; }
}
)css";

}  // namespace app::report
