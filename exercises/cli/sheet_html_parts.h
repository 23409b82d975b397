// What a page of a sheet looks like and does. No framework: the sheet is inline SVG, in which `step-3` is the class
// of what step 3 drew, and `aria-label` what a mark tells. Neither text has an ampersand or a less-than, so that a
// parser of XML reads the page as a browser does.
#pragma once

namespace epure {

inline constexpr const char* style_of_sheet =
    R"(:root { --now: #f90; }
.epure { display: flex; flex-direction: column; min-height: 100vh; }
.sheet { flex: auto; margin: 0; padding: 0 1rem; }
.sheet svg { display: block; width: 100%; height: auto; max-height: calc(100vh - 9rem); margin: 0 auto .5rem; }
.later { visibility: hidden; }
.now { filter: drop-shadow(0 0 300px var(--now)) drop-shadow(0 0 120px var(--now)); }
g.now { filter: drop-shadow(0 0 300px var(--now)); }
@media (pointer: coarse) { .states summary { padding: .8rem 0; } }
.area { stroke: transparent; stroke-width: 1800; stroke-dasharray: none; fill: none; pointer-events: stroke;
  filter: none; cursor: help; }
@media (pointer: coarse) { .area { stroke-width: 4500; } }
.sheet [aria-label]:focus { outline: none; }
.sheet [aria-label]:focus-visible { filter: drop-shadow(0 0 200px #0af) drop-shadow(0 0 120px #0af); }
.words { max-width: 60rem; min-height: 2.8em; margin: .3rem auto 0; }
.states { max-width: 60rem; margin: 0 auto; padding: .5rem 1rem 1rem; }
.states li:first-child, .states li:last-child { list-style: none; }
.tip { position: fixed; z-index: 1; max-width: 22rem; padding: .2rem .5rem; border: 1px solid var(--edge);
  background: var(--ground); pointer-events: none; }
@media print {
  h1, .controls, .states, .tip { display: none; }
  .epure { display: block; min-height: 0; }
  .sheet { padding: 0; }
  .sheet svg { max-height: none; margin: 0; break-inside: avoid; }
  .now, .sheet [aria-label]:focus-visible { filter: none; }
}
)";

inline constexpr const char* script_of_sheet = R"(

  // Steps. The slider goes from what is given (0) over each step to the whole sheet, which is shown at first.
  const controls = find('.controls');
  if (controls) {
    const sheet = find('svg'), slider = find('.slider'), words = find('.words');
    const states = [...page.querySelectorAll('.states li')], whole = states.length - 1;
    const drawn = states.map((state, step) => [...sheet.querySelectorAll('.step-' + step)]);
    const show = wanted => {
      const shown = Math.min(Math.max(wanted, 0), whole);
      slider.value = shown;
      slider.setAttribute('aria-valuetext', states[shown].dataset.name);
      drawn.forEach((marks, step) => marks.forEach(mark => {
        mark.classList.toggle('later', step > shown);
        mark.classList.toggle('now', step === shown);
      }));
      states.forEach((state, step) =>
        step === shown ? state.setAttribute('aria-current', 'step') : state.removeAttribute('aria-current'));
      const name = document.createElement('b');
      name.textContent = states[shown].dataset.name + ' ';
      const own = shown === 0 || shown === whole ? [] : states[shown].cloneNode(true).childNodes;
      words.replaceChildren(name, ...own);
    };
    const move = by => show(Number(slider.value) + by);
    slider.addEventListener('input', () => show(Number(slider.value)));
    find('.previous').addEventListener('click', () => move(-1));
    find('.next').addEventListener('click', () => move(1));
    const keys = { ArrowLeft: () => move(-1), ArrowRight: () => move(1), Home: () => show(0), End: () => show(whole) };
    on_keys(keys, element => element === slider);
    controls.hidden = false;
    show(whole);
  }

  // Values. Lines are thin: each mark that tells something gets a wider one, unseen, to point at.
  const tip = find('.tip');
  const tell = (mark, x, y) => {
    tip.textContent = mark.getAttribute('aria-label');
    tip.hidden = false;
    const size = tip.getBoundingClientRect();
    tip.style.left = Math.max(4, Math.min(x + 12, innerWidth - size.width - 4)) + 'px';
    tip.style.top = Math.max(4, y - size.height - 8) + 'px';
  };
  const silence = () => { tip.hidden = true; };
  page.querySelectorAll('svg [aria-label]').forEach(mark => {
    const area = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    area.setAttribute('d', mark.getAttribute('d'));
    area.setAttribute('class', 'area');
    area.setAttribute('aria-hidden', 'true');
    mark.after(area);
    const seen = () => !mark.classList.contains('later');
    for (const each of [mark, area]) {
      const told = event => seen() ? tell(mark, event.clientX, event.clientY) : silence();
      each.addEventListener('pointermove', told);
      each.addEventListener('click', told);
      each.addEventListener('pointerleave', event => { if (event.pointerType !== 'touch') silence(); });
    }
    mark.addEventListener('focus', () => {
      const box = mark.getBoundingClientRect();
      tell(mark, (box.left + box.right) / 2, (box.top + box.bottom) / 2);
    });
    mark.addEventListener('blur', silence);
  });
  document.addEventListener('keydown', event => { if (event.key === 'Escape') silence(); });
  document.addEventListener('pointerdown', silence);  // what a finger has asked for stays until it asks for more
)";

}  // namespace epure
