// The catalogue against time: panels of one figure that share their time axis.

// panels(grid, { id, title, caption, source, wide, height, controls, x, panels: [{ id, title, weight, logarithmic, zero, limits: { min, max } }], datasets }): panels from top to bottom,
// datasets as Chart.js takes them with the panel as their yAxisID; those without a label are not in the legend. Returns { chart, show(datasets) }.
function panels(grid, options) {
  const plot = element("div", { class: "plot" }), legend = element("div", { class: "legend" });
  plot.style.height = options.height + "px";
  figure(grid, options.id, options.title, [...(options.controls ? [element("div", { class: "controls" }, ...options.controls)] : []), legend, plot], options.caption, options.source, options.wide);
  const canvas = element("canvas", { role: "img", "aria-label": options.title });
  plot.append(canvas);
  const scales = { x: { ...axis(options.x.title, options.x.logarithmic), ...(options.x.limits || {}) } };
  // The library stacks from the bottom.
  for (const panel of [...options.panels].reverse()) {
    const made = { ...axis(panel.title, panel.logarithmic), ...(panel.limits || {}), axis: "y", position: "left", stack: "panels", stackWeight: panel.weight };
    if (panel.zero) made.beginAtZero = true;
    if (!panel.logarithmic) made.ticks.maxTicksLimit = Math.round(1 + 3 * panel.weight);
    // The highest label of a panel would stand on the lowest of the one above.
    const label = made.ticks.callback;
    if (panel !== options.panels[0]) made.ticks.callback = (value, number, ticks) => (number === ticks.length - 1 ? null : label(value));
    // Titles of all panels in one line, whatever stands beside them.
    made.afterFit = (scale) => { scale.width = Math.max(scale.width, 66); };
    scales[panel.id] = made;
  }
  const made = new Chart(canvas, {
    type: "scatter",
    data: { datasets: [] },
    options: {
      responsive: true,
      maintainAspectRatio: false,
      interaction: { mode: "nearest", axis: "xy", intersect: true },
      layout: { padding: { right: 12, top: 6 } },
      scales,
      plugins: {
        legend: { display: false },
        tooltip: { filter: (item) => item.dataset.label !== "", callbacks: { label: (item) => `${item.dataset.label}: ${shown(item.parsed.y, 4)} at ${shown(item.parsed.x, 5)}` } },
      },
    },
  });
  const show = (datasets) => {
    made.data.datasets = datasets;
    legend.replaceChildren(...datasets.filter((set) => set.label !== "").map((set) => element("span", { class: "item" }, swatch(set), set.label)));
    made.update("none");
  };
  show(options.datasets);
  return { chart: made, show };
}

// What a data set looks like, for a legend: a stroke, a box, a disc or a triangle.
function swatch(set) {
  if (set.pointStyle === "triangle") {
    const made = element("span", {}, "\u25b3");
    made.style.color = set.borderColor;
    return made;
  }
  const made = element("span", { class: set.fill ? "box" : set.showLine ? "stroke" : "disc" });
  if (set.showLine && !set.fill) made.style.borderTop = `${Math.max(1.5, set.borderWidth)}px ${!(set.borderDash || []).length ? "solid" : set.borderDash[0] > 2 ? "dashed" : "dotted"} ${set.borderColor}`;
  else Object.assign(made.style, { background: set.backgroundColor, borderColor: set.borderColor, ...(set.fill ? {} : { width: "10px", height: "10px" }) });
  return made;
}

const curve = (label, panel, x, y, colour, more = {}) => ({ label, yAxisID: panel, data: x.map((at, row) => ({ x: at, y: y[row] })).filter((point) => point.y !== null && Number.isFinite(point.y)), showLine: true, borderColor: colour,
  backgroundColor: "transparent", borderWidth: 1.6, pointRadius: 0, pointHitRadius: 4, ...more });

