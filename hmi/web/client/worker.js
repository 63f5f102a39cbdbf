// The worker in which a panel is painted: it has a processor for itself, and the page stays quick to touch.
'use strict';

importScripts('reader.js', 'ink.js', 'words.js', 'commands.js', 'elements.js', 'paint.js', 'easel.js');

let easel = null;
onmessage = event => {
  if (event.data.t === 'canvas') easel = new Easel(event.data.canvas, message => postMessage(message));
  else easel.take(event.data);
};
