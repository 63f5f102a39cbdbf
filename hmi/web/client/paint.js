// Draws the commands that hmi/web/paint_recorder.cpp wrote: reads a frame, keeps each element's commands, and paints what
// changed onto the canvas. Knows nothing of the connection.
'use strict';

class Reader {
  constructor(buffer) {
    this.view = new DataView(buffer);
    this.at = 0;
  }
  get isAtEnd() { return this.at >= this.view.byteLength; }
  byte() { return this.view.getUint8(this.at++); }
  count() {
    let value = 0, factor = 1;
    for (;;) {
      const part = this.byte();
      value += (part & 127) * factor;
      if (part < 128) return value;
      factor *= 128;
    }
  }
  length() {
    const raw = this.count();
    return (raw % 2 ? -(raw + 1) / 2 : raw / 2) / 64;
  }
  real() {
    const value = this.view.getFloat32(this.at, true);
    this.at += 4;
    return value;
  }
  color() {
    const red = this.byte(), green = this.byte(), blue = this.byte(), alpha = this.byte();
    return alpha === 255 ? `rgb(${red},${green},${blue})` : `rgba(${red},${green},${blue},${alpha / 255})`;
  }
  rect() { return [this.length(), this.length(), this.length(), this.length()]; }
  blob() {
    const size = this.count();
    const bytes = new Uint8Array(this.view.buffer, this.view.byteOffset + this.at, size);
    this.at += size;
    return bytes;
  }
  path() {
    const out = {shape: new Path2D(), rule: this.byte() === 0 ? 'evenodd' : 'nonzero', box: [0, 0, 0, 0]}, box = out.box;
    let x = 0, y = 0, firstX = 0, firstY = 0, isFirst = true;
    const reach = (atX, atY) => {
      if (isFirst || atX < box[0]) box[0] = atX;
      if (isFirst || atY < box[1]) box[1] = atY;
      if (isFirst || atX > box[2]) box[2] = atX;
      if (isFirst || atY > box[3]) box[3] = atY;
      isFirst = false;
    };
    for (;;) {
      if (!isFirst) reach(x, y);
      switch (this.byte()) {
      case 0: return out;
      case 1: out.shape.moveTo(firstX = x += this.length(), firstY = y += this.length()); reach(x, y); break;
      case 2: out.shape.lineTo(x += this.length(), y += this.length()); break;
      case 3: {
        const ax = x + this.length(), ay = y + this.length(), bx = ax + this.length(), by = ay + this.length();
        x = bx + this.length();
        y = by + this.length();
        out.shape.bezierCurveTo(ax, ay, bx, by, x, y);
        reach(ax, ay);
        reach(bx, by);
        break;
      }
      case 4: out.shape.closePath(); x = firstX; y = firstY; break;
      default: throw new Error('path');
      }
    }
  }
}

const kStill = [1, 0, 0, 1, 0, 0], kPixels = [1, 0, 0, 1, 0, 0]; // the second one: not scaled

/// What a command is drawn with. Transforms, pens and brushes are never changed once they are made.
class State {
  constructor() {
    this.transform = kStill;
    this.pen = null;
    this.brush = null;
    this.opacity = 1;
    this.crisp = 0;
    this.clip = null;
  }
  copy() { return Object.assign(new State(), this); }
  isLike(other) {
    return this.pen === other.pen && this.brush === other.brush && this.opacity === other.opacity && this.crisp === other.crisp &&
        this.clip === other.clip && this.transform.every((part, i) => part === other.transform[i]);
  }
}

/// A context that is given only what it does not have yet: of 1,000 elements most are drawn alike.
class Ink {
  constructor(context, scale, left = 0, top = 0) {
    this.context = context;
    this.scale = scale;
    this.left = left;
    this.top = top;
    this.forget();
  }

  forget() {
    this.transform = this.opacity = this.fillPaint = this.strokePaint = this.pen = this.shrink = null;
    this.isDashed = true;
  }

