// What happened on the natural fractures: where, when, and what was decided at each meeting.

const meetingMarks = { crosses: "#1d7a46", arrested: "#b3261e" };
const stateColours = { wetted: "#2f6fb0", slipped: "#c99a2e", open: "#d1495b" };

// A cross through a circle where the hydraulic fracture may go on, a square where it is arrested.
function drawMeeting(ctx, [x, y], crosses) {
  ctx.strokeStyle = crosses ? meetingMarks.crosses : meetingMarks.arrested;
  ctx.fillStyle = "#fff";
  ctx.lineWidth = 2;
  ctx.beginPath();
  if (crosses) ctx.arc(x, y, 6, 0, 2 * Math.PI);
  else ctx.rect(x - 5.5, y - 5.5, 11, 11);
  ctx.fill();
  if (crosses) for (const side of [1, -1]) {
    ctx.moveTo(x - 4, y - 4 * side);
    ctx.lineTo(x + 4, y + 4 * side);
  }
  ctx.stroke();
}

function naturalViews(data) {
  const { nodes, segments, kinds } = data.map, traces = data.case.fractures.filter((line) => line.kind === "natural").flatMap((line) => line.points);
  const hydraulic = segments.filter((_, number) => kinds[number] === 0).flatMap(([first, second]) => [first, second]);
  const of = (x, y) => boxAround(x, y, data.case.domain);
  return { "near the hydraulic fracture": of(hydraulic.map((node) => nodes.x[node]), hydraulic.map((node) => nodes.y[node])),
    "all natural fractures": of(traces.map(([x]) => x), traces.map(([, y]) => y)) };
}

function naturalMap(grid, data) {
  const reports = data.joints ? data.joints.reports : data.map.reports.map(({ time }) => ({ time, unit: [], slip: [], wetted: [], open: [] }));
  if (reports.length === 0) return;
  const units = data.joints ? data.joints.units : {}, views = naturalViews(data), meetings = data.meetings ? data.meetings.columns : { time: [] };
  const greatest = reports.reduce((most, report) => report.slip.reduce((a, b) => Math.max(a, Math.abs(b)), most), 0);
  const state = { field: chosen("natural_map", ["state"], "slip") };
  const colourOf = (report, at) => {
    if (state.field === "slip") return rampColour(0.5 + report.slip[at] / greatest / 2, divergingRamp);
    return report.open[at] ? stateColours.open : report.wetted[at] ? stateColours.wetted : stateColours.slipped;
  };
  const draw = (ctx, place) => {
    const report = reports[controls.report()], { nodes, segments, kinds } = data.map;
    ctx.lineCap = "butt";
    ctx.strokeStyle = "#75828e";
    ctx.lineWidth = 1.3;
    for (const line of data.case.fractures) if (line.kind === "natural") polyline(ctx, place, line.points);
    report.unit.forEach((unit, at) => {
      const along = (reach) => [units.x[unit] + reach * Math.cos(units.angle[unit]), units.y[unit] + reach * Math.sin(units.angle[unit])];
      const stroke = [along(-units.back[unit]), along(units.ahead[unit])];
      ctx.strokeStyle = "#55606b";
      ctx.lineWidth = 6;
      polyline(ctx, place, stroke);
      ctx.strokeStyle = colourOf(report, at);
      ctx.lineWidth = 4.5;
      polyline(ctx, place, stroke);
    });
    const before = data.map.reports.filter((other) => other.time <= report.time * (1 + 1e-9)).length - 1;
    ctx.strokeStyle = "#101820";
    ctx.lineWidth = 2.5;
    ctx.lineCap = "round";
    segments.forEach(([first, second, since], number) => {
      if (kinds[number] === 0 && since <= before) polyline(ctx, place, [[nodes.x[first], nodes.y[first]], [nodes.x[second], nodes.y[second]]]);
    });
    perforations(ctx, place, data.case);
    meetings.time.forEach((time, row) => {
      if (time <= report.time * (1 + 1e-9)) drawMeeting(ctx, place(meetings.x[row], meetings.y[row]), meetings.crosses[row] > 0);
    });
  };
  const bar = () => {
    if (state.field === "state") return { title: "state", marks: Object.entries(stateColours).map(([name, colour]) => [colour, name === "slipped" ? "dry, slipped" : name]) };
    return greatest > 0 ? { title: "slip [mm]", low: -greatest * 1e3, high: greatest * 1e3, colour: (share) => rampColour(share, divergingRamp) } : null;
  };
  const controls = timeControls(reports, (report) => `t = ${shown(report.time)} s`, () => picture.redraw());
  const first = asked.get("view") in views ? asked.get("view") : Object.keys(views)[data.map.segments.length > 0 ? 0 : 1];
  const plot = element("div", { class: "plot tall" });
  figure(grid, "natural_map", "Natural fractures", [element("div", { class: "controls" }, ...controls.elements,
    ...radioButtons("natural-field", ["slip", "state"], (name) => name, state.field, (name) => { state.field = name; picture.redraw(); }),
    ...radioButtons("natural-view", Object.keys(views), (name) => name, first, (name) => picture.show(views[name]))), plot],
    "Thin lines: natural fractures; on them, where anything has happened, slip with its sign, or state. Black: hydraulic fracture; circle: perforation. "
    + "Green circle with a cross: met, may be crossed; red square: met, arrested.",
    "segments/*.h5: reports/*/joints/*, networks/*; meetings.csv; effective_case.json: fractures", true);
  const picture = plane(plot, views[first], data.in_situ, draw, "Natural fractures", bar);
}

