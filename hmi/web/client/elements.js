// The elements of a panel as the painter (paint.js) keeps them: their commands, and which of them stay while others change.
'use strict';

const kCalm = 16; // updates after which a command counts as one that stays
const kDear = 6;  // microseconds that a picture in place of commands must save

/// Neighbouring commands that all change, or all stay.
class Run {
  constructor(begin, end, stays) {
    this.begin = begin;
    this.end = end;
    this.stays = stays;
    this.forget();
  }
  forget() {
    this.cost = -1;
    this.key = null;
    this.look = undefined;
  }

  isDear(commands) {
    if (this.cost >= 0) return this.cost >= kDear;
    this.cost = 0;
    for (let i = this.begin; i < this.end; ++i) this.cost += commands[i].cost;
    return this.cost >= kDear;
  }

  /// What it needs of the state before it, what it leaves behind, and a key of all that it does.
  describe(commands) {
    const sets = new State(), needs = new Set();
    for (const part in sets) sets[part] = null;
    this.anchor = null;
    this.isFixed = false; // draws at places that do not move with the first transform
    let key = '', hasDrawn = false;
    for (let i = this.begin; i < this.end; ++i) {
      const one = commands[i];
      if (one.part === 'transform' && (sets.transform || hasDrawn || one.value[0] !== 1 || one.value[3] !== 1)) this.isFixed = true;
      if (one.part !== 'transform' || this.isFixed) key += one.id + ',';
      if (one.part === 'clip') this.isFixed = true;
      if (one.part) {
        sets[one.part] = one;
        if (one.part === 'transform' && !this.isFixed) this.anchor = one;
        continue;
      }
      hasDrawn = true;
      for (const part of one.usesBrush ? kParts : kPartsOfPens) if (!sets[part]) needs.add(part);
    }
    if (needs.has('transform')) this.anchor = null;
    this.sets = Object.keys(sets).filter(part => sets[part]).map(part => sets[part]);
    this.needs = [...needs].filter(part => part !== 'transform');
    this.key = key;
  }
}
const kPartsOfPens = ['transform', 'pen', 'opacity', 'crisp', 'clip'], kParts = ['brush', ...kPartsOfPens];

/// One element: its commands, in runs.
class Element {
  constructor() {
    this.bounds = null;
    this.area = null;
    this.isShown = false;
    this.commands = [];
    this.changed = []; // by command: in which update
    this.updates = 0;
    this.runs = null;
    this.leaveGround();
  }

  /// Its first commands may be part of the ground, which is painted once.
  leaveGround() {
    this.grounded = 0;
    this.after = null; // the state then
  }

  /// After `kept` commands, `removed` ones give way to the new ones.
  begin() {
    this.isUprooted = false;
    this.isWhole = this.commands.length === 0;
    this.at = 0;
    ++this.updates;
    if (this.updates % kCalm === 0) this.runs = null;
  }
  replace(kept, removed, commands) {
    if (this.at + kept < this.grounded) this.isUprooted = true;
    const at = this.at += kept, count = commands.length, when = this.isWhole ? -kCalm : this.updates;
    if (removed === count) {
      for (let i = 0; i < count; ++i) {
        this.commands[at + i] = commands[i];
        if (this.updates - this.changed[at + i] >= kCalm) this.runs = null; // it had stayed until now
        this.changed[at + i] = when;
      }
    } else {
      this.commands.splice(at, removed, ...commands);
      this.changed.splice(at, removed, ...commands.map(() => when));
      this.runs = null;
    }
    this.at += count;
  }
  end() {
    if (this.runs) for (const run of this.runs) if (!run.stays) run.forget();
  }

  runsNow() {
    if (this.runs) return this.runs;
    this.runs = [];
    const stays = i => this.updates - this.changed[i] >= kCalm;
    for (let begin = 0, end = 0; begin < this.commands.length; begin = end) {
      const isStill = stays(begin);
      for (end = begin + 1; end < this.commands.length && stays(end) === isStill;) ++end;
      this.runs.push(new Run(begin, end, isStill));
    }
    return this.runs;
  }
}
