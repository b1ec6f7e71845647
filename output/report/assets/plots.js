// What all of a report's scripts share, and curves over the cycle drawn with Chart.js.
'use strict';

const report = {
  data: JSON.parse(document.getElementById('data').textContent),
  plots: [],   // of panels: {panel, figure, chart, cursor, dot, output}
  shown: [],   // the designs whose curves are drawn: A, then B
  errors: [],
};

// What goes wrong is kept where a test, or a reader who asks, can see it.
window.addEventListener('error', (event) => report.errors.push(event.message));
window.addEventListener('unhandledrejection', (event) => report.errors.push(String(event.reason)));

report.colour = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

// A number for people: so many digits, with a real minus.
report.text = (value, digits = 5) => {
  if (value === null || !Number.isFinite(value)) return '–';
  return String(Number(value.toPrecision(digits))).replace('-', '−');
};

report.withUnit = (text, unit) => (unit && text !== '–' ? text + '\u00a0' + unit : text);

// The samples of one panel of a design, as Chart.js takes them.
report.points = (design, index) => {
  const line = design.lines[index];
  const places = design.grids[line.grid];
  return line.y.map((y, i) => ({ x: places[i], y: y === null ? NaN : y }));
};

// The value of a panel's curve at a place, between samples in proportion.
report.valueAt = (design, index, place) => {
  const line = design.lines[index];
  const x = design.grids[line.grid];
  let low = 0;
  let high = x.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle] <= place) low = middle; else high = middle;
  }
  const [from, to] = [line.y[low], line.y[high]];
  if (from === null || to === null || x[high] === x[low]) return from;
  return from + (to - from) * (place - x[low]) / (x[high] - x[low]);
};

// Between which values curves are nearly always: all but a hundredth of their cycle to either side.
// Samples are not even, so each counts as much as it is from its neighbours.
report.usualRange = (series) => {
  const parts = series.flatMap((line) => line.map((p, i) => ({
    y: p.y, weight: line[Math.min(i + 1, line.length - 1)].x - line[Math.max(i - 1, 0)].x,
  }))).filter((part) => Number.isFinite(part.y)).sort((a, b) => a.y - b.y);
  const whole = parts.reduce((sum, part) => sum + part.weight, 0);
  const at = (share) => {
    let passed = 0;
    const found = parts.find((part) => (passed += part.weight) >= share * whole);
    return (found || parts[parts.length - 1]).y;
  };
  return parts.length === 0 ? null : { low: at(0.01), high: at(0.99) };
};

// The least and the greatest value to be shown: not a spike that would press all the rest flat, which
// is marked with its value where it leaves the chart (report.spikePlugin).
report.shownRange = (series) => {
  const values = series.flat().map((p) => p.y).filter(Number.isFinite);
  const range = { low: values.reduce((a, b) => Math.min(a, b), Infinity),
                  high: values.reduce((a, b) => Math.max(a, b), -Infinity), below: false, above: false };
  const usual = report.usualRange(series);
  if (usual === null) return range;
  const span = usual.high - usual.low;
  const size = Math.max(Math.abs(usual.low), Math.abs(usual.high));
  if (!(span > 1e-3 * size)) return range;  // it is constant but for its spikes
  const far = 5 * span;
  const isAbove = range.high - usual.high > far;
  const isBelow = usual.low - range.low > far;
  const step = 10 ** Math.floor(Math.log10(span));  // the axis ends at a number in few digits
  const high = step * Math.ceil((usual.high + 0.2 * span) / step);
  const low = step * Math.floor((usual.low - 0.2 * span) / step);
  if (isAbove) Object.assign(range, { high, above: true });
  if (isBelow) Object.assign(range, { low, below: true });
  return range;
};

// Limits far beyond the curve are named under it, but do not press it flat.
report.rangeOf = (panel, series) => {
  let { low, high, above, below } = report.shownRange(series);
  if (!(low <= high)) return {};
  const size = Math.max(Math.abs(low), Math.abs(high));
  const span = size < 1e-12 ? 1 : Math.max(high - low, 1e-3 * size);
  for (const limit of panel.limits) {
    if (limit > high && limit - high < 4 * span) high = limit;
    if (limit < low && low - limit < 4 * span) low = limit;
  }
  if (panel.y.lower !== null) return { min: panel.y.lower, max: panel.y.upper };
  if (above || below) {
    return { ...(below ? { min: low } : { suggestedMin: low }),
             ...(above ? { max: high } : { suggestedMax: high }) };
  }
  return high - low < span ? { suggestedMin: low - span, suggestedMax: high + span }
    : { suggestedMin: low, suggestedMax: high };
};

