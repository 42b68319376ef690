// Pictures of the plane: equal scales in x and y, and a function that draws on the canvas.

function niceStep(span, parts) {
  const raw = span / parts, power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= raw);
}

// Widens the box [west, east, south, north] to the shape of the drawing area.
function equalise(made, box) {
  const { width, height } = made.chartArea;
  if (width <= 0 || height <= 0) return;
  const metre = Math.max((box[1] - box[0]) / width, (box[3] - box[2]) / height);
  const middle = [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2], scales = made.options.scales;
  const stepSize = Math.max(niceStep(metre * width, 14), Math.min(niceStep(metre * width, 8), niceStep(metre * height, 4)));
  Object.assign(scales.x, { min: middle[0] - (metre * width) / 2, max: middle[0] + (metre * width) / 2 });
  Object.assign(scales.y, { min: middle[1] - (metre * height) / 2, max: middle[1] + (metre * height) / 2 });
  // The library's own ticks start from the limits where these are nearly a whole number of steps apart.
  scales.x.afterBuildTicks = scales.y.afterBuildTicks = (scale) => {
    scale.ticks = [];
    for (let number = Math.ceil(scale.min / stepSize); number * stepSize <= scale.max; ++number) scale.ticks.push({ value: number * stepSize });
  };
}

// plane(plot, box, inSitu, draw, label, bar): draw(context, place, area) with place(x, y) -> [pixel, pixel]; beside it the in-situ stresses
// and, if bar() gives one, a colour bar; with inSitu null neither, and the picture takes their place. Returns { show(box), redraw() }.
function plane(plot, box, inSitu, draw, label, bar) {
  const canvas = element("canvas", { role: "img", "aria-label": label });
  plot.append(canvas);
  let shownBox = box, settling = false;
  const settle = (made) => {
    // Tick labels change the drawing area, and the area the limits: two rounds are enough.
    settling = true;
    for (let round = 0; round < 2; ++round) {
      equalise(made, shownBox);
      made.update("none");
    }
    settling = false;
  };
  const scale = (title) => ({ type: "linear", min: 0, max: 1, title: { display: true, text: title },
    ticks: { autoSkip: false, maxRotation: 0, callback: (value) => shown(Number(value.toPrecision(8)), 6) } });
  const made = new Chart(canvas, {
    type: "scatter",
    data: { datasets: [{ data: [] }] },
    options: {
      responsive: true,
      maintainAspectRatio: false,
      layout: { padding: { right: inSitu ? 150 : 8, top: 6 } },
      events: [],
      scales: { x: scale("x, east [m]"), y: scale("y, north [m]") },
      plugins: { legend: { display: false }, tooltip: { enabled: false } },
      onResize: (resized) => { if (!settling) setTimeout(() => settle(resized), 0); },
    },
    plugins: [{
      id: "plane",
      afterDatasetsDraw: (drawn) => {
        const { ctx, chartArea, scales } = drawn;
        ctx.save();
        if (inSitu) inSituAxes(ctx, chartArea, inSitu);
        if (bar && bar()) colourBar(ctx, chartArea, bar());
        ctx.beginPath();
        ctx.rect(chartArea.left, chartArea.top, chartArea.width, chartArea.height);
        ctx.clip();
        draw(ctx, (x, y) => [scales.x.getPixelForValue(x), scales.y.getPixelForValue(y)], chartArea);
        ctx.restore();
      },
    }],
  });
  settle(made);
  return { show: (next) => { shownBox = next; settle(made); }, redraw: () => made.draw() };
}

function polyline(ctx, place, points) {
  ctx.beginPath();
  points.forEach(([x, y], number) => (number === 0 ? ctx.moveTo(...place(x, y)) : ctx.lineTo(...place(x, y))));
  ctx.stroke();
}

// Two arrows towards each other along a direction, as compression is drawn.
function compressionArrows(ctx, x, y, angle, length) {
  for (const side of [1, -1]) {
    const across = Math.cos(angle) * side, up = -Math.sin(angle) * side, gap = 9;
    const tip = [x + across * gap, y + up * gap], tail = [x + across * (gap + length), y + up * (gap + length)];
    ctx.beginPath();
    ctx.moveTo(...tail);
    ctx.lineTo(...tip);
    for (const turn of [0.45, -0.45]) {
      const head = Math.atan2(up, across) + turn;
      ctx.moveTo(...tip);
      ctx.lineTo(tip[0] + 8 * Math.cos(head), tip[1] + 8 * Math.sin(head));
    }
    ctx.stroke();
  }
}

// The total in-situ stresses, if there are any, to the right of a picture.
function inSituAxes(ctx, area, inSitu) {
  const x = area.right + 78, y = area.top + 64, longest = 42;
  if (inSitu.greatest === 0 && inSitu.least === 0) return;
  ctx.strokeStyle = ctx.fillStyle = "#4b5965";
  ctx.lineWidth = 1.6;
  const ratio = inSitu.greatest > 0 ? Math.max(0.3, inSitu.least / inSitu.greatest) : 1;
  compressionArrows(ctx, x, y, inSitu.angle, longest);
  compressionArrows(ctx, x, y, inSitu.angle + Math.PI / 2, longest * ratio);
  ctx.font = "12px " + Chart.defaults.font.family;
  ctx.textAlign = "center";
  const isotropic = Math.abs(inSitu.greatest - inSitu.least) < 1e-9 * Math.abs(inSitu.greatest);
  ctx.fillText(isotropic ? "in situ, isotropic" : "in situ, total", x, y + 66);
  ctx.fillText(isotropic ? `${shown(inSitu.greatest / 1e6)} MPa` : `${shown(inSitu.greatest / 1e6)} and ${shown(inSitu.least / 1e6)} MPa`, x, y + 82);
}

// To the right of a picture, below the in-situ stresses: { title, unit, low, high, colour(share) }, or { title, marks: [[colour, text], ...] }.
function colourBar(ctx, area, bar) {
  const left = area.right + 24, top = area.top + 210, width = 16, height = Math.max(60, Math.min(260, area.bottom - top));
  ctx.font = "12px " + Chart.defaults.font.family;
  ctx.fillStyle = "#4b5965";
  ctx.textAlign = "left";
  bar.title.split("\n").forEach((line, number, lines) => ctx.fillText(line, left, top - 12 - 15 * (lines.length - 1 - number)));
  if (bar.marks) {
    bar.marks.forEach(([colour, text], number) => {
      ctx.fillStyle = colour;
      ctx.fillRect(left, top + 4 + 20 * number, width, 5);
      ctx.fillStyle = "#4b5965";
      ctx.fillText(text, left + width + 7, top + 11 + 20 * number);
    });
    return;
  }
  for (let line = 0; line < height; ++line) {
    ctx.fillStyle = bar.colour(1 - line / (height - 1));
    ctx.fillRect(left, top + line, width, 1.5);
  }
  ctx.strokeStyle = ctx.fillStyle = "#4b5965";
  ctx.lineWidth = 1;
  ctx.strokeRect(left, top, width, height);
  const step = niceStep(bar.high - bar.low, 6);
  for (let number = Math.ceil(bar.low / step - 1e-9); number * step <= bar.high + 1e-9 * step; ++number) {
    const at = top + (height * (bar.high - number * step)) / (bar.high - bar.low);
    ctx.beginPath();
    ctx.moveTo(left + width, at);
    ctx.lineTo(left + width + 4, at);
    ctx.stroke();
    ctx.fillText(shown(Number((number * step).toPrecision(8)), 6), left + width + 7, at + 4);
  }
}