function meetingsTable(grid, data) {
  const most = 100, card = element("div", { class: "card wide", id: "meetings" }, element("h3", {}, "Meetings"));
  grid.append(card);
  if (!data.meetings) {
    card.append("No natural fracture has been reached by a hydraulic one.");
    return;
  }
  const at = data.meetings.columns, rows = at.time.slice(0, most).map((time, row) => [shown(time), `${shown(at.x[row])}, ${shown(at.y[row])}`, at.hydraulic[row], at.natural[row],
    shown((at.angle[row] * 180) / Math.PI, 3), shown(at.friction[row], 3), at.critical_friction[row] === null ? "none" : shown(at.critical_friction[row], 3),
    at.criterion[row].replaceAll("_", " "), { text: at.crosses[row] ? "may cross" : "arrested", kind: at.crosses[row] ? "pass" : "fail" }]);
  card.append(table(["time [s]", "place [m]", "hydraulic", "natural", "angle [\u00b0]", "friction [\u2013]", "critical [\u2013]", "criterion", "decision"], rows,
    ["number", "number", "", "", "number", "number", "number", "", ""]));
  if (at.time.length > most) card.append(`${most} of ${at.time.length}; all stand in meetings.csv.`);
}

function naturalFractures(data, of) {
  const grid = section("Natural fractures", "A hydraulic fracture that reaches a natural one joins it; whether it may cross is decided once, at that moment, by "
    + "a criterion of friction: it may if the friction is at least the critical one."), x = "time [s]";
  const columns = data.history.columns, junction = columns.junction_pressure || [];
  const sinceJunction = (column) => junction.map((pressure, row) => (pressure > 0 ? columns[column][row] : null));
  naturalMap(grid, data);
  meetingsTable(grid, data);
  chart(grid, { id: "slip", title: "Slip", x, y: "slip [mm]", factor: 1e3, zero: true,
    series: [of("greatest", "greatest_slip", colours.blue), of("farther than ten tip sizes from any open fracture", "greatest_far_slip", colours.orange)],
    caption: "Greatest slip of the natural fractures since the start.", source: "history.csv: time, greatest_slip, greatest_far_slip" });
  chart(grid, { id: "natural_length", title: "Extent", x, y: "trace length [m]", zero: true, right: "distance [m]", rightFactor: 1,
    series: [of("wetted", "wetted_length", colours.blue), of("slipped", "slipped_length", colours.ochre), of("open", "opened_length", colours.plum),
      of("farthest slip from an open fracture", "slip_distance", colours.grey, { right: true, line: "dashed" })],
    caption: "Trace length of natural fractures in the network, slipped by more than 0.01 mm, and open.", source: "history.csv: time, wetted_length, slipped_length, opened_length, slip_distance" });
  chart(grid, { id: "junction_pressure", title: "Pressure at the junctions", x, y: "pressure [MPa]", factor: 1e-6, right: "number", rightFactor: 1, wide: true,
    series: [{ ...of("inlet", "inlet_pressure", colours.grey), y: sinceJunction("inlet_pressure") },
      { ...of("highest junction", "junction_pressure", colours.blue), y: sinceJunction("junction_pressure") },
      of("met", "meetings", colours.ochre, { right: true, width: 1 }), of("of them may be crossed", "crossings", colours.teal, { right: true, width: 1, line: "dashed" })],
    caption: "Total fluid pressure at the inlet and at the junction where it is highest, since there is one.", source: "history.csv: time, inlet_pressure, junction_pressure, meetings, crossings" });
}
