'use strict';
// Makes a viewer of each frame's pictures: wipe, blink, difference, magnifier, masks of features.
//
// Everything is drawn from the pictures that the page holds anyway. `difference` was computed by
// the grader, black (agrees) to white (wrong), so that what is shown is what was scored. Pictures
// are decoded when their frame is opened. Text goes into the page as text only.

(() => {

const kGlassPixels = 15;   // sides of what the magnifier shows
const kGlassZoom = 10;
const kMostWorst = 5;
const kHeat = [[68, 20, 130], [135, 30, 140], [200, 60, 105], [245, 130, 50], [252, 232, 60]];

// ---- pictures -----------------------------------------------------------------------------------

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

// ---- one frame ----------------------------------------------------------------------------------

class Viewer {
  constructor(frame) {
    this.frame = frame;
    this.root = document.getElementById('viewer').content.firstElementChild.cloneNode(true);
    this.stage = this.find('.stage');
    this.slider = this.find('.wipe');
    this.place = {x: 0, y: 0};
  }

  find(selector) { return this.root.querySelector(selector); }

  async open() {
    const image = name => this.frame.querySelector('.pictures img.' + name);
    [this.yours, this.reference, this.difference] = await Promise.all(
      ['yours', 'reference', 'difference'].map(name => pixelsOf(image(name))));
    put(this.find('canvas.yours'), this.yours);
    put(this.find('canvas.reference'), this.reference);
    put(this.find('canvas.heat'), heatOf(this.yours, this.difference));
    this.find('canvas.yours').setAttribute('aria-label', image('yours').alt);
    this.drawLegend();
    this.listWorst();
    this.listen();
    this.listenToFeatures();
    this.wipeTo(50);
    this.frame.prepend(this.root);
    this.frame.classList.add('live');
    this.frame.viewer = this;
  }

  // What the stage shows: 'wipe', 'yours', 'reference' or 'difference'.
  show(what) {
    this.stage.dataset.show = what;
    this.find('button.difference').setAttribute('aria-pressed', String(what === 'difference'));
    this.find('.legend').hidden = what !== 'difference';
    this.find('.status').textContent =
      {wipe: '', yours: 'yours', reference: 'the reference', difference: 'where they differ'}[what];
  }

  wipeTo(percent) {
    const value = Math.min(100, Math.max(0, percent));
    this.slider.value = String(value);
    this.slider.setAttribute('aria-valuetext', `${Math.round(value)} percent yours`);
    this.stage.style.setProperty('--at', value + '%');
    this.show('wipe');
  }

  blink() { this.show(this.stage.dataset.show === 'reference' ? 'yours' : 'reference'); }

  toggleDifference() {
    this.show(this.stage.dataset.show === 'difference' ? 'wipe' : 'difference');
  }

  listen() {
    this.slider.addEventListener('input', () => this.wipeTo(Number(this.slider.value)));
    this.find('button.difference').addEventListener('click', () => this.toggleDifference());
    this.listenToBlink(this.find('button.blink'));
    this.listenToPointer();
    this.find('.glasses').addEventListener('keydown', event => {
      const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
      if (!step[event.key] || event.ctrlKey || event.altKey || event.metaKey)
        return;
      event.preventDefault();
      this.magnify(this.place.x + step[event.key][0], this.place.y + step[event.key][1]);
    });
  }

  // Pointing at the button shows the reference, holding it down yours; a finger holds it for the
  // reference. By keyboard each press changes the picture.
  listenToBlink(button) {
    const mouse = event => event.pointerType === 'mouse';
    button.addEventListener('pointerenter', event => mouse(event) && this.show('reference'));
    button.addEventListener('pointerdown',
                            event => this.show(mouse(event) ? 'yours' : 'reference'));
    button.addEventListener('pointerup', event => this.show(mouse(event) ? 'reference' : 'wipe'));
    button.addEventListener('pointerleave', () => this.show('wipe'));
    button.addEventListener('pointercancel', () => this.show('wipe'));
    button.addEventListener('click', event => event.detail === 0 && this.blink());
  }

  // Dragging wipes; merely pointing moves the magnifier.
  listenToPointer() {
    const placeOf = event => {
      const box = this.stage.getBoundingClientRect();
      return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    };
    this.stage.addEventListener('pointerdown', event => {
      this.stage.setPointerCapture(event.pointerId);
      this.wipeTo(100 * placeOf(event)[0]);
    });
    this.stage.addEventListener('pointermove', event => {
      const [x, y] = placeOf(event);
      if (this.stage.hasPointerCapture(event.pointerId))
        this.wipeTo(100 * x);
      else
        this.magnify(Math.floor(x * this.reference.width), Math.floor(y * this.reference.height));
    });
  }

  // ---- magnifier ----

  magnify(x, y) {
    x = Math.min(this.reference.width - 1, Math.max(0, x));
    y = Math.min(this.reference.height - 1, Math.max(0, y));
    this.place = {x, y};
    for (const [name, pixels] of [['yours', this.yours], ['reference', this.reference]]) {
      const glass = this.find('.glass.of-' + name);
      this.drawGlass(glass, pixels);
      const colour = colourAt(pixels, x, y);
      const caption = glass.nextElementSibling;
      caption.querySelector('code').textContent = hex(colour);
      caption.querySelector('.swatch').style.backgroundColor = colour ? hex(colour) : '';
    }
    this.find('.place').textContent = `Pixel (${x}, ${y}), counted from the top left`;
    this.stage.style.setProperty('--x', 100 * (x + 0.5) / this.reference.width + '%');
    this.stage.style.setProperty('--y', 100 * (y + 0.5) / this.reference.height + '%');
  }

  drawGlass(glass, pixels) {
    const size = kGlassPixels * kGlassZoom, half = (kGlassPixels - 1) / 2;
    glass.width = glass.height = size;
    const context = glass.getContext('2d');
    for (let row = 0; row < kGlassPixels; ++row)
      for (let column = 0; column < kGlassPixels; ++column) {
        const colour = colourAt(pixels, this.place.x + column - half, this.place.y + row - half);
        if (!colour)
          continue;
        context.fillStyle = hex(colour);
        context.fillRect(column * kGlassZoom, row * kGlassZoom, kGlassZoom, kGlassZoom);
      }
    for (const [colour, margin] of [['#000', 1.5], ['#fff', 0.5]]) {
      context.strokeStyle = colour;
      context.strokeRect(half * kGlassZoom - margin, half * kGlassZoom - margin,
                         kGlassZoom + 2 * margin, kGlassZoom + 2 * margin);
    }
  }

  listWorst() {
    const places = worstPlaces(this.yours, this.reference, this.difference, kMostWorst);
    this.find('.worst p').textContent =
      places.length ? 'The worst pixels' : 'No pixel is wrong.';
    for (const {x, y} of places) {
      const button = document.createElement('button');
      button.type = 'button';
      const parts = [[this.yours, 'yours'], [this.reference, 'reference']].map(([pixels, name]) => {
        const part = document.createElement('span');
        const swatch = document.createElement('i');
        swatch.className = 'swatch';
        const colour = colourAt(pixels, x, y);
        swatch.style.backgroundColor = colour ? hex(colour) : '';
        part.append(swatch, `${name} ${hex(colour)}`);
        return part;
      });
      const where = document.createElement('span');
      where.textContent = `(${x}, ${y})`;
      button.append(where, ...parts);
      for (const event of ['focus', 'click', 'pointerenter'])
        button.addEventListener(event, () => this.magnify(x, y));
      const item = document.createElement('li');
      item.append(button);
      this.find('.worst ol').append(item);
    }
    const first = places[0] ??
      {x: this.reference.width >> 1, y: this.reference.height >> 1};
    this.magnify(first.x, first.y);
  }

  drawLegend() {
    const context = this.find('.legend canvas').getContext('2d');
    for (let x = 0; x < 120; ++x) {
      context.fillStyle = hex(heatColour(x / 119));
      context.fillRect(x, 0, 1, 1);
    }
  }

  // ---- features ----

  listenToFeatures() {
    for (const feature of this.frame.querySelectorAll('.feature')) {
      const image = feature.querySelector('img.mask');
      if (!image)
        continue;
      const show = async () => {
        this.lit = feature;
        const mask = await pixelsOf(image);
        if (this.lit !== feature)  // left again while the mask was decoded
          return;
        put(this.find('canvas.where'), spotlightOf(mask));
        this.stage.classList.add('lit');
      };
      const hide = () => {
        this.lit = null;
        this.stage.classList.remove('lit');
      };
      for (const event of ['pointerenter', 'focus'])
        feature.addEventListener(event, show);
      for (const event of ['pointerleave', 'blur'])
        feature.addEventListener(event, hide);
    }
  }
}

// ---- the page -----------------------------------------------------------------------------------

/** The viewer that a key is meant for: the focused one, the one pointed at, the first one in view. */
function viewerForKeys() {
  const frames = [...document.querySelectorAll('.frame.live')];
  const visible = frames.filter(frame => {
    const box = frame.getBoundingClientRect();
    return box.height > 0 && box.bottom > 80 && box.top < innerHeight - 80;
  });
  const chosen = document.activeElement.closest('.frame.live') ??
    document.activeElement.closest('.check')?.querySelector('.frame.live') ??
    frames.find(frame => frame.matches(':hover')) ?? visible[0];
  return chosen?.viewer;
}

document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.repeat)
    return;
  const act = {b: 'blink', d: 'toggleDifference'}[event.key];
  const viewer = viewerForKeys();
  if (act && viewer)
    viewer[act]();
  else if (event.key === 'Escape' && viewer)
    viewer.show('wipe');
});

