/** A satisfaction function that a person draws: a canvas, its timeline, a pen for the keyboard, a table of points. */
class Drawing {
  static SHARES = [1 / 12, 1 / 4, 1 / 2, 1];

  constructor(timeline, initial, texts, changed) {
    this.timeline = timeline;
    this.texts = texts;
    this.changed = changed;
    this.step = (timeline.end - timeline.start) / timeline.samples;
    this.initial = initial;
    this.values = new Float64Array(timeline.samples).fill(initial);
    this.past = [];
    this.zoom = 1;
    this.first = timeline.start;
    this.pen = null;
    this.last = null;
    this.pointer = null; // Of the finger, pen or mouse that draws: a second finger is none.
    this.painter = new Painter(timeline, texts);
    this.points = new PointTable(timeline, texts, (points) => this.drawPoints(points), (text) => this.tell(text));
    this.build();
    new ResizeObserver(() => this.paint()).observe(this.canvas);
  }

  get lastTime() {
    return this.timeline.start + this.step * (this.timeline.samples - 1);
  }

  get span() {
    return (this.timeline.end - this.timeline.start) * Drawing.SHARES[this.zoom];
  }

  build() {
    const t = this.texts;
    this.canvas = element("canvas", { class: "curve", tabindex: "0", role: "application", "aria-label": t.canvas });
    this.overview = element("canvas", {
      class: "overview", tabindex: "0", role: "slider", "aria-label": t.overview,
      "aria-valuemin": String(this.timeline.start / 60), "aria-valuemax": String(this.timeline.end / 60),
    });
    this.readout = element("p", { class: "readout", role: "status", "aria-live": "polite" });
    const button = (text, act) => element("button", { type: "button", onclick: act }, text);
    this.undoButton = button(t.undo, () => this.undo());
    this.clearButton = button(t.clear, () => this.clear());
    this.lessButton = button(t.show_less, () => this.show(this.zoom - 1));
    this.moreButton = button(t.show_more, () => this.show(this.zoom + 1));
    const tools = element("div", { class: "tools" }, this.undoButton, this.clearButton,
      element("span", { class: "gap" }), button("◀ " + t.earlier, () => this.move(-this.span / 2)),
      button(t.later + " ▶", () => this.move(this.span / 2)), this.lessButton, this.moreButton);
    this.root = element("div", { class: "drawing" }, this.canvas, this.overview, this.readout, tools, this.points.root);
    this.listen();
  }

