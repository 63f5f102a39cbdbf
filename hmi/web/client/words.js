// Texts of a panel: their letters where Qt puts them, and pictures of those that come again. Knows nothing of the elements.
'use strict';

/// Letters by number, and what small pictures are painted on.
class Glyphs {
  constructor() {
    this.paths = []; // as Reader.path() gives them
    this.scratch = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
  }
}

/// One text: drawn from a picture of it as soon as it comes a second time, since outlines are filled slowly.
class Word {
  constructor(from, glyphs) {
    this.glyphs = glyphs;
    this.letters = [];
    this.shape = null;
    this.pictures = new Map(); // by colour, size and fraction of a pixel
    this.last = null;
    let x = 0, y = 0;
    for (let left = from.count(); left > 0; --left) {
      const glyph = from.count();
      this.letters.push([glyph, x += from.length(), y += from.length()]);
    }
  }

  draw(s, ink) {
    if (!s.pen.value) return;
    const paint = s.pen.value.paint, to = s.transform.value;
    if (!to[1] && !to[2] && to[0] === to[3] && typeof paint === 'string') return this.upright(paint, s, ink);
    if (!this.shape) this.outline();
    ink.enter(s);
    ink.fillWith(paint);
    ink.context.fill(this.shape, 'nonzero');
  }

  outline() {
    this.shape = new Path2D();
    for (const [id, x, y] of this.letters)
      if (this.glyphs.paths[id]) this.shape.addPath(this.glyphs.paths[id].shape, {e: x, f: y});
  }

  upright(paint, s, ink) {
    const to = s.transform.value, size = to[0] * ink.scale, x = Math.round(to[4] * ink.scale * 64), y = Math.round(to[5] * ink.scale * 64);
    const fine = (x & 63) * 64 + (y & 63);
    let last = this.last;
    if (!last || last.paint !== paint || last.size !== size || last.fine !== fine) {
      const key = paint + ' ' + size + ' ' + fine;
      last = this.pictures.get(key);
      if (!last) {
        this.pictures.set(key, {paint, size, fine, picture: undefined, left: 0, top: 0});
        return this.fill(size, x / 64, y / 64, paint, s, ink);
      }
      if (last.picture === undefined) this.makePicture(last);
      this.last = last;
    }
    if (!last.picture) return this.fill(size, x / 64, y / 64, paint, s, ink);
    ink.blit(last.picture, (x >> 6) + last.left, (y >> 6) + last.top, s.clip.value, s.opacity.value);
  }

  /// Letter by letter.
  fill(size, x, y, paint, s, ink) {
    ink.enter(s);
    ink.fillWith(paint);
    ink.transform = null;
    ink.isPlain = false; // each letter has a place of its own: pictures after it must ask for pixels again
    for (const [glyph, atX, atY] of this.placed(size, x, y)) {
      ink.context.setTransform(size, 0, 0, size, atX - ink.left, atY - ink.top);
      ink.context.fill(glyph.shape, 'nonzero');
    }
  }

  /// Each letter in pixels, where Qt puts it: at quarters of a pixel across, at whole ones down.
  placed(size, x, y) {
    const out = [], paths = this.glyphs.paths;
    for (const [id, letterX, letterY] of this.letters)
      if (paths[id]) out.push([paths[id], Math.floor((x + letterX * size) * 4 + 0.01) / 4, Math.round(y + letterY * size)]);
    return out;
  }

  makePicture(one) {
    const kMost = 65536, size = one.size, letters = this.placed(size, (one.fine >> 6) / 64, (one.fine & 63) / 64);
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
    const scratch = this.glyphs.scratch;
    if (!scratch || !(width * height <= kMost)) return;
    scratch.width = width;
    scratch.height = height;
    const c = scratch.getContext('2d');
    c.fillStyle = one.paint;
    for (const [glyph, x, y] of letters) {
      c.setTransform(size, 0, 0, size, x - one.left, y - one.top);
      c.fill(glyph.shape, 'nonzero');
    }
    one.picture = scratch.transferToImageBitmap();
  }
}