/** Resolves once the frame has its viewer, if it is one that gets any. */
function openFrame(frame) {
  if (frame.querySelector('.pictures img.reference'))
    frame.opening ??= new Viewer(frame).open();
  return frame.opening;
}

for (const check of document.querySelectorAll('details.check')) {
  const frame = check.querySelector('.frame');
  if (!frame)
    continue;
  const yours = frame.querySelector('img.yours');
  if (yours && check.classList.contains('full')) {
    const small = document.createElement('img');
    small.className = 'small';
    small.alt = '';
    small.src = yours.src;
    check.querySelector('summary').prepend(small);
  }
  if (check.open)
    openFrame(frame);
  check.addEventListener('toggle', () => check.open && openFrame(frame));
}

// ---- a page that follows (LiveReport.h) ---------------------------------------------------------
//
// What the reader has done to the page stays as it is when the page is loaded anew: what is open or
// closed, what a viewer shows, and which task stands where on the screen. It is kept in the entry
// of the browser's history, which lives as long as the tab.

const kLookMs = 400, kRestMs = 4000;

/** A name for a part that it has in the next version of the page, too. */
function nameOf(part) {
  return (part.closest('.task')?.id ?? '') + ' ' +
    (part.querySelector('summary .title')?.textContent ?? part.className);
}

