// Events of a catalogue as things to draw: colour by type, size by moment, balls.

// Told apart with any colour vision (Okabe and Ito 2008).
const eventColours = { shear: "#0072b2", tensile: "#d55e00", closing: "#009e73", mixed: "#cc79a7" };
const eventTypes = Object.keys(eventColours);

// The events in the order of the catalogue, with what drawing needs.
function seismicEvents(seismicity) {
  const at = seismicity.columns;
  return at.id.map((id, row) => ({ id, row, time: at.tc[row], x: at.x[row], y: at.y[row], moment: at.M0[row], magnitude: at.Mw[row], type: at.type[row],
    distance: seismicity.distance ? seismicity.distance.distance[row] : null, u: at.u[row], v: at.v[row], normal: [at.nx[row], at.ny[row]], fracture: at.fracture[row],
    pattern: principalPattern({ xx: at.Mxx[row], yy: at.Myy[row], zz: at.Mzz[row], xy: at.Mxy[row] }) }));
}

// Radius [pixel] of an event, proportional to 10^(Mw/2), which is the cube root of the moment; the greatest has `largest`, none less than `smallest`.
function radiusOf(events, largest, smallest) {
  const greatest = events.reduce((most, event) => Math.max(most, event.moment), 0);
  return (moment) => (greatest > 0 ? Math.max(smallest, largest * Math.cbrt(moment / greatest)) : smallest);
}

// Magnitudes for a legend: whole ones, or halves where the events span little.
function legendMagnitudes(events) {
  const values = events.map((event) => event.magnitude).filter((value) => value !== null);
  if (values.length === 0) return [];
  const most = values.reduce((a, b) => Math.max(a, b)), least = values.reduce((a, b) => Math.min(a, b));
  const step = most - least < 1.5 ? 0.5 : 1, top = Math.floor(most / step + 1e-9) * step;
  return [top, top - step, top - 2 * step];
}

const momentOfMagnitude = (magnitude) => 10 ** (1.5 * magnitude + 9.1);

// Pictures of balls, made once for each pattern (to a fiftieth), type and size class, in the frame of the major axis.
const ballCache = new Map();

function ballPicture(pattern, type, radius) {
  const size = 2 * (radius < 5 ? 8 : radius < 12 ? 20 : 40) * Math.ceil(window.devicePixelRatio || 1);
  const [xx, yy, zz] = [pattern.major, pattern.minor, pattern.normal].map((value) => Math.round(50 * value) / 50), key = [xx, yy, zz, type, size].join();
  if (!ballCache.has(key)) {
    const picture = element("canvas", { width: size, height: size }), ctx = picture.getContext("2d");
    const colour = [1, 3, 5].map((digit) => parseInt(eventColours[type].slice(digit, digit + 2), 16));
    ctx.putImageData(new ImageData(ballPixels({ xx, yy, zz, xy: 0 }, size, colour), size, size), 0, 0);
    ballCache.set(key, picture);
  }
  return ballCache.get(key);
}

// The plane that failed as a stroke, and arrows away from it where it opened, towards it where it closed.
function drawPlane(ctx, event, radius, withArrows) {
  const [across, up] = [event.normal[0], -event.normal[1]];
  if (across === 0 && up === 0) return;
  const drawLine = (from, to) => {
    ctx.moveTo(...from);
    ctx.lineTo(...to);
  };
  ctx.beginPath();
  drawLine([-1.35 * radius * up, 1.35 * radius * across], [1.35 * radius * up, -1.35 * radius * across]);
  if (withArrows) {
    const [tail, tip] = event.type === "tensile" ? [radius + 1, 1.7 * radius + 4] : [1.7 * radius + 4, radius + 2], head = 0.22 * radius + 2, back = tip > tail ? -head : head;
    for (const side of [1, -1]) {
      const at = (along, beside) => [side * along * across - beside * up, side * along * up + beside * across];
      drawLine(at(tail, 0), at(tip, 0));
      drawLine(at(tip, 0), at(tip + back, 0.7 * head));
      drawLine(at(tip, 0), at(tip + back, -0.7 * head));
    }
  }
  ctx.stroke();
}

// One ball with its plane around (x, y) [pixel].
function drawBall(ctx, event, [x, y], radius, withArrows) {
  ctx.save();
  ctx.translate(x, y);
  if (event.pattern) {
    ctx.save();
    ctx.rotate(-event.pattern.angle);
    ctx.drawImage(ballPicture(event.pattern, event.type, radius), -radius, -radius, 2 * radius, 2 * radius);
    ctx.restore();
  }
  ctx.strokeStyle = event.type === "tensile" ? "#5c2800" : event.type === "closing" ? eventColours.closing : "#101820";
  ctx.lineWidth = radius < 5 ? 0.7 : 1;
  ctx.beginPath();
  ctx.arc(0, 0, radius, 0, 2 * Math.PI);
  ctx.stroke();
  ctx.strokeStyle = "#101820";
  ctx.lineWidth = radius < 5 ? 0.8 : 1.4;
  if (radius >= 3) drawPlane(ctx, event, radius, withArrows);
  ctx.restore();
}

