// The catalogue on the map: balls over the fractures, and slip beside them.

// Around the events, without the farthest hundredth where there are many; around the fractures.
function seismicViews(data, events) {
  const inner = (values) => {
    const sorted = [...values].sort((a, b) => a - b), cut = Math.floor(values.length / 200);
    return sorted.slice(cut, sorted.length - cut);
  };
  const views = { events: boxAround(inner(events.map((event) => event.x)), inner(events.map((event) => event.y)), data.case.domain) };
  const least = 4 * data.seismicity.columns.length.reduce((most, length) => Math.max(most, length || 0), 1e-3);
  if (views.events[1] - views.events[0] < least && views.events[3] - views.events[2] < least) {
    const middle = [(views.events[0] + views.events[1]) / 2, (views.events[2] + views.events[3]) / 2];
    views.events = [middle[0] - least, middle[0] + least, middle[1] - least, middle[1] + least];
  }
  const { width, height } = data.case.domain, { nodes } = data.map;
  if (nodes.x.length > 0) views["fracture network"] = boxAround(nodes.x, nodes.y, data.case.domain);
  views["whole domain"] = [-width / 2, width / 2, -height / 2, height / 2];
  return views;
}

// Times to choose from: the field reports, as far as there are events, and the last event.
function seismicTimes(data, events) {
  const last = events.reduce((most, event) => Math.max(most, event.time), 0), times = data.map.reports.map(({ time }) => time);
  return (times.length === 0 || times[times.length - 1] < last * (1 - 1e-9) ? [...times, last] : times).map((time) => ({ time }));
}

// Buttons and a drag of the mouse that change the box of a picture; `nearest(x, y)` tells of what lies under the mouse.
function movable(plot, pictures, state, tell) {
  const button = (text, label, factor) => {
    const made = element("button", { type: "button", "aria-label": label }, text);
    made.addEventListener("click", () => zoom(factor));
    return made;
  };
  const show = (box) => {
    state.box = box;
    for (const picture of pictures()) picture.show(box);
  };
  const zoom = (factor) => {
    const [west, east, south, north] = state.box, x = (west + east) / 2, y = (south + north) / 2;
    show([x + (west - x) * factor, x + (east - x) * factor, y + (south - y) * factor, y + (north - y) * factor]);
  };
  let from = null;
  plot.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; });
  plot.addEventListener("pointerup", (event) => {
    const metre = state.place ? state.place(1, 0)[0] - state.place(0, 0)[0] : 0;
    const [right, down] = from && metre > 0 ? [(event.clientX - from[0]) / metre, (event.clientY - from[1]) / metre] : [0, 0];
    from = null;
    if (Math.hypot(right, down) * metre > 4) show([state.box[0] - right, state.box[1] - right, state.box[2] + down, state.box[3] + down]);
  });
  plot.addEventListener("pointermove", (event) => {
    const area = plot.getBoundingClientRect();
    if (state.place) tell(event.clientX - area.left, event.clientY - area.top);
  });
  return [button("+", "closer", 0.6), button("\u2212", "farther", 1 / 0.6)];
}

const intoWindow = ({ box, wide, extra = 0, most = 640, least = 300 }) => Math.min(most, Math.max(least, (wide * (box[3] - box[2])) / (box[1] - box[0]) + 60 + extra));

function describe(event) {
  const kind = { open: "an open fracture", natural: "a natural fracture", grown: "the grown fracture", none: "the rock" }[event.fracture] || event.fracture;
  return `event ${event.id}: ${event.type}, Mw ${event.magnitude === null ? "none" : shown(event.magnitude, 3)}, M0 ${shown(event.moment, 3)} N m, t = ${shown(event.time, 5)} s, on ${kind}`;
}

const ballCaption = "Balls: equal-area projection of the lower half of the focal sphere seen from above, whole moment tensor with its isotropic part and M_zz; coloured where the first motion is outward, white where "
  + "it is inward. A tensile event moves outward everywhere, so its ball is a plain disc. The stroke through a ball is the plane that failed; arrows, where there is room: it opened, or closed. Radius by 10^(Mw/2). Where balls of one type would cover each other, "
  + "the greatest is drawn and the others are dots; a closer look shows more of them.";

