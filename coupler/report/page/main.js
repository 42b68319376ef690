// The page from top to bottom.

const data = JSON.parse(document.getElementById("data").textContent);
const history = data.history.columns, ledger = data.ledger.columns, time = history.time;
const last = (column) => (history[column] && history[column].length ? history[column][history[column].length - 1] : null);
const isUsed = (column) => (history[column] || []).some((value) => value !== null && value !== 0);
const ofHistory = (label, column, colour, more = {}) => ({ label, x: time, y: history[column] || [], colour, ...more });
const isDry = (data.case.injection.perforations || []).length === 0;
const hasNaturalFractures = (data.case.fractures || []).some((line) => line.kind === "natural");
const thinned = data.history.rows > time.length;

function head() {
  const { run, summary } = data, top = document.getElementById("head");
  top.append(element("h1", {}, run.title || "Fissura run"));
  const end = last("time"), planned = data.case.time.end;
  const reached = end === null ? "no coupling time reached yet" : `simulated to ${shown(end)} of ${shown(planned)} s`;
  let state = `Run under way, or cut short without a last word: ${reached}.`, kind = "";
  if (summary && summary.failure) {
    const { participant, interval, phase, sentence } = summary.failure;
    state = `Failed in interval ${interval} (${participant}, ${phase}): ${sentence}. ${reached}.`;
    kind = "fail";
  } else if (summary) {
    state = { pass: "Verdict: pass", fail: "Verdict: fail", none: "No verdict: nothing was expected" }[summary.verdict] + `; ${reached}.`;
    kind = summary.verdict === "none" ? "" : summary.verdict;
  }
  top.append(element("p", { class: "state" }, element("span", kind ? { class: kind } : {}, state)));
  top.append(element("p", { class: "provenance" }, `Fissura ${run.version}, commit ${String(run.git_commit).slice(0, 12)}, ${run.threads} threads, started ${run.started}; case ${String(run.case_hash).slice(0, 12)}. ${(run.command_line || []).join(" ")}`));
  for (const change of run.network_changes || [])
    top.append(element("p", { class: "provenance" }, `After interval ${change.interval}, at ${shown(change.time)} s, the flow solver ${change.to} went on instead of ${change.from}.`));
}

function verdict(grid) {
  const quantities = (data.summary && data.summary.quantities) || [];
  const card = element("div", { class: "card wide", id: "verdict" }, element("h3", {}, "Expected against obtained"));
  if (quantities.length === 0) card.append("Nothing was judged" + (data.summary ? "." : ": the run has not ended."));
  else {
    const rows = quantities.map((quantity) => {
      const bound = quantity.relative_error === null && { maximum: "\u2264 ", mean: "\u2264 ", minimum: "\u2265 " }[quantity.measure];
      return [quantity.name, quantity.measure.replaceAll("_", " "), (bound || "") + shown(quantity.expected, 5), shown(quantity.obtained, 5),
        quantity.unit === "1" ? "\u2013" : quantity.unit, percent(quantity.relative_error), percent(quantity.tolerance),
        { text: (quantity.pass ? "pass" : "fail") + (quantity.remark ? ": " + quantity.remark : ""), kind: quantity.pass ? "pass" : "fail" }];
    });
    card.append(table(["quantity", "measure", "expected", "obtained", "unit", "error", "tolerance", ""], rows,
      ["", "", "number", "number", "", "number", "number", ""]));
  }
  grid.append(card);
}

