// What a drawing command is, the state that it is drawn in, and a canvas that is given only what it does not have yet.
'use strict';

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
  set(other) {
    this.transform = other.transform;
    this.pen = other.pen;
    this.brush = other.brush;
    this.opacity = other.opacity;
    this.crisp = other.crisp;
    this.clip = other.clip;
    return this;
  }
  copy() { return new State().set(this); }
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
    this.isPlain = false;
  }

  place(a, b, d, e, x, y) {
    const k = this.scale, atX = x * k - this.left, atY = y * k - this.top;
    this.context.setTransform(a * k, b * k, d * k, e * k, atX, atY);
    this.isPlain = a * k === 1 && e * k === 1 && !b && !d && Number.isInteger(atX) && Number.isInteger(atY);
    this.atX = atX;
    this.atY = atY;
  }

  /// Pixels of the canvas are counted from (atX, atY) now.
  toPixels() {
    if (this.isPlain) return;
    this.transform = null;
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.isPlain = true;
    this.atX = this.atY = 0;
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
      this.isPlain = false;
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

  /// Pixel for pixel, at a place of the canvas. A clip that is a box takes its part of the picture.
  blit(picture, x, y, clip, opacity) {
    x -= this.left;
    y -= this.top;
    if (clip && clip.isBox) {
      const [left, top, right, bottom] = clip.box, k = this.scale;
      return this.blitPart(picture, x, y, left * k - this.left, top * k - this.top, right * k - this.left, bottom * k - this.top, opacity);
    }
    if (this.clipped !== clip) this.clip(clip);
    this.fade(opacity);
    this.toPixels();
    this.context.drawImage(picture, x - this.atX, y - this.atY);
  }

  /// A box within a clip of another shape: a part of a picture of that shape, since clips that are no boxes are slow. False:
  /// it is for the caller to draw.
  fillClipped(s, paint, x, y, width, height) {
    const clip = s.clip.value, to = s.transform.value, k = this.scale;
    if (!clip || clip.isBox || typeof paint !== 'string' || to[0] !== 1 || to[3] !== 1 || to[1] || to[2]) return false;
    const shape = filled(clip, paint, k);
    if (!shape) return false;
    // Where the box goes beyond the shape, the shape's own edge is what is seen.
    const [left, top, right, bottom] = clip.box, boxLeft = to[4] + Math.min(x, x + width), boxTop = to[5] + Math.min(y, y + height);
    const edge = (at, end) => (at <= end ? -Infinity : at);
    this.blitPart(shape.picture, shape.left - this.left, shape.top - this.top, edge(boxLeft, left) * k - this.left,
      edge(boxTop, top) * k - this.top, -edge(-boxLeft - Math.abs(width), -right) * k - this.left,
      -edge(-boxTop - Math.abs(height), -bottom) * k - this.top, s.opacity.value);
    return true;
  }

  /// What of a picture is in a box. Pixels that are partly in it are as faint, as if it had been clipped.
  blitPart(picture, x, y, left, top, right, bottom, opacity) {
    left = Math.max(left, x);
    top = Math.max(top, y);
    right = Math.min(right, x + picture.width);
    bottom = Math.min(bottom, y + picture.height);
    if (left >= right || top >= bottom) return;
    if (this.clipped) this.clip(null);
    this.toPixels();
    const columns = strips(left, right), rows = strips(top, bottom);
    for (let i = 0; i < columns.length; i += 3)
      for (let j = 0; j < rows.length; j += 3) {
        const fromX = columns[i], fromY = rows[j], width = columns[i + 1] - fromX, height = rows[j + 1] - fromY;
        this.fade(opacity * columns[i + 2] * rows[j + 2]);
        this.context.drawImage(picture, fromX - x, fromY - y, width, height, fromX - this.atX, fromY - this.atY, width, height);
      }
  }
}

const kShapes = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);

/// A picture of a path filled with a colour; null the first time, or if it would be too large.
function filled(path, paint, scale) {
  const kMost = 1 << 18, kColours = 4;
  if (!path.fills || path.scale !== scale || path.fills.size > kColours) path.fills = new Map();
  path.scale = scale;
  const known = path.fills.get(paint);
  if (known) return known.picture ? known : makeFilled(path, paint, scale, known);
  const [left, top, right, bottom] = path.box.map(at => at * scale);
  const one = {picture: null, left: Math.floor(left) - 1, top: Math.floor(top) - 1, width: 0, height: 0};
  one.width = Math.ceil(right) + 1 - one.left;
  one.height = Math.ceil(bottom) + 1 - one.top;
  if (kShapes && one.width * one.height <= kMost) path.fills.set(paint, one);
  return null;
}

function makeFilled(path, paint, scale, one) {
  kShapes.width = one.width;
  kShapes.height = one.height;
  const c = kShapes.getContext('2d');
  c.setTransform(scale, 0, 0, scale, -one.left, -one.top);
  c.fillStyle = paint;
  c.fill(path.shape, path.rule);
  one.picture = kShapes.transferToImageBitmap();
  return one;
}

/// A stretch as whole pixels: begin, end and how much of them, up to three times.
function strips(begin, end) {
  const first = Math.ceil(begin), last = Math.floor(end);
  if (first === begin && last === end) return [begin, end, 1];
  if (first > last) return [last, first, end - begin];
  const out = [];
  if (first > begin) out.push(first - 1, first, first - begin);
  if (last > first) out.push(first, last, 1);
  if (end > last) out.push(last, last + 1, end - last);
  return out;
}
