// Keeps the elements of a panel as the frames of hmi/web/panel_stream.cpp say, and paints what changed onto the canvas.
// Knows nothing of the connection.
'use strict';

const kEdge = 3;             // pixels of the panel that an element may paint around itself
const kLookRoom = 16 << 20; // pixels of all looks

const kFresh = new State();

class Painter {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', {alpha: false});
    this.commands = new Commands(this.context);
    this.scratch = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
    this.elements = [];
    this.dirty = [];
    this.allDirty = true;
    this.scale = 1;
    this.state = new State(); // of the element that is being painted
    this.paints = 0;
    this.color = '#fff';
    this.ground = null;
    this.forgetLooks();
  }

  get pictures() { return this.commands.pictures; }

  resize(width, height, scale, color) {
    this.scale = scale;
    this.color = color;
    this.canvas.width = Math.max(1, Math.round(width * scale));
    this.canvas.height = Math.max(1, Math.round(height * scale));
    for (const element of this.elements) if (element) this.settle(element);
    this.forgetLooks();
    this.allDirty = true;
  }

  /// Looks: pictures of runs, by what they do. Elements that look the same share them.
  forgetLooks() {
    this.looks = new Map();
    this.lookPixels = 0;
    this.edition = {};
    this.dropGround();
  }

  /// The ground: a picture of what stays at the beginning of elements and has nothing beneath it that does not.
  dropGround() {
    this.ground = null;
    this.groundAt = this.paints + kCalm;
    for (const element of this.elements) if (element) element.leaveGround();
  }

  makeGround() {
    this.groundAt = Infinity;
    if (!this.scratch) return;
    const ground = new OffscreenCanvas(this.canvas.width, this.canvas.height), c = ground.getContext('2d', {alpha: false});
    c.fillStyle = this.color;
    c.fillRect(0, 0, ground.width, ground.height);
    const ink = new Ink(c, this.scale), others = [];
    for (const element of this.elements) {
      if (!element || !element.isShown) continue;
      const [first] = element.runsNow();
      if (first && first.stays && !others.some(other => overlap(other, this.inner(element)))) {
        element.after = new State();
        element.grounded = first.end;
        for (let i = 0; i < first.end; ++i) element.commands[i].run(element.after, ink);
      }
      if (element.grounded < element.commands.length) others.push(this.inner(element));
    }
    ink.end();
    this.ground = ground;
  }

  /// Takes a frame in; returns its number. What changed is painted by paint().
  take(buffer) {
    const from = new Reader(buffer), number = from.count();
    while (!from.isAtEnd) {
      switch (from.byte()) {
      case 1: this.commands.glyphs.paths[from.count()] = from.path(); break;
      case 2: this.takePicture(from.count(), from.blob()); break;
      case 3: this.takeElement(from); break;
      case 4: this.reset(); break;
      default: throw new Error('section');
      }
    }
    return number;
  }

  reset() {
    this.elements = [];
    this.commands.forget();
    this.forgetLooks();
    this.allDirty = true;
  }

  takePicture(id, bytes) {
    const one = this.pictures[id] = {image: null, isRead: false};
    const done = image => {
      one.image = image;
      one.isRead = true;
      this.forgetLooks();
      this.allDirty = true;
      if (this.onPictures) this.onPictures();
    };
    createImageBitmap(new Blob([bytes.slice()], {type: 'image/png'})).then(done, () => done(null));
  }

  /// All pictures that came are there.
  get isWhole() { return this.pictures.every(one => one.isRead); }

  /// Everything from its commands alone.
  paintAfresh() {
    this.commands.forget();
    this.forgetLooks();
    this.allDirty = true;
    this.paint();
  }

  takeElement(from) {
    const index = from.count(), flags = from.byte();
    const element = this.elements[index] || (this.elements[index] = new Element());
    if (element.bounds) this.dirty.push(element.bounds);
    if (flags & 2) {
      element.bounds = from.rect();
      this.settle(element);
      this.dirty.push(element.bounds);
    }
    const isShown = (flags & 1) !== 0, isOther = element.isShown !== isShown || (flags & 2) !== 0;
    element.isShown = isShown;
    element.begin();
    for (let left = from.count(); left > 0; --left) {
      const kept = from.count(), removed = from.count(), commands = [];
      for (let more = from.count(); more > 0; --more) commands.push(this.commands.read(from));
      element.replace(kept, removed, commands);
    }
    element.end();
    if (this.ground && (isOther || element.isUprooted)) this.dropGround();
  }

  settle(element) {
    element.area = this.area(element.bounds);
    element.runs = null;
  }

  /// The pixels that a rectangle of the panel touches: left, top, right, bottom.
  area([x, y, w, h]) {
    const k = this.scale;
    return [Math.floor(x * k) - 1, Math.floor(y * k) - 1, Math.ceil((x + w) * k) + 1, Math.ceil((y + h) * k) + 1];
  }

  /// Without the edge in which only outlines are: elements side by side do not count as one upon the other.
  inner(element) {
    const [left, top, right, bottom] = element.area, edge = Math.ceil(kEdge * this.scale) + 1;
    return [left + edge, top + edge, right - edge, bottom - edge];
  }

  /// What is to be painted again, as areas that do not overlap; null: all of it.
  areas() {
    if (this.allDirty || this.dirty.length > 512) return null;
    const out = [];
    for (const rect of this.dirty) {
      let area = this.area(rect);
      area = [Math.max(0, area[0]), Math.max(0, area[1]), Math.min(this.canvas.width, area[2]), Math.min(this.canvas.height, area[3])];
      if (area[0] >= area[2] || area[1] >= area[3]) continue;
      for (let i = 0; i < out.length;) {
        if (!overlap(area, out[i])) { ++i; continue; }
        const other = out[i];
        area = [Math.min(area[0], other[0]), Math.min(area[1], other[1]), Math.max(area[2], other[2]), Math.max(area[3], other[3])];
        out[i] = out[out.length - 1];
        out.pop();
        i = 0; // the larger one may overlap those before
      }
      out.push(area);
    }
    const covered = out.reduce((sum, [left, top, right, bottom]) => sum + (right - left) * (bottom - top), 0);
    return covered > this.canvas.width * this.canvas.height / 2 ? null : out;
  }

  /// Paints what changed; true if anything did.
  paint() {
    if (!this.allDirty && this.dirty.length === 0) return false;
    const areas = this.areas(), all = [0, 0, this.canvas.width, this.canvas.height];
    this.dirty = [];
    this.allDirty = false;
    if (++this.paints >= this.groundAt) this.makeGround();
    const c = this.context;
    for (const area of areas || [all]) {
      const [left, top, right, bottom] = area;
      c.save();
      c.setTransform(1, 0, 0, 1, 0, 0);
      if (areas) {
        c.beginPath();
        c.rect(left, top, right - left, bottom - top);
        c.clip();
      }
      c.globalAlpha = 1;
      if (this.ground) {
        c.drawImage(this.ground, left, top, right - left, bottom - top, left, top, right - left, bottom - top);
      } else {
        c.fillStyle = this.color;
        c.fillRect(left, top, right - left, bottom - top);
      }
      const ink = new Ink(c, this.scale);
      for (const element of this.elements)
        if (element && element.isShown && overlap(element.area, area)) this.paintElement(element, ink);
      ink.end();
      c.restore();
    }
    return true;
  }

  paintElement(element, ink) {
    const commands = element.commands, grounded = element.grounded;
    if (grounded === commands.length) return;
    const state = grounded ? this.state.set(element.after) : this.state.set(kFresh);
    for (const run of element.runsNow()) {
      if (run.end <= grounded) continue;
      const look = run.begin < grounded ? null : this.look(element, run, state);
      if (look) {
        const at = this.places(run, state);
        for (const one of run.sets) state[one.part] = one;
        ink.blit(look.picture, at.x + look.left, at.y + look.top, null, 1);
      } else {
        for (let i = Math.max(run.begin, grounded); i < run.end; ++i) commands[i].run(state, ink);
      }
    }
  }

  /// Where its first transform puts a run, in pixels and 64ths of one.
  places(run, state) {
    const to = (run.anchor || state.transform).value, x = Math.round(to[4] * this.scale * 64), y = Math.round(to[5] * this.scale * 64);
    return {x: x >> 6, y: y >> 6, fine: (x & 63) * 64 + (y & 63)};
  }

  /// The picture of a run; null: its commands are as quick, or it is seen too seldom.
  look(element, run, state) {
    if (!run.isDear(element.commands)) return null;
    if (run.key === null) run.describe(element.commands);
    if (run.look !== undefined && run.edition === this.edition && isSame(run, state)) {
      if (run.look) run.look.at = this.paints;
      return run.look;
    }
    const at = this.places(run, state), key = this.keyOf(element, run, state, at);
    let look = this.looks.get(key);
    if (!look) {
      if (this.looks.size >= 32768) this.forgetLooks();
      this.looks.set(key, look = {seen: 0, picture: null, left: 0, top: 0, at: 0});
    }
    look.at = this.paints;
    // What changes is pictured only when it comes again and again.
    if (!look.picture && (++look.seen < (run.stays ? 2 : 4) || !this.picture(look, element, run, state, at))) return null;
    run.look = look;
    run.edition = this.edition;
    run.had = run.needs.map(part => state[part]);
    return look;
  }

  keyOf(element, run, state, at) {
    const [left, top, right, bottom] = element.area, transform = (run.anchor || state.transform).value;
    let key = run.key;
    for (const part of run.needs) key += part + state[part].id;
    key += `;${at.fine};${left - at.x};${top - at.y};${right - left};${bottom - top}`;
    const isFixed = run.isFixed || transform[0] !== 1 || transform[3] !== 1 || (run.needs.includes('clip') && state.clip.value);
    return isFixed ? `${key};${transform};${left};${top}` : key;
  }

  /// Makes room by letting go what was not drawn lately.
  hasRoom(pixels) {
    if (this.lookPixels + pixels <= kLookRoom) return true;
    const kLately = 32;
    if (this.clearedAt !== undefined && this.paints - this.clearedAt < kLately) return false;
    this.clearedAt = this.paints;
    this.edition = {};
    for (const [key, look] of this.looks) {
      if (this.paints - look.at < kLately) continue;
      if (look.picture) this.lookPixels -= look.picture.width * look.picture.height;
      this.looks.delete(key);
    }
    return this.lookPixels + pixels <= kLookRoom;
  }

  picture(look, element, run, state, at) {
    const [left, top, right, bottom] = element.area, width = right - left, height = bottom - top;
    if (!this.scratch || !this.hasRoom(width * height)) return false;
    this.scratch.width = width;
    this.scratch.height = height;
    const c = this.scratch.getContext('2d'), ink = new Ink(c, this.scale, left, top), within = state.copy();
    for (let i = run.begin; i < run.end; ++i) element.commands[i].run(within, ink);
    ink.end();
    look.picture = this.scratch.transferToImageBitmap();
    look.left = left - at.x;
    look.top = top - at.y;
    this.lookPixels += width * height;
    return true;
  }
}

/// What the run needs of the state before it is what it had.
function isSame(run, state) {
  for (let i = 0; i < run.needs.length; ++i) if (run.had[i] !== state[run.needs[i]]) return false;
  return true;
}

function overlap(a, b) { return a[0] < b[2] && a[1] < b[3] && a[2] > b[0] && a[3] > b[1]; }
