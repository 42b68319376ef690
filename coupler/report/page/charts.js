// Series against time or number, drawn by Chart.js.

const colours = { blue: "#1f4e79", orange: "#c8641b", teal: "#2a8c82", plum: "#8e4a86", grey: "#8593a0", ochre: "#b08a1e" };

Chart.defaults.animation = false;
Chart.defaults.font.family = '"Helvetica Neue", Arial, "DejaVu Sans", sans-serif';
Chart.defaults.font.size = 12;
Chart.defaults.color = "#4b5965";
Chart.defaults.borderColor = "#e8edf1";

// Points of two columns; what has no value, or none on a logarithmic axis, is left out.
function points(x, y, factor, logarithmic) {
  const found = [];
  for (let row = 0; row < Math.min(x.length, y.length); ++row) {
    if (x[row] === null || y[row] === null) continue;
    if (!logarithmic || y[row] * factor > 0) found.push({ x: x[row], y: y[row] * factor });
  }
  return found;
}

function axis(title, logarithmic, position) {
  const made = { type: logarithmic ? "logarithmic" : "linear", title: { display: true, text: title }, ticks: { maxRotation: 0 } };
  if (position) made.position = position;
  if (position === "right") made.grid = { drawOnChartArea: false };
  if (!logarithmic) {
    made.ticks.callback = (value) => shown(value, 6);
    return made;
  }
  made.ticks.callback = (value) => {
    const exponent = Math.log10(value);
    return Math.abs(exponent - Math.round(exponent)) < 1e-9 ? powerOfTen(Math.round(exponent)) : null;
  };
  // Whole decades, so that there is always a label; ten at most, so that a start from rest does not press the rest together.
  made.afterDataLimits = (scale) => {
    const highest = Math.ceil(Math.log10(scale.max) - 1e-9);
    const lowest = Math.max(Math.floor(Math.log10(scale.min) + 1e-9), highest - 10);
    scale.max = 10 ** highest;
    scale.min = 10 ** Math.min(lowest, highest - 1);
  };
  return made;
}

function dataset(series, factor, logarithmic) {
  return {
    label: series.label,
    data: points(series.x, series.y, factor, logarithmic),
    showLine: series.line !== "none",
    borderColor: series.colour,
    backgroundColor: series.line === "none" || series.marker ? series.colour : "transparent",
    borderWidth: series.width || 1.8,
    borderDash: { dashed: [7, 4], dotted: [2, 3] }[series.line] || [],
    pointRadius: series.marker || 0,
    pointHitRadius: 6,
    pointStyle: series.line === "none" && !series.dots ? "rectRot" : "circle",
    yAxisID: series.right ? "right" : "y",
  };
}

// chart(grid, { id, title, caption, source, x, y, right, logarithmic, factor, series }): a figure with one chart. x, y and right are titles
// of axes; factor turns SI into the unit of y, rightFactor into that of right; limits are [least, most] of y in its unit. Series without a single point are left out; a chart without
// series becomes a sentence.
function chart(grid, options) {
  const datasets = options.series
    .map((series) => dataset(series, (series.right ? options.rightFactor : options.factor) || 1, options.logarithmic))
    .filter((made) => made.data.length > 0);
  const plot = element("div", { class: "plot" });
  figure(grid, options.id, options.title, [plot], options.caption, options.source, options.wide);
  if (datasets.length === 0) {
    plot.classList.add("empty");
    plot.style.height = "auto";
    plot.append("Nothing to draw: " + (options.logarithmic ? "every value is zero." : "no value yet."));
    return;
  }
  const canvas = element("canvas", { role: "img", "aria-label": options.title });
  plot.append(canvas);
  const scales = { x: axis(options.x, false), y: axis(options.y, options.logarithmic) };
  if (options.zero) scales.y.beginAtZero = true;
  if (options.limits) [scales.y.min, scales.y.max] = options.limits;
  if (datasets.some((made) => made.yAxisID === "right")) scales.right = { ...axis(options.right, false, "right"), beginAtZero: true };
  new Chart(canvas, {
    type: "scatter",
    data: { datasets },
    options: {
      responsive: true,
      maintainAspectRatio: false,
      interaction: { mode: "nearest", axis: "x", intersect: false },
      scales,
      plugins: {
        legend: { display: datasets.length > 1, align: "start", labels: { boxWidth: 26, boxHeight: 1, padding: 14, usePointStyle: false } },
        tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${shown(item.parsed.y, 5)} at ${shown(item.parsed.x, 5)}` } },
      },
    },
  });
}