// Keeps discs apart: claim(x, y, reach) says whether its disc touches none that has been claimed, and claims it if so.
function claims(cell) {
  const taken = new Map();
  let greatest = 0;
  return (x, y, reach) => {
    greatest = Math.max(greatest, reach);
    const column = Math.floor(x / cell), row = Math.floor(y / cell), cells = Math.ceil((reach + greatest) / cell);
    for (let right = -cells; right <= cells; ++right)
      for (let down = -cells; down <= cells; ++down)
        for (const other of taken.get(`${column + right},${row + down}`) || []) if (Math.hypot(other[0] - x, other[1] - y) < reach + other[2]) return false;
    const key = `${column},${row}`;
    taken.set(key, [...(taken.get(key) || []), [x, y, reach]]);
    return true;
  };
}

// All events for which `isShown`, as far as they lie in the area: balls, the larger ones first to take their place among those of their type, and dots for
// what has no room; shear above the rest. Arrows only where there is room for them.
function drawBalls(ctx, place, sorted, radius, isShown, area) {
  const hasRoom = Object.fromEntries(eventTypes.map((type) => [type, claims(24)])), hasRoomForArrows = claims(24), balls = [];
  for (const event of sorted) {
    if (!isShown(event)) continue;
    const at = place(event.x, event.y), size = radius(event.moment), reach = 2 * size + 4;
    if (at[0] < area.left - reach || at[0] > area.right + reach || at[1] < area.top - reach || at[1] > area.bottom + reach) continue;
    if (hasRoom[event.type](...at, 0.85 * size)) balls.push([event, at, size]);
    else drawDot(ctx, event, at, Math.min(size, 3.2));
  }
  const isShear = ([event]) => event.type === "shear";
  for (const [event, at, size] of [...balls.filter((ball) => !isShear(ball)), ...balls.filter(isShear)]) {
    const opens = size >= 5 && (event.type === "tensile" || event.type === "closing");
    drawBall(ctx, event, at, size, opens && hasRoomForArrows(...at, 0.95 * size + 4));
  }
}

function drawDot(ctx, event, [x, y], radius) {
  ctx.fillStyle = eventColours[event.type];
  ctx.strokeStyle = "#ffffff";
  ctx.lineWidth = 0.6;
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
  ctx.fill();
  ctx.stroke();
}

function largeFirst(events) {
  return [...events].sort((a, b) => b.moment - a.moment || a.row - b.row);
}

// Beneath events: natural fractures thin, the hydraulic fracture as it was at a time thick.
function fracturesBeneath(ctx, place, data, time) {
  const { nodes, segments, kinds, reports } = data.map, before = reports.filter((report) => report.time <= time * (1 + 1e-9)).length - 1;
  ctx.strokeStyle = "#8f9ba6";
  ctx.lineWidth = 1.2;
  for (const line of data.case.fractures || []) if (line.kind === "natural") polyline(ctx, place, line.points);
  ctx.lineCap = "round";
  ctx.strokeStyle = "#101820";
  ctx.lineWidth = 3;
  segments.forEach(([first, second, since], number) => {
    if (kinds[number] === 0 && since <= before) polyline(ctx, place, [[nodes.x[first], nodes.y[first]], [nodes.x[second], nodes.y[second]]]);
  });
  perforations(ctx, place, data.case);
}

// What the marks mean: types with their numbers, sizes, and on a map (data not null) lines.
function eventLegend(data, events, radius) {
  const disc = (size, fill, line) => {
    const made = element("span", { class: "disc" });
    Object.assign(made.style, { width: 2 * size + "px", height: 2 * size + "px", background: fill, borderColor: line });
    return made;
  };
  const item = (...content) => element("span", { class: "item" }, ...content), line = (colour, width) => {
    const made = element("span", { class: "stroke" });
    made.style.borderTop = `${width}px solid ${colour}`;
    return made;
  };
  const types = eventTypes.map((type) => [type, events.filter((event) => event.type === type).length]).filter(([, count]) => count > 0);
  const lines = data === null ? [] : [item(line("#101820", 3), "hydraulic fracture"),
    ...((data.case.fractures || []).some((other) => other.kind === "natural") ? [item(line("#8f9ba6", 1.5), "natural fracture")] : [])];
  return element("div", { class: "legend" }, ...types.map(([type, count]) => item(disc(6, eventColours[type], eventColours[type]), `${type} (${count})`)),
    ...legendMagnitudes(events).map((magnitude) => item(disc(radius(momentOfMagnitude(magnitude)), "#fff", "#4b5965"), `Mw ${shown(magnitude, 3)}`)), ...lines);
}
