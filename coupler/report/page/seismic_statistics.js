// The catalogue as a whole: frequency and magnitude, mechanisms, stimulated volume.

function frequencyMagnitude(grid, data) {
  const { frequency_magnitude: found, caption } = data.seismicity;
  if (!found || found.magnitude.length === 0) return;
  const highest = Math.max(...found.cumulative), top = 10 ** Math.ceil(Math.log10(highest * 1.3)), foot = 1, number = (label, values, more) => ({ label, yAxisID: "number", data: found.magnitude.map((magnitude, bin) =>
    ({ x: magnitude, y: values[bin] })).filter((point) => point.y > 0), pointRadius: 4, clip: 6, order: 2, ...more });
  const upright = (label, magnitude, colour, dash) => (magnitude === null || magnitude === undefined ? [] : [curve(label, "number", [magnitude, magnitude], [foot, top], colour, { borderDash: dash, borderWidth: 1.4, order: 3 })]);
  const { b, completeness } = found, lines = [];
  if (b) {
    const from = b.from, atCompleteness = b.events;
    const ends = (slope) => { const to = Math.min(Math.max(...found.magnitude) + found.bin, from + Math.log10(atCompleteness / foot) / slope); return [[from, to], [atCompleteness, atCompleteness * 10 ** (-slope * (to - from))]]; };
    const sigma = b.sigma_shi_bolt ?? b.sigma_aki, line = (label, slope, more) => curve(label, "number", ...ends(slope), "#b3382c", { order: 1, ...more });
    lines.push(line(`b = ${b.value.toFixed(2)} \u00b1 ${sigma.toFixed(2)}`, b.value, { borderWidth: 2 }));
    for (const slope of [b.value - sigma, b.value + sigma]) if (slope > 0) lines.push(line("", slope, { borderWidth: 1, borderDash: [4, 3] }));
  }
  const minus = (value) => shown(Number(value.toFixed(2)), 3);
  const known = completeness !== null && completeness !== undefined, floor = found.numerical_floor !== null && found.numerical_floor !== undefined;
  const sentence = b ? `b by ${b.method} from ${b.events} events of at least Mw ${minus(b.from)}; \u00b1: ${b.sigma_shi_bolt === undefined || b.sigma_shi_bolt === null ? `Aki (${b.sigma_aki.toFixed(3)})` : `Shi and Bolt (Aki: ${b.sigma_aki.toFixed(3)})`}, dashed.`
    : `b is not reported: ${(found.not_reported || "no reason given").replace(/ -(?=\d)/g, " \u2212")}`.replace(/\.?$/, ".");
  panels(grid, { id: "frequency_magnitude", title: "Frequency and magnitude", height: 440, x: { title: "magnitude Mw [\u2013]" }, panels: [{ id: "number", title: "number of events", weight: 1, logarithmic: true }],
    datasets: [number("of at least Mw", found.cumulative, { pointStyle: "circle", backgroundColor: "#101820", borderColor: "#101820", pointRadius: 3 }),
      number(`in a bin of ${shown(found.bin)}`, found.incremental, { pointStyle: "triangle", backgroundColor: "#fff", borderColor: "#0072b2", borderWidth: 1.3, order: 1 }), ...lines,
      ...upright(known ? `Mc = ${minus(completeness)}` : "", completeness, "#009e73", [7, 4]), ...upright(floor ? `of one element: ${minus(found.numerical_floor)}` : "", found.numerical_floor, "#8593a0", [2, 3])],
    caption: `${sentence}${floor ? " Left of the dotted line a single element of the finest size fails: there the catalogue shows the mesh." : ""} ${caption}`, source: "seismicity/catalogue.csv: Mw" });
}

// A picture without axes: draw(context, area).
function sketch(plot, draw, label) {
  const canvas = element("canvas", { role: "img", "aria-label": label });
  plot.append(canvas);
  return new Chart(canvas, { type: "scatter", data: { datasets: [{ data: [] }] }, options: { responsive: true, maintainAspectRatio: false, events: [], scales: { x: { display: false }, y: { display: false } },
    plugins: { legend: { display: false }, tooltip: { enabled: false } } }, plugins: [{ id: "sketch", afterDatasetsDraw: ({ ctx, chartArea }) => {
    ctx.save();
    draw(ctx, chartArea);
    ctx.restore();
  } }] });
}

