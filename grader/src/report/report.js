'use strict';
// Makes a viewer of each frame's pictures: wipe, blink, difference, magnifier, masks of features.
//
// Everything is drawn from the pictures that the page holds anyway. `difference` was computed by
// the grader, black (agrees) to white (wrong), so that what is shown is what was scored. Pictures
// are decoded when their frame is opened. Text goes into the page as text only.

const kGlassPixels = 15;   // sides of what the magnifier shows
const kGlassZoom = 10;
const kMostWorst = 5;

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