function seismicMap(grid, data, events) {
  const views = seismicViews(data, events), sorted = largeFirst(events), radius = radiusOf(events, ballSize(events), 2.2);
  const first = asked.get("view") in views ? asked.get("view") : "events", modes = { until: "all until then", since: "since the report before" };
  const state = { box: views[first], mode: chosen("seismic_map", Object.keys(modes), "until"), place: null };
  const times = seismicTimes(data, events);
  const isShown = (event) => event.time <= times[controls.report()].time * (1 + 1e-9)
    && (state.mode === "until" || controls.report() === 0 || event.time > times[controls.report() - 1].time * (1 + 1e-9));
  const draw = (ctx, place, area) => {
    state.place = place;
    fracturesBeneath(ctx, place, data, times[controls.report()].time);
    drawBalls(ctx, place, sorted, radius, isShown, area);
  };
  const controls = timeControls(times, ({ time }) => `t = ${shown(time)} s, ${events.filter((event) => event.time <= time * (1 + 1e-9)).length} events`, () => picture.redraw());
  const plot = element("div", { class: "plot" }), pointed = element("div", { class: "pointed" }, "\u00a0");
  plot.style.height = intoWindow({ box: views.events, wide: 900 }) + "px";
  const tell = (x, y) => {
    const near = sorted.filter(isShown).map((event) => [event, state.place(event.x, event.y)]).filter(([event, at]) => Math.hypot(at[0] - x, at[1] - y) < radius(event.moment) + 1);
    pointed.textContent = near.length > 0 ? describe(near[near.length - 1][0]) : "\u00a0";
  };
  const zoom = movable(plot, () => [picture], state, tell);
  figure(grid, "seismic_map", "Events on the map", [element("div", { class: "controls" }, ...controls.elements, ...radioButtons("seismic-mode", Object.keys(modes), (name) => modes[name], state.mode,
    (name) => { state.mode = name; picture.redraw(); })),
    element("div", { class: "controls" }, ...radioButtons("seismic-view", Object.keys(views), (name) => name, first, (name) => { state.box = views[name]; picture.show(views[name]); }), ...zoom),
    plot, pointed, eventLegend(data, events, radius)],
    `${ballCaption} Drag to move. ${data.seismicity.caption}`, "seismicity/catalogue.csv: tc_s, x_m, y_m, M0_Nm, Mw, Mxx, Myy, Mzz, Mxy, type; segments/*.h5: networks/*", true);
  const picture = plane(plot, state.box, data.in_situ, draw, "Events on the map");
}

// Radius of the greatest ball: smaller where there are many.
function ballSize(events) {
  return Math.min(22, Math.max(12, 240 / Math.sqrt(events.length)));
}

// Slip of the contact units at field reports: [{ time, strokes: [[x, y, x, y, slip], ...] }].
function slipReports(data) {
  const { joints, seismicity } = data;
  if (joints && joints.reports.length > 0) {
    const { x, y, angle, back, ahead } = joints.units;
    return joints.reports.map(({ time, unit, slip }) => ({ time, strokes: unit.map((number, at) => {
      const along = (reach) => [x[number] + reach * Math.cos(angle[number]), y[number] + reach * Math.sin(angle[number])];
      return [...along(-back[number]), ...along(ahead[number]), slip[at]];
    }) }));
  }
  return seismicity.slip ? [{ time: seismicity.slip.time, strokes: seismicity.slip.segments }] : [];
}

// Slip in the model beside the events, at one time, alike in scale and view (as figure 22 of Profit et al. 2016).
function seismicSlip(grid, data, events) {
  const reports = slipReports(data), greatest = reports.reduce((most, { strokes }) => strokes.reduce((a, stroke) => Math.max(a, Math.abs(stroke[4])), most), 0);
  if (greatest === 0) return;
  const views = seismicViews(data, events), sorted = largeFirst(events), radius = radiusOf(events, 0.8 * ballSize(events), 2.2);
  const first = asked.get("view") in views ? asked.get("view") : "events", state = { box: views[first], place: null };
  const drawSlip = (ctx, place) => {
    state.place = place;
    const { time, strokes } = reports[controls.report()];
    fracturesBeneath(ctx, place, data, time);
    ctx.lineCap = "butt";
    for (const [xa, ya, xb, yb, slip] of strokes) {
      ctx.strokeStyle = "#55606b";
      ctx.lineWidth = 6;
      polyline(ctx, place, [[xa, ya], [xb, yb]]);
      ctx.strokeStyle = rampColour(0.5 + slip / greatest / 2, divergingRamp);
      ctx.lineWidth = 4.5;
      polyline(ctx, place, [[xa, ya], [xb, yb]]);
    }
  };
  const drawEvents = (ctx, place, area) => {
    const { time } = reports[controls.report()];
    fracturesBeneath(ctx, place, data, time);
    drawBalls(ctx, place, sorted, radius, (event) => event.time <= time * (1 + 1e-9), area);
  };
  const controls = timeControls(reports, ({ time }) => `t = ${shown(time)} s`, () => pictures.forEach((picture) => picture.redraw()));
  const plots = ["Slip in the model", "Events until then"].map((title) => [title, element("div", { class: "plot" })]);
  for (const [, plot] of plots) plot.style.height = intoWindow({ box: views.events, wide: 500, most: 560 }) + "px";
  const bar = element("span", { class: "bar" });
  bar.style.background = `linear-gradient(to right, ${divergingRamp.join(",")})`;
  const zoom = movable(plots[0][1], () => pictures, state, () => {});
  figure(grid, "seismic_slip", "Slip in the model, and the events",
    [element("div", { class: "controls" }, ...controls.elements, ...radioButtons("slip-view", Object.keys(views), (name) => name, first, (name) => {
      state.box = views[name];
      pictures.forEach((picture) => picture.show(views[name]));
    }), ...zoom), element("div", { class: "pair" }, ...plots.map(([title, plot]) => element("div", {}, element("h4", {}, title), plot))),
    element("div", { class: "scale" }, `slip \u2212${shown(greatest * 1e3, 3)} mm`, bar, `+${shown(greatest * 1e3, 3)} mm`), eventLegend(data, events, radius)],
    `Left: contact units of natural fractures on which anything has happened, coloured by slip since the start with its sign. Right: the events until the same time, balls as on the map. ${data.seismicity.caption}`,
    "segments/*.h5: reports/*/joints/*, networks/*; seismicity/catalogue.csv", true);
  const pictures = plots.map(([title, plot], number) => plane(plot, state.box, null, [drawSlip, drawEvents][number], title));
}
