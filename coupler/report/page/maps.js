// The fracture over time, and the stress around it at the end.

const ramp = ["#1b1464", "#5b1a8b", "#9c2a86", "#cf4a66", "#ee7b45", "#f2b134"];

function rampColour(share) {
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

function boxAround(x, y, domain) {
  if (x.length === 0) return [-domain.width / 2, domain.width / 2, -domain.height / 2, domain.height / 2];
  const box = [Math.min(...x), Math.max(...x), Math.min(...y), Math.max(...y)];
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
  const state = { report: reports.length - 1, field: "aperture" };
  const ranges = { aperture: range(reports, "aperture"), pressure: range(reports, "pressure") };
  const box = boxAround(nodes.x, nodes.y, data.case.domain);
  const draw = (ctx, place) => {
    caseLines(ctx, place, data.case);
    const values = reports[state.report][state.field], [low, high] = ranges[state.field];
    for (const [first, second, since] of segments) {
      const here = since <= state.report && values[first] !== null && values[first] !== undefined;
      ctx.strokeStyle = here ? rampColour(((values[first] + values[second]) / 2 - low) / (high - low)) : "#dfe5ea";
      ctx.lineWidth = here ? 5 : 2;
      ctx.lineCap = "round";
      polyline(ctx, place, [[nodes.x[first], nodes.y[first]], [nodes.x[second], nodes.y[second]]]);
    }
    ctx.strokeStyle = "#22303c";
    ctx.fillStyle = "#fff";
    ctx.lineWidth = 1.5;
    for (const perforation of data.case.injection.perforations || []) {
      ctx.beginPath();
      ctx.arc(...place(...perforation.position), 4, 0, 2 * Math.PI);
      ctx.fill();
      ctx.stroke();
    }
  };

  const slider = element("input", { type: "range", min: 0, max: reports.length - 1, value: state.report, "aria-label": "time" });
  const time = element("span", { class: "value" }), play = element("button", { type: "button" }, "Play");
  const low = element("span", {}), high = element("span", {}), bar = element("span", { class: "bar" });
  bar.style.background = `linear-gradient(to right, ${ramp.join(",")})`;
  const choices = Object.entries(mapFields).map(([name, field]) => {
    const button = element("input", { type: "radio", name: "map-field", value: name });
    button.checked = name === state.field;
    button.addEventListener("change", () => { state.field = name; refresh(); });
    return element("label", {}, button, " " + field.label);
  });
  const plot = element("div", { class: "plot" });
  const aspect = (box[3] - box[2]) / (box[1] - box[0]);
  plot.style.height = Math.min(680, Math.max(250, 950 * aspect + 60)) + "px";
  figure(grid, "map", "Fracture", [element("div", { class: "controls" }, play, slider, time, ...choices), plot,
    element("div", { class: "scale" }, low, bar, high)],
    "The fracture network at the field reports of the run; equal scales. Light grey: where it will be at the last report; thin lines: slits, "
    + "natural fractures and (dashed) prescribed paths of the case; circle: perforation. The arrows are the in-situ principal stresses.",
    "segments/*.h5: reports/*/network/aperture, pressure; networks/*/position, segments", true);
  const picture = plane(plot, box, data.in_situ, draw, "Fracture map");

  function refresh() {
    const report = reports[state.report], field = mapFields[state.field], [least, most] = ranges[state.field];
    time.textContent = `t = ${shown(report.time)} s, revision ${report.revision}`;
    const [below, above] = state.field === "pressure" ? ["\u2264 ", "\u2265 "] : ["", ""];
    low.textContent = `${field.label} ${below}${shown(least * field.factor, 4)} ${field.unit}`;
    high.textContent = `${above}${shown(most * field.factor, 4)} ${field.unit}`;
    slider.value = state.report;
    picture.redraw();
  }
  slider.addEventListener("input", () => { state.report = Number(slider.value); refresh(); });
  let timer = null;
  play.addEventListener("click", () => {
    if (timer !== null) {
      clearInterval(timer);
      timer = null;
      play.textContent = "Play";
      return;
    }
    play.textContent = "Stop";
    timer = setInterval(() => { state.report = (state.report + 1) % reports.length; refresh(); }, 250);
  });
  refresh();
}

function drawCross(ctx, [x, y], angle, half) {
  const across = half * Math.cos(angle), up = half * Math.sin(angle);
  ctx.beginPath();
  ctx.moveTo(x - across, y + up);
  ctx.lineTo(x + across, y - up);
  ctx.stroke();
}

function stressPicture(grid, data) {
  if (!data.stress) return;
  const views = data.stress.views, reports = data.map.reports, last = reports[reports.length - 1];
  const state = { view: views[Math.max(0, views.length - 2)] };
  const draw = (ctx, place) => {
    const { box, x, y, angle, greatest, least } = state.view;
    const [left] = place(box[0], 0), [right] = place(box[1], 0);
    const cell = (right - left) * Math.sqrt((box[3] - box[2]) / (box[1] - box[0]) / 400);
    ctx.strokeStyle = "#22303c";
    ctx.lineWidth = 3;
    for (const [first, second] of data.map.segments)
      polyline(ctx, place, [[data.map.nodes.x[first], data.map.nodes.y[first]], [data.map.nodes.x[second], data.map.nodes.y[second]]]);
    for (let number = 0; number < x.length; ++number) {
      const middle = place(x[number], y[number]), largest = Math.max(Math.abs(greatest[number]), Math.abs(least[number]));
      const stroke = (value) => (value > 0 ? "#c0392b" : "#2b6ca3");
      ctx.lineWidth = 1.4;
      if (Math.abs(greatest[number] - least[number]) < 0.005 * largest) {
        ctx.fillStyle = "#9fb0be";
        ctx.fillRect(middle[0] - 1.5, middle[1] - 1.5, 3, 3);
        continue;
      }
      ctx.strokeStyle = stroke(greatest[number]);
      drawCross(ctx, middle, angle[number], 0.42 * cell);
      ctx.strokeStyle = stroke(least[number]);
      drawCross(ctx, middle, angle[number] + Math.PI / 2, 0.2 * cell);
    }
  };
  const plot = element("div", { class: "plot" });
  plot.style.height = "640px";
  const choices = views.map((view) => {
    const button = element("input", { type: "radio", name: "stress-view", value: view.name });
    button.checked = view === state.view;
    button.addEventListener("change", () => { state.view = view; picture.show(view.box); });
    return element("label", {}, button, " " + view.name);
  });
  figure(grid, "stress", `Principal stress directions at t = ${shown(data.stress.time)} s`,
    [element("div", { class: "controls" }, ...choices), plot],
    "Principal effective stresses of single elements. The long stroke lies along the greatest compression, the short one along the least; "
    + "red: tension. A dot stands where the two differ by less than 0.5 %, so that there is no direction. "
    + (last ? "Dark line: the fracture." : ""),
    "segments/*.h5: reports/*/structure/effective_stress_xx, yy, xy", true);
  const picture = plane(plot, state.view.box, data.in_situ, draw, "Principal stress directions");
}
