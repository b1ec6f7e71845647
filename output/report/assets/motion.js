// The mechanism in motion, and the place of the cycle that is marked in every curve.
'use strict';

report.cycle = null;   // {lower, upper, unit} of the cycle that the curves run over
report.place = 0;
report.playing = false;

// The cycle is the axis of the first panel; a law's own curves over x are not along it.
report.findCycle = () => {
  const panel = (report.data.panels || [])[0];
  report.cycle = panel ? panel.x : null;
};

report.isAlong = (panel) =>
  report.cycle !== null && panel.x.label === report.cycle.label &&
  panel.x.upper === report.cycle.upper;

// What a curve, or the cycle's angle, has at the place; NaN where it has no value.
report.valueOf = (curve, design, place) => {
  if (curve === 'cycle') return place;
  const index = report.data.panels.findIndex((panel) => panel.id === curve);
  const value = index < 0 ? null : report.valueAt(design, index, place);
  return value === null ? NaN : value;
};

report.sine = (degrees) => Math.sin(degrees * Math.PI / 180);

// One step of a body's motion: "KIND CURVE DRAWN FACTOR X Y PHASE", from the pose that is drawn at the
// curve's value DRAWN.
report.stepAt = (step, design, place) => {
  const [kind, curve, ...numbers] = step.split(' ');
  const [drawn, factor, x, y, phase] = numbers.map(Number);
  const by = factor * (report.valueOf(curve, design, place) - drawn);
  if (!Number.isFinite(by)) return null;
  switch (kind) {
    case 'turn': return `rotate(${by} ${x} ${y})`;
    case 'slide': return `translate(${by * x} ${by * y})`;
    case 'harmonic': {
      const gained = report.sine(phase + by) - report.sine(phase);
      return `translate(${gained * x} ${gained * y})`;
    }
    default: throw new Error('no motion ' + kind);
  }
};

// The curves of an element on a body that turns about the y axis with the cycle, each point "RIGHT UP
// NEAR" in the coordinates that the body takes along.
report.spunCurves = (element) => {
  element.spun = element.spun || element.dataset.spun.split('|')
    .map((curve) => curve.split(',').map((point) => point.split(' ').map(Number)));
  return element.spun;
};

// The stretches on the near side as the d of a path: of one curve, or of what is between two.
report.nearParts = (curves) => {
  const isNear = (i) => curves.every((curve) => i < curve.length && curve[i][2] >= 0);
  const between = curves.length > 1;
  let text = '';
  for (let begin = 0, end = 0; end <= curves[0].length; end += 1) {
    if (isNear(end)) continue;
    const part = curves[0].slice(begin, end);
    if (between) part.push(...curves[1].slice(begin, end).reverse());
    if (end > begin + 1) {
      text += 'M' + part.map(([x, y]) => x.toFixed(2) + ' ' + y.toFixed(2)).join('L') +
        (between ? 'Z' : '');
    }
    begin = end + 1;
  }
  return text;
};

report.spinBodies = (scene, place) => {
  const [c, s] = [Math.cos(place * Math.PI / 180), report.sine(place)];
  for (const element of scene.querySelectorAll('[data-spun]')) {
    const curves = report.spunCurves(element)
      .map((curve) => curve.map(([x, y, near]) => [c * x + s * near, y, c * near - s * x]));
    const paths = [...element.querySelectorAll('path')];
    if (curves.length > 1) paths.shift().setAttribute('d', report.nearParts(curves));
    paths.forEach((path, i) => path.setAttribute('d', report.nearParts([curves[i]])));
  }
};

// A body without a value at the place stays where it was.
report.moveBodies = () => {
  const scene = document.querySelector('.scene');
  const design = report.shown[0];
  if (!scene || !design) return;
  for (const body of scene.querySelectorAll('[data-motion]')) {
    const steps = body.dataset.motion.split('; ')
      .map((step) => report.stepAt(step, design, report.place));
    if (!steps.includes(null)) body.setAttribute('transform', steps.join(' '));
  }
  report.spinBodies(scene, report.place);
};

// Sets one plot's cursor.
report.mark = (plot) => {
  const design = report.shown[0];
  if (!design || !plot.cursor || !report.isAlong(plot.panel)) return;
  const { x, y } = plot.chart.scales;
  const area = plot.chart.chartArea;
  if (!area) return;
  const value = report.valueAt(design, plot.index, report.place);
  plot.cursor.hidden = false;
  plot.cursor.style.transform = `translateX(${x.getPixelForValue(report.place)}px)`;
  plot.cursor.style.top = area.top + 'px';
  plot.cursor.style.height = area.bottom - area.top + 'px';
  const height = value === null ? -1 : y.getPixelForValue(value) - area.top;
  const inside = height >= 0 && height <= area.bottom - area.top;
  plot.dot.style.display = inside ? '' : 'none';
  plot.dot.style.top = height - 4 + 'px';
  const values = report.shown.map((one) => report.valueAt(one, plot.index, report.place));
  plot.output.textContent = report.withUnit(values.map((one) => report.text(one)).join(' | '),
    plot.panel.y.unit);
};

report.goTo = (place) => {
  if (report.cycle === null) return;
  report.place = Math.min(Math.max(place, report.cycle.lower), report.cycle.upper);
  const slider = document.getElementById('place');
  if (slider) {
    const text = report.withUnit(report.text(report.place, 4), report.cycle.unit);
    slider.value = 1000 * (report.place - report.cycle.lower) /
      (report.cycle.upper - report.cycle.lower);
    slider.setAttribute('aria-valuetext', text);
    document.getElementById('place-text').textContent = text;
  }
  report.moveBodies();
  report.plots.forEach(report.mark);
};

report.clicked = (plot, place) => {
  if (report.isAlong(plot.panel)) report.goTo(place);
};

// One cycle in six seconds; for readers who want less motion in twelve still pictures.
report.play = () => {
  const calm = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  const length = report.cycle.upper - report.cycle.lower;
  let before = null;
  let waited = 0;
  const frame = (now) => {
    if (!report.playing) return;
    const passed = before === null ? 0 : (now - before) / 6000;
    before = now;
    waited += passed;
    if (!calm || waited >= 1 / 12) {
      const next = report.place - report.cycle.lower + waited * length;
      report.goTo(report.cycle.lower + next % length);
      waited = 0;
    }
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
};

report.setPlaying = (on) => {
  const button = document.getElementById('play');
  report.playing = on;
  button.textContent = on ? 'Pause' : 'Play';
  button.setAttribute('aria-pressed', String(on));
  if (on) report.play();
};

report.startMotion = () => {
  report.findCycle();
  const slider = document.getElementById('place');
  if (slider && report.cycle) {
    slider.addEventListener('input', () => {
      report.setPlaying(false);
      const share = Number(slider.value) / 1000;
      report.goTo(report.cycle.lower + share * (report.cycle.upper - report.cycle.lower));
    });
    document.getElementById('play').addEventListener('click',
      () => report.setPlaying(!report.playing));
  }
  if (report.cycle) report.goTo(report.cycle.lower);
};
