// The front: hover tells of a design, a click chooses it, two are compared.
'use strict';

report.fronts = [];   // the charts
report.chosen = { a: 0, b: null };

report.groupsOf = (designs) => [...new Set(designs.map((design) => design.group))];

// Points of one group; a point knows its design.
report.groupSet = (pair, group, colour) => ({
  label: group,
  data: report.data.designs
    .map((design, i) => ({ x: design.objectives[pair.across], y: design.objectives[pair.up], i,
                           group: design.group }))
    .filter((point) => point.group === group),
  backgroundColor: colour,
  borderColor: colour,
  pointRadius: 3.5,
  pointHoverRadius: 6,
});

report.ringSet = (pair, label, i, colour, style) => ({
  label,
  data: i === null ? [] : [{ x: report.data.designs[i].objectives[pair.across],
                             y: report.data.designs[i].objectives[pair.up], i }],
  backgroundColor: 'transparent',
  borderColor: colour,
  borderWidth: 2.5,
  pointRadius: style === 'rectRot' ? 7 : 9,
  pointHoverRadius: 9,
  pointStyle: style,
});

report.frontSets = (pair) => {
  const { a, b } = report.chosen;
  const groups = report.groupsOf(report.data.designs);
  const sets = groups.map((group, i) =>
    report.groupSet(pair, group, report.colour('g' + (1 + i % 6))));
  if (report.data.front.knee !== null) {
    sets.push(report.ringSet(pair, 'knee', report.data.front.knee, report.colour('ink'), 'rectRot'));
  }
  sets.push(report.ringSet(pair, 'design A', a, report.colour('a'), 'circle'));
  if (b !== null) sets.push(report.ringSet(pair, 'design B', b, report.colour('b'), 'circle'));
  if (pair.bound) {
    sets.push({
      label: pair.bound.name,
      data: pair.bound.x.map((x, i) => ({ x, y: pair.bound.y[i] }))
        .filter((point) => point.x !== null && point.y !== null),
      showLine: true, pointRadius: 0, pointHitRadius: 0, borderWidth: 1.4, borderDash: [6, 4],
      borderColor: report.colour('ink'), backgroundColor: 'transparent', pointStyle: 'line',
    });
  }
  return sets;
};

// The frame shows the points, whatever else is drawn.
report.frontRange = (index) => {
  const values = report.data.designs.map((design) => design.objectives[index]);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const room = 0.03 * Math.max(high - low, 1e-9 * Math.abs(high), 1e-12);
  return { suggestedMin: low - room, suggestedMax: high + room };
};

report.frontAxis = (index) => {
  const objective = report.data.front.objectives[index];
  return report.axis({
    ...report.frontRange(index),
    title: { display: true, text: [objective.name, objective.unit].filter(Boolean).join(', '),
             font: { size: 13 } },
    ticks: { maxTicksLimit: 8, callback: (value) => report.text(value, 5) },
  });
};

report.frontTooltip = {
  displayColors: false,
  filter: (item, place, items) => items.findIndex((one) => one.raw.i === item.raw.i) === place,
  callbacks: {
    title: (items) => items.length ? report.data.designs[items[0].raw.i]?.label : '',
    label: (item) => (report.data.designs[item.raw.i]?.rows || []).slice(0, 8)
      .map(([what, text]) => what + ': ' + (text.length > 48 ? text.slice(0, 47) + '…' : text)),
  },
};

report.drawFront = (figure) => {
  const pair = report.data.front.pairs[Number(figure.dataset.pair)];
  const chart = new Chart(figure.querySelector('canvas'), {
    type: 'scatter',
    data: { datasets: report.frontSets(pair) },
    options: {
      animation: false,
      responsive: true,
      maintainAspectRatio: false,
      interaction: { mode: 'nearest', intersect: true },
      plugins: {
        legend: { position: 'bottom', labels: { usePointStyle: true, boxHeight: 7,
                                                color: report.colour('ink') } },
        tooltip: report.frontTooltip,
      },
      scales: { x: report.frontAxis(pair.across), y: report.frontAxis(pair.up) },
      onClick: (event, items, its) => report.frontClicked(event, its),
    },
  });
  report.fronts.push({ chart, pair });
};

report.frontClicked = (event, chart) => {
  const near = chart.getElementsAtEventForMode(event, 'nearest', { intersect: true }, true);
  const hit = near.map((item) => chart.data.datasets[item.datasetIndex].data[item.index])
    .find((point) => point.i !== undefined);
  if (!hit) return;
  const which = document.querySelector('input[name="chooses"]:checked').value;
  report.choose(event.native?.shiftKey ? 'b' : which, hit.i);
};

report.choose = (which, i) => {
  report.chosen[which] = i;
  const { a, b } = report.chosen;
  const { designs } = report.data;
  document.getElementById('design-a').value = String(a);
  document.getElementById('design-b').value = b === null ? '' : String(b);
  for (const { chart, pair } of report.fronts) {
    chart.data.datasets = report.frontSets(pair);
    chart.update();
  }
  report.compare();
  const stage = document.querySelector('.stage');
  if (stage && designs[a].scene) stage.innerHTML = designs[a].scene;
  report.show(b === null ? [designs[a]] : [designs[a], designs[b]]);
  report.goTo(report.place);
};

// A table with a column for each chosen design and, of numbers, the difference.
report.compare = () => {
  const { a, b } = report.chosen;
  const [first, second] = [report.data.designs[a], b === null ? null : report.data.designs[b]];
  const cell = (tag, text, number) => {
    const element = document.createElement(tag);
    element.textContent = text;
    if (number) element.className = 'number';
    return element;
  };
  const line = (cells) => {
    const row = document.createElement('tr');
    row.append(...cells);
    return row;
  };
  const head = [cell('th', ''), cell('th', 'A: ' + first.label, true)];
  if (second) head.push(cell('th', 'B: ' + second.label, true), cell('th', 'B − A', true));
  const rows = [line(head)];
  const names = [...new Set([...first.rows, ...(second ? second.rows : [])].map((row) => row[0]))];
  for (const name of names) {
    const of = (design) => design.rows.find((row) => row[0] === name) || [name, '–', null];
    const mine = of(first);
    const cells = [cell('td', name), cell('td', mine[1], mine[2] !== null)];
    if (second) {
      const other = of(second);
      const both = mine[2] !== null && other[2] !== null;
      cells.push(cell('td', other[1], other[2] !== null),
        cell('td', both ? report.text(other[2] - mine[2], 4) : '', true));
    }
    rows.push(line(cells));
  }
  document.getElementById('compare').replaceChildren(...rows);
};

report.fillSelect = (id, which, optional) => {
  const select = document.getElementById(id);
  if (optional) select.append(new Option('none', ''));
  report.data.designs.forEach((design, i) => select.append(new Option(design.label, String(i))));
  select.addEventListener('change',
    () => report.choose(which, select.value === '' ? null : Number(select.value)));
};

report.startFront = () => {
  if (!report.data.front) return;
  report.chosen.a = report.data.front.knee ?? 0;
  report.fillSelect('design-a', 'a', false);
  report.fillSelect('design-b', 'b', true);
  document.querySelectorAll('figure.front').forEach(report.drawFront);
  report.choose('a', report.chosen.a);
};