// Dots of events, a data set for each type; radius by moment.
function eventDots(events, panel, x, y, largest) {
  const radius = radiusOf(events, largest, 1.3);
  return eventTypes.map((type) => {
    const some = largeFirst(events.filter((event) => event.type === type && x(event) !== null && y(event) !== null));
    return { label: type, yAxisID: panel, data: some.map((event) => ({ x: x(event), y: y(event) })), pointRadius: some.map((event) => radius(event.moment)),
      pointHoverRadius: some.map((event) => radius(event.moment)), backgroundColor: eventColours[type] + "a0", borderColor: eventColours[type], borderWidth: 0.7, pointStyle: "circle", order: 2, clip: 6 };
  }).filter((made) => made.data.length > 0);
}

// The steps of a curve that holds each value until the next.
const held = { stepped: "before" };

// The time of the run as far as it went.
function timeAxis(data) {
  const { time } = data.history.columns, seismicity = data.seismicity.columns.t0, longest = Math.max(time[time.length - 1] || 0, seismicity.reduce((a, b) => Math.max(a, b), 0));
  return { title: "time [s]", limits: roundLimits(Math.min(0, seismicity.reduce((a, b) => Math.min(a, b), 0)), longest, 14) };
}

function pumpRate(pumping, panel) {
  return curve("pump rate", panel, pumping.time, pumping.rate.map((rate) => rate * 1e3), colours.ochre);
}

const isPumped = (seismicity) => seismicity.pumping && seismicity.pumping.time.length > 0 && seismicity.pumping.rate.some((rate) => rate !== 0);
const ratePanel = { id: "rate", title: "rate [L/s]", weight: 1, zero: true };

// From `from` to a whole number of steps beyond `most`.
function roundLimits(from, most, parts) {
  const step = most > from ? niceStep(most - from, parts) : 1;
  return { min: from, max: from + step * Math.max(1, Math.ceil((most - from) / step - 1e-9)) };
}

// Series of a law of growth, named with its coefficient and exponent.
function lawName(law) {
  const exponent = `t^${shown(law.exponent, 2)}`, best = law.diffusivity !== undefined && law.diffusivity !== null ? `, D = ${shown(law.diffusivity, 3)} m\u00b2/s` : "";
  return `${law.name}: r = ${shown(law.coefficient, 3)} ${exponent}${best}`;
}

const lawColours = ["#3d5a80", "#8e4a86", "#2a8c82", "#b08a1e", "#64727f"];

function distanceTime(grid, data, events) {
  const { distance, pumping, caption } = data.seismicity;
  if (!distance) return;
  const start = distance.start || 0, longest = events.reduce((most, event) => Math.max(most, event.distance || 0), 0);
  const laws = (distance.laws || []).filter((law) => law.coefficient !== null && law.curve).map((law, number) => curve(lawName(law), "distance", law.curve.time, law.curve.distance, lawColours[number % lawColours.length],
    { borderWidth: law.name === distance.best_law ? 2.4 : 1.1, borderDash: law.name === distance.best_law ? [] : [6, 4], order: 1 }));
  const envelope = distance.envelope ? [curve("95 % envelope", "distance", distance.envelope.time, distance.envelope.distance, "#101820", { borderWidth: 1.2, pointRadius: 3, pointStyle: "rect", backgroundColor: "#101820", order: 1 })] : [];
  const back = distance.back_front ? [curve("back front", "distance", distance.back_front.curve.time, distance.back_front.curve.distance, "#b3382c", { borderDash: [2, 3], order: 1 })] : [];
  const datasets = [...eventDots(events, "distance", (event) => event.time, (event) => event.distance, 9), ...envelope, ...laws, ...back];
  const pumped = isPumped(data.seismicity);
  if (pumped) datasets.push(pumpRate(pumping, "rate"));
  const fitted = distance.exponent === null || distance.exponent === undefined ? "" : `The envelope grows as t^p with p = ${shown(distance.exponent, 3)}${distance.exponent_sigma ? ` \u00b1 ${shown(distance.exponent_sigma, 2)}` : ""}. `;
  panels(grid, { id: "distance_time", title: "Distance from the well", wide: true, height: pumped ? 560 : 440, x: timeAxis(data),
    panels: [{ id: "distance", title: "distance [m]", weight: 3.2, limits: roundLimits(0, longest * 1.05, 8) }, ...(pumped ? [ratePanel] : [])], datasets,
    caption: `${fitted}${distance.verdict || ""} Dots by type, their size by moment; t in a law is the time since pumping began${start ? ` at ${shown(start)} s` : ""}; thick: the law that fits best. ${caption}`,
    source: `seismicity/catalogue.csv: tc_s, x_m, y_m, M0_Nm, type${pumped ? "; history.csv: time, rate" : ""}` });
}

