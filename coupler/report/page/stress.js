// The stress around the fracture: two maps over time, and its directions at the end.

function bytesOf(base64) {
  return Uint8Array.from(window.atob(base64), (letter) => letter.charCodeAt(0));
}

// A canvas with one pixel for each cell of the map, north on top; cells without a value are clear.
function pictureOf(map, values, colours) {
  const canvas = element("canvas", { width: map.columns, height: map.rows }), ctx = canvas.getContext("2d");
  const picture = ctx.createImageData(map.columns, map.rows), bytes = bytesOf(values);
  const table = Array.from({ length: 255 }, (_, level) => rampColour(level / 254, colours).match(/\d+/g).map(Number));
  for (let row = 0; row < map.rows; ++row)
    for (let column = 0; column < map.columns; ++column) {
      const level = bytes[(map.rows - 1 - row) * map.columns + column];
      if (level < 255) picture.data.set([...table[level], 255], 4 * (row * map.columns + column));
    }
  ctx.putImageData(picture, 0, 0);
  return canvas;
}

// The natural fractures of the case, and of the network what was there at a time; dark on a light seam, to be seen on any
// colour; `fine` lines where there are many in a small place.
function fracturesOver(ctx, place, data, time, fine) {
  const natural = (data.case.fractures || []).filter((line) => line.kind === "natural");
  const before = data.map.reports.filter((report) => report.time <= time * (1 + 1e-9)).length - 1;
  const { nodes, segments, kinds } = data.map;
  const hydraulic = segments.filter(([, , since], number) => since <= before && kinds[number] === 0);
  for (const [colour, width] of [["#ffffffb0", 3], ["#22303c", 1.1]]) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = fine ? width / 2 : width;
    for (const line of natural) polyline(ctx, place, line.points);
    ctx.lineWidth = width + 2;
    for (const [first, second] of hydraulic) polyline(ctx, place, [[nodes.x[first], nodes.y[first]], [nodes.x[second], nodes.y[second]]]);
  }
}

// A map of raster.hpp over time: { id, title, bar, factor, colours, caption, source, fine }.
function stressMap(grid, data, map, options) {
  if (!map) return;
  const pictures = map.reports.map((report) => pictureOf(map, report.values, options.colours));
  const controls = timeControls(map.reports, (report) => `t = ${shown(report.time)} s`, () => picture.redraw());
  const draw = (ctx, place) => {
    const [left, top] = place(map.box[0], map.box[3]), [right, bottom] = place(map.box[1], map.box[2]);
    ctx.imageSmoothingEnabled = true;
    ctx.drawImage(pictures[controls.report()], left, top, right - left, bottom - top);
    fracturesOver(ctx, place, data, map.reports[controls.report()].time, options.fine);
    perforations(ctx, place, data.case);
  };
  const plot = element("div", { class: "plot tall" });
  figure(grid, options.id, options.title, [element("div", { class: "controls" }, ...controls.elements), plot], options.caption,
    "segments/*.h5: reports/*/structure/effective_stress_xx, yy, xy" + (options.source || ""), true);
  const bar = { title: options.bar, low: map.low * options.factor, high: map.high * options.factor, colour: (share) => rampColour(share, options.colours) };
  const picture = plane(plot, map.box, data.in_situ, draw, options.title, () => bar);
}

function stressMaps(grid, data) {
  const cut = " Means of the elements around each node. The last 0.2 % of the values at an end of the scale have the colour of that end.";
  const away = data.relative_stress && data.relative_stress.far;
  const far = away ? ` At the end, farther than ${shown(away.distance, 3)} m (half the extent of the network) from any fracture in the network, it has changed by ${percent(away.greatest_change)} at the most.` : "";
  stressMap(grid, data, data.least_stress, { id: "least_stress", title: "Minimum principal stress around the fracture", bar: "\u03c3_h [MPa],\ntension +",
    factor: 1e-6, colours: ramp, caption: "Least compressive principal effective stress, tension positive; thick line: hydraulic fracture, thin lines: natural "
      + "fractures, circle: perforation." + cut });
  stressMap(grid, data, data.relative_stress, { id: "relative_stress", title: "Relative greatest horizontal stress in the whole domain", bar: "\u03c3_H / \u03c3_H0 [\u2013]",
    factor: 1, fine: true, colours: divergingRamp, source: "; effective_case.json: in_situ", caption: "Most compressive principal effective stress over the one in situ at the same place: 1 where nothing has changed." + far + cut });
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
  const views = data.stress.views, names = views.map((view) => view.name);
  const first = chosen("stress", names, names[Math.max(0, names.length - 2)]);
  const state = { view: views[names.indexOf(first)] };
  const draw = (ctx, place) => {
    const { box, x, y, angle, greatest, least } = state.view;
    const [left] = place(box[0], 0), [right] = place(box[1], 0);
    const cell = (right - left) * Math.sqrt((box[3] - box[2]) / (box[1] - box[0]) / 400);
    fracturesOver(ctx, place, data, data.stress.time, state.view.name === "whole domain");
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
  const plot = element("div", { class: "plot tall" });
  const choices = radioButtons("stress-view", names, (name) => name, first, (name) => {
    state.view = views[names.indexOf(name)];
    picture.show(state.view.box);
  });
  figure(grid, "stress", `Principal stress directions at t = ${shown(data.stress.time)} s`,
    [element("div", { class: "controls" }, ...choices), plot],
    "Principal effective stresses of single elements. The long stroke lies along the greatest compression, the short one along the least; "
    + "red: tension. A dot stands where the two differ by less than 0.5 %, so that there is no direction. "
    + "Thick line: hydraulic fracture; thin lines: natural fractures.",
    "segments/*.h5: reports/*/structure/effective_stress_xx, yy, xy", true);
  const picture = plane(plot, state.view.box, data.in_situ, draw, "Principal stress directions");
}