report.axis = (options) => ({
  type: 'linear',
  grid: { color: report.colour('line'), borderColor: report.colour('line') },
  ...options,
  ticks: { color: report.colour('soft'), maxRotation: 0, font: { size: 11 }, ...options.ticks },
  title: { display: false, color: report.colour('soft'), ...options.title },
});

// Angles are read in quarters and thirds of a turn.
report.stepOf = (axis) => {
  const whole = axis.unit === 'deg' && (axis.upper - axis.lower) % 360 === 0;
  return whole ? (axis.upper - axis.lower) / 6 : undefined;
};

// The colours of designs over one another, as in report.css.
report.seriesColour = (i) => report.colour(['a', 'b', 'g3', 'g4'][i]);
report.seriesDash = (i) => [[], [9, 4], [3, 3], [10, 3, 2, 3]][i];
report.letter = (i) => 'ABCD'[i];

report.datasets = (panel, index) => {
  const sets = report.shown.map((design, i) => ({
    label: design.label || panel.name,
    data: report.points(design, index),
    borderColor: report.seriesColour(i),
    backgroundColor: report.seriesColour(i),
    borderDash: report.seriesDash(i),
    borderWidth: 1.7,
  }));
  for (const limit of panel.limits) {
    sets.push({
      label: 'limit',
      data: [{ x: panel.x.lower, y: limit }, { x: panel.x.upper, y: limit }],
      borderColor: report.colour('limit'),
      borderDash: [6, 4],
      borderWidth: 1.4,
      isLimit: true,
    });
  }
  return sets;
};

report.tooltip = (panel) => ({
  filter: (item) => !item.dataset.isLimit,
  displayColors: false,
  callbacks: {
    title: (items) => items.length === 0 ? ''
      : report.withUnit(report.text(items[0].parsed.x, 4), panel.x.unit),
    label: (item) => (report.shown.length > 1 ? item.dataset.label + ': ' : '') +
      report.withUnit(report.text(item.parsed.y), panel.y.unit),
  },
});

// Which line is whose, where there are several; a design without the curve has no entry.
report.legend = () => ({
  display: report.shown.length > 1,
  position: 'top',
  align: 'end',
  onClick: () => {},
  labels: {
    boxWidth: 18, boxHeight: 0, padding: 8, color: report.colour('ink'),
    generateLabels: (chart) => chart.data.datasets.map((set, i) => ({ set, i }))
      .filter(({ set }) => !set.isLimit && set.data.some((p) => Number.isFinite(p.y)))
      .map(({ set, i }) => ({ text: report.letter(i), strokeStyle: set.borderColor, lineWidth: 2,
                              lineDash: set.borderDash,
                              fontColor: report.colour('ink'), datasetIndex: i })),
  },
});

// Rises and returns of the motion lie behind the curves; over that of the displacement they and the
// dwells between them have their names.
report.spansOf = (panel) =>
  (panel.x.unit === 'deg' && panel.x.lower === 0 && panel.x.upper === 360 && report.data.spans) || [];
report.hasSpanNames = (panel) =>
  panel.id.endsWith('displacement') && report.spansOf(panel).length > 0;

report.spanPlugin = (panel) => ({
  id: 'spans',
  beforeDatasetsDraw: (chart) => {
    const { ctx, chartArea: area, scales } = chart;
    ctx.save();
    ctx.font = `11px ${Chart.defaults.font.family}`;
    ctx.textAlign = 'center';
    for (const span of report.spansOf(panel)) {
      const [left, right] = [span.from, span.to].map((at) => scales.x.getPixelForValue(at));
      if (span.kind !== 'dwell') {
        ctx.globalAlpha = 0.1;
        ctx.fillStyle = report.colour(span.kind === 'rise' ? 'a' : 'b');
        ctx.fillRect(left, area.top, right - left, area.bottom - area.top);
      }
      if (!report.hasSpanNames(panel) || ctx.measureText(span.kind).width > right - left - 2) continue;
      ctx.globalAlpha = 1;
      ctx.fillStyle = report.colour('soft');
      ctx.fillText(span.kind, (left + right) / 2, area.top - 4);
    }
    ctx.restore();
  },
});

