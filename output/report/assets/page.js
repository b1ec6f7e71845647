// Puts a report together when it is opened.
'use strict';

// Colours are those of the scheme that the reader's system has, or of paper.
report.recolour = () => {
  Chart.defaults.color = report.colour('soft');
  for (const plot of report.plots) plot.chart.destroy();
  for (const { chart } of report.fronts) chart.destroy();
  report.plots = [];
  report.fronts = [];
  document.querySelectorAll('.cursor').forEach((cursor) => cursor.remove());
  document.querySelectorAll('figure.plot').forEach(report.plot);
  document.querySelectorAll('figure.front').forEach(report.drawFront);
  report.drawSweep();
  report.goTo(report.place);
};

report.print = (on) => {
  if (on) document.documentElement.dataset.theme = 'print';
  else delete document.documentElement.dataset.theme;
  document.querySelectorAll('details:not(.more)').forEach((part) => { part.open = on; });
  report.recolour();
  if (!on) return;
  // Two columns on a sheet of A4; a canvas is printed as it is.
  for (const plot of report.plots) plot.chart.resize(310, 170);
  for (const { chart } of report.fronts) chart.resize(640, 330);
};

report.start = () => {
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  Chart.defaults.color = report.colour('soft');
  const designs = report.data.designs || [];
  report.shown = report.data.overlaid ? designs : designs.slice(0, 1);
  document.querySelectorAll('figure.plot').forEach(report.plot);
  report.startMotion();
  report.startFront();
  report.startSweep();
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', report.recolour);
  window.addEventListener('beforeprint', () => report.print(true));
  window.addEventListener('afterprint', () => report.print(false));
  document.documentElement.dataset.ready = 'yes';
};

report.start();
