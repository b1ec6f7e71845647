#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Opens reports in a headless Chromium as a reader would, and says what is wrong with them.

    open_reports.py [--shots FOLDER] REPORT.html...

No id is given twice in a page. Checked of each, at 1280 and at 400 pixels: no message in the browser's
log, no error in a script, no request to anywhere, nothing wider than the page, no empty picture, no
words that lie on others or are cut; that every body of the mechanism moves and, of fronts, that a
click on a point shows its design and curves. In a light and in a dark scheme words stand out from what
is behind them, and curves from the paper. Printed, also from a dark scheme, the page is dark on white,
no wider than a sheet of A4, and a PDF of such sheets. Needs chromedriver and nothing but Python's own
modules. Prints a line for each fault; status 1 with any.
"""
import base64
import json
import pathlib
import re
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request

WIDTHS = (1280, 400)

# Faults that a page can see of itself: boxes of words that overlap, parts that stick out, blank canvases.
LOOK = r"""
const faults = [];
const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
if (wide > 0) faults.push(`the page is ${wide} px wider than the window`);
const name = (e) => (e.textContent || e.tagName).trim().slice(0, 40);
const words = [...document.querySelectorAll(
  'h1,h2,h3,p,li,figcaption,dt,dd,td,th,label,button,summary,legend')]
  .filter((e) => e.getClientRects().length && e.textContent.trim() && !e.closest('.table, pre, nav'));
const inside = (a, b) => a.contains(b) || b.contains(a);
const boxes = words.map((e) => [e, e.getBoundingClientRect()]);
for (let i = 0; i < boxes.length; ++i) {
  const [e, r] = boxes[i];
  if (r.right > document.documentElement.clientWidth + 1 || r.left < -1)
    faults.push(`"${name(e)}" is cut by the window`);
  for (let k = i + 1; k < Math.min(boxes.length, i + 30); ++k) {
    const [f, q] = boxes[k];
    if (inside(e, f)) continue;
    const x = Math.min(r.right, q.right) - Math.max(r.left, q.left);
    const y = Math.min(r.bottom, q.bottom) - Math.max(r.top, q.top);
    if (x > 2 && y > 2) faults.push(`"${name(e)}" lies on "${name(f)}"`);
  }
}
for (const canvas of document.querySelectorAll('canvas')) {
  const { width, height } = canvas;
  const what = canvas.getAttribute('aria-label');
  if (!what) faults.push('a canvas has no words for those who do not see it');
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [width || 1, height || 1];
  const context = copy.getContext('2d', { willReadFrequently: true });
  if (width && height) context.drawImage(canvas, 0, 0);
  const pixels = context.getImageData(0, 0, copy.width, copy.height).data;
  let inked = 0;
  for (let i = 3; i < pixels.length; i += 4) inked += pixels[i] > 0;
  if (inked < 200) faults.push(`an empty picture: ${what}`);
}
for (const plot of report.plots) {
  const { chartArea: a, width, height } = plot.chart;
  if (a.width < 0.5 * width || a.height < 0.4 * height)
    faults.push(`labels leave no room for the curve: ${plot.panel.name}`);
  if (!plot.chart.data.datasets.some((set) => !set.isLimit && set.data.some((p) => Number.isFinite(p.y))))
    faults.push(`a plot without a curve: ${plot.panel.name}`);
}
return faults;
"""


# Words whose contrast with their background is below what WCAG 2 asks for (4.5, of large ones 3), and
# curves below its 3. Returns the faults and the luminance of the paper.
CONTRAST = r"""
const faults = [];
// Mixed colours are told in shares of one: "color(srgb 0.7 0.8 0.9)".
const numbers = (colour) => (colour.match(/[\d.]+/g) || [0, 0, 0, 0]).map(
  (text, i) => (colour.startsWith('color(') && i < 3 ? 255 : 1) * Number(text));
const over = ([r, g, b, a = 1], under) => [r, g, b].map((c, i) => a * c + (1 - a) * under[i]);
const luminance = (rgb) => rgb.map((c) => c / 255).map((c) => c <= 0.04045 ? c / 12.92
  : ((c + 0.055) / 1.055) ** 2.4).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