  place(a, b, d, e, x, y) {
    const k = this.scale;
    this.context.setTransform(a * k, b * k, d * k, e * k, x * k - this.left, y * k - this.top);
  }

  enter(s) {
    if (this.transform !== s.transform) this.place(...(this.transform = s.transform));
    this.fade(s.opacity);
  }

  fade(opacity) {
    if (this.opacity !== opacity) this.context.globalAlpha = this.opacity = opacity;
  }

  fillWith(paint) {
    if (this.fillPaint !== paint) this.context.fillStyle = this.fillPaint = paint;
  }

  strokeWith(s) {
    const pen = s.pen, c = this.context;
    this.enter(s);
    // Without smoothing, Qt's lines fill whole pixels.
    if (s.crisp) {
      c.translate(0.5, 0.5);
      this.transform = null;
    }
    const shrink = pen.isCosmetic ? 1 / Math.max(1e-6, Math.hypot(s.transform[0], s.transform[1])) : 1;
    if (this.strokePaint !== pen.paint) c.strokeStyle = this.strokePaint = pen.paint;
    if (this.pen === pen && this.shrink === shrink) return;
    this.pen = pen;
    this.shrink = shrink;
    c.lineWidth = pen.width * shrink;
    c.lineCap = pen.cap;
    c.lineJoin = pen.join;
    c.miterLimit = pen.miter;
    if (!pen.dashes.length && !this.isDashed) return;
    this.isDashed = pen.dashes.length > 0;
    c.setLineDash(pen.dashes.map(dash => dash * shrink));
    c.lineDashOffset = pen.offset * shrink;
  }

  /// The clip in place of the one before.
  clip(path) {
    const c = this.context;
    c.restore();
    c.save();
    this.forget();
    if (!path) return;
    this.place(...kStill);
    c.clip(path.shape, path.rule);
  }

  /// Pixel for pixel.
  straight() {
    if (this.transform === kPixels) return;
    this.transform = kPixels;
    this.context.setTransform(1, 0, 0, 1, 0, 0);
  }

  blit(face) {
    this.fade(1);
    this.straight();
    this.context.drawImage(face.picture, face.left - this.left, face.top - this.top);
  }
}

/// One element: its commands, and pictures of those at its beginning and its end that do not change.
class Element {
  constructor() {
    this.bounds = null;
    this.isShown = false;
    this.commands = [];
    this.updates = 0;
    this.repaints = 0; // since the last update
    this.isClipped = false;
    this.head = this.tail = 0; // commands that stay the same
    this.forgetFaces();
  }

  forgetFaces() { this.headFace = this.tailFace = undefined; }

  /// `first` commands before and `last` ones behind the new ones stay.
  update(first, removed, commands) {
    const last = this.commands.length - first - removed, had = this.commands.length;
    this.commands.splice(first, removed, ...commands);
    this.repaints = 0;
    this.isClipped = this.commands.some(command => command.isClip);
    if (had === 0) return;
    const kEvery = 16; // updates after which what has been still is pictured again
    if (this.updates % kEvery === 0) {
      if (this.updates > 0) this.keep(this.calmHead, this.calmTail);
      this.calmHead = first;
      this.calmTail = last;
      if (this.updates === 0) this.keep(first, last);
    }
    this.calmHead = Math.min(this.calmHead, first);
    this.calmTail = Math.min(this.calmTail, last);
    ++this.updates;
    this.keep(Math.min(this.head, first), Math.min(this.tail, last));
  }

  keep(head, tail) {
    if (head !== this.head) this.headFace = undefined;
    if (tail !== this.tail) this.tailFace = undefined;
    this.head = head;
    this.tail = tail;
  }

  /// Repainted since something else changed: all of it stays the same.
  stay() {
    const kOften = 4;
    if (++this.repaints === kOften) this.keep(this.commands.length, 0);
  }
}

