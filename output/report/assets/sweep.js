// A sweep: which choice is best where, contours of the objective, what holds the designs, where
// there is none; of one number curves. Drawn as SVG, anew for each width and choice of axes.
'use strict';

report.sweepView = null;   // the axes, what colours tell, the values that are held

report.svg = (kind, attributes, text) => {
  const node = document.createElementNS('http://www.w3.org/2000/svg', kind);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  return node;
};

report.sweepTitle = (name) => [name.name.replaceAll('_', ' '), name.unit].filter(Boolean).join(', ');

// Of any number of values; a call with each as an argument has a limit.
report.min = (values) => values.reduce((a, b) => Math.min(a, b), Infinity);
report.max = (values) => values.reduce((a, b) => Math.max(a, b), -Infinity);

// What differs by less than 1e-9 of its size is equal: the first of the list counts.
report.isBetter = (a, b) => Math.abs(a - b) > 1e-9 * Math.max(Math.abs(a), Math.abs(b)) &&
  (report.data.sweep.maximize ? a > b : a < b);

// The number of a row along a name, the same that its axis has.
report.along = (row, k) => {
  const name = report.data.sweep.names[k];
  return name.sampled ? row.n[k - report.data.sweep.axes] : name.numbers[row.v[k]];
};

// Rows that the held values leave.
report.sweepRows = () => report.data.sweep.rows.filter((row) =>
  report.sweepView.held.every((value, k) => value === null || row.v[k] === value));

// Of rows at one place the best design; without one, the row that says why.
report.bestOf = (rows) => {
  let best = null;
  for (const row of rows) {
    if (row.s !== 'design') continue;
    if (best === null || report.isBetter(row.o, best.o)) best = row;
  }
  return best || rows.find((row) => row.s === 'passes') || rows.find((row) => row.s !== 'open') ||
    rows[0];
};

// What colours tell of a row: the choice that is best, or what holds the design.
report.groupOfRow = (row) => {
  const view = report.sweepView, sweep = report.data.sweep;
  if (row.s === 'open') return 'not done';
  if (row.s === 'passes') return 'violates ' + row.held.join(', ');
  if (row.s !== 'design') return 'no design: ' + (row.why || 'none was found');
  if (view.tells === 'held' && sweep.evaluated) return 'meets every limit';
  if (view.tells === 'held') return row.held.length ? 'held by ' + row.held.join(', ') : 'held by no limit';
  if (view.tells === 'objective') return 'design';
  const name = sweep.names[view.tells];
  return name.values[row.v[view.tells]];
};

// Groups by how often they come, the designs first; the rarest share a colour.
report.sweepGroups = (places) => {
  const count = new Map();
  for (const row of places) {
    const group = report.groupOfRow(row);
    const known = count.get(group) || { n: 0, bad: row.s !== 'design' };
    known.n += 1;
    count.set(group, known);
  }
  const good = [...count].filter(([, g]) => !g.bad).sort((a, b) => b[1].n - a[1].n);
  const bad = [...count].filter(([, g]) => g.bad).sort((a, b) => b[1].n - a[1].n);
  const look = new Map();
  good.forEach(([group], i) => look.set(group, {
    colour: i < 6 ? report.colour('g' + (i + 1)) : report.colour('soft'), bad: false,
    mark: i < 26 ? String.fromCharCode(65 + i) : '+' }));
  bad.forEach(([group], i) => look.set(group, {
    colour: report.colour('limit'), bad: true, mark: String(i + 1) }));
  return look;
};

report.ticksOf = (low, high, most) => {
  const raw = (high - low) / Math.max(1, most);
  if (!(raw > 0)) return [low];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((f) => f * power).find((s) => s >= raw * 0.999);
  const ticks = [];
  for (let t = Math.ceil(low / step - 1e-9) * step; t <= high + 1e-9 * step; t += step) {
    ticks.push(Math.abs(t) < 1e-9 * step ? 0 : t);
  }
  return ticks;
};