// From the least after the first fiftieth of the time, when the well is being filled, to the greatest of all.
function pressureLimits({ time, pressure }) {
  const inMegapascal = (values) => values.filter((value) => value !== null).map((value) => value / 1e6);
  const values = inMegapascal(pressure.filter((_, row) => time[row] > time[time.length - 1] / 50));
  if (values.length === 0) return {};
  const least = values.reduce((a, b) => Math.min(a, b)), most = inMegapascal(pressure).reduce((a, b) => Math.max(a, b)), step = niceStep(Math.max(most - least, 0.02 * Math.abs(most), 1e-3), 3);
  return { min: Math.floor(least / step) * step, max: Math.ceil(most / step + 0.1) * step };
}

function magnitudeTime(grid, data, events) {
  const { pumping, caption } = data.seismicity, some = events.filter((event) => event.magnitude !== null);
  if (some.length === 0) return;
  const magnitudes = some.map((event) => event.magnitude), top = magnitudes.reduce((a, b) => Math.max(a, b)), foot = Math.floor(2 * magnitudes.reduce((a, b) => Math.min(a, b)) - 0.2) / 2;
  const stems = eventTypes.map((type) => ({ ...curve("", "magnitude", [], [], eventColours[type] + "70"), borderWidth: 0.8, spanGaps: false, order: 3,
    data: some.filter((event) => event.type === type).flatMap((event) => [{ x: event.time, y: foot }, { x: event.time, y: event.magnitude }, { x: event.time, y: NaN }]) })).filter((made) => made.data.length > 0);
  const datasets = [...stems, ...eventDots(some, "magnitude", (event) => event.time, (event) => event.magnitude, 5)], pumped = isPumped(data.seismicity);
  if (pumped) datasets.push(curve("well pressure", "pressure", pumping.time, pumping.pressure.map((value) => (value === null || value / 1e6 < (pressureLimits(pumping).min ?? 0) ? null : value / 1e6)), colours.blue), pumpRate(pumping, "rate"));
  panels(grid, { id: "magnitude_time", title: "Magnitude against time", wide: true, height: pumped ? 520 : 320, x: timeAxis(data),
    panels: [{ id: "magnitude", title: "magnitude Mw [\u2013]", weight: 2.6, limits: { min: foot, max: Math.ceil(2 * top + 0.2) / 2 } }, ...(pumped ? [{ id: "pressure", title: "pressure [MPa]", weight: 1, limits: pressureLimits(pumping) }, ratePanel] : [])], datasets,
    caption: `A stem for each event.${pumped ? " Beneath: total pressure in the well, once it is full, and what is pumped." : ""} ${caption}`, source: `seismicity/catalogue.csv: tc_s, Mw, type${pumped ? "; history.csv: time, well_pressure, rate" : ""}` });
}

