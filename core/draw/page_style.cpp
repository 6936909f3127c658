#include "core/draw/page_style.hpp"

namespace riedel {

const char* page_style() {
  return R"(
:root { --ink: #262626; --soft: #666; --line: #ddd; --pick: #fff4d6; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 74rem; background: #fff; color: var(--ink);
  font: 16px/1.5 system-ui, "Segoe UI", "DejaVu Sans", Helvetica, Arial, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 1rem; letter-spacing: -0.01em; }
h2 { font-size: 1.3rem; margin: 2.8rem 0 .8rem; padding-top: .7rem; border-top: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 1.8rem 0 .5rem; }
p { max-width: 46rem; margin: .6rem 0; }
dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .15rem 1.2rem; margin: 1rem 0; font-size: .9rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
figure { margin: 0; }
figcaption { color: var(--soft); font-size: .85rem; line-height: 1.35; }
.plot { margin: 1.2rem 0 1.6rem; }
.sheet { overflow-x: auto; }
.sheet svg { display: block; width: 100%; min-width: 34rem; max-width: 52rem; height: auto; }
.keys { display: flex; flex-wrap: wrap; gap: .3rem .4rem; margin: .5rem 0; }
.keys button { display: inline-flex; align-items: center; gap: .45rem; padding: .2rem .6rem; font: inherit; font-size: .82rem;
  color: inherit; text-align: left; background: #fff; border: 1px solid var(--line); border-radius: 1rem; cursor: pointer; }
.keys button:hover { border-color: #888; }
.keys button:focus-visible { outline: 2px solid #0072b2; outline-offset: 1px; }
.keys button.picked { background: var(--pick); border-color: #c90; }
.swatch { flex: none; width: 26px; height: 8px; }
.pictures { margin: 1.2rem 0 1.8rem; }
.row { display: flex; flex-wrap: wrap; gap: 1rem 1.1rem; }
.row figure { max-width: 45vw; }
.row img { display: block; width: 100%; height: auto; }
.row figcaption { text-align: center; font-size: .78rem; color: var(--ink); overflow-wrap: anywhere; }
.colors { display: flex; flex-wrap: wrap; align-items: flex-start; gap: .2rem .8rem; margin: .8rem 0 .2rem; font-size: .85rem; }
.bar { width: 22rem; overflow: visible; max-width: 100%; font-size: 11px; fill: var(--ink); }
.scroll { overflow-x: auto; margin: 0 0 1.4rem; }
table { border-collapse: collapse; font-size: .86rem; font-variant-numeric: tabular-nums; }
.caption { color: var(--soft); font-size: .85rem; line-height: 1.35; margin: 1rem 0 .4rem; max-width: none; }
th, td { padding: .28rem .7rem; text-align: right; vertical-align: top; white-space: nowrap; border-bottom: 1px solid #eee; }
thead th { vertical-align: bottom; white-space: normal; font-weight: 600; border-bottom: 2px solid var(--ink); min-width: 4.2rem; }
th.text, td.text { text-align: left; }
tbody th { font-weight: 500; }
table.long th, table.long td { white-space: normal; max-width: 30rem; }
table.long td { min-width: 6.5rem; }
tbody tr:hover { background: #f6f8fa; }
tr.picked, tr.picked:hover { background: var(--pick); }
.agrees { color: #00704a; font-weight: 600; }
.differs { color: #b34700; font-weight: 600; }
.cannot { color: #555; font-weight: 600; }
.faint { color: var(--soft); }
svg [data-run], .row figure { transition: opacity .12s; }
.picking svg [data-run]:not(.picked), .picking .row figure[data-run]:not(.picked) { opacity: .13; }
@media (max-width: 40rem) {
  body { padding: 1.1rem .9rem 3rem; }
  h1 { font-size: 1.5rem; }
  dl { grid-template-columns: minmax(0, 1fr); gap: 0; }
  dd { margin-bottom: .4rem; }
}
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  .picking svg [data-run], .picking .row figure[data-run] { opacity: 1 !important; }
  .scroll, .sheet { overflow: visible; }
  table { font-size: 7.5pt; }
  th, td { padding: .15rem .35rem; }
  thead th { min-width: 0; }
  .plot, .row figure, tr { break-inside: avoid; }
  h2, h3, .caption { break-after: avoid; }
  .keys button { border: none; padding: 0 .5rem 0 0; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";
}

const char* page_script() {
  return R"(
const picked = new Set();
function pick(run) {
  picked.has(run) ? picked.delete(run) : picked.add(run);
  document.body.classList.toggle("picking", picked.size > 0);
  for (const each of document.querySelectorAll("[data-run]")) {
    const mine = picked.has(each.dataset.run);
    each.classList.toggle("picked", mine);
    if (each.matches("button")) each.setAttribute("aria-pressed", mine);
  }
}
for (const each of document.querySelectorAll("[data-run]"))
  each.addEventListener("click", () => pick(each.dataset.run));
document.addEventListener("keydown", event => {
  if (event.key === "Escape") [...picked].forEach(pick);
});
)";
}

} // namespace riedel
