// Paints a panel as messages say: in a worker of its own where the browser has them, else in the page. Tells what is on
// the screen.
'use strict';

class Easel {
  /// `report` gets {t: 'shown', number, painted, isWhole} after each frame, and answers.
  constructor(canvas, report) {
    this.report = report;
    this.painter = new Painter(canvas);
    this.painter.onPictures = () => this.schedule();
    this.number = 0;  // of the last frame that was taken in
    this.painted = 0; // how often something was painted
    this.isScheduled = false;
  }

  take(message) {
    switch (message.t) {
    case 'size':
      this.painter.resize(message.width, message.height, message.scale, message.color);
      return void this.painter.paint();
    case 'start': // a new connection counts its frames from 1
      this.number = 0;
      return;
    case 'frame':
      this.number = this.painter.take(message.bytes);
      return this.schedule();
    case 'ask': return this.answer(message);
    }
  }

  /// Frames that come between two of the screen's are painted together.
  schedule() {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      if (this.painter.paint()) ++this.painted;
      this.report({t: 'shown', number: this.number, painted: this.painted, isWhole: this.painter.isWhole});
    });
  }

  /// For tests: which elements are shown, or pictures of the canvas: as it is and, if both are asked for, as it would be
  /// without all that was kept.
  async answer({id, what}) {
    const painter = this.painter, canvas = painter.canvas;
    if (what === 'elements') return this.report({t: 'answer', id, value: painter.elements.map(one => one.isShown)});
    const taken = () => canvas.convertToBlob ? canvas.convertToBlob() : new Promise(done => canvas.toBlob(done));
    painter.paint();
    const pictures = [taken()];
    if (what === 'both') {
      painter.paintAfresh();
      pictures.push(taken());
    }
    this.report({t: 'answer', id, value: await Promise.all(pictures)});
  }
}