function keyFigures(grid) {
  const summary = data.summary || {}, coupling = summary.coupling || {}, wall = summary.wall || {};
  const card = (id, title, rows) => grid.append(element("div", { class: "card", id }, element("h3", {}, title), table(null, rows, ["", "number"])));
  card("at-the-end", "At the last coupling time", [
    ["time", `${shown(last("time"))} s`], ["half-length", `${shown(last("half_length"))} m`],
    ...(isDry ? [["strain energy", `${shown(last("strain_energy"))} J`], ["cohesive work", `${shown(last("cohesive_work"))} J`], ["failure work", `${shown(last("failure_work"))} J`]] : [
    ["inlet aperture", `${shown(last("inlet_aperture") * 1e3)} mm`], ["inlet net pressure", `${shown(last("inlet_net_pressure") / 1e6)} MPa`],
    ["injected", `${shown(last("injected"))} m\u00b3`], ["efficiency", shown(last("efficiency"))],
    ["ledger residual, relative", shown(last("relative_residual"), 2)]])]);
  const steps = (history.explicit_steps || []).length && !thinned ? history.explicit_steps.reduce((sum, count) => sum + count, 0) : null;
  card("effort", "Effort", [
    ["coupling intervals", shown(coupling.intervals ?? data.history.rows)], ["explicit steps", shown(coupling.explicit_steps ?? steps)],
    ["insertions", shown(coupling.insertions ?? last("revision"))], ["elements", shown((summary.mesh || {}).elements ?? last("elements"))],
    ["mass scale at the end", shown(last("mass_scale"))], ["wall time", `${shown(wall.total_s)} s`],
    ["of it: structure, network, coupler", `${shown(wall.structure_s, 3)}, ${shown(wall.network_s, 3)}, ${shown(wall.coupler_s, 3)} s`]]);
}

// The part of a curve within the time of the case.
function within(curve) {
  const rows = curve.time.map((_, row) => row).filter((row) => curve.time[row] <= data.case.time.end * (1 + 1e-9));
  return { x: rows.map((row) => curve.time[row]), y: rows.map((row) => curve.value[row]) };
}

// From zero, or the least, to a little above the largest value after the first hundredth of the case: before, the fracture is not open yet.
function limitsAfterOpening(column, factor) {
  const values = time.map((at, row) => (at > data.case.time.end / 100 ? history[column][row] : null)).filter((value) => value !== null);
  if (values.length === 0) return null;
  const most = values.reduce((a, b) => Math.max(a, b)) * factor, least = values.reduce((a, b) => Math.min(a, b), 0) * factor;
  if (most <= least) return null;
  const step = niceStep(most - least, 8);
  return [Math.floor(least / step) * step, Math.ceil((most * 1.02) / step) * step];
}

// The run, what the case is compared with, and the classical solution.
function compared(column, label) {
  const { curves, points: expected } = data.comparison, series = [ofHistory(label, column, colours.blue, { width: 2.2 })];
  if (curves[column]) series.push({ label: "reference of the case", ...within(curves[column]), colour: colours.orange, line: "dashed" });
  const given = expected.filter((point) => point.name === column);
  if (given.length) series.push({ label: "expected", x: given.map((point) => point.time), y: given.map((point) => point.value), colour: colours.orange, line: "none", marker: 6 });
  if (data.classical && data.classical[column])
    series.push({ label: "classical KGD", x: data.classical.time, y: data.classical[column], colour: colours.grey, line: "dotted" });
  return series;
}

function sourceOf(...columns) {
  return "history.csv: time, " + columns.join(", ") + (Object.keys(data.comparison.curves).length ? "; input/ reference of expected.toml" : "");
}

function growth() {
  const remark = data.comparison.remark ? ` The reference of the case is missing: ${data.comparison.remark}.` : "";
  const classical = data.classical ? "Classical KGD: Geertsma and de Klerk (1969), each wing with half the rate; no toughness, no leak-off, no lag, so a "
    + "real fracture of finite toughness is shorter and wider; it needs a constant rate and a Newtonian fluid." : "The classical KGD solution is not "
    + "drawn: it needs a Newtonian fluid injected at a constant rate through one perforation.";
  const grid = section("Growth", (isDry ? "No fluid is pumped in this case." : classical) + remark), x = "time [s]";
  chart(grid, { id: "half_length", title: "Half-length", x, y: "half-length [m]", zero: true, wide: isDry && !isUsed("path_deviation") && !isUsed("end_angle"),
    series: [...compared("half_length", "half-length"), ofHistory("opened part", "half_length_open", colours.teal, { width: 1 }),
      ofHistory("fully broken part", "half_length_broken", colours.plum, { width: 1 })],
    caption: "Half of the trace length, between the last opened and the last fully broken node; the steps are mesh edges.",
    source: sourceOf("half_length, half_length_open, half_length_broken") });
  if (!isDry) inlet(grid, x);
  if (isUsed("path_deviation") || isUsed("end_angle")) path(grid, x);
}

