// Reads the numbers, colours and outlines that hmi/web/paint_bytes.h wrote. Knows nothing of commands.
'use strict';

class Reader {
  constructor(buffer) {
    this.view = new DataView(buffer);
    this.bytes = new Uint8Array(buffer);
    this.at = 0;
  }
  get isAtEnd() { return this.at >= this.bytes.length; }
  byte() {
    if (this.at >= this.bytes.length) throw new Error('end');
    return this.bytes[this.at++];
  }
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
  peek(size) { return String.fromCharCode.apply(null, this.bytes.subarray(this.at, this.at + size)); }
  blob() {
    const size = this.count();
    const bytes = this.bytes.subarray(this.at, this.at + size);
    this.at += size;
    return bytes;
  }
  path() {
    const out = {shape: new Path2D(), rule: this.byte() === 0 ? 'evenodd' : 'nonzero', box: [0, 0, 0, 0], isBox: false}, box = out.box;
    let x = 0, y = 0, firstX = 0, firstY = 0, isFirst = true, corners = 0, isStraight = true;
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
      case 0:
        out.isBox = isStraight && corners === 4 && x === firstX && y === firstY;
        return out;
      case 1: isStraight = isStraight && corners === 0; out.shape.moveTo(firstX = x += this.length(), firstY = y += this.length()); reach(x, y); break;
      case 2: {
        const beforeX = x, beforeY = y;
        out.shape.lineTo(x += this.length(), y += this.length());
        isStraight = isStraight && (x === beforeX) !== (y === beforeY);
        ++corners;
        break;
      }
      case 3: {
        const ax = x + this.length(), ay = y + this.length(), bx = ax + this.length(), by = ay + this.length();
        x = bx + this.length();
        y = by + this.length();
        out.shape.bezierCurveTo(ax, ay, bx, by, x, y);
        reach(ax, ay);
        reach(bx, by);
        isStraight = false;
        break;
      }
      case 4:
        out.shape.closePath();
        if (corners === 3 && (x === firstX) !== (y === firstY)) ++corners;
        x = firstX;
        y = firstY;
        break;
      default: throw new Error('path');
      }
    }
  }
}
