'use strict';
// What a report computes of its pictures. The three scripts of a report share one scope: this one,
// report.js, follow.js, in this order.

const kHeat = [[68, 20, 130], [135, 30, 140], [200, 60, 105], [245, 130, 50], [252, 232, 60]];

/** The pixels of an <img>: {width, height, data}. */
async function pixelsOf(image) {
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  const context = canvas.getContext('2d', {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

function put(canvas, pixels) {
  canvas.width = pixels.width;
  canvas.height = pixels.height;
  canvas.getContext('2d').putImageData(pixels, 0, 0);
}

/** [r, g, b] at a place, or null outside. */
function colourAt(pixels, x, y) {
  if (x < 0 || y < 0 || x >= pixels.width || y >= pixels.height)
    return null;
  const at = 4 * (y * pixels.width + x);
  return [pixels.data[at], pixels.data[at + 1], pixels.data[at + 2]];
}

function hex(colour) {
  return colour ? '#' + colour.map(each => each.toString(16).padStart(2, '0')).join('') : 'outside';
}

/** The colour of an error from 0 to 1. */
function heatColour(error) {
  const at = error * (kHeat.length - 1);
  const low = Math.min(Math.floor(at), kHeat.length - 2);
  return kHeat[low].map((each, i) => Math.round(each + (at - low) * (kHeat[low + 1][i] - each)));
}

/** Errors in colour over the picture, which is dark and grey where it agrees. */
function heatOf(yours, difference) {
  const heat = new ImageData(difference.width, difference.height);
  for (let y = 0; y < heat.height; ++y)
    for (let x = 0; x < heat.width; ++x) {
      const at = 4 * (y * heat.width + x);
      const error = difference.data[at] / 255;
      const [red, green, blue] = colourAt(yours, x, y) ?? [0, 0, 0];
      const grey = 14 + (0.3 * red + 0.59 * green + 0.11 * blue) * 0.22;
      heat.data.set(error > 0 ? heatColour(error) : [grey, grey, grey], at);
      heat.data[at + 3] = 255;
    }
  return heat;
}

/** Dark where the mask is not, with a bright edge around where it is. */
function spotlightOf(mask) {
  const light = new ImageData(mask.width, mask.height);
  const inside = (x, y) => (colourAt(mask, x, y) ?? [0])[0] > 127;
  for (let y = 0; y < mask.height; ++y)
    for (let x = 0; x < mask.width; ++x) {
      const at = 4 * (y * mask.width + x);
      if (inside(x, y))
        continue;
      const edge = inside(x - 1, y) || inside(x + 1, y) || inside(x, y - 1) || inside(x, y + 1);
      light.data.set(edge ? [255, 214, 10, 255] : [8, 10, 16, 185], at);
    }
  return light;
}

/** Up to `most` places with the largest errors, each in a part of the picture of its own. */
function worstPlaces(yours, reference, difference, most) {
  const places = [];
  const apart = Math.max(8, difference.width / 12);
  const badness = (x, y) => {
    const error = difference.data[4 * (y * difference.width + x)];
    const a = colourAt(yours, x, y), b = colourAt(reference, x, y);
    const distance = a && b ? Math.max(...a.map((each, i) => Math.abs(each - b[i]))) : 255;
    return error > 0 ? error * 256 + distance : 0;
  };
  const all = [];
  for (let y = 0; y < difference.height; ++y)
    for (let x = 0; x < difference.width; ++x) {
      const bad = badness(x, y);
      if (bad > 0)
        all.push({x, y, bad});
    }
  all.sort((a, b) => b.bad - a.bad);
  for (const each of all) {
    if (places.every(other => Math.hypot(other.x - each.x, other.y - each.y) >= apart))
      places.push(each);
    if (places.length === most)
      break;
  }
  return places;
}