// Where a curve leaves the chart, its greatest value there, with an arrow.
report.spikePlugin = (panel) => ({
  id: 'spikes',
  afterDatasetsDraw: (chart) => {
    const { ctx, chartArea: area, scales: { x, y } } = chart;
    ctx.save();
    ctx.font = `11px ${Chart.defaults.font.family}`;
    ctx.fillStyle = report.colour('ink');
    for (const sign of [1, -1]) {
      let worst = null;
      for (const set of chart.data.datasets) {
        if (set.isLimit) continue;
        for (const p of set.data) {
          const beyond = sign > 0 ? p.y > y.max : p.y < y.min;
          if (beyond && (worst === null || sign * (p.y - worst.y) > 0)) worst = p;
        }
      }
      if (worst === null) continue;
      const at = x.getPixelForValue(worst.x);
      const isLeft = at > (area.left + area.right) / 2;
      const arrow = sign > 0 ? '↑' : '↓';
      const text = report.withUnit(report.text(worst.y, 4), panel.y.unit);
      ctx.textAlign = isLeft ? 'right' : 'left';
      ctx.fillText(isLeft ? `${text} ${arrow}` : `${arrow} ${text}`, at + (isLeft ? -3 : 3),
        sign > 0 ? area.top + 11 : area.bottom - 4);
    }
    ctx.restore();
  },
});

report.yAxis = (panel, index) => report.axis({
  ...report.rangeOf(panel, report.shown.map((design) => report.points(design, index))),
  ticks: { maxTicksLimit: 7, callback: (value) => report.text(value, 6) },
  afterFit: (scale) => { scale.width = 58; },
});

report.plot = (figure) => {
  const index = Number(figure.dataset.panel);
  const panel = report.data.panels[index];
  const canvas = figure.querySelector('canvas');
  const plot = { panel, index, figure, output: figure.querySelector('output') };
  plot.chart = new Chart(canvas, {
    type: 'line',
    data: { datasets: report.datasets(panel, index) },
    plugins: [report.spanPlugin(panel), report.spikePlugin(panel)],
    options: {
      animation: false,
      responsive: true,
      maintainAspectRatio: false,
      parsing: false,
      normalized: true,
      elements: {
        point: { radius: 0, hitRadius: 0 },
        // Chart.js draws a straight line through many points by the least and the greatest of each
        // pixel, which makes steps of a slope; a curve it draws through every point.
        line: { tension: 1e-9, capBezierPoints: false },
      },
      interaction: { mode: 'nearest', axis: 'x', intersect: false },
      layout: { padding: { top: report.hasSpanNames(panel) ? 14 : 0 } },
      plugins: { legend: report.legend(), tooltip: report.tooltip(panel) },
      scales: {
        x: report.axis({
          min: panel.x.lower, max: panel.x.upper,
          ticks: { stepSize: report.stepOf(panel.x), maxTicksLimit: 8 },
          title: { display: true, text: [panel.x.label, panel.x.unit].filter(Boolean).join(', ') },
        }),
        y: report.yAxis(panel, index),
      },
      onClick: (event, items, chart) => report.clicked(plot, chart.scales.x.getValueForPixel(event.x)),
      onResize: () => requestAnimationFrame(() => report.mark(plot)),
    },
  });
  report.addCursor(plot);
  report.plots.push(plot);
};

report.addCursor = (plot) => {
  plot.cursor = document.createElement('div');
  plot.cursor.className = 'cursor';
  plot.cursor.hidden = true;
  plot.dot = document.createElement('i');
  plot.cursor.append(plot.dot);
  plot.figure.querySelector('.canvas').append(plot.cursor);
};

// Draws the designs A and B, or A alone, in every panel.
report.show = (designs) => {
  report.shown = designs;
  for (const plot of report.plots) {
    plot.chart.data.datasets = report.datasets(plot.panel, plot.index);
    plot.chart.options.scales.y = report.yAxis(plot.panel, plot.index);
    plot.chart.options.plugins.legend = report.legend();
    plot.chart.update();
  }
};