function inlet(grid, x) {
  chart(grid, { id: "inlet_aperture", title: "Aperture at the inlet", x, y: "aperture [mm]", factor: 1e3, zero: true,
    series: compared("inlet_aperture", "aperture"), caption: "Mechanical opening at the first perforation.", source: sourceOf("inlet_aperture") });
  chart(grid, { id: "inlet_net_pressure", title: "Net pressure at the inlet", x, y: "net pressure [MPa]", factor: 1e-6, limits: limitsAfterOpening("inlet_net_pressure", 1e-6),
    series: compared("inlet_net_pressure", "net pressure"),
    caption: "Fluid pressure at the first perforation minus the in-situ total stress that closes the fracture there; the first moments are off the scale.", source: sourceOf("inlet_net_pressure") });
  chart(grid, { id: "pumping", title: "Pumping", x, y: "well pressure [MPa]", factor: 1e-6, right: "rate [L/s]", rightFactor: 1e3,
    series: [ofHistory("well pressure", "well_pressure", colours.blue), ofHistory("rate", "rate", colours.ochre, { right: true })],
    caption: "Total pressure in the well, and the rate of the whole thickness: injected positive, produced negative.", source: "history.csv: time, well_pressure, rate" });
  if (isUsed("leaked")) chart(grid, { id: "efficiency", title: "Efficiency", x, y: "efficiency [\u2013]",
    wide: !isUsed("path_deviation"), series: compared("efficiency", "efficiency"), caption: "Fluid in the fractures over all fluid.", source: sourceOf("efficiency") });
}

function path(grid, x) {
  const degree = 180 / Math.PI;
  chart(grid, { id: "path", title: "Path", wide: !isDry && !isUsed("leaked"), x, y: "angle [degree]", factor: degree, right: "distance [m]", rightFactor: 1,
    series: [ofHistory("slit to chord of the wing", "path_angle", colours.blue), ofHistory("first segment to greatest compression", "first_angle", colours.teal),
      ofHistory("end to greatest compression", "end_angle", colours.plum), ofHistory("distance from the slit's line", "path_deviation", colours.ochre, { right: true })],
    caption: "The worst of all wings; the end is the mean of the last three segments. In an isotropic stress the slit stands for the greatest compression.", source: "history.csv: time, path_angle, first_angle, end_angle, path_deviation" });
}

function fluid() {
  const grid = section("Fluid ledger", "Every litre is booked: injected + in place + found + reset = in the fractures + leaked + residual."), x = "time [s]";
  const booked = (label, column, colour) => ({ label, x: ledger.time, y: ledger[column], colour });
  chart(grid, { id: "ledger", title: "Volumes", x, y: "volume [L]", factor: 1e3,
    series: [booked("injected", "injected", colours.blue), booked("in the fractures", "in_fractures", colours.teal), booked("leaked", "leaked", colours.orange),
      booked("found in natural fractures", "found", colours.plum)].filter((series) => !["leaked", "found in natural fractures"].includes(series.label) || (series.y || []).some((value) => value > 0)),
    caption: "Cumulative volumes of the whole thickness. Without leak-off, what is injected is in the fractures and the two lines lie on each other.",
    source: "ledger.csv: time, injected, in_fractures, leaked, found" });
  chart(grid, { id: "residual", title: "Residual", x, y: "relative residual [\u2013]", logarithmic: true,
    series: [{ label: "residual", x: ledger.time, y: ledger.relative_residual, colour: colours.blue, line: "none", dots: true, marker: 1.5 }],
    caption: "What the ledger cannot account for, over the largest volume that went through it: rounding. Exact zeros cannot be drawn.",
    source: "ledger.csv: time, relative_residual" });
}