function viewStateOf(viewer) {
  return {show: viewer.stage.dataset.show, wipe: viewer.slider.value, place: viewer.place};
}

function showAgain(viewer, state) {
  viewer.wipeTo(Number(state.wipe));
  viewer.show(state.show);
  viewer.magnify(state.place.x, state.place.y);
}

/** What stands at the top of the screen, and how far from it: {id, top}. */
function anchorNow() {
  const parts = [...document.querySelectorAll('.task, .assignment')].reverse();
  const part = parts.find(each => each.getBoundingClientRect().top <= innerHeight / 3);
  return part && {id: part.id, top: part.getBoundingClientRect().top};
}

class Follower {
  constructor(version) {
    this.version = version;
    this.kept = history.state ?? {toggled: {}, viewers: {}, anchor: null};
    history.scrollRestoration = 'manual';
    document.addEventListener('click', event => {
      const details = event.target.closest('summary')?.parentElement;
      if (details)
        this.kept.toggled[nameOf(details)] = !details.open;  // it is about to change
    });
    this.restore().then(() => this.lookLater());
  }

  async restore() {
    const opening = [];
    for (const details of document.querySelectorAll('details')) {
      details.open = this.kept.toggled[nameOf(details)] ?? details.open;
      const frame = details.querySelector('.frame');
      const state = this.kept.viewers[nameOf(details)];
      if (frame && details.open)
        opening.push(openFrame(frame)?.then(() => state && showAgain(frame.viewer, state)));
    }
    await Promise.all(opening);
    const {anchor} = this.kept;
    const part = anchor && document.getElementById(anchor.id);
    if (part)
      scrollBy(0, part.getBoundingClientRect().top - anchor.top);
  }

  keep() {
    for (const frame of document.querySelectorAll('.frame.live'))
      this.kept.viewers[nameOf(frame.closest('details'))] = viewStateOf(frame.viewer);
    // A page without tasks, because something does not compile, says nothing about where one was.
    if (document.querySelector('.task'))
      this.kept.anchor = anchorNow();
    history.replaceState(this.kept, '');
  }

  lookLater() { setTimeout(() => document.hidden ? this.lookWhenSeen() : this.look(), kLookMs); }

  lookWhenSeen() {
    document.addEventListener('visibilitychange', () => this.look(), {once: true});
  }

  look() {
    const image = new Image();
    image.onload = () => {
      if (`${image.naturalWidth}x${image.naturalHeight}` === this.version)
        return this.lookLater();
      this.keep();
      location.reload();
    };
    // Nobody writes this page now; somebody may again.
    image.onerror = () => setTimeout(() => this.lookLater(), kRestMs);
    image.src = 'version.svg?' + Date.now();
  }
}

if (document.body.dataset.version)
  new Follower(document.body.dataset.version);

})();