// A frame with axes; `x` and `y` take numbers to the picture.
report.sweepFrame = (box, across, up, size) => {
  const svg = report.svg('svg', { viewBox: `0 0 ${size.w} ${size.h}`, width: size.w, height: size.h,
                                  role: 'img', 'aria-label': `${up.title} over ${across.title}` });
  const left = 64, bottom = 46, top = 10, right = 12;
  const x = (v) => left + (v - across.low) / (across.high - across.low) * (size.w - left - right);
  const y = (v) => size.h - bottom - (v - up.low) / (up.high - up.low) * (size.h - top - bottom);
  const text = report.colour('soft'), line = report.colour('line');
  const label = (ax, ay, words, anchor, more = {}) => svg.append(report.svg('text', {
    x: ax, y: ay, fill: text, 'font-size': 12, 'text-anchor': anchor, ...more }, words));
  for (const t of report.ticksOf(across.low, across.high, size.w / 90)) {
    svg.append(report.svg('line', { x1: x(t), x2: x(t), y1: size.h - bottom, y2: size.h - bottom + 5,
                                    stroke: text }));
    label(x(t), size.h - bottom + 18, report.text(t, 5), 'middle');
  }
  for (const t of report.ticksOf(up.low, up.high, size.h / 60)) {
    svg.append(report.svg('line', { x1: left - 5, x2: left, y1: y(t), y2: y(t), stroke: text }));
    label(left - 8, y(t) + 4, report.text(t, 5), 'end');
  }
  svg.append(report.svg('rect', { x: left, y: top, width: size.w - left - right,
                                  height: size.h - top - bottom, fill: 'none', stroke: line }));
  label((left + size.w - right) / 2, size.h - 8, across.title, 'middle', { 'font-size': 13 });
  label(0, 0, up.title, 'middle', { 'font-size': 13,
    transform: `translate(14 ${(top + size.h - bottom) / 2}) rotate(-90)` });
  box.append(svg);
  return { svg, x, y };
};

report.edges = (numbers) => {
  const n = numbers.length;
  if (n === 1) return [numbers[0] - 0.5, numbers[0] + 0.5];
  const inner = numbers.slice(1).map((v, i) => (v + numbers[i]) / 2);
  return [numbers[0] - (inner[0] - numbers[0]), ...inner,
          numbers[n - 1] + (numbers[n - 1] - inner[n - 2])];
};

// Marching squares on a grid that may have holes: pieces of the line value = level.
report.contour = (xs, ys, value, level) => {
  const pieces = [];
  const cross = (a, b, va, vb) => {
    const t = (level - va) / (vb - va);
    return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
  };
  for (let i = 0; i + 1 < xs.length; ++i) {
    for (let j = 0; j + 1 < ys.length; ++j) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const v = corners.map(([a, b]) => value(a, b));
      if (v.some((one) => one === null)) continue;
      const p = corners.map(([a, b]) => [xs[a], ys[b]]);
      const cut = [];
      for (let k = 0; k < 4; ++k) {
        const m = (k + 1) % 4;
        if ((v[k] >= level) !== (v[m] >= level)) cut.push(cross(p[k], p[m], v[k], v[m]));
      }
      for (let k = 0; k + 1 < cut.length; k += 2) pieces.push([cut[k], cut[k + 1]]);
    }
  }
  return pieces;
};

report.tellRow = (row) => {
  const sweep = report.data.sweep, box = document.getElementById('swept');
  const facts = sweep.names.map((name, k) => [name.name.replaceAll('_', ' '),
    name.sampled || name.numeric ? report.text(report.along(row, k), 6) + (name.unit ? ' ' + name.unit : '')
                                 : name.values[row.v[k]]]);
  if (row.o !== null) {
    facts.push([sweep.objective.name.replaceAll('_', ' '),
                report.text(row.o, 6) + (sweep.objective.unit ? ' ' + sweep.objective.unit : '')]);
  }
  facts.push(['verdict', row.verdict]);
  if (row.held.length) facts.push([row.s === 'passes' ? 'violates' : 'held by', row.held.join(', ')]);
  if (row.why) facts.push(['why', row.why]);
  sweep.limits.forEach((limit, k) => {
    if (row.m && row.m[k] !== null && row.m[k] !== undefined) {
      facts.push(['margin of ' + limit.name.replaceAll('_', ' '),
                  report.text(row.m[k], 4) + (limit.unit ? ' ' + limit.unit : '')]);
    }
  });
  box.replaceChildren(...facts.map(([what, words]) => {
    const tr = document.createElement('tr'), th = document.createElement('th'),
          td = document.createElement('td');
    th.textContent = what; td.textContent = words;
    tr.append(th, td);
    return tr;
  }));
};