function coupling() {
  const grid = section("Coupling", "Structure and flow solver are solved apart; these are the differences between them at the coupling times."), x = "time [s]";
  chart(grid, { id: "mismatch", title: "Mismatch and drift", x, y: "relative difference [\u2013]", logarithmic: true, wide: true,
    series: [ofHistory("drift", "drift", colours.ochre, { width: 1 }), ofHistory("mismatch", "mismatch", colours.blue, { width: 1.2 })],
    caption: "Mismatch: volume the structure opened against the content of the network. Drift: the same with the differences of single nodes not cancelling.",
    source: "history.csv: time, mismatch, drift" });
}

function energies() {
  const grid = section("Energy", ""), x = "time [s]";
  chart(grid, { id: "energies", title: "Energies", x, y: "energy [J]", logarithmic: true, wide: !isUsed("cohesive_share"),
    series: [ofHistory("strain", "strain_energy", colours.blue), ofHistory("kinetic", "kinetic_energy", colours.grey, { width: 1 }),
      ofHistory("cohesive work", "cohesive_work", colours.orange), ofHistory("failure work", "failure_work", colours.plum)],
    caption: "Whole thickness. Strain: of the change from in situ, known at field reports. Kinetic: with the scaled mass; it has to stay small against the "
      + "strain energy. Cohesive and failure work: spent on fracture faces and in the rock.", source: "history.csv: time, strain_energy, kinetic_energy, cohesive_work, failure_work" });
  if (isUsed("cohesive_share")) chart(grid, { id: "cohesive_share", title: "Cohesive work over fracture energy", x, y: "share [\u2013]", zero: true,
    series: [ofHistory("share", "cohesive_share", colours.blue)],
    caption: "Work spent on the faces over fracture energy times grown area: 1 when every grown segment has broken fully.", source: "history.csv: time, cohesive_share" });
}

function remeshing() {
  const { rows, columns } = data.remeshing, number = columns.time.map((_, row) => row + 1), x = "insertion";
  const difference = (after, before) => columns[after].map((value, row) => value - columns[before][row]);
  const sum = (column) => columns[column].reduce((total, value) => total + value, 0);
  const touched = columns.elements_made.map((made, row) => Math.max(made, columns.elements_removed[row])).sort((a, b) => a - b);
  const median = (touched[Math.floor((rows - 1) / 2)] + touched[Math.floor(rows / 2)]) / 2;
  const identical = columns.hash_before.every((hash, row) => hash === columns.hash_after[row]);
  const of = (label, y, colour, more = {}) => ({ label, x: number, y, colour, marker: 2, width: 1, ...more });
  const grid = section("Remeshing", "Every insertion replaces a patch of elements around one tip; all others must stay bit-identical.");
  const total = ((data.summary || {}).wall || {}).total_s, stable = columns.stable_step_after.map((after, row) => after / columns.stable_step_before[row]);
  grid.append(element("div", { class: "card wide", id: "remeshing-totals" }, element("h3", {}, "Totals"), table(
    ["insertions", "median touched", "most touched", "untouched elements", "smallest angle", "smallest altitude", "worst step ratio", "largest mass error", "wall time"],
    [[String(rows), shown(median), shown(touched[rows - 1]),
      { text: identical ? "bit-identical" : "CHANGED", kind: identical ? "pass" : "fail" }, `${shown(Math.min(...columns.smallest_angle) * 180 / Math.PI, 3)}\u00b0`,
      `${shown(Math.min(...columns.smallest_altitude), 3)} m`, shown(Math.min(...stable), 3), shown(Math.max(...columns.mass_error.map(Math.abs)), 2),
      `${shown(sum("wall_seconds"), 3)} s` + (total ? ` (${percent(sum("wall_seconds") / total)})` : "")]])));
  chart(grid, { id: "touched", title: "Elements touched", x, y: "elements", zero: true,
    series: [of("removed", columns.elements_removed, colours.orange), of("made", columns.elements_made, colours.blue)],
    caption: "Elements of the patch before and after; the larger number counts as touched.", source: "remeshing.csv: elements_removed, elements_made" });
  chart(grid, { id: "altitude", title: "Smallest altitude and stable step", x, y: "altitude [m]", zero: true, right: "stable step, after over before [\u2013]", rightFactor: 1,
    series: [of("smallest altitude", columns.smallest_altitude, colours.blue), of("stable step, after over before", stable, colours.ochre, { right: true })],
    caption: "The smallest altitude of the new elements, and what the insertion did to the stable step of the structure.",
    source: "remeshing.csv: smallest_altitude, stable_step_before, stable_step_after" });
  chart(grid, { id: "energy_jump", title: "Energy of the patch", x, y: "after minus before [J]",
    series: [of("strain", difference("strain_energy_after", "strain_energy_before"), colours.blue),
      of("kinetic", difference("kinetic_energy_after", "kinetic_energy_before"), colours.orange)],
    caption: "What carrying displacement and momentum over to the new elements changes. Segments inserted at once share one patch energy.",
    source: "remeshing.csv: strain_energy_*, kinetic_energy_*" });
  chart(grid, { id: "remeshing_wall", title: "Wall time of an insertion", x, y: "wall time [ms]", factor: 1e3, zero: true,
    series: [of("wall time", columns.wall_seconds, colours.blue)], caption: "Of the structure: patch, new elements, transfer of state.", source: "remeshing_wall.csv: wall_seconds" });
}