const kFaceRoom = 16 << 20; // pixels of all pictures of elements

class Painter {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', {alpha: false});
    const scratch = () => typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
    this.scratch = scratch();
    this.wordScratch = scratch(); // words are pictured while an element is
    this.facePixels = 0;
    this.glyphs = [];
    this.words = new Map(); // by glyphs and their places
    this.wordPictures = 0;
    this.pens = new Map(); // by their bytes, as are brushes: the same one is the same object
    this.brushes = new Map();
    this.pictures = [];
    this.elements = [];
    this.dirty = [];
    this.allDirty = true;
    this.scale = 1;
    this.ground = '#fff';
  }

  resize(width, height, scale, ground) {
    this.scale = scale;
    this.ground = ground;
    this.canvas.width = Math.max(1, Math.round(width * scale));
    this.canvas.height = Math.max(1, Math.round(height * scale));
    this.forgetFaces();
    this.allDirty = true;
  }

  forgetFaces() {
    this.facePixels = 0;
    for (const element of this.elements) if (element) element.forgetFaces();
  }

  /// Takes a frame in; returns its number. What changed is painted by paint().
  take(buffer) {
    const from = new Reader(buffer), number = from.count();
    while (!from.isAtEnd) {
      switch (from.byte()) {
      case 1: this.glyphs[from.count()] = from.path(); break;
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
    this.facePixels = 0;
    this.forgetWords(); // glyphs may have other numbers now
    this.allDirty = true;
  }

  takePicture(id, bytes) {
    const image = this.pictures[id] = new Image();
    image.onload = () => {
      this.forgetFaces();
      this.allDirty = true;
      if (this.onPictures) this.onPictures();
    };
    image.src = URL.createObjectURL(new Blob([bytes.slice()], {type: 'image/png'}));
  }

  takeElement(from) {
    const index = from.count(), flags = from.byte();
    const element = this.elements[index] || (this.elements[index] = new Element());
    if (element.bounds) this.dirty.push(element.bounds);
    if (flags & 2) {
      element.bounds = from.rect();
      element.forgetFaces();
      this.dirty.push(element.bounds);
    }
    element.isShown = (flags & 1) !== 0;
    const first = from.count(), removed = from.count(), commands = [];
    for (let left = from.count(); left > 0; --left) commands.push(this.command(from));
    element.update(first, removed, commands);
  }

  /// One command: what it does with the state, or draws in it. `cost`: roughly how slow it is.
  command(from) {
    const set = run => ({run, cost: 0, isClip: false}), draw = (run, cost = 2) => ({run, cost, isClip: false});
    switch (from.byte()) {
    case 1: { const at = [1, 0, 0, 1, from.length(), from.length()]; return set(s => { s.transform = at; }); }
    case 2: { const m = [0, 0, 0, 0, 0, 0].map(() => from.real()); return set(s => { s.transform = m; }); }
    case 3: { const pen = this.known(this.pens, from, () => this.pen(from)); return set(s => { s.pen = pen; }); }
    case 4: { const brush = this.known(this.brushes, from, () => this.brush(from)); return set(s => { s.brush = brush; }); }
    case 5: { const opacity = from.byte() / 255; return set(s => { s.opacity = opacity; }); }
    case 6: { const path = from.byte() ? from.path() : null; return {run: s => { s.clip = path; }, cost: 0, isClip: true}; }
    case 7: { const crisp = from.byte() ? 0.5 : 0; return set(s => { s.crisp = crisp; }); }
    case 8: return draw(this.rectangle(from.rect()), 1);
    case 9: {
      const [x, y, w, h] = from.rect(), shape = new Path2D();
      shape.ellipse(x + w / 2, y + h / 2, Math.abs(w / 2), Math.abs(h / 2), 0, 0, 2 * Math.PI);
      shape.closePath();
      return draw(this.drawn(shape));
    }
    case 10: { const {shape, rule} = from.path(); return draw(this.drawn(shape, rule)); }
    case 11: { const rule = from.byte() ? 'nonzero' : 'evenodd'; return draw(this.drawn(this.points(from, true), rule)); }
    case 12: { const shape = this.points(from, false); return draw((s, ink) => this.stroke(s, ink, shape)); }
    case 13: {
      const x = from.length(), y = from.length(), shape = new Path2D();
      shape.moveTo(x, y);
      shape.lineTo(x + from.length(), y + from.length());
      return draw((s, ink) => this.stroke(s, ink, shape));
    }
    case 14: { const id = from.count(), to = from.rect(), part = from.rect(); return draw((s, ink) => this.picture(s, ink, id, to, part)); }
    case 15: return draw(this.text(from));
    default: throw new Error('command');
    }
  }

  /// What was read before is not made a second time.
  known(all, from, read) {
    const begin = from.at, made = read();
    const key = String.fromCharCode(...new Uint8Array(from.view.buffer, from.view.byteOffset + begin, from.at - begin));
    if (all.has(key)) return all.get(key);
    if (all.size >= 4096) all.clear();
    all.set(key, made);
    return made;
  }

  points(from, isClosed) {
    const shape = new Path2D();
    let x = 0, y = 0;
    for (let i = 0, n = from.count(); i < n; ++i) {
      x += from.length();
      y += from.length();
      if (i === 0) shape.moveTo(x, y); else shape.lineTo(x, y);
    }
    if (isClosed) shape.closePath();
    return shape;
  }

  pen(from) {
    const paint = this.brush(from);
    if (!paint) return null;
    const flags = from.byte(), width = from.length(), join = ['miter', 'bevel', 'round'][(flags >> 2) & 3];
    const miter = join === 'miter' ? from.length() * 2 : 10, dashes = [];
    for (let left = from.count(); left > 0; --left) dashes.push(from.length());
    const offset = dashes.length ? from.length() : 0;
    return {paint, width, join, miter, dashes, offset, cap: ['butt', 'square', 'round'][flags & 3], isCosmetic: (flags & 16) !== 0};
  }

  brush(from) {
    const stops = gradient => {
      for (let left = from.count(); left > 0; --left) gradient.addColorStop(Math.min(1, Math.max(0, from.real())), from.color());
      return gradient;
    };
    switch (from.byte()) {
    case 0: return null;
    case 1: return from.color();
    case 2: return stops(this.context.createLinearGradient(from.length(), from.length(), from.length(), from.length()));
    case 3: {
      const x = from.length(), y = from.length(), radius = from.length(), focalX = from.length(), focalY = from.length();
      return stops(this.context.createRadialGradient(focalX, focalY, 0, x, y, Math.max(0, radius)));
    }
    case 4: {
      // Qt counts against the clock from three o'clock; the canvas with it.
      const x = from.length(), y = from.length(), angle = from.real(), turned = [];
      for (let left = from.count(); left > 0; --left) turned.unshift([1 - from.real(), from.color()]);
      const gradient = this.context.createConicGradient(-angle * Math.PI / 180, x, y);
      for (const [at, color] of turned) gradient.addColorStop(Math.min(1, Math.max(0, at)), color);
      return gradient;
    }
    default: throw new Error('brush');
    }
  }

  /// Words that were drawn before keep their outline: figures change often, and most of them come again.
  text(from) {
    const runs = [];
    let x = 0, y = 0, firstX = 0, firstY = 0, key = '';
    for (let left = from.count(); left > 0; --left) {
      const glyph = from.count();
      x += from.length();
      y += from.length();
      if (runs.length === 0) { firstX = x; firstY = y; }
      runs.push([glyph, x - firstX, y - firstY]);
      key += `${glyph},${x - firstX},${y - firstY};`;
    }
    return (s, ink) => {
      if (!s.pen) return;
      const word = this.word(key, runs), [a, b, d, e, toX, toY] = s.transform;
      const x = toX + a * firstX + d * firstY, y = toY + b * firstX + e * firstY;
      if (!b && !d && a === e && typeof s.pen.paint === 'string' && this.blitWord(word, s, ink, a, x, y)) return;
      ink.place(a, b, d, e, x, y);
      ink.transform = null;
      ink.fade(s.opacity);
      ink.fillWith(s.pen.paint);
      ink.context.fill(word.shape, 'nonzero');
    };
  }

  word(key, runs) {
    const known = this.words.get(key);
    if (known) return known;
    const word = {shape: new Path2D(), box: [0, 0, 0, 0], pictures: new Map()};
    for (const [id, x, y] of runs) {
      const glyph = this.glyphs[id];
      if (!glyph) continue;
      word.shape.addPath(glyph.shape, {e: x, f: y});
      const [left, top, right, bottom] = glyph.box, box = word.box;
      word.box = [Math.min(box[0], x + left), Math.min(box[1], y + top), Math.max(box[2], x + right), Math.max(box[3], y + bottom)];
    }
    if (this.words.size >= 8192) this.words.clear();
    this.words.set(key, word);
    return word;
  }

  /// Upright words in one colour that come a second time become pictures: outlines are filled slowly. Their places are
  /// held to a 64th of a pixel, as they come. False: not this one, or not yet.
  blitWord(word, s, ink, size, x, y) {
    const k = this.scale, fineX = Math.round(x * k * 64), fineY = Math.round(y * k * 64), paint = s.pen.paint;
    const key = paint + ' ' + size * k * 64 + ' ' + ((fineX & 63) * 64 + (fineY & 63));
    let picture = word.pictures.get(key);
    if (picture === undefined) return !word.pictures.set(key, 'seen');
    if (picture === 'seen') word.pictures.set(key, picture = this.pictureOf(word, paint, size * k, (fineX & 63) / 64, (fineY & 63) / 64));
    if (!picture) return false;
    ink.fade(s.opacity);
    ink.straight();
    ink.context.drawImage(picture.image, (fineX >> 6) + picture.left - ink.left, (fineY >> 6) + picture.top - ink.top);
    return true;
  }

  pictureOf(word, paint, size, x, y) {
    const box = word.box, left = Math.floor(box[0] * size + x) - 1, top = Math.floor(box[1] * size + y) - 1;
    const width = Math.ceil(box[2] * size + x) + 1 - left, height = Math.ceil(box[3] * size + y) + 1 - top;
    if (!this.wordScratch || width * height > 65536) return null;
    if (++this.wordPictures > 8192) this.forgetWords();
    this.wordScratch.width = width;
    this.wordScratch.height = height;
    const c = this.wordScratch.getContext('2d');
    c.setTransform(size, 0, 0, size, x - left, y - top);
    c.fillStyle = paint;
    c.fill(word.shape, 'nonzero');
    return {image: this.wordScratch.transferToImageBitmap(), left, top};
  }

  forgetWords() {
    this.words.clear();
    this.wordPictures = 0;
  }

  /// Most of what is drawn are rectangles, which are much quicker without a path.
  rectangle([x, y, w, h]) {
    return (s, ink) => {
      if (s.brush) {
        ink.enter(s);
        ink.fillWith(s.brush);
        ink.context.fillRect(x, y, w, h);
      }
      if (!s.pen) return;
      ink.strokeWith(s);
      ink.context.strokeRect(x, y, w, h);
    };
  }

  drawn(shape, rule = 'evenodd') {
    return (s, ink) => {
      if (s.brush) {
        ink.enter(s);
        ink.fillWith(s.brush);
        ink.context.fill(shape, rule);
      }
      this.stroke(s, ink, shape);
    };
  }

  stroke(s, ink, shape) {
    if (!s.pen) return;
    ink.strokeWith(s);
    ink.context.stroke(shape);
  }

  picture(s, ink, id, [x, y, w, h], [fromX, fromY, fromW, fromH]) {
    const image = this.pictures[id];
    if (!image || !image.complete || !image.naturalWidth || !fromW || !fromH) return;
    ink.enter(s);
    ink.context.imageSmoothingQuality = 'high';
    ink.context.drawImage(image, fromX, fromY, fromW, fromH, x, y, w, h);
  }

  /// The pixels that a rectangle of the panel touches: left, top, right, bottom.
  area([x, y, w, h]) {
    const k = this.scale;
    return [Math.floor(x * k) - 1, Math.floor(y * k) - 1, Math.ceil((x + w) * k) + 1, Math.ceil((y + h) * k) + 1];
  }

  /// What is to be painted again, as areas that do not overlap; null: all of it.
  areas() {
    if (this.allDirty || this.dirty.length > 512) return null;
    const out = [];
    for (const rect of this.dirty) {
      let area = this.area(rect);
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
    for (const element of this.elements) if (element) element.area = this.area(element.bounds);
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
      c.fillStyle = this.ground;
      c.fillRect(left, top, right - left, bottom - top);
      const ink = new Ink(c, this.scale);
      for (const element of this.elements)
        if (element && element.isShown && overlap(element.area, area)) this.paintElement(element, ink);
      c.restore();
    }
    return true;
  }

  paintElement(element, ink) {
    element.stay();
    const c = ink.context, commands = element.commands, tailAt = commands.length - element.tail;
    const head = this.face(element, 'headFace', 0, element.head, null);
    const state = head ? head.after.copy() : new State();
    if (head) ink.blit(head);
    if (element.isClipped) {
      c.save(); // only a clip must be taken back
      if (state.clip) ink.clip(state.clip);
    }
    this.run(commands, head ? element.head : 0, tailAt, state, ink);
    const tail = state.clip ? null : this.face(element, 'tailFace', tailAt, commands.length, state);
    if (tail) ink.blit(tail); else this.run(commands, tailAt, commands.length, state, ink);
    if (!element.isClipped) return;
    c.restore();
    ink.forget();
  }

  run(commands, begin, end, state, ink) {
    for (let i = begin; i < end; ++i) {
      commands[i].run(state, ink);
      if (commands[i].isClip) ink.clip(state.clip);
    }
  }

  /// A picture of some of an element's commands that stay the same; null: it would not be quicker, or there is no room.
  face(element, name, begin, end, before) {
    const known = element[name];
    if (known === null || (known && (!before || known.before.isLike(before)))) return known;
    if (known) return element[name] = null; // drawn in one state and another: no picture is right for both
    const cost = element.commands.slice(begin, end).reduce((sum, command) => sum + command.cost, 0);
    return element[name] = cost < 4 ? null : this.makeFace(element, begin, end, before || new State());
  }

  hasRoom(pixels) {
    if (this.facePixels + pixels <= kFaceRoom) return true;
    this.facePixels = 0; // without those that were let go
    for (const element of this.elements)
      if (element) for (const face of [element.headFace, element.tailFace]) if (face) this.facePixels += face.picture.width * face.picture.height;
    return this.facePixels + pixels <= kFaceRoom;
  }

  makeFace(element, begin, end, before) {
    const [left, top, right, bottom] = element.area, width = right - left, height = bottom - top;
    if (!this.scratch || !this.hasRoom(width * height)) return null;
    this.facePixels += width * height;
    this.scratch.width = width;
    this.scratch.height = height;
    const c = this.scratch.getContext('2d'), after = before.copy();
    c.save();
    this.run(element.commands, begin, end, after, new Ink(c, this.scale, left, top));
    c.restore();
    return {picture: this.scratch.transferToImageBitmap(), left, top, before: before.copy(), after};
  }
}

function overlap(a, b) { return a[0] < b[2] && a[1] < b[3] && a[2] > b[0] && a[3] > b[1]; }
