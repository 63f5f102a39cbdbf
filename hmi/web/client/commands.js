// Reads what hmi/web/paint_recorder.cpp wrote: outlines, pens, brushes and drawing commands that paint themselves. A
// command that comes again is the same object, with all that was made for it. Knows nothing of the elements.
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
  /// The next bytes as a key, without going on.
  peek(size) { return String.fromCharCode.apply(null, new Uint8Array(this.view.buffer, this.view.byteOffset + this.at, size)); }
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

let lastCommand = 0;

/// Sets a part of the state, or draws (then `part` is empty). `cost`: roughly how many microseconds it takes.
class Command {
  constructor(part, value, cost = 0, usesBrush = false) {
    this.id = ++lastCommand;
    this.part = part;
    this.value = value;
    this.cost = cost;
    this.usesBrush = usesBrush;
  }
  run(state, ink) {
    if (this.part) state[this.part] = this; else this.value(state, ink);
  }
}

const kStill = new Command('transform', [1, 0, 0, 1, 0, 0]), kNoPen = new Command('pen', null), kNoBrush = new Command('brush', null);
const kOpaque = new Command('opacity', 1), kSmooth = new Command('crisp', 0), kNoClip = new Command('clip', null);
const kPixels = [1, 0, 0, 1, 0, 0]; // not scaled

/// What a command is drawn with: for each part, the command that set it.
class State {
  constructor() {
    this.transform = kStill;
    this.pen = kNoPen;
    this.brush = kNoBrush;
    this.opacity = kOpaque;
    this.crisp = kSmooth;
    this.clip = kNoClip;
  }
  copy() { return Object.assign(new State(), this); }
}

/// A context that is given only what it does not have yet: of 1,000 elements most are drawn alike. Between restore() and
/// save() of its own it is as it was handed over.
class Ink {
  constructor(context, scale, left = 0, top = 0) {
    this.context = context;
    this.scale = scale;
    this.left = left;
    this.top = top;
    this.clipped = null;
    context.save();
    this.forget();
  }

  end() { this.context.restore(); }

  forget() {
    this.transform = this.opacity = this.fillPaint = this.strokePaint = this.pen = this.shrink = null;
    this.isDashed = true;
  }

  place(a, b, d, e, x, y) {
    const k = this.scale;
    this.context.setTransform(a * k, b * k, d * k, e * k, x * k - this.left, y * k - this.top);
  }

  enter(s) {
    if (this.clipped !== s.clip.value) this.clip(s.clip.value);
    const to = s.transform.value;
    if (this.transform !== to) {
      this.transform = to;
      this.place(to[0], to[1], to[2], to[3], to[4], to[5]);
    }
    this.fade(s.opacity.value);
  }

  fade(opacity) {
    if (this.opacity !== opacity) this.context.globalAlpha = this.opacity = opacity;
  }

  fillWith(paint) {
    if (this.fillPaint !== paint) this.context.fillStyle = this.fillPaint = paint;
  }

  strokeWith(s) {
    const pen = s.pen.value, c = this.context;
    this.enter(s);
    // Without smoothing, Qt's lines fill whole pixels.
    if (s.crisp.value) {
      c.translate(0.5, 0.5);
      this.transform = null;
    }
    const to = s.transform.value, shrink = pen.isCosmetic ? 1 / Math.max(1e-6, Math.hypot(to[0], to[1])) : 1;
    if (this.strokePaint !== pen.paint) c.strokeStyle = this.strokePaint = pen.paint;
    if (this.pen === pen && this.shrink === shrink) return;
    const before = this.pen && this.shrink === shrink ? this.pen : null;
    this.pen = pen;
    this.shrink = shrink;
    if (!before || before.width !== pen.width) c.lineWidth = pen.width * shrink;
    if (!before || before.cap !== pen.cap) c.lineCap = pen.cap;
    if (!before || before.join !== pen.join) c.lineJoin = pen.join;
    if (!before || before.miter !== pen.miter) c.miterLimit = pen.miter;
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
    this.clipped = path;
    if (!path) return;
    this.place(1, 0, 0, 1, 0, 0);
    c.clip(path.shape, path.rule);
  }

