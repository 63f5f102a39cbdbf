// Reads what hmi/web/paint_recorder.cpp wrote: pens, brushes and drawing commands that paint themselves. A command that
// comes again is the same object, with all that was made for it. Knows nothing of the elements.
'use strict';

/// All commands of a panel, each once, and the letters and pictures that they name.
class Commands {
  constructor(context) {
    this.context = context; // makes gradients
    this.glyphs = new Glyphs();
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
      return draw(this.line(from.length(), from.length(), from.length(), from.length()), kPath, false);
    }
    case 14: {
      const id = from.count(), to = from.rect(), part = from.rect();
      return draw((s, ink) => this.picture(s, ink, id, to, part), kPath, false);
    }
    case 15: { const word = new Word(from, this.glyphs); return draw((s, ink) => word.draw(s, ink), kText, false); }
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

  /// Most of what is drawn are rectangles, which are much quicker without a path.
  rectangle([x, y, w, h]) {
    return (s, ink) => {
      if (s.brush.value && !ink.fillClipped(s, s.brush.value, x, y, w, h)) {
        ink.enter(s);
        ink.fillWith(s.brush.value);
        ink.context.fillRect(x, y, w, h);
      }
      if (!s.pen.value) return;
      ink.strokeWith(s);
      ink.context.strokeRect(x, y, w, h);
    };
  }

  /// One that is upright or level is a box as well.
  line(x, y, toX, toY) {
    const shape = new Path2D(), isBox = (toX === 0) !== (toY === 0);
    shape.moveTo(x, y);
    shape.lineTo(x + toX, y + toY);
    return (s, ink) => {
      const pen = s.pen.value;
      if (isBox && pen && !pen.dashes.length && !pen.isCosmetic && pen.cap !== 'round' && !s.crisp.value) {
        const half = pen.width / 2, along = pen.cap === 'square' ? half : 0, acrossX = toX ? along : half, acrossY = toY ? along : half;
        const left = Math.min(x, x + toX) - acrossX, top = Math.min(y, y + toY) - acrossY;
        if (ink.fillClipped(s, pen.paint, left, top, Math.abs(toX) + 2 * acrossX, Math.abs(toY) + 2 * acrossY)) return;
      }
      this.stroke(s, ink, shape);
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
    const image = this.pictures[id] ? this.pictures[id].image : null;
    if (!image || !fromW || !fromH) return;
    ink.enter(s);
    ink.context.imageSmoothingQuality = 'high';
    ink.context.drawImage(image, fromX, fromY, fromW, fromH, x, y, w, h);
  }
}