report.sweepLegend = (look, more) => {
  const box = document.getElementById('sweep-legend');
  const items = [...look].map(([group, { colour, bad, mark }]) => {
    const item = document.createElement('li');
    const key = document.createElement('b');
    key.textContent = mark;
    key.style.background = bad ? 'transparent' : colour;
    key.style.color = bad ? colour : report.colour('paper');
    key.style.border = '1px solid ' + colour;
    item.append(key, ' ' + group.replaceAll('_', ' '));
    return item;
  });
  for (const words of more) {
    const item = document.createElement('li');
    item.textContent = words;
    items.push(item);
  }
  box.replaceChildren(...items);
};

report.hatch = (svg) => {
  const pattern = report.svg('pattern', { id: 'hatch', width: 7, height: 7,
    patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)' });
  pattern.append(report.svg('rect', { width: 7, height: 7, fill: report.colour('panel') }),
                 report.svg('line', { x1: 0, x2: 0, y1: 0, y2: 7, stroke: report.colour('limit'),
                                      'stroke-width': 1.4, 'stroke-opacity': 0.55 }));
  const defs = report.svg('defs', {});
  defs.append(pattern);
  svg.append(defs);
};

report.shade = (colour, part) => `color-mix(in srgb, ${colour} ${Math.round(part * 100)}%, ${report.colour('paper')})`;

// How strong a colour is: the better the objective, the stronger.
report.strength = (row, range) => {
  if (row.o === null || !(range[1] > range[0])) return 0.6;
  const part = (row.o - range[0]) / (range[1] - range[0]);
  return 0.25 + 0.55 * (report.data.sweep.maximize ? part : 1 - part);
};

report.drawMap = (box, size) => {
  const sweep = report.data.sweep, view = report.sweepView;
  const nx = sweep.names[view.across], ny = sweep.names[view.up], rows = report.sweepRows();
  const order = (name) => name.numbers.map((_, i) => i).sort((a, b) => name.numbers[a] - name.numbers[b]);
  const ox = order(nx), oy = order(ny);
  const xs = ox.map((i) => nx.numbers[i]), ys = oy.map((i) => ny.numbers[i]);
  const ex = report.edges(xs), ey = report.edges(ys);
  const place = new Map();
  for (const row of rows) {
    const key = row.v[view.across] + ' ' + row.v[view.up];
    if (!place.has(key)) place.set(key, []);
    place.get(key).push(row);
  }
  const at = (i, j) => {
    const there = place.get(ox[i] + ' ' + oy[j]);
    return there ? report.bestOf(there) : null;
  };
  const grid = xs.map((_, i) => ys.map((_, j) => at(i, j)));
  const flat = grid.flat().filter(Boolean);
  const look = report.sweepGroups(flat);
  const values = flat.filter((r) => r.o !== null && r.s !== 'open').map((r) => r.o);
  const range = [report.min(values), report.max(values)];
  const { svg, x, y } = report.sweepFrame(box,
    { low: ex[0], high: ex[ex.length - 1], title: report.sweepTitle(nx) },
    { low: ey[0], high: ey[ey.length - 1], title: report.sweepTitle(ny) }, size);
  report.hatch(svg);
  const marks = flat.length <= 400;
  grid.forEach((column, i) => column.forEach((row, j) => {
    if (!row) return;
    const group = report.groupOfRow(row), its = look.get(group);
    const w = Math.abs(x(ex[i + 1]) - x(ex[i])), h = Math.abs(y(ey[j + 1]) - y(ey[j]));
    const cell = report.svg('rect', { x: x(ex[i]), y: y(ey[j + 1]), width: w + 0.3, height: h + 0.3,
      fill: its.bad ? 'url(#hatch)' : report.shade(its.colour, report.strength(row, range)) });
    cell.append(report.svg('title', {}, group + (row.o === null ? '' : ': ' + report.text(row.o, 5))));
    cell.addEventListener('click', () => report.tellRow(row));
    cell.addEventListener('mouseenter', () => report.tellRow(row));
    svg.append(cell);
    if (marks && w > 15 && h > 13) {
      svg.append(report.svg('text', { x: x(ex[i]) + w / 2, y: y(ey[j + 1]) + h / 2 + 4,
        'text-anchor': 'middle', 'font-size': 10.5, 'pointer-events': 'none',
        fill: report.colour(its.bad ? 'limit' : 'ink'), 'fill-opacity': 0.75 }, its.mark));
    }
  }));
  // Where one group ends and another begins.
  const edge = (x1, y1, x2, y2) => svg.append(report.svg('line', { x1, y1, x2, y2,
    stroke: report.colour('ink'), 'stroke-width': 1.6 }));
  const held = (row) => (row && row.s === 'design' ? row.held.join(', ') : row ? row.s : '');
  const limit = (x1, y1, x2, y2) => svg.append(report.svg('line', { x1, y1, x2, y2,
    stroke: report.colour('limit'), 'stroke-width': 1.6, 'stroke-dasharray': '5 3' }));
  const draw = (a, b, x1, y1, x2, y2) => {
    if (!a || !b) return;
    if (report.groupOfRow(a) !== report.groupOfRow(b)) edge(x1, y1, x2, y2);
    else if (held(a) !== held(b)) limit(x1, y1, x2, y2);
  };
  grid.forEach((column, i) => column.forEach((row, j) => {
    if (i + 1 < grid.length) draw(row, grid[i + 1][j], x(ex[i + 1]), y(ey[j]), x(ex[i + 1]), y(ey[j + 1]));
    if (j + 1 < column.length) draw(row, column[j + 1], x(ex[i]), y(ey[j + 1]), x(ex[i + 1]), y(ey[j + 1]));
  }));
  const objective = (i, j) => (grid[i][j] && grid[i][j].o !== null ? grid[i][j].o : null);
  const levels = report.ticksOf(range[0], range[1], 7);
  const drawContour = (pieces, colour, words, dash) => {
    if (!pieces.length) return;
    svg.append(report.svg('path', { fill: 'none', stroke: colour, 'stroke-width': 1.2,
      'pointer-events': 'none', 'stroke-dasharray': dash,
      d: pieces.map(([a, b]) => `M${x(a[0])} ${y(a[1])}L${x(b[0])} ${y(b[1])}`).join('') }));
    const [a, b] = pieces[Math.floor(pieces.length / 2)];
    svg.append(report.svg('text', { x: (x(a[0]) + x(b[0])) / 2, y: (y(a[1]) + y(b[1])) / 2 - 3,
      'font-size': 11, 'font-weight': 600, 'text-anchor': 'middle', fill: colour, stroke: report.colour('paper'),
      'stroke-width': 3, 'paint-order': 'stroke', 'pointer-events': 'none' }, words));
  };
  for (const level of levels) {
    drawContour(report.contour(xs, ys, objective, level), report.colour('ink'), report.text(level, 5), '');
  }
  if (sweep.evaluated) {
    sweep.limits.forEach((one, k) => {
      const margin = (i, j) => (grid[i][j] && grid[i][j].m ? grid[i][j].m[k] : null);
      drawContour(report.contour(xs, ys, margin, 0), report.colour('limit'),
                  one.name.replaceAll('_', ' '), '6 3');
    });
  }
  const more = ['lines: ' + report.sweepTitle(sweep.objective)];
  more.push(sweep.evaluated ? 'dashed: where a limit is reached'
                            : 'dashed: where other limits begin to hold the design');
  report.sweepLegend(look, more);
};

report.drawSamples = (box, size) => {
  const sweep = report.data.sweep, view = report.sweepView, rows = report.sweepRows();
  const range = (k) => {
    const all = rows.map((row) => report.along(row, k));
    const low = report.min(all), high = report.max(all), room = 0.04 * (high - low || 1);
    return { low: low - room, high: high + room, title: report.sweepTitle(sweep.names[k]) };
  };
  const values = rows.filter((r) => r.o !== null).map((r) => r.o);
  const objectives = [report.min(values), report.max(values)];
  const look = report.sweepGroups(rows);
  const { svg, x, y } = report.sweepFrame(box, range(view.across), range(view.up), size);
  report.hatch(svg);
  for (const row of rows) {
    const its = look.get(report.groupOfRow(row));
    const dot = report.svg('circle', { cx: x(report.along(row, view.across)),
      cy: y(report.along(row, view.up)), r: rows.length > 500 ? 3 : 6, stroke: its.colour,
      fill: its.bad ? 'url(#hatch)' : report.shade(its.colour, report.strength(row, objectives)) });
    dot.append(report.svg('title', {}, report.groupOfRow(row) +
                                        (row.o === null ? '' : ': ' + report.text(row.o, 5))));
    dot.addEventListener('click', () => report.tellRow(row));
    dot.addEventListener('mouseenter', () => report.tellRow(row));
    svg.append(dot);
  }
  report.sweepLegend(look, ['the stronger a colour, the better the objective']);
};

// Over one number: a curve for each choice.
report.drawCurves = (box, size) => {
  const sweep = report.data.sweep, view = report.sweepView, rows = report.sweepRows();
  const name = sweep.names[view.across];
  const across = rows.map((row) => report.along(row, view.across));
  const values = rows.filter((r) => r.o !== null).map((r) => r.o);
  if (!values.length) {
    box.append('No combination has a design.');
    return;
  }
  const room = 0.05 * (report.max(values) - report.min(values) || Math.abs(values[0]) || 1);
  const gap = 0.02 * (report.max(across) - report.min(across) || 1);
  const { svg, x, y } = report.sweepFrame(box,
    { low: report.min(across) - gap, high: report.max(across) + gap, title: report.sweepTitle(name) },
    { low: report.min(values) - room, high: report.max(values) + room,
      title: report.sweepTitle(sweep.objective) }, size);
  report.hatch(svg);
  const word = sweep.names.findIndex((n, k) => !n.numeric && report.sweepView.held[k] === null);
  const lines = new Map();
  for (const row of rows) {
    const key = word < 0 ? report.sweepTitle(sweep.objective) : sweep.names[word].values[row.v[word]];
    if (!lines.has(key)) lines.set(key, new Map());
    const at = lines.get(key), place = report.along(row, view.across);
    at.set(place, [...(at.get(place) || []), row]);
  }
  const look = new Map();
  let hatched = false;
  [...lines].forEach(([key, places], i) => {
    const colour = i < 6 ? report.colour('g' + (i + 1)) : report.colour('soft');
    const mark = i < 26 ? String.fromCharCode(65 + i) : '+';
    look.set(key, { colour, bad: false, mark });
    const sorted = [...places].sort((a, b) => a[0] - b[0])
      .map(([place, all]) => [place, report.bestOf(all)]);
    let path = '', open = false, last = null;
    for (const [place, row] of sorted) {
      if (row.o === null || row.s === 'open') { open = false; continue; }
      path += `${open ? 'L' : 'M'}${x(place)} ${y(row.o)}`;
      open = true;
      last = [place, row];
    }
    svg.append(report.svg('path', { d: path, fill: 'none', stroke: colour, 'stroke-width': 1.8 }));
    for (const [place, row] of sorted) {
      const missing = row.o === null || row.s === 'open';
      hatched ||= missing || row.s === 'passes';
      const dot = report.svg('circle', { cx: x(place), r: 4.5, stroke: missing ? report.colour('limit') : colour,
        cy: missing ? y(report.min(values) - room) : y(row.o),
        fill: missing || row.s === 'passes' ? 'url(#hatch)' : colour });
      dot.append(report.svg('title', {}, report.groupOfRow(row)));
      dot.addEventListener('click', () => report.tellRow(row));
      dot.addEventListener('mouseenter', () => report.tellRow(row));
      svg.append(dot);
    }
    if (last) {
      svg.append(report.svg('text', { x: x(last[0]) - 9, y: y(last[1].o) - 8, 'font-size': 11,
        'font-weight': 700, fill: colour, 'text-anchor': 'end', stroke: report.colour('paper'),
        'stroke-width': 3, 'paint-order': 'stroke' }, mark));
    }
  });
  report.sweepLegend(look, hatched ? ['hatched: no design there, or one that violates a limit'] : []);
};

// Words alone: bars, the best first.
report.drawBars = (box, size) => {
  const sweep = report.data.sweep, rows = report.sweepRows();
  const k = report.sweepView.across, groups = new Map();
  for (const row of rows) groups.set(row.v[k], [...(groups.get(row.v[k]) || []), row]);
  const bars = [...groups].map(([value, all]) => [sweep.names[k].values[value], report.bestOf(all)])
    .sort((a, b) => (a[1].o === null) - (b[1].o === null) ||
                    (report.isBetter(a[1].o, b[1].o) ? -1 : 1));
  const step = 22, left = Math.min(220, size.w * 0.42), h = bars.length * step + 8;
  const svg = report.svg('svg', { viewBox: `0 0 ${size.w} ${h}`, width: size.w, height: h, role: 'img',
    'aria-label': report.sweepTitle(sweep.objective) });
  const values = bars.map(([, row]) => row.o).filter((o) => o !== null);
  const low = Math.min(0, ...values), high = Math.max(0, ...values) || 1;
  const x = (v) => left + (v - low) / (high - low) * (size.w - left - 76);
  bars.forEach(([name, row], i) => {
    const top = i * step;
    const words = name.length > left / 7 ? name.slice(0, Math.floor(left / 7) - 1) + '…' : name;
    svg.append(report.svg('text', { x: left - 8, y: top + 15, 'text-anchor': 'end', 'font-size': 12.5,
                                    fill: report.colour('ink') }, words));
    if (row.o !== null) {
      const bar = report.svg('rect', { x: Math.min(x(0), x(row.o)), y: top + 3, height: step - 7,
        width: Math.abs(x(row.o) - x(0)), fill: report.colour(row.s === 'design' ? 'a' : 'limit') });
      bar.addEventListener('click', () => report.tellRow(row));
      bar.addEventListener('mouseenter', () => report.tellRow(row));
      svg.append(bar);
    }
    svg.append(report.svg('text', { x: row.o === null ? left : x(Math.max(row.o, 0)) + 6, y: top + 15,
      'font-size': 12, fill: report.colour('soft') }, row.o === null ? 'no design' : report.text(row.o, 5)));
  });
  box.append(svg);
  report.sweepLegend(new Map(), [report.sweepTitle(sweep.objective)]);
};

report.drawSweep = () => {
  const box = document.getElementById('sweep-map');
  if (!box || !report.sweepView) return;
  box.replaceChildren();
  const w = Math.max(280, Math.min(box.clientWidth, 980));
  const size = { w, h: Math.round(Math.min(0.62 * w + 60, 560)) };
  const view = report.sweepView, names = report.data.sweep.names;
  if (!names[view.across].numeric) report.drawBars(box, size);
  else if (view.up === null) report.drawCurves(box, size);
  else if (names[view.across].sampled || names[view.up].sampled) report.drawSamples(box, size);
  else report.drawMap(box, size);
  document.querySelectorAll('#sweep-held label').forEach((label) => {
    const k = Number(label.dataset.name);
    label.hidden = k === view.across || k === view.up || names[k].sampled;
  });
};

report.sweepSelect = (title, options, chosen, take) => {
  const label = document.createElement('label'), select = document.createElement('select');
  options.forEach(([value, words]) => {
    const option = document.createElement('option');
    option.value = value; option.textContent = words;
    select.append(option);
  });
  select.value = chosen;
  select.addEventListener('change', () => { take(select.value); report.drawSweep(); });
  label.append(title + ' ', select);
  return label;
};

report.startSweep = () => {
  const sweep = report.data.sweep;
  if (!sweep) return;
  const numeric = sweep.names.map((name, k) => k).filter((k) => sweep.names[k].numeric);
  const words = sweep.names.map((name, k) => k).filter((k) => !sweep.names[k].numeric);
  const varied = words.find((k) => sweep.names[k].values.length > 1);
  report.sweepView = {
    across: numeric.length ? numeric[0] : 0,
    up: numeric.length > 1 ? numeric[1] : null,
    tells: varied !== undefined ? varied : 'held',
    held: sweep.names.map(() => null),
  };
  const view = report.sweepView, box = document.getElementById('sweep-controls');
  const title = (k) => sweep.names[k].name.replaceAll('_', ' ');
  const choices = numeric.length ? numeric : words;
  box.append(report.sweepSelect('across', choices.map((k) => [k, title(k)]), view.across, (k) => {
    const other = view.across;
    view.across = Number(k);
    if (view.up === view.across) view.up = other;
    box.querySelectorAll('select')[1] && (box.querySelectorAll('select')[1].value = view.up ?? '');
  }));
  if (numeric.length > 1) {
    box.append(report.sweepSelect('up', [['', 'the objective'], ...numeric.map((k) => [k, title(k)])],
      view.up, (k) => {
        view.up = k === '' ? null : Number(k);
        if (view.up === view.across) view.across = numeric.find((n) => n !== view.up);
        box.querySelectorAll('select')[0].value = view.across;
      }));
  }
  if (numeric.length) {
    const tells = words.map((k) => [k, 'best ' + title(k)]);
    box.append(report.sweepSelect('colours show', [...tells, ['held', 'what holds the design'],
      ['objective', 'the objective']], view.tells,
      (k) => { view.tells = k === 'held' || k === 'objective' ? k : Number(k); }));
  }
  const held = document.getElementById('sweep-held');
  sweep.names.forEach((name, k) => {
    if (name.sampled || name.values.length < 2) return;
    const label = report.sweepSelect(title(k), [['', 'the best of all'],
      ...name.values.map((value, i) => [i, value])], '',
      (value) => { view.held[k] = value === '' ? null : Number(value); });
    label.dataset.name = k;
    held.append(label);
  });
  report.drawSweep();
  let width = window.innerWidth;
  window.addEventListener('resize', () => {
    if (window.innerWidth === width) return;
    width = window.innerWidth;
    report.drawSweep();
  });
};
