// The page of a panel: holds the connection, paints what comes, sends what is touched and typed, and keeps buttons for
// keyboards and screen readers over the picture.
'use strict';

const byId = id => document.getElementById(id);
const stage = byId('stage'), canvas = byId('canvas'), elements = byId('elements');
const labels = new Map();
const display = new Display(canvas, number => send({t: 'drawn', n: number}), () => { if (socket) socket.close(); });
let socket = null, panel = null, waits = 250, noteTimer = 0, isHeld = false, secret = '', user = '';
const asked = new URLSearchParams(location.search);
const wanted = {panel: decodeURIComponent(location.pathname.replace(/^\/panel\/?/, '')), language: asked.get('language') || ''};
if (asked.has('bare')) document.body.classList.add('bare');

function send(message) {
  if (socket && socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
}

function scaleNow() { return (panel ? fit() : 1) * (window.devicePixelRatio || 1); }

function fit() {
  if (asked.has('scale')) return Number(asked.get('scale')) || 1;
  return Math.max(0.05, Math.min(stage.clientWidth / panel.width, stage.clientHeight / panel.height));
}

function connect() {
  socket = new WebSocket((location.protocol === 'https:' ? 'wss://' : 'ws://') + location.host + '/panel-stream');
  socket.binaryType = 'arraybuffer';
  socket.onopen = () => {
    waits = 250;
    display.restart();
    send({t: 'hello', text: wanted.panel, more: wanted.language, n: scaleNow()});
    sendMotion();
    if (secret) send({t: 'login', text: secret, more: user});
  };
  socket.onmessage = event => {
    if (typeof event.data === 'string') return take(JSON.parse(event.data));
    display.take(event.data);
  };
  socket.onclose = () => {
    socket = null;
    isHeld = false;
    stage.classList.add('stale');
    if (panel) state(panel.words.lost, true);
    // Not all browsers at the same moment after a restart of the server.
    setTimeout(connect, waits * (0.75 + Math.random() / 2));
    waits = Math.min(waits * 2, 10000);
  };
}

// Who asked the system for less movement gets arrows in place of what flows and turns.
const calm = window.matchMedia('(prefers-reduced-motion: reduce)');
function sendMotion() { send({t: 'motion', n: calm.matches ? 0 : 1}); }
calm.addEventListener('change', sendMotion);

function take(message) {
  switch (message.t) {
  case 'panel': return show(message);
  case 'state': return state(message.text, message.bad);
  case 'refused': return note(message.text);
  case 'words': return message.list.forEach(label);
  case 'login': return loggedIn(message);
  }
}

function show(message) {
  const isOther = !panel || panel.name !== message.name || panel.width !== message.width || panel.height !== message.height;
  if (panel && panel.operator && !message.operator) secret = ''; // logged out after a time without a touch
  panel = message;
  wanted.panel = message.name;
  wanted.language = message.language;
  document.title = message.name;
  document.documentElement.lang = message.language;
  document.body.dir = message.rtl ? 'rtl' : 'ltr';
  document.body.classList.toggle('dark', message.dark);
  stage.classList.remove('stale');
  state('', false);
  if (isOther) { elements.replaceChildren(); labels.clear(); }
  fill(byId('panels'), message.panels.map(name => [name, name]), message.name);
  fill(byId('languages'), message.languages, message.language);
  byId('log').textContent = message.operator ? message.words.logOut : message.words.logIn;
  byId('who').textContent = message.operator;
  byId('nameLabel').textContent = message.words.user;
  byId('name').hidden = byId('nameLabel').hidden = !message.people;
  byId('codeLabel').textContent = message.words.code;
  byId('loginOk').textContent = message.words.logIn;
  byId('loginCancel').textContent = message.words.cancel;
  const query = new URLSearchParams(location.search);
  query.set('language', message.language);
  history.replaceState(null, '', '/panel/' + encodeURIComponent(message.name) + '?' + query);
  place();
}

function fill(select, rows, chosen) {
  select.replaceChildren(...rows.map(([value, text]) => new Option(text, value, false, value === chosen)));
  select.hidden = rows.length < 2;
}

function state(text, isBad) {
  byId('state').textContent = text;
  byId('state').className = text ? (isBad ? 'bad' : 'notice') : '';
}

function note(text) {
  byId('note').textContent = text;
  clearTimeout(noteTimer);
  noteTimer = setTimeout(() => { byId('note').textContent = ''; }, 4000);
}

function place() {
  if (!panel) return;
  const zoom = fit(), width = panel.width * zoom, height = panel.height * zoom;
  const left = Math.max(0, Math.floor((stage.clientWidth - width) / 2)), top = Math.max(0, Math.floor((stage.clientHeight - height) / 2));
  display.resize(panel.width, panel.height, scaleNow(), panel.ground);
  for (const [part, style] of [[canvas, canvas.style], [elements, elements.style]]) {
    style.left = left + 'px';
    style.top = top + 'px';
    if (part === canvas) { style.width = width + 'px'; style.height = height + 'px'; }
  }
  elements.style.transform = `scale(${zoom})`;
  elements.style.transformOrigin = '0 0';
}

/// A button or a text that lies over an element, for keyboards and screen readers. Only what is new of it is touched:
/// a panel has 1,000 of them.
function label([index, words, isLive, x, y, width, height]) {
  const tag = isLive ? 'BUTTON' : 'SPAN', place = `left:${x}px;top:${y}px;width:${width}px;height:${height}px`;
  let one = labels.get(index);
  if (one && one.part.tagName !== tag) { one.part.remove(); one = null; }
  if (!one) {
    one = {part: document.createElement(tag), words: null, place: ''};
    one.part.dataset.index = index;
    if (isLive) one.part.addEventListener('click', () => send({t: 'activate', n: index}));
    else one.part.setAttribute('role', 'img');
    labels.set(index, one);
    const after = lastLabel() < index ? null : [...elements.children].find(other => Number(other.dataset.index) > index);
    elements.insertBefore(one.part, after || null);
  }
  if (one.words !== words) one.part.setAttribute('aria-label', one.words = words);
  if (one.place !== place) one.part.style.cssText = one.place = place;
}
function lastLabel() { return elements.lastElementChild ? Number(elements.lastElementChild.dataset.index) : -1; }

// ---- fingers, mouse, keys

function at(event) {
  const box = canvas.getBoundingClientRect(), zoom = fit();
  return {x: (event.clientX - box.left) / zoom, y: (event.clientY - box.top) / zoom};
}

let lastMove = null, moveTimer = 0;
stage.addEventListener('pointerdown', event => {
  if (!panel || isHeld || event.button !== 0) return;
  event.preventDefault();
  isHeld = true;
  stage.setPointerCapture(event.pointerId);
  send({t: 'down', ...at(event)});
});
stage.addEventListener('pointermove', event => {
  if (!isHeld) return;
  lastMove = at(event);
  if (!moveTimer) moveTimer = setTimeout(sendMove, 30);
});
function sendMove() {
  clearTimeout(moveTimer);
  moveTimer = 0;
  if (lastMove) send({t: 'move', ...lastMove});
  lastMove = null;
}
stage.addEventListener('pointerup', event => {
  if (!isHeld) return;
  sendMove();
  isHeld = false;
  send({t: 'up', ...at(event)});
});
function letGo() {
  if (isHeld) send({t: 'cancel'});
  isHeld = false;
}
stage.addEventListener('pointercancel', letGo);
window.addEventListener('blur', letGo);
stage.addEventListener('contextmenu', event => event.preventDefault());
stage.addEventListener('wheel', event => {
  if (event.ctrlKey || !panel) return;
  event.preventDefault();
  send({t: 'wheel', ...at(event), n: Math.max(-10, Math.min(10, -event.deltaY / 100))});
}, {passive: false});
window.addEventListener('keydown', event => {
  if (byId('login').open || event.ctrlKey || event.metaKey || event.altKey) return;
  if (document.activeElement && document.activeElement.tagName === 'SELECT') return;
  const isOnButton = document.activeElement && document.activeElement.tagName === 'BUTTON';
  if (isOnButton && (event.key === 'Enter' || event.key === ' ')) return;
  if (event.key.length === 1 || ['Enter', 'Backspace', 'Escape'].includes(event.key)) send({t: 'key', text: event.key});
});

// ---- panel, language, login

byId('panels').addEventListener('change', event => send({t: 'panel', text: event.target.value}));
byId('languages').addEventListener('change', event => send({t: 'language', text: event.target.value}));
byId('log').addEventListener('click', () => {
  if (panel && panel.operator) {
    secret = '';
    return send({t: 'logout'});
  }
  byId('loginNote').textContent = '';
  byId('code').value = '';
  byId('name').value = user;
  byId('login').showModal();
});
byId('loginCancel').addEventListener('click', () => byId('login').close());
byId('login').querySelector('form').addEventListener('submit', event => {
  event.preventDefault();
  secret = byId('code').value;
  user = panel.people ? byId('name').value : '';
  send({t: 'login', text: secret, more: user});
});
function loggedIn(message) {
  if (message.ok) return byId('login').close();
  secret = '';
  byId('loginNote').textContent = message.text;
  note(message.text);
}

window.addEventListener('resize', () => {
  place();
  send({t: 'scale', n: scaleNow()});
});
// For tests: what is on the screen.
window.stepwise = {display, get shown() { return display.shown; }, get panel() { return panel; }, send};
connect();