// Place in Hudson's skewed diamond of principal moments m1 >= m2 >= m3.
function hudsonPlace(moments) {
  const greatest = Math.max(...moments.map(Math.abs)), [first, second, third] = [...moments].sort((a, b) => b - a).map((value) => value / greatest);
  return [(-2 / 3) * (first + third - 2 * second), (first + second + third) / 3];
}

// Principal moments of Hudson's T and k.
function momentsOfHudson(T, k) {
  const rest = 1 - Math.abs(k), third = T > 0 ? -rest : rest, first = (T * rest) / 2;
  return [first + k, k - first - third, third + k];
}

// Where pure mechanisms lie; the crack is one in this rock.
function hudsonMarks(rock) {
  const ratio = (2 * rock.poissons_ratio) / (1 - 2 * rock.poissons_ratio), crack = [ratio + 2, ratio, ratio];
  return [["double couple", [1, 0, -1]], ["explosion", [1, 1, 1]], ["implosion", [-1, -1, -1]], ["+ crack", crack], ["\u2212 crack", crack.map((value) => -value)], ["+ CLVD", [2, -1, -1]], ["\u2212 CLVD", [1, 1, -2]],
    ["+ dipole", [1, 0, 0]], ["\u2212 dipole", [0, 0, -1]]].map(([name, moments]) => ({ name, at: hudsonPlace(moments) }));
}

function hudson(grid, data, events) {
  const some = largeFirst(events.filter((event) => event.pattern && event.u !== null && event.v !== null));
  if (some.length === 0) return;
  const radius = radiusOf(some, 9, 2), steps = Array.from({ length: 41 }, (_, number) => -1 + number / 20), marks = hudsonMarks(data.case.rock);
  const draw = (ctx, area) => {
    const scale = Math.min(area.width / 3.5, (area.height - 8) / 2.36), middle = [(area.left + area.right) / 2, (area.top + area.bottom) / 2];
    const place = (u, v) => [middle[0] + scale * u, middle[1] - scale * v], line = (points) => polyline(ctx, place, points);
    ctx.strokeStyle = "#d5dde4";
    ctx.lineWidth = 1;
    for (const level of [-0.75, -0.5, -0.25, 0.25, 0.5, 0.75]) {
      line(steps.map((k) => hudsonPlace(momentsOfHudson(level, k))));
      line(steps.map((T) => hudsonPlace(momentsOfHudson(T, level))));
    }
    ctx.strokeStyle = "#8593a0";
    line(steps.map((k) => hudsonPlace(momentsOfHudson(1e-12, k))));
    line(steps.map((T) => hudsonPlace(momentsOfHudson(T, 0))));
    ctx.strokeStyle = "#22303c";
    ctx.lineWidth = 1.4;
    line([[0, 1], [4 / 3, 1 / 3], [0, -1], [-4 / 3, -1 / 3], [0, 1]]);
    for (const event of some) {
      ctx.fillStyle = eventColours[event.type] + "90";
      ctx.strokeStyle = eventColours[event.type];
      ctx.lineWidth = 0.7;
      ctx.beginPath();
      ctx.arc(...place(event.u, event.v), radius(event.moment), 0, 2 * Math.PI);
      ctx.fill();
      ctx.stroke();
    }
    ctx.font = "12px " + Chart.defaults.font.family;
    for (const { name, at } of marks) {
      const [x, y] = place(...at), isLeft = at[0] < -1e-9, isMiddle = Math.abs(at[0]) < 1e-9;
      ctx.strokeStyle = "#101820";
      ctx.lineWidth = 1.6;
      ctx.beginPath();
      for (const [right, up] of [[4, 4], [4, -4]]) {
        ctx.moveTo(x - right, y - up);
        ctx.lineTo(x + right, y + up);
      }
      ctx.stroke();
      ctx.textAlign = isMiddle && at[1] !== 0 ? "center" : isLeft ? "right" : "left";
      const where = isMiddle ? [at[1] === 0 ? x + 9 : x, y - 13 * Math.sign(at[1] + 0.5) + 4] : [x + (isLeft ? -9 : 9), y + (at[1] >= 0 ? -5 : 13)];
      ctx.lineWidth = 3.5;
      ctx.strokeStyle = "#ffffffd0";
      ctx.strokeText(name, ...where);
      ctx.fillStyle = "#22303c";
      ctx.fillText(name, ...where);
    }
  };
  const plot = element("div", { class: "plot" });
  plot.style.height = "420px";
  figure(grid, "hudson", "Mechanisms", [plot, eventLegend(null, some, radius)],
    `Source types after Hudson et al. (1989), in the skewed diamond: u to the right, v upwards; lines of equal T and k in quarters. The cracks are those of this rock (Poisson's ratio ${shown(data.case.rock.poissons_ratio, 3)}). ${data.seismicity.caption}`,
    "seismicity/catalogue.csv: u, v, M0_Nm, type");
  sketch(plot, draw, "Mechanisms");
}