const behind = (e) => {
  if (!e) return [255, 255, 255];
  const colour = numbers(getComputedStyle(e).backgroundColor);
  return colour[3] === undefined || colour[3] === 1 ? colour.slice(0, 3)
    : over(colour, behind(e.parentElement));
};
const ratio = (a, b) => {
  const [high, low] = [luminance(a), luminance(b)].sort((p, q) => q - p);
  return (high + 0.05) / (low + 0.05);
};
const own = (e) => [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
for (const e of document.querySelectorAll('body *')) {
  if (!e.getClientRects().length || !own(e) || e.closest('svg, script, style')) continue;
  const style = getComputedStyle(e), back = behind(e), size = parseFloat(style.fontSize);
  const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
  const found = ratio(over(numbers(style.color), back), back);
  if (found < (large ? 3 : 4.5))
    faults.push(`"${e.textContent.trim().slice(0, 40)}" has a contrast of ${found.toFixed(2)}`);
}
const paper = behind(document.body);
const probe = document.createElement('canvas').getContext('2d');
for (const plot of report.plots) {
  for (const set of plot.chart.data.datasets) {
    if (typeof set.borderColor !== 'string') continue;
    probe.fillStyle = set.borderColor;
    const hex = probe.fillStyle;
    if (!hex.startsWith('#')) continue;  // see-through on purpose
    const colour = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
    const found = ratio(colour, paper);
    if (found < 3) faults.push(`a curve of ${plot.panel.name} has a contrast of ${found.toFixed(2)}`);
  }
}
return [[...new Set(faults)], luminance(paper)];
"""


class Browser:
    """A headless Chromium behind chromedriver, by plain WebDriver requests."""

    def __init__(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        self.base = f"http://127.0.0.1:{port}"
        self.session = self.begin()

    def begin(self):
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                            "--disable-dev-shm-usage", "--window-size=1300,1000"]}
        wanted = {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL"}}}}
        for _ in range(100):
            try:
                return self.post("/session", wanted)["sessionId"]
            except urllib.error.URLError as error:
                if isinstance(error, urllib.error.HTTPError):
                    raise RuntimeError(error.read().decode()) from error
                time.sleep(0.1)  # the driver is not up yet
        raise RuntimeError("chromedriver does not answer")

    def post(self, path, body, method="POST"):
        data = json.dumps(body).encode() if method == "POST" else None
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"},
                                         method=method)
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        with opener.open(request, timeout=120) as answer:
            return json.load(answer)["value"]

    def send(self, path, body):
        return self.post(f"/session/{self.session}{path}", body)

    def run(self, script, *arguments):
        return self.send("/execute/sync", {"script": script, "args": list(arguments)})

    def command(self, name, **parameters):
        return self.send("/goog/cdp/execute", {"cmd": name, "params": parameters})

    def width(self, pixels):
        self.command("Emulation.setDeviceMetricsOverride", width=pixels, height=900,
                     deviceScaleFactor=1, mobile=False)

    def media(self, scheme, media=""):
        self.command("Emulation.setEmulatedMedia", media=media,
                     features=[{"name": "prefers-color-scheme", "value": scheme}])
        time.sleep(0.3)  # charts are drawn anew

    def pdf(self):
        """What comes out of the printer, as the bytes of a PDF; none where the browser cannot print."""
        try:
            data = self.command("Page.printToPDF", preferCSSPageSize=True, printBackground=False)["data"]
        except urllib.error.HTTPError as error:
            if "wasn't found" in error.read().decode():
                return None
            raise
        return base64.b64decode(data)

    def click(self, x, y):
        pointer = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": [
            {"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)},
            {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]}
        self.send("/actions", {"actions": [pointer]})

    def hover(self, x, y):
        pointer = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": [
            {"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)}]}
        self.send("/actions", {"actions": [pointer]})

    def log(self):
        return [entry["message"] for entry in self.send("/se/log", {"type": "browser"})]

    def shot(self, path):
        """The whole page: the window is made as high, or pictures are caught while they change."""
        width, height = self.run("return [innerWidth, document.documentElement.scrollHeight]")
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height,
                     deviceScaleFactor=1, mobile=False)
        time.sleep(0.5)
        image = self.command("Page.captureScreenshot")["data"]
        self.width(width)
        pathlib.Path(path).write_bytes(base64.b64decode(image))

    def close(self):
        try:
            self.post(f"/session/{self.session}", None, "DELETE")
        finally:
            self.driver.terminate()
            self.driver.wait()


def moving_faults(browser):
    """The slider moves every body of the mechanism, and the mark in the curves."""
    if not browser.run("return document.getElementById('place') !== null"):
        return []
    moved, still = browser.run("""
        const bodies = [...document.querySelectorAll('.scene [data-motion]')];
        const poses = () => bodies.map((body) => body.getAttribute('transform'));
        const look = () => poses().join() + report.plots.map((plot) => plot.output.textContent).join();
        const go = (value) => { slider.value = value; slider.dispatchEvent(new Event('input')); };
        const before = look(), slider = document.getElementById('place'), at = [];
        for (const value of [90, 370, 620, 810]) { go(value); at.push(poses()); }
        const after = look(), place = report.place;
        go(0);
        const still = bodies.filter((_, i) => at.every((one) => one[i] === at[0][i]))
          .map((body) => body.querySelector('title').textContent);
        return [[before !== after, place > report.cycle.lower, before === look()], still];""")
    faults = [f"{name} does not move" for name in still]
    return faults if moved == [True, True, True] else faults + [
        f"the mechanism does not follow its slider: {moved}"]


def name_faults(path):
    """No id is given twice: a link or a picture would find the first alone."""
    names = re.findall(r'<[a-zA-Z][^<>]*?\sid="([^"]*)"', pathlib.Path(path).read_text())
    return [f"the id {name} is given {names.count(name)} times" for name in sorted(set(names))
            if names.count(name) > 1]


def contact_faults(browser):
    """A roller stays on its cam: its middle is as far from the drawn profile as its radius says."""
    return browser.run(r"""
        const faults = [], scene = document.querySelector('.scene');
        const cam = scene && scene.querySelector('path.cam:not(.second)');
        const roller = scene && scene.querySelector('circle.roller');
        if (!cam || !roller || cam.closest('.body').dataset.motion === undefined) return faults;
        const length = cam.getTotalLength(), radius = Number(roller.getAttribute('r'));
        const outline = Array.from({length: 4000}, (_, i) => cam.getPointAtLength(length * i / 4000));
        const share = radius * 0.02;
        for (const place of [0.1, 0.3, 0.55, 0.8]) {
          report.goTo(report.cycle.lower + place * (report.cycle.upper - report.cycle.lower));
          const from = cam.getCTM(), to = roller.getCTM().inverse();
          const matrix = to.multiply(from);
          const x = Number(roller.getAttribute('cx')), y = Number(roller.getAttribute('cy'));
          const gap = Math.min(...outline.map((p) => {
            const q = p.matrixTransform(matrix);
            return Math.hypot(q.x - x, q.y - y); })) - radius;
          if (!(Math.abs(gap) < share))
            faults.push(`the roller is ${gap.toFixed(3)} mm off its cam at ${report.place}`);
        }
        report.goTo(report.cycle.lower);
        return faults;""")


def joint_faults(browser):
    """Bodies that a joint ties together stay together."""
    return browser.run(r"""
        const faults = [], joints = [...document.querySelectorAll('.scene circle.joint')];
        if (!joints.length) return faults;
        for (const place of [0.1, 0.3, 0.55, 0.8]) {
          report.goTo(report.cycle.lower + place * (report.cycle.upper - report.cycle.lower));
          const [from, ...others] = joints.map((joint) => new DOMPoint(
            Number(joint.getAttribute('cx')), Number(joint.getAttribute('cy')))
            .matrixTransform(joint.getCTM()));
          for (const to of others) {
            const gap = Math.hypot(from.x - to.x, from.y - to.y);
            if (!(gap < 0.5)) faults.push(`a joint is ${gap.toFixed(2)} px open at ${report.place}`);
          }
        }
        report.goTo(report.cycle.lower);
        return faults;""")


def front_faults(browser):
    """A click on a point of the front chooses it, and its curves are drawn."""
    if not browser.run("return Boolean(report.data.front) && report.fronts.length > 0"):
        return []
    faults = []
    for which in ("a", "b"):
        browser.run("document.querySelector('input[name=chooses][value=' + arguments[0] + ']').checked = true",
                    which)
        browser.run("report.fronts[0].chart.canvas.scrollIntoView({ block: 'center', behavior: 'instant' })")
        time.sleep(0.3)  # the page comes to rest
        x, y, i, before = browser.run("""
            const { chart, pair } = report.fronts[0], canvas = chart.canvas;
            const i = arguments[0] === 'a' ? 1 : report.data.designs.length - 2;
            const point = report.data.designs[i].objectives, box = canvas.getBoundingClientRect();
            return [box.left + chart.scales.x.getPixelForValue(point[pair.across]),
                    box.top + chart.scales.y.getPixelForValue(point[pair.up]), i,
                    report.plots.length ? JSON.stringify(report.plots[0].chart.data.datasets.map(
                      (set) => set.data)) : ''];""", which)
        browser.hover(x, y)
        time.sleep(0.3)
        if not browser.run("const tip = report.fronts[0].chart.tooltip;"
                           "return tip.opacity > 0 && tip.body.some((part) => part.lines.length > 1)"):
            faults.append(f"point {i} says nothing of itself when hovered")
        browser.click(x, y)
        time.sleep(0.3)  # Chart.js hears of a click with the next frame
        chosen, label, table, after = browser.run("""
            const i = report.chosen[arguments[0]];
            return [i, i === null ? '' : report.data.designs[i].label,
                    document.getElementById('compare').textContent,
                    report.plots.length ? JSON.stringify(report.plots[0].chart.data.datasets.map(
                      (set) => set.data)) : ''];""", which)
        # Of points that lie on one another the nearest is taken.
        near = browser.run("""
            const { chart, pair } = report.fronts[0];
            const at = (i) => [chart.scales.x.getPixelForValue(
              report.data.designs[i].objectives[pair.across]), chart.scales.y.getPixelForValue(
              report.data.designs[i].objectives[pair.up])];
            const [p, q] = [at(arguments[0]), at(arguments[1])];
            return Math.hypot(p[0] - q[0], p[1] - q[1]);""", i, chosen if chosen is not None else 0)
        if chosen is None or near > 8:
            faults.append(f"a click on point {i} chose {chosen} as {which.upper()}")
        elif label not in table:
            faults.append(f"the table does not have {label}")
        if which == "b" and before == after and before:
            faults.append("a second design adds no curves")
    if browser.run("return report.plots.some((plot) => plot.chart.data.datasets"
                   ".filter((set) => !set.isLimit).length !== 2)"):
        faults.append("not every panel shows both designs")
    return faults


def scheme_faults(browser, shots, stem):
    """Light and dark: words and curves stand out, and the paper is what the scheme says."""
    faults = []
    for scheme in ("dark", "light"):
        browser.media(scheme)
        here, paper = browser.run(CONTRAST)
        if (paper < 0.2) != (scheme == "dark"):
            here.append(f"the paper has a luminance of {paper:.2f}")
        here += browser.run(LOOK)
        if shots and scheme == "dark":
            browser.shot(pathlib.Path(shots) / f"{stem}-dark.png")
        faults += [f"in a {scheme} scheme: {fault}" for fault in here]
    return faults


def print_faults(browser, shots, stem):
    """Printed from a dark scheme: dark on white, within the sheet, and a PDF of sheets of A4."""
    sheet = round(180 / 25.4 * 96)  # A4 less its margins
    browser.width(sheet)
    browser.media("dark", "print")
    browser.run("report.print(true)")
    time.sleep(0.4)
    faults, paper = browser.run(CONTRAST)
    if paper < 0.9:
        faults.append(f"the paper has a luminance of {paper:.2f}")
    wide = browser.run("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
    if wide > 0:
        faults.append(f"the page is {wide} px wider than the sheet")
    browser.run("report.print(false)")
    browser.media("dark")
    pdf = browser.pdf()
    if pdf is not None:
        boxes = re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", pdf)
        if not pdf.startswith(b"%PDF") or not boxes:
            faults.append("no PDF of any sheet")
        for wide, high in set(boxes):
            if abs(float(wide) - 595.3) > 1 or abs(float(high) - 841.9) > 1:
                faults.append(f"a sheet of {float(wide):.0f} x {float(high):.0f} points is not A4")
        if shots:
            (pathlib.Path(shots) / f"{stem}.pdf").write_bytes(pdf)
    if browser.run("return document.documentElement.dataset.theme !== undefined"):
        faults.append("the page on screen stays as it was printed")
    browser.media("light")
    return [f"printed: {fault}" for fault in faults]


def faults_of(browser, path, shots):
    faults = [f"{path}: {fault}" for fault in name_faults(path)]
    address = pathlib.Path(path).resolve().as_uri()
    for width in WIDTHS:
        browser.width(width)
        browser.send("/url", {"url": address})
        here = []
        if not browser.run("return document.documentElement.dataset.ready === 'yes'"):
            here.append("the scripts did not come to their end")
        time.sleep(0.4)  # sizes settle
        here += browser.run(LOOK)
        if shots:
            browser.shot(pathlib.Path(shots) / f"{pathlib.Path(path).stem}-{width}.png")
        here += moving_faults(browser) + contact_faults(browser) + joint_faults(browser)
        here += front_faults(browser)
        here += browser.run(LOOK)
        if width == WIDTHS[0]:
            stem = pathlib.Path(path).stem
            here += scheme_faults(browser, shots, stem) + print_faults(browser, shots, stem)
        here += browser.run("return report.errors")
        here += [f"in the browser's log: {message}" for message in browser.log()]
        loaded = browser.run("return performance.getEntriesByType('resource')"
                             ".map((entry) => entry.name).filter((name) => !name.startsWith('data:'))")
        here += [f"asks for {name}" for name in loaded]
        faults += [f"{path} at {width} px: {fault}" for fault in dict.fromkeys(here)]
    return faults


def main(words):
    shots = None
    if words[:1] == ["--shots"]:
        shots, words = words[1], words[2:]
        pathlib.Path(shots).mkdir(parents=True, exist_ok=True)
    browser = Browser()
    try:
        faults = [fault for path in words for fault in faults_of(browser, path, shots)]
    finally:
        browser.close()
    print("\n".join(faults) if faults else f"{len(words)} reports opened, nothing wrong")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
