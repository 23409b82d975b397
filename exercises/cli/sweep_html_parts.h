// What the page of a sweep looks like and does. No framework: every position is an inline SVG, of which one is seen,
// and a row of the table of all positions, from which the values beside it are taken. Neither text has an ampersand
// or a less-than, so that a parser of XML reads the page as a browser does.
#pragma once

namespace epure {

inline constexpr const char* style_of_sweep =
    R"(:root { --now: #c40; }
.show { display: grid; gap: 0 1.5rem; padding: 0 1rem; align-items: start; }
@media (min-width: 60rem) { .show.both { grid-template-columns: 1fr 1fr; } }
.sheet { margin: 0; }
.sheet svg { display: block; width: 100%; height: auto; max-height: max(16rem, calc(100vh - 15rem)); }
.pictures { display: grid; }
.scales, .position { grid-area: 1 / 1; min-width: 0; }
.position { visibility: hidden; }
.position.shown { visibility: visible; }
.charts { cursor: crosshair; touch-action: pan-y; }
.here { fill: none; stroke: var(--now); stroke-width: 220; }
.mark { fill: var(--now); stroke: var(--ground); stroke-width: 120; }
.none { font-style: italic; }
.none, .fault { max-width: 34rem; }
.bounds { font-size: .8rem; margin-left: 1rem; white-space: nowrap; }
.all .bounds { display: block; margin: 0; }
@media (max-width: 40rem) { .values .bounds { display: block; margin: 0; white-space: normal; } }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .2rem .9rem .2rem 0; border-bottom: 1px solid var(--edge); }
th { font-weight: normal; }
.values { margin: .5rem 0; padding: 0 1rem; }
.values .value { min-width: 14rem; }
.name { font-weight: bold; margin: .3rem 0; }
.all { max-width: 60rem; margin: 0 auto; padding: .5rem 1rem 1rem; }
.scroll { overflow-x: auto; }
.all tr[aria-current] { outline: 2px solid var(--now); }
@media print {
  body { font-size: 10pt; }
  h1 { margin: 0; }
  .controls, .all { display: none; }
  .show, .show.both { display: block; padding: 0; }
  .sheet { break-inside: avoid; margin-bottom: 5mm; }
  .sheet svg { max-height: none; }
  .charts svg { max-height: 100mm; }
  .values { padding: 0; margin: 0; max-width: none; break-inside: avoid; }
}
@page { size: A4; margin: 12mm; }
)";

inline constexpr const char* script_of_sweep = R"(
  const all = selector => [...page.querySelectorAll(selector)];
  const rows = all('.all tbody tr'), last = rows.length - 1;
  const pictures = all('.position'), values = all('.values .value'), told = find('.values');
  const slider = find('.slider'), play = find('.play'), name = find('.name'), fault = find('.fault');

  // On each chart a line where it is, on each curve a mark.
  const charts = find('.charts'), drawing = charts.querySelector('svg');
  const made = (element, kind) => {
    const shape = document.createElementNS('http://www.w3.org/2000/svg', element);
    shape.setAttribute('class', kind);
    shape.setAttribute('aria-hidden', 'true');
    return drawing.appendChild(shape);
  };
  const ends = charts.dataset.frames.split(' ').map(Number);
  const here = made('path', 'here');
  const marks = values.map(() => made('circle', 'mark'));
  marks.forEach(mark => mark.setAttribute('r', 800));

  let shown = 0, timer = 0;
  const show = wanted => {
    shown = Math.min(Math.max(wanted, 0), last);
    const row = rows[shown], cells = row.querySelectorAll('.value'), x = row.dataset.x;
    slider.value = shown;
    slider.setAttribute('aria-valuetext', row.dataset.name);
    name.replaceChildren(...row.querySelector('th').cloneNode(true).childNodes);
    pictures.forEach((picture, place) => picture.classList.toggle('shown', place === shown));
    values.forEach((value, i) => {
      value.replaceChildren(...cells[i].cloneNode(true).childNodes);
      const y = cells[i].dataset.y;
      marks[i].setAttribute('visibility', y ? 'visible' : 'hidden');
      marks[i].setAttribute('cx', x);
      marks[i].setAttribute('cy', y || 0);
    });
    if (fault) fault.replaceChildren(...row.querySelector('.faults').cloneNode(true).childNodes);
    let line = '';
    for (let i = 0; i !== ends.length; i += 2) line += 'M' + x + ' ' + ends[i] + 'V' + ends[i + 1];
    here.setAttribute('d', line);
    rows.forEach((each, place) =>
      place === shown ? each.setAttribute('aria-current', 'true') : each.removeAttribute('aria-current'));
  };

  // Once through takes some eight seconds; while it moves, nothing is read aloud.
  const is_playing = () => timer !== 0;
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    play.textContent = play.dataset.play;
    told.setAttribute('aria-live', 'polite');
  };
  const start = () => {
    told.setAttribute('aria-live', 'off');
    play.textContent = play.dataset.pause;
    if (shown === last) show(0);
    timer = setInterval(() => show(shown === last ? 0 : shown + 1), Math.max(40, 8000 / rows.length));
  };
  const turn = () => is_playing() ? stop() : start();
  const go = to => {
    if (is_playing()) stop();
    show(to);
  };
  play.addEventListener('click', turn);
  slider.addEventListener('input', () => go(Number(slider.value)));
  find('.previous').addEventListener('click', () => go(shown - 1));
  find('.next').addEventListener('click', () => go(shown + 1));
  const keys = { ArrowLeft: () => go(shown - 1), ArrowRight: () => go(shown + 1), Home: () => go(0),
    End: () => go(last), ' ': turn };
  // Of what has the focus: buttons are pressed by the space bar, the slider and the table move by arrows.
  const is_own = (element, key) => key === ' ' ? ['BUTTON', 'SUMMARY'].includes(element.tagName)
                                               : element === slider || element.className === 'scroll';
  on_keys(keys, is_own);

  // To point at a chart goes to the position that is nearest on the axis, on the same curve.
  const pick = event => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(drawing.getScreenCTM().inverse()).x;
    let best = shown;
    const apart = place => Math.abs(rows[place].dataset.x - at);
    rows.forEach((row, place) => {
      if (row.dataset.curve === rows[shown].dataset.curve) best = apart(best) > apart(place) ? place : best;
    });
    go(best);
  };
  charts.addEventListener('pointerdown', pick);
  charts.addEventListener('pointermove', event => { if (event.buttons === 1) pick(event); });

  find('.controls').hidden = false;
  show(0);
)";

}  // namespace epure