function stepping() {
  const grid = section("Intervals and steps", thinned ? `The run has ${data.history.rows} coupling intervals; ${time.length} are drawn here and above, the extremes of residual, mismatch, drift, pressure and duration among them.` : ""), x = "time [s]";
  chart(grid, { id: "interval", title: "Coupling interval and stable step", x, y: "duration [s]", logarithmic: true,
    series: [ofHistory("coupling interval", "duration", colours.blue, { width: 1.2 }), ofHistory("stable step", "stable_step", colours.teal)],
    caption: "Simulated length of each coupling interval, and the explicit step of the structure.", source: "history.csv: time, duration, stable_step" });
  chart(grid, { id: "steps", title: "Steps and iterations", x, y: "number in an interval", zero: true,
    series: [ofHistory("explicit steps", "explicit_steps", colours.blue, { width: 1 }), ofHistory("Newton iterations", "newton_iterations", colours.orange, { width: 1 }),
      ofHistory("halvings", "halvings", colours.plum, { width: 1 })],
    caption: "Work of one coupling interval: of the structure, and of the flow solver.", source: "history.csv: time, explicit_steps, newton_iterations, halvings" });
  chart(grid, { id: "mass_scale", title: "Mass scale", x, y: "factor on the density [\u2013]", logarithmic: true, wide: !isUsed("elements"),
    series: [ofHistory("mass scale", "mass_scale", colours.blue)], caption: "Follows the pumping.", source: "history.csv: time, mass_scale" });
  if (isUsed("elements")) chart(grid, { id: "elements", title: "Mesh", x, y: "elements", series: [ofHistory("elements", "elements", colours.blue)],
    caption: "Elements of the mesh.", source: "history.csv: time, elements" });
}

head();
const result = section("Result", "");
verdict(result);
keyFigures(result);
if (data.map.segments.length > 0) fractureMap(section("Fracture map", ""), data);
if (hasNaturalFractures) naturalFractures(data, ofHistory);
if (data.seismicity) seismicSection(data);
growth();
if (!isDry) fluid();
if (!isDry) coupling();
if (data.remeshing && data.remeshing.rows > 0) remeshing();
energies();
if (data.stress) {
  const grid = section("Stress", "");
  stressMaps(grid, data);
  stressPicture(grid, data);
}
stepping();
showOnly(asked.get("figure"));