function seismicRate(grid, data) {
  const { rate, pumping, caption } = data.seismicity;
  if (!rate || !rate.events.some((count) => count > 0)) return;
  const minutes = rate.events.map((_, bin) => (rate.time[bin + 1] - rate.time[bin]) / 60), pumped = isPumped(data.seismicity);
  // The outline of the bins: down to the foot between them only where there is nothing.
  const outline = (values, foot) => rate.time.slice(0, -1).flatMap((from, bin) => [{ x: from, y: values[bin] / minutes[bin] || foot }, { x: rate.time[bin + 1], y: values[bin] / minutes[bin] || foot }]);
  const moments = rate.moment.map((moment, bin) => moment / minutes[bin]).filter((moment) => moment > 0), foot = 10 ** Math.floor(Math.log10(Math.min(...moments)) - 1e-9);
  const bars = (label, panel, data, colour, base) => ({ ...curve(label, panel, [], [], colour), data, backgroundColor: colour + "40", fill: { value: base }, borderWidth: 1.2 });
  const datasets = [bars("events", "events", outline(rate.events, 0), "#0072b2", 0), bars("moment", "moment", outline(rate.moment, foot), "#d55e00", foot)];
  if (pumped) datasets.push(pumpRate(pumping, "rate"));
  panels(grid, { id: "seismic_rate", title: "Rate of events and of moment", height: 420, x: timeAxis(data),
    panels: [{ id: "events", title: "events / min", weight: 1.5, zero: true }, { id: "moment", title: "N m / min", weight: 1.5, logarithmic: true, limits: { min: foot } }, ...(pumped ? [ratePanel] : [])], datasets,
    caption: `Number and summed scalar moment of the events in each bin, over its duration. ${caption}`, source: `seismicity/catalogue.csv: tc_s, M0_Nm${pumped ? "; history.csv: time, rate" : ""}` });
}

function momentTime(grid, data) {
  const { moment, caption } = data.seismicity;
  if (!moment || moment.time.length === 0) return;
  const againstVolume = moment.injected && moment.injected.some((volume) => volume > 0), names = againstVolume ? ["time", "injected volume"] : ["time"];
  const x = { time: moment.time, "injected volume": moment.injected };
  const sets = (name) => {
    const of = (label, values, colour, more) => curve(label, "moment", x[name], values.map((value, row) => (value > 0 && (name === "time" || x[name][row] > 0) ? value : null)), colour, more);
    return [of("sum of the moments", moment.cumulative, "#101820", { ...held, borderWidth: 2.2 }), of("greatest event so far", moment.greatest, "#d55e00", { ...held }),
      ...(againstVolume ? [of("2 G \u0394V, bound of the sum", moment.sum_bound, "#101820", { borderDash: [7, 4], borderWidth: 1.2 }), of("G \u0394V, bound of the greatest", moment.greatest_bound, "#d55e00", { borderDash: [7, 4], borderWidth: 1.2 })] : [])];
  };
  const axes = { time: () => axis("time [s]", false), "injected volume": () => axis("injected volume [m\u00b3]", true) };
  const first = chosen("moment_time", names, "time");
  const go = (name) => {
    made.chart.options.scales.x = axes[name]();
    made.show(sets(name));
  };
  const made = panels(grid, { id: "moment_time", title: "Moment released", height: 420, controls: againstVolume ? radioButtons("moment-against", names, (name) => "against " + name, first, go) : null,
    x: { title: "time [s]" }, panels: [{ id: "moment", title: "moment [N m]", weight: 1, logarithmic: true }], datasets: [],
    caption: `${againstVolume ? "Bounds after McGarr (1976, 2014) from the injected volume \u0394V and the shear modulus G of the rock: lines to compare with, nothing is held to them. " : ""}${caption}`,
    source: "seismicity/catalogue.csv: tc_s, M0_Nm" + (againstVolume ? "; history.csv: time, injected" : "") });
  go(first);
}

// Of fewer than five events nothing is to be seen in it.
function magnitudeDistance(grid, data, events) {
  const some = events.filter((event) => event.magnitude !== null && event.distance !== null);
  if (some.length < 5) return;
  panels(grid, { id: "magnitude_distance", title: "Magnitude against distance", height: 420, x: { title: "distance from the well [m]", limits: { min: 0 } }, panels: [{ id: "magnitude", title: "magnitude Mw [\u2013]", weight: 2 }],
    datasets: eventDots(some, "magnitude", (event) => event.distance, (event) => event.magnitude, 5), caption: data.seismicity.caption, source: "seismicity/catalogue.csv: x_m, y_m, Mw, type" });
}
