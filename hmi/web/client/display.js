// The page's side of the canvas: hands frames to whoever paints them (easel.js) and hears what is on the screen.
'use strict';

class Display {
  /// `onShown` gets the number of the frame that is on the screen; `onFailed` is called when painting came to an end.
  constructor(canvas, onShown, onFailed) {
    this.onShown = onShown;
    this.shown = this.painted = this.lastAsked = 0;
    this.isWhole = false;
    this.answers = new Map();
    const hear = message => this.hear(message);
    if (canvas.transferControlToOffscreen && typeof Worker !== 'undefined') {
      const surface = canvas.transferControlToOffscreen(), worker = new Worker('/client/worker.js');
      worker.onmessage = event => hear(event.data);
      worker.onerror = onFailed;
      worker.postMessage({t: 'canvas', canvas: surface}, [surface]);
      this.post = (message, parts) => worker.postMessage(message, parts || []);
    } else {
      const easel = new Easel(canvas, hear);
      this.post = message => easel.take(message);
    }
  }

  resize(width, height, scale, color) { this.post({t: 'size', width, height, scale, color}); }

  /// Frames of a new connection come; those of the old one are not acknowledged any more.
  restart() { this.post({t: 'start'}); }

  /// The bytes are the painter's from now on.
  take(bytes) { this.post({t: 'frame', bytes}, [bytes]); }

  hear(message) {
    if (message.t === 'answer') {
      this.answers.get(message.id)(message.value);
      this.answers.delete(message.id);
      return;
    }
    this.shown = message.number;
    this.painted = message.painted;
    this.isWhole = message.isWhole;
    if (message.number) this.onShown(message.number);
  }

  /// See Easel.answer().
  ask(what) {
    const id = ++this.lastAsked;
    return new Promise(done => {
      this.answers.set(id, done);
      this.post({t: 'ask', id, what});
    });
  }

  /// For tests: the canvas as data URLs.
  async pictures(what = 'picture') {
    const url = blob => new Promise(done => {
      const reader = new FileReader();
      reader.onload = () => done(reader.result);
      reader.readAsDataURL(blob);
    });
    return Promise.all((await this.ask(what)).map(url));
  }
}
