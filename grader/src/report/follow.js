'use strict';
// A page that follows (LiveReport.h).
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