function stimulatedVolume(grid, data, events) {
  const { volume, caption } = data.seismicity;
  if (!volume || volume.cells.length === 0) return;
  const most = volume.cells.reduce((greatest, [, , count]) => Math.max(greatest, count), 1), half = volume.voxel_size / 2, counts = ["#fdf0d5", "#fad48e", "#f2a65a", "#d9673d", "#a23b2a", "#641b24"];
  const end = events.reduce((last, event) => Math.max(last, event.time), 0), low = Math.min(volume.voxel_events, most), colour = (share) => rampColour(share, counts);
  const shareOf = (count) => (most > low ? Math.log(count / low) / Math.log(most / low) : 1);
  const xs = volume.cells.flatMap(([x]) => [x - half, x + half]), ys = volume.cells.flatMap(([, y]) => [y - half, y + half]), box = boxAround(xs, ys, data.case.domain);
  const draw = (ctx, place) => {
    for (const [x, y, count] of volume.cells) {
      const [left, top] = place(x - half, y + half), [right, bottom] = place(x + half, y - half);
      ctx.lineWidth = 0.6;
      ctx.strokeStyle = "#c9a27a";
      ctx.fillStyle = count >= volume.voxel_events ? colour(shareOf(count)) : "#fff";
      ctx.fillRect(left, top, right - left, bottom - top);
      ctx.strokeRect(left, top, right - left, bottom - top);
    }
    fracturesBeneath(ctx, place, data, Math.max(end, ...data.map.reports.map(({ time }) => time)));
    ctx.fillStyle = "#22303c90";
    for (const { x, y } of events) {
      const at = place(x, y);
      ctx.fillRect(at[0] - 1, at[1] - 1, 2, 2);
    }
    if (volume.hull.length > 2) {
      ctx.strokeStyle = "#0072b2";
      ctx.lineWidth = 2;
      ctx.setLineDash([8, 5]);
      polyline(ctx, place, [...volume.hull, volume.hull[0]]);
      ctx.setLineDash([]);
    }
  };
  const plot = element("div", { class: "plot" }), bar = element("span", { class: "bar" });
  bar.style.background = `linear-gradient(to right, ${counts.join(",")})`;
  plot.style.height = intoWindow({ box, wide: 900 }) + "px";
  figure(grid, "stimulated_volume", "Stimulated volume", [plot, element("div", { class: "scale" }, `${shown(low)} ${low === 1 ? "event" : "events"}`, bar, `${shown(most)} in a cell (logarithmic)`)],
    `Cells of ${shown(volume.voxel_size)} m with at least ${shown(volume.voxel_events)} ${volume.voxel_events === 1 ? "event" : "events"}: ${shown(volume.voxel_volume, 4)} m\u00b3. Convex hull of all events (dashed): ${shown(volume.hull_volume, 4)} m\u00b3; `
      + `it takes in what lies between arms, and is the larger the more scattered the events are. Both over the thickness of ${shown(volume.thickness, 4)} m. ${caption}`,
    "seismicity/catalogue.csv: x_m, y_m; effective_case.json: seismicity", true);
  plane(plot, box, data.in_situ, draw, "Stimulated volume");
}

// The section on the catalogue of events.
function seismicSection(data) {
  const { totals } = data.seismicity, events = seismicEvents(data.seismicity);
  const grid = section("Microseismicity", `${totals.events} ${totals.events === 1 ? "event" : "events"}${totals.greatest_magnitude === null || totals.greatest_magnitude === undefined ? "" : `, the greatest of Mw ${shown(totals.greatest_magnitude, 3)}`}. `
    + "What the model would radiate; docs/microseismicity.md says what must not be concluded from it.");
  seismicMap(grid, data, events);
  seismicSlip(grid, data, events);
  distanceTime(grid, data, events);
  magnitudeTime(grid, data, events);
  frequencyMagnitude(grid, data);
  hudson(grid, data, events);
  momentTime(grid, data);
  seismicRate(grid, data);
  magnitudeDistance(grid, data, events);
  stimulatedVolume(grid, data, events);
}
