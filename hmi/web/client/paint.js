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
    const out = {shape: new Path2D(), rule: this.byte() === 0 ? 'evenodd' : 'nonzero'};
    let x = 0, y = 0, firstX = 0, firstY = 0;
    for (;;) {
      switch (this.byte()) {
      case 0: return out;
      case 1: out.shape.moveTo(firstX = x += this.length(), firstY = y += this.length()); break;
      case 2: out.shape.lineTo(x += this.length(), y += this.length()); break;
      case 3: {
        const ax = x + this.length(), ay = y + this.length(), bx = ax + this.length(), by = ay + this.length();
        x = bx + this.length();
        y = by + this.length();
        out.shape.bezierCurveTo(ax, ay, bx, by, x, y);
        break;
      }
      case 4: out.shape.closePath(); x = firstX; y = firstY; break;
      default: throw new Error('path');
      }
    }
  }
}

class Painter {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', {alpha: false});
    this.glyphs = [];
    this.outlines = new Map(); // by glyphs and their places
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
    this.allDirty = true;
  }

  /// Takes a frame in; returns its number. What changed is painted by paint().
  take(buffer) {
    const from = new Reader(buffer), number = from.count();
    while (!from.isAtEnd) {
      switch (from.byte()) {
      case 1: this.glyphs[from.count()] = from.path().shape; break;
      case 2: this.takePicture(from.count(), from.blob()); break;
      case 3: this.takeElement(from); break;
      case 4: this.elements = []; this.outlines.clear(); this.allDirty = true; break; // glyphs may have other numbers now
      default: throw new Error('section');
      }
    }
    return number;
  }

  takePicture(id, bytes) {
    const image = this.pictures[id] = new Image();
    image.onload = () => {
      this.allDirty = true;
      if (this.onPictures) this.onPictures();
    };
    image.src = URL.createObjectURL(new Blob([bytes.slice()], {type: 'image/png'}));
  }

  takeElement(from) {
    const index = from.count(), flags = from.byte();
    const element = this.elements[index] || (this.elements[index] = {bounds: null, commands: [], isShown: false});
    if (element.bounds) this.dirty.push(element.bounds);
    if (flags & 2) element.bounds = from.rect();
    element.isShown = (flags & 1) !== 0;
    this.dirty.push(element.bounds);
    const first = from.count(), removed = from.count(), commands = [];
    for (let left = from.count(); left > 0; --left) commands.push(this.command(from));
    element.commands.splice(first, removed, ...commands);
  }

  /// One command as a function of the state it is drawn in.
  command(from) {
    switch (from.byte()) {
    case 1: { const x = from.length(), y = from.length(); return s => s.transform = [1, 0, 0, 1, x, y]; }
    case 2: { const m = [0, 0, 0, 0, 0, 0].map(() => from.real()); return s => s.transform = m; }
    case 3: { const pen = this.pen(from); return s => s.pen = pen; }
    case 4: { const brush = this.brush(from); return s => s.brush = brush; }
    case 5: { const opacity = from.byte() / 255; return s => s.opacity = opacity; }
    case 6: { const path = from.byte() ? from.path() : null; return (s, c) => this.clip(s, c, path); }
    case 7: { const crisp = from.byte() ? 0.5 : 0; return s => s.crisp = crisp; }
    case 8: { const [x, y, w, h] = from.rect(), shape = new Path2D(); shape.rect(x, y, w, h); return this.drawn(shape); }
    case 9: {
      const [x, y, w, h] = from.rect(), shape = new Path2D();
      shape.ellipse(x + w / 2, y + h / 2, Math.abs(w / 2), Math.abs(h / 2), 0, 0, 2 * Math.PI);
      shape.closePath();
      return this.drawn(shape);
    }
    case 10: { const {shape, rule} = from.path(); return this.drawn(shape, rule); }
    case 11: { const rule = from.byte() ? 'nonzero' : 'evenodd'; return this.drawn(this.points(from, true), rule); }
    case 12: { const shape = this.points(from, false); return (s, c) => this.stroke(s, c, shape); }
    case 13: {
      const x = from.length(), y = from.length(), shape = new Path2D();
      shape.moveTo(x, y);
      shape.lineTo(x + from.length(), y + from.length());
      return (s, c) => this.stroke(s, c, shape);
    }
    case 14: { const id = from.count(), to = from.rect(), part = from.rect(); return (s, c) => this.picture(s, c, id, to, part); }
    case 15: return this.text(from);
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
    return (s, c) => {
      if (!s.pen) return;
      const [a, b, d, e, toX, toY] = s.transform, k = this.scale;
      c.setTransform(a * k, b * k, d * k, e * k, (toX + a * firstX + d * firstY) * k, (toY + b * firstX + e * firstY) * k);
      c.globalAlpha = s.opacity;
      c.fillStyle = s.pen.paint;
      c.fill(this.outline(key, runs), 'nonzero');
    };
  }

  outline(key, runs) {
    const known = this.outlines.get(key);
    if (known) return known;
    const whole = new Path2D();
    for (const [glyph, x, y] of runs) if (this.glyphs[glyph]) whole.addPath(this.glyphs[glyph], {e: x, f: y});
    if (this.outlines.size >= 4096) this.outlines.clear();
    this.outlines.set(key, whole);
    return whole;
  }

  enter(s, c) {
    const [a, b, d, e, x, y] = s.transform, k = this.scale;
    c.setTransform(a * k, b * k, d * k, e * k, x * k, y * k);
    c.globalAlpha = s.opacity;
  }

  drawn(shape, rule = 'evenodd') {
    return (s, c) => {
      if (s.brush) {
        this.enter(s, c);
        c.fillStyle = s.brush;
        c.fill(shape, rule);
      }
      this.stroke(s, c, shape);
    };
  }

  stroke(s, c, shape) {
    const pen = s.pen;
    if (!pen) return;
    this.enter(s, c);
    // Without smoothing, Qt's lines fill whole pixels.
    if (s.crisp) c.translate(0.5, 0.5);
    const [a, b] = s.transform, shrink = pen.isCosmetic ? 1 / Math.max(1e-6, Math.hypot(a, b)) : 1;
    c.strokeStyle = pen.paint;
    c.lineWidth = pen.width * shrink;
    c.lineCap = pen.cap;
    c.lineJoin = pen.join;
    c.miterLimit = pen.miter;
    c.setLineDash(pen.dashes.map(dash => dash * shrink));
    c.lineDashOffset = pen.offset * shrink;
    c.stroke(shape);
  }

  picture(s, c, id, [x, y, w, h], [fromX, fromY, fromW, fromH]) {
    const image = this.pictures[id];
    if (!image || !image.complete || !image.naturalWidth || !fromW || !fromH) return;
    this.enter(s, c);
    c.imageSmoothingQuality = 'high';
    c.drawImage(image, fromX, fromY, fromW, fromH, x, y, w, h);
  }

  clip(s, c, path) {
    c.restore();
    c.save();
    if (!path) return;
    c.setTransform(this.scale, 0, 0, this.scale, 0, 0);
    c.clip(path.shape, path.rule);
  }

  /// Paints what changed; true if anything did.
  paint() {
    const dirty = this.dirty, k = this.scale;
    if (!this.allDirty && dirty.length === 0) return false;
    const width = this.canvas.width, height = this.canvas.height;
    let areas = [[0, 0, width, height]];
    if (!this.allDirty) {
      areas = dirty.map(([x, y, w, h]) => {
        const left = Math.floor(x * k) - 1, top = Math.floor(y * k) - 1;
        return [left, top, Math.ceil((x + w) * k) + 1 - left, Math.ceil((y + h) * k) + 1 - top];
      });
      if (areas.length > 256) areas = [[0, 0, width, height]];
    }
    this.dirty = [];
    this.allDirty = false;
    const c = this.context;
    c.save();
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.beginPath();
    for (const [x, y, w, h] of areas) c.rect(x, y, w, h);
    c.clip();
    c.globalAlpha = 1;
    c.fillStyle = this.ground;
    c.fillRect(0, 0, width, height);
    for (const element of this.elements) {
      if (!element || !element.isShown || !this.touches(element.bounds, areas)) continue;
      const state = {transform: [1, 0, 0, 1, 0, 0], pen: null, brush: null, opacity: 1, crisp: 0};
      c.save();
      for (const command of element.commands) command(state, c);
      c.restore();
    }
    c.restore();
    return true;
  }

  touches([x, y, w, h], areas) {
    const k = this.scale, left = x * k - 1, top = y * k - 1, right = (x + w) * k + 1, bottom = (y + h) * k + 1;
    return areas.some(a => a[0] < right && a[1] < bottom && a[0] + a[2] > left && a[1] + a[3] > top);
  }
}
