// Beach balls of moment tensors whose z axis is principal, as in plane strain: { xx, yy, zz, xy }, isotropic part and M_zz kept. Pure functions.

// Where a ray of the lower half of the focal sphere, seen from above, leaves: of the point (x, y) of the unit disc of the equal-area (Schmidt) projection.
function rayOf(x, y) {
  const square = x * x + y * y, stretch = Math.sqrt(Math.max(0, 2 - square));
  return [x * stretch, y * stretch, square - 1];
}

// Amplitude n.M.n of P waves along a ray; outward motion is positive.
function radiation({ xx, yy, zz, xy }, [x, y, z]) {
  return xx * x * x + 2 * xy * x * y + yy * y * y + zz * z * z;
}

// Principal moments over the greatest magnitude of them, `major` >= `minor` in the plane, `normal` out of it, and the angle of the major axis, counter-clockwise
// from x [rad]; null of a tensor that is zero.
function principalPattern({ xx, yy, zz, xy }) {
  const middle = (xx + yy) / 2, half = Math.hypot((xx - yy) / 2, xy);
  const greatest = Math.max(Math.abs(middle + half), Math.abs(middle - half), Math.abs(zz));
  if (!(greatest > 0)) return null;
  return { major: (middle + half) / greatest, minor: (middle - half) / greatest, normal: zz / greatest, angle: Math.atan2(2 * xy, xx - yy) / 2 };
}

// Share of a square cell of the disc, of width `cell` around (x, y), that is [within the disc, filled]; four by four points of it are looked at.
function cellShares(moment, x, y, cell) {
  const steps = [-0.375, -0.125, 0.125, 0.375];
  let within = 0, filled = 0;
  for (const right of steps)
    for (const up of steps) {
      const at = [x + right * cell, y + up * cell];
      if (at[0] * at[0] + at[1] * at[1] > 1) continue;
      within += 1 / 16;
      if (radiation(moment, rayOf(...at)) > 0) filled += 1 / 16;
    }
  return [within, filled];
}

// Share of the disc that is filled, and with it of the sphere: the projection keeps areas.
function filledShare(moment, cells) {
  const sum = [0, 0], cell = 2 / cells;
  for (let row = 0; row < cells; ++row)
    for (let column = 0; column < cells; ++column)
      cellShares(moment, (column + 0.5) * cell - 1, (row + 0.5) * cell - 1, cell).forEach((share, number) => { sum[number] += share; });
  return sum[1] / sum[0];
}

// Red, green, blue and opacity of the `size` x `size` pixels of a ball, north on top: filled part in `colour` [red, green, blue], the rest white.
function ballPixels(moment, size, colour) {
  const pixels = new Uint8ClampedArray(4 * size * size), cell = 2 / size;
  for (let row = 0; row < size; ++row)
    for (let column = 0; column < size; ++column) {
      const [within, filled] = cellShares(moment, (column + 0.5) * cell - 1, 1 - (row + 0.5) * cell, cell);
      if (within === 0) continue;
      const share = filled / within;
      pixels.set([...colour.map((part) => 255 + share * (part - 255)), 255 * within], 4 * (row * size + column));
    }
  return pixels;
}
