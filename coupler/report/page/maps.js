// The fracture over time, and what all pictures over time share.

const ramp = ["#1b1464", "#5b1a8b", "#9c2a86", "#cf4a66", "#ee7b45", "#f2b134"];

// From less over nothing to more.
const divergingRamp = ["#174a7c", "#3f86b8", "#a3c8de", "#f1f1ee", "#f0b799", "#cf5f4a", "#8e1b2d"];

function rampColour(share, ramp) {
  const at = Math.min(Math.max(share, 0), 1) * (ramp.length - 1), first = Math.min(Math.floor(at), ramp.length - 2);
  const part = (name, digit) => parseInt(name.slice(1 + 2 * digit, 3 + 2 * digit), 16);
  const mixed = [0, 1, 2].map((digit) => Math.round(part(ramp[first], digit) * (1 - at + first) + part(ramp[first + 1], digit) * (at - first)));
  return `rgb(${mixed.join(",")})`;
}

function caseLines(ctx, place, runCase) {
  const styles = { open: ["#9fb0be", []], natural: ["#9fb0be", []], intact: ["#cfd8df", [3, 4]] };
  const isFree = (runCase.growth || {}).path === "free";
  for (const line of runCase.fractures || []) {
    if (isFree && line.kind === "intact") continue;
    [ctx.strokeStyle] = styles[line.kind] || styles.open;
    ctx.setLineDash((styles[line.kind] || styles.open)[1]);
    ctx.lineWidth = 1;
    polyline(ctx, place, line.points);
  }
  ctx.setLineDash([]);
}

function perforations(ctx, place, runCase) {
  ctx.strokeStyle = "#22303c";
  ctx.fillStyle = "#fff";
  ctx.lineWidth = 1.5;
  for (const perforation of runCase.injection.perforations || []) {
    ctx.beginPath();
    ctx.arc(...place(...perforation.position), 4, 0, 2 * Math.PI);
    ctx.fill();
    ctx.stroke();
  }
}

// A button, a slider over reports and a label; `changed` is called whenever another report is to be shown. Starts at the last, or at the
// time that the address of the page asks for. A single report needs no slider.
function timeControls(reports, label, changed) {
  let report = reports.length - 1, timer = null;
  if (asked.has("time"))
    reports.forEach((candidate, number) => {
      if (Math.abs(candidate.time - asked.get("time")) < Math.abs(reports[report].time - asked.get("time"))) report = number;
    });
  const slider = element("input", { type: "range", min: 0, max: reports.length - 1, value: report, "aria-label": "time" });
  const time = element("span", { class: "value" }, label(reports[report])), play = element("button", { type: "button" }, "Play");
  const go = (number) => {
    report = number;
    slider.value = report;
    time.textContent = label(reports[report]);
    changed();
  };
  slider.addEventListener("input", () => go(Number(slider.value)));
  play.addEventListener("click", () => {
    if (timer === null) timer = setInterval(() => go((report + 1) % reports.length), 250);
    else timer = clearInterval(timer) || null;
    play.textContent = timer === null ? "Play" : "Stop";
  });
  return { elements: reports.length > 1 ? [play, slider, time] : [time], report: () => report };
}

// Radio buttons for one choice; `changed` is called with the name chosen.
function radioButtons(group, names, label, selected, changed) {
  return names.map((name) => {
    const button = element("input", { type: "radio", name: group, value: name });
    button.checked = name === selected;
    button.addEventListener("change", () => changed(name));
    return element("label", {}, button, " " + label(name));
  });
}

function boxAround(x, y, domain) {
  if (x.length === 0) return [-domain.width / 2, domain.width / 2, -domain.height / 2, domain.height / 2];
  const least = (values) => values.reduce((a, b) => Math.min(a, b)), most = (values) => values.reduce((a, b) => Math.max(a, b));
  const box = [least(x), most(x), least(y), most(y)];
  const margin = 0.12 * Math.max(box[1] - box[0], box[3] - box[2]);
  return [box[0] - margin, box[1] + margin, box[2] - margin, box[3] + margin];
}

const mapFields = {
  aperture: { label: "aperture", unit: "mm", factor: 1e3 },
  pressure: { label: "fluid pressure", unit: "MPa", factor: 1e-6 },
};

// Aperture from zero to the largest. Pressure without its lowest and highest values: it is zero where no fluid is yet, and high before the
// fracture opens.
function range(reports, field) {
  const values = reports.flatMap((report) => report[field].filter((value) => value !== null)).sort((a, b) => a - b);
  const at = (share) => values[Math.floor(share * (values.length - 1))];
  const [low, high] = field === "aperture" ? [0, at(1)] : [at(0.1), at(0.98)];
  return high > low ? [low, high] : [low || 0, (low || 0) + 1];
}

function fractureMap(grid, data) {
  const { nodes, segments, reports } = data.map;
  if (segments.length === 0) return;
  const state = { field: chosen("map", Object.keys(mapFields), "aperture") };
  const ranges = { aperture: range(reports, "aperture"), pressure: range(reports, "pressure") };
  const box = boxAround(nodes.x, nodes.y, data.case.domain);
  const draw = (ctx, place) => {
    caseLines(ctx, place, data.case);
    const report = controls.report(), values = reports[report][state.field], [low, high] = ranges[state.field];
    for (const [first, second, since] of segments) {
      const here = since <= report && values[first] !== null && values[first] !== undefined;
      ctx.strokeStyle = here ? rampColour(((values[first] + values[second]) / 2 - low) / (high - low), ramp) : "#dfe5ea";
      ctx.lineWidth = here ? 5 : 2;
      ctx.lineCap = "round";
      polyline(ctx, place, [[nodes.x[first], nodes.y[first]], [nodes.x[second], nodes.y[second]]]);
    }
    perforations(ctx, place, data.case);
  };

  const controls = timeControls(reports, (report) => `t = ${shown(report.time)} s, revision ${report.revision}`, () => refresh());
  const low = element("span", {}), high = element("span", {}), bar = element("span", { class: "bar" });
  bar.style.background = `linear-gradient(to right, ${ramp.join(",")})`;
  const choices = radioButtons("map-field", Object.keys(mapFields), (name) => mapFields[name].label, state.field,
    (name) => { state.field = name; refresh(); });
  const plot = element("div", { class: "plot" });
  const aspect = (box[3] - box[2]) / (box[1] - box[0]);
  plot.style.height = Math.min(680, Math.max(250, 950 * aspect + 60)) + "px";
  figure(grid, "map", "Fracture", [element("div", { class: "controls" }, ...controls.elements, ...choices), plot,
    element("div", { class: "scale" }, low, bar, high)],
    "The fracture network at the field reports of the run; equal scales. Light grey: where it will be at the last report; thin lines: slits, "
    + "natural fractures and (dashed) prescribed paths of the case; circle: perforation. The arrows are the in-situ principal stresses.",
    "segments/*.h5: reports/*/network/aperture, pressure; networks/*/position, segments", true);
  const picture = plane(plot, box, data.in_situ, draw, "Fracture map");

  function refresh() {
    const field = mapFields[state.field], [least, most] = ranges[state.field];
    const [below, above] = state.field === "pressure" ? ["\u2264 ", "\u2265 "] : ["", ""];
    low.textContent = `${field.label} ${below}${shown(least * field.factor, 4)} ${field.unit}`;
    high.textContent = `${above}${shown(most * field.factor, 4)} ${field.unit}`;
    picture.redraw();
  }
  refresh();
}