  /// Pixel for pixel, at a place of the canvas.
  blit(picture, x, y, clip, opacity) {
    if (this.clipped !== clip) this.clip(clip);
    this.fade(opacity);
    if (this.transform !== kPixels) {
      this.transform = kPixels;
      this.context.setTransform(1, 0, 0, 1, 0, 0);
    }
    this.context.drawImage(picture, x - this.left, y - this.top);
  }
}

/// All commands of a panel, each once, and the letters and pictures that they name.
class Commands {
  constructor(context) {
    this.context = context; // makes gradients
    this.scratch = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
    this.glyphs = [];
    this.pictures = [];
    this.forget();
  }

  /// Glyphs may get other numbers.
  forget() {
    this.young = new Map(); // by their bytes
    this.old = new Map();
  }

  /// Those that came lately are kept; of the others, those that are drawn.
  read(from) {
    const kLongest = 2048, kMany = 8192, size = from.count(), end = from.at + size;
    const key = size <= kLongest ? from.peek(size) : null;
    let one = key === null ? undefined : this.young.get(key);
    if (one) {
      from.at = end;
      return one;
    }
    one = (key !== null && this.old.get(key)) || this.make(from);
    from.at = end;
    if (key === null) return one;
    if (this.young.size >= kMany) {
      this.old = this.young;
      this.young = new Map();
    }
    this.young.set(key, one);
    return one;
  }