  listen() {
    const canvas = this.canvas;
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button > 0 || this.pointer !== null) return;
      event.preventDefault();
      canvas.focus({ preventScroll: true });
      canvas.setPointerCapture(event.pointerId);
      this.remember();
      this.pointer = event.pointerId;
      this.last = this.pen = null;
      this.draw(event);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (event.pointerId !== this.pointer) return;
      const passed = event.getCoalescedEvents ? event.getCoalescedEvents() : [];
      for (const point of passed.length ? passed : [event]) this.draw(point);
    });
    const end = (event) => {
      if (event.pointerId !== this.pointer) return;
      if (event.type === "pointerup") this.draw(event);
      this.pointer = null;
      this.changed();
      this.paint();
    };
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, end);
    canvas.addEventListener("keydown", (event) => this.key(event));
    let held = false;
    const grab = (event) => {
      const box = this.overview.getBoundingClientRect();
      const share = (event.clientX - box.left) / box.width;
      this.lookAt(this.timeline.start + share * (this.timeline.end - this.timeline.start) - this.span / 2);
    };
    this.overview.addEventListener("pointerdown", (event) => {
      held = true;
      this.overview.setPointerCapture(event.pointerId);
      grab(event);
    });
    this.overview.addEventListener("pointermove", (event) => { if (held) grab(event); });
    for (const name of ["pointerup", "pointercancel"]) this.overview.addEventListener(name, () => { held = false; });
    this.overview.addEventListener("keydown", (event) => {
      const moves = { ArrowLeft: -1 / 4, ArrowRight: 1 / 4, PageUp: -1, PageDown: 1 };
      if (!(event.key in moves)) return;
      event.preventDefault();
      this.move(moves[event.key] * this.span);
    });
  }

  // -- the curve ------------------------------------------------------------------------------------------

  remember() {
    this.past.push(this.values.slice());
    if (this.past.length > 100) this.past.shift();
  }

  draw(event) {
    const box = this.canvas.getBoundingClientRect();
    const pad = Painter.PADDING;
    const across = (event.clientX - box.left - pad.left) / (box.width - pad.left - pad.right);
    const down = (event.clientY - box.top - pad.top) / (box.height - pad.top - pad.bottom);
    // Outside the canvas the curve goes along its edge: nobody draws what cannot be seen.
    this.lineTo(this.first + between(0, across, 1) * this.span, between(0, 1 - down, 1));
  }

  /** Draws on from the last point: every sample on the way gets its value, also where the pointer jumped. */
  lineTo(time, value) {
    const here = { time: between(this.timeline.start, time, this.lastTime), value };
    const from = this.last === null ? here : this.last;
    const [low, high] = from.time <= here.time ? [from, here] : [here, from];
    const position = (at) => (at - this.timeline.start) / this.step;
    for (let i = Math.ceil(position(low.time) - 1e-9); i <= position(high.time) + 1e-9; i += 1) {
      const at = this.timeline.start + i * this.step;
      const share = high.time > low.time ? (at - low.time) / (high.time - low.time) : 1;
      this.values[i] = low.value + (high.value - low.value) * between(0, share, 1);
    }
    this.values[Math.round(position(here.time))] = here.value;
    this.last = here;
    this.points.waiting = false;
    this.say(here.time, here.value);
    this.paint();
  }

  drawPoints(points) {
    this.remember();
    this.values.fill(0);
    this.last = null;
    for (const point of points) this.lineTo(point.time, point.value);
    this.last = this.pen = null;
    this.changed();
    this.paint();
  }

  say(time, value) {
    const words = { minutes: (time / 60).toFixed(1), percent: Math.round(value * 100) };
    this.tell(filled(this.texts.pen, words));
  }

  tell(text) { this.readout.textContent = text; }

  undo() {
    if (!this.past.length) return;
    this.values = this.past.pop();
    this.last = this.pen = null;
    this.changed();
    this.paint();
  }

  clear() {
    this.remember();
    this.values.fill(this.initial);
    this.last = this.pen = null;
    this.changed();
    this.paint();
  }

  load(values) {
    this.values = Float64Array.from(values);
    this.paint();
  }

  rounded() {
    return Array.from(this.values, (value) => Math.round(value * 1e4) / 1e4);
  }

  // -- the window -----------------------------------------------------------------------------------------

  show(zoom) {
    const middle = this.first + this.span / 2;
    this.zoom = between(0, zoom, Drawing.SHARES.length - 1);
    this.lookAt(middle - this.span / 2);
  }

  move(by) { this.lookAt(this.first + by); }

  lookAt(first) {
    this.first = between(this.timeline.start, first, this.timeline.end - this.span);
    this.paint();
  }

  key(event) {
    const far = event.shiftKey ? 4 : 1;
    const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.key in moves) {
      event.preventDefault();
      const [across, up] = moves[event.key];
      const pen = this.pen ?? { time: this.first, value: 0.5 };
      const stride = Math.max(1, Math.round(this.span / 60 / this.step)) * this.step * far;
      pen.time = between(this.timeline.start, pen.time + across * stride, this.lastTime);
      pen.value = between(0, Math.round((pen.value + up * 0.05 * far) * 100) / 100, 1);
      this.pen = pen;
      if (pen.time < this.first) this.first = Math.max(this.timeline.start, pen.time - this.span / 4);
      if (pen.time > this.first + this.span) {
        this.first = Math.min(this.timeline.end - this.span, pen.time - (3 / 4) * this.span);
      }
      this.say(pen.time, pen.value);
      this.paint();
    } else if ((event.key === "Enter" || event.key === " ") && this.pen) {
      event.preventDefault();
      this.remember();
      this.lineTo(this.pen.time, this.pen.value);
      this.changed();
    } else if (event.key === "Escape") {
      this.last = this.pen = null;
      this.paint();
    } else if (event.key.toLowerCase() === "z" && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      this.undo();
    }
  }

  // -- painting ---------------------------------------------------------------------------------------------

  paint() {
    this.undoButton.disabled = !this.past.length;
    this.lessButton.disabled = this.zoom === 0;
    this.moreButton.disabled = this.zoom === Drawing.SHARES.length - 1;
    this.overview.setAttribute("aria-valuenow", (this.first / 60).toFixed(1));
    this.overview.setAttribute("aria-valuetext",
      [this.first, this.first + this.span].map((time) => this.painter.minutes(time)).join(" – "));
    this.painter.paintCurve(this, this.canvas);
    this.painter.paintOverview(this, this.overview);
  }
}