  make(from) {
    const kRect = 1, kText = 3, kPath = 4;
    const draw = (run, cost = kPath, usesBrush = true) => new Command('', run, cost, usesBrush);
    switch (from.byte()) {
    case 1: return new Command('transform', [1, 0, 0, 1, from.length(), from.length()]);
    case 2: return new Command('transform', [0, 0, 0, 0, 0, 0].map(() => from.real()));
    case 3: return new Command('pen', this.pen(from));
    case 4: return new Command('brush', this.brush(from));
    case 5: return new Command('opacity', from.byte() / 255);
    case 6: return new Command('clip', from.byte() ? from.path() : null);
    case 7: return new Command('crisp', from.byte() ? 0.5 : 0);
    case 8: return draw(this.rectangle(from.rect()), kRect);
    case 9: {
      const [x, y, w, h] = from.rect(), shape = new Path2D();
      shape.ellipse(x + w / 2, y + h / 2, Math.abs(w / 2), Math.abs(h / 2), 0, 0, 2 * Math.PI);
      shape.closePath();
      return draw(this.drawn(shape));
    }
    case 10: { const {shape, rule} = from.path(); return draw(this.drawn(shape, rule)); }
    case 11: { const rule = from.byte() ? 'nonzero' : 'evenodd'; return draw(this.drawn(this.points(from, true), rule)); }
    case 12: { const shape = this.points(from, false); return draw((s, ink) => this.stroke(s, ink, shape), kPath, false); }
    case 13: {
      const x = from.length(), y = from.length(), shape = new Path2D();
      shape.moveTo(x, y);
      shape.lineTo(x + from.length(), y + from.length());
      return draw((s, ink) => this.stroke(s, ink, shape), kPath, false);
    }
    case 14: {
      const id = from.count(), to = from.rect(), part = from.rect();
      return draw((s, ink) => this.picture(s, ink, id, to, part), kPath, false);
    }
    case 15: return draw(this.text(from), kText, false);
    default: throw new Error('command');
    }
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

  /// A text is drawn from a picture of it as soon as it comes a second time: outlines are filled slowly.
  text(from) {
    const word = {letters: [], shape: null, box: null, pictures: new Map(), last: null};
    let x = 0, y = 0;
    for (let left = from.count(); left > 0; --left) {
      const glyph = from.count();
      word.letters.push([glyph, x += from.length(), y += from.length()]);
    }
    return (s, ink) => {
      if (!s.pen.value) return;
      const paint = s.pen.value.paint, to = s.transform.value;
      if (!to[1] && !to[2] && to[0] === to[3] && typeof paint === 'string') return this.upright(word, paint, s, ink);
      if (!word.shape) this.outline(word);
      ink.enter(s);
      ink.fillWith(paint);
      ink.context.fill(word.shape, 'nonzero');
    };
  }

  outline(word) {
    word.shape = new Path2D();
    for (const [id, x, y] of word.letters)
      if (this.glyphs[id]) word.shape.addPath(this.glyphs[id].shape, {e: x, f: y});
  }

  upright(word, paint, s, ink) {
    const to = s.transform.value, size = to[0] * ink.scale, x = Math.round(to[4] * ink.scale * 64), y = Math.round(to[5] * ink.scale * 64);
    const fine = (x & 63) * 64 + (y & 63);
    let last = word.last;
    if (!last || last.paint !== paint || last.size !== size || last.fine !== fine) {
      const key = paint + ' ' + size + ' ' + fine;
      last = word.pictures.get(key);
      if (!last) {
        word.pictures.set(key, {paint, size, fine, picture: undefined, left: 0, top: 0});
        return this.letters(word, size, x / 64, y / 64, paint, s, ink);
      }
      if (last.picture === undefined) this.makePicture(word, last);
      word.last = last;
    }
    if (!last.picture) return this.letters(word, size, x / 64, y / 64, paint, s, ink);
    ink.blit(last.picture, (x >> 6) + last.left, (y >> 6) + last.top, s.clip.value, s.opacity.value);
  }

  letters(word, size, x, y, paint, s, ink) {
    ink.enter(s);
    ink.fillWith(paint);
    ink.transform = null;
    for (const [glyph, atX, atY] of this.placed(word, size, x, y)) {
      ink.context.setTransform(size, 0, 0, size, atX - ink.left, atY - ink.top);
      ink.context.fill(glyph.shape, 'nonzero');
    }
  }

  /// Each letter in pixels, where Qt puts it: at quarters of a pixel across, at whole ones down.
  placed(word, size, x, y) {
    const out = [];
    for (const [id, letterX, letterY] of word.letters)
      if (this.glyphs[id]) out.push([this.glyphs[id], Math.floor((x + letterX * size) * 4 + 0.01) / 4, Math.round(y + letterY * size)]);
    return out;
  }

  makePicture(word, one) {
    const kMost = 65536, size = one.size, letters = this.placed(word, size, (one.fine >> 6) / 64, (one.fine & 63) / 64);
    let left = Infinity, top = Infinity, right = -Infinity, bottom = -Infinity;
    for (const [glyph, x, y] of letters) {
      left = Math.min(left, x + glyph.box[0] * size);
      top = Math.min(top, y + glyph.box[1] * size);
      right = Math.max(right, x + glyph.box[2] * size);
      bottom = Math.max(bottom, y + glyph.box[3] * size);
    }
    one.left = Math.floor(left) - 1;
    one.top = Math.floor(top) - 1;
    const width = Math.ceil(right) + 1 - one.left, height = Math.ceil(bottom) + 1 - one.top;
    one.picture = null;
    if (!this.scratch || !(width * height <= kMost)) return;
    this.scratch.width = width;
    this.scratch.height = height;
    const c = this.scratch.getContext('2d');
    c.fillStyle = one.paint;
    for (const [glyph, x, y] of letters) {
      c.setTransform(size, 0, 0, size, x - one.left, y - one.top);
      c.fill(glyph.shape, 'nonzero');
    }
    one.picture = this.scratch.transferToImageBitmap();
  }

  /// Most of what is drawn are rectangles, which are much quicker without a path.
  rectangle([x, y, w, h]) {
    return (s, ink) => {
      if (s.brush.value) {
        ink.enter(s);
        ink.fillWith(s.brush.value);
        ink.context.fillRect(x, y, w, h);
      }
      if (!s.pen.value) return;
      ink.strokeWith(s);
      ink.context.strokeRect(x, y, w, h);
    };
  }

  drawn(shape, rule = 'evenodd') {
    return (s, ink) => {
      if (s.brush.value) {
        ink.enter(s);
        ink.fillWith(s.brush.value);
        ink.context.fill(shape, rule);
      }
      this.stroke(s, ink, shape);
    };
  }

  stroke(s, ink, shape) {
    if (!s.pen.value) return;
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
}
