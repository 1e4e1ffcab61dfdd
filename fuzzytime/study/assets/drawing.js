"use strict";

/** Makes an element; texts become text, never markup. */
function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name in made && typeof value !== "string") made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

function filled(text, words) {
  return text.replace(/\{(\w+)\}/g, (whole, name) => (name in words ? String(words[name]) : whole));
}

/** A satisfaction function that a person draws: a canvas, its timeline, a pen for the keyboard, a table of points. */
class Drawing {
  static PADDING = { left: 52, right: 28, top: 18, bottom: 34 };
  static SHARES = [1 / 12, 1 / 4, 1 / 2, 1];

  constructor(timeline, initial, texts, changed) {
    this.timeline = timeline;
    this.texts = texts;
    this.changed = changed;
    this.step = (timeline.end - timeline.start) / timeline.samples;
    this.initial = initial;
    this.values = new Float64Array(timeline.samples).fill(initial);
    this.past = [];
    this.touched = false;
    this.zoom = 1;
    this.first = timeline.start;
    this.pen = null;
    this.last = null;
    this.dragging = false;
    this.build();
    this.observer = new ResizeObserver(() => this.paint());
    this.observer.observe(this.canvas);
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
    this.root = element("div", { class: "drawing" }, this.canvas, this.overview, this.readout, tools, this.table());
    this.listen();
  }

  listen() {
    const canvas = this.canvas;
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button > 0 || this.dragging) return;
      event.preventDefault();
      canvas.focus({ preventScroll: true });
      canvas.setPointerCapture(event.pointerId);
      this.remember();
      this.dragging = true;
      this.last = this.pen = null;
      this.draw(event);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!this.dragging) return;
      const passed = event.getCoalescedEvents ? event.getCoalescedEvents() : [];
      for (const point of passed.length ? passed : [event]) this.draw(point);
    });
    const end = () => {
      if (!this.dragging) return;
      this.dragging = false;
      this.changed();
      this.paint();
    };
    canvas.addEventListener("pointerup", (event) => { if (this.dragging) this.draw(event); end(); });
    canvas.addEventListener("pointercancel", end);
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
    const pad = Drawing.PADDING;
    const across = (event.clientX - box.left - pad.left) / (box.width - pad.left - pad.right);
    const down = (event.clientY - box.top - pad.top) / (box.height - pad.top - pad.bottom);
    this.lineTo(this.first + across * this.span, 1 - down);
  }

  /** Draws on from the last point: every sample on the way gets its value, also where the pointer jumped. */
  lineTo(time, value) {
    const end = this.timeline.start + this.step * (this.timeline.samples - 1);
    const here = { time: Math.min(Math.max(time, this.timeline.start), end), value: Math.min(Math.max(value, 0), 1) };
    const from = this.last === null ? here : this.last;
    const [low, high] = from.time <= here.time ? [from, here] : [here, from];
    const position = (at) => (at - this.timeline.start) / this.step;
    for (let i = Math.ceil(position(low.time) - 1e-9); i <= position(high.time) + 1e-9; i += 1) {
      const at = this.timeline.start + i * this.step;
      const share = high.time > low.time ? (at - low.time) / (high.time - low.time) : 1;
      this.values[i] = low.value + (high.value - low.value) * Math.min(Math.max(share, 0), 1);
    }
    this.values[Math.round(position(here.time))] = here.value;
    this.last = here;
    this.touched = true;
    this.say(here.time, here.value);
    this.paint();
  }

  say(time, value) {
    const words = { minutes: (time / 60).toFixed(1), percent: Math.round(value * 100) };
    this.readout.textContent = filled(this.texts.pen, words);
  }

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
    this.touched = true;
    this.paint();
  }

  rounded() {
    return Array.from(this.values, (value) => Math.round(value * 1e4) / 1e4);
  }

  // -- the window -----------------------------------------------------------------------------------------

  show(zoom) {
    const middle = this.first + this.span / 2;
    this.zoom = Math.min(Math.max(zoom, 0), Drawing.SHARES.length - 1);
    this.lookAt(middle - this.span / 2);
  }

  move(by) { this.lookAt(this.first + by); }

  lookAt(first) {
    this.first = Math.min(Math.max(first, this.timeline.start), this.timeline.end - this.span);
    this.paint();
  }

  key(event) {
    const far = event.shiftKey ? 4 : 1;
    const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.key in moves) {
      event.preventDefault();
      const [across, up] = moves[event.key];
      const pen = this.pen ?? { time: this.first, value: 0.5 };
      const end = this.timeline.start + this.step * (this.timeline.samples - 1);
      const stride = Math.max(1, Math.round(this.span / 60 / this.step)) * this.step * far;
      pen.time = Math.min(Math.max(pen.time + across * stride, this.timeline.start), end);
      pen.value = Math.min(Math.max(Math.round((pen.value + up * 0.05 * far) * 100) / 100, 0), 1);
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

  // -- the table of points ----------------------------------------------------------------------------------

  table() {
    const t = this.texts;
    const rows = element("div", { class: "points" }, element("span", {}, t.points_minutes),
      element("span", {}, t.points_percent), element("span"));
    const add = (minutes = "", percent = "") => {
      const number = (label, value, high) => element("input", {
        type: "number", min: "0", max: String(high), step: "any", value: String(value), "aria-label": label,
      });
      const row = [number(t.points_minutes, minutes, this.timeline.end / 60), number(t.points_percent, percent, 100)];
      const gone = element("button", {
        type: "button", onclick: () => { for (const part of [...row, gone]) part.remove(); },
      }, t.points_remove);
      rows.append(...row, gone);
    };
    add();
    add();
    return element("details", {}, element("summary", {}, t.points_title), element("p", { class: "hint" }, t.points),
      rows, element("div", { class: "tools" },
        element("button", { type: "button", onclick: () => add() }, t.points_add),
        element("button", { type: "button", onclick: () => this.apply(rows) }, t.points_apply)));
  }

  apply(rows) {
    const inputs = [...rows.querySelectorAll("input")];
    const points = [];
    for (let i = 0; i < inputs.length; i += 2) {
      if (inputs[i].value === "" && inputs[i + 1].value === "") continue;
      points.push({ time: Number(inputs[i].value || NaN) * 60, value: Number(inputs[i + 1].value || NaN) / 100 });
    }
    const { start, end } = this.timeline;
    const fits = (p) => p.time >= start && p.time <= end && p.value >= 0 && p.value <= 1;
    if (!points.length || !points.every(fits)) {
      this.readout.textContent = filled(this.texts.points_wrong, { low: start / 60, high: end / 60 });
      return;
    }
    points.sort((one, other) => one.time - other.time);
    this.remember();
    this.values.fill(0);
    this.last = null;
    for (const point of points) this.lineTo(point.time, point.value);
    this.last = this.pen = null;
    this.changed();
    this.paint();
  }

  // -- painting ---------------------------------------------------------------------------------------------

  paint() {
    this.undoButton.disabled = !this.past.length;
    this.lessButton.disabled = this.zoom === 0;
    this.moreButton.disabled = this.zoom === Drawing.SHARES.length - 1;
    this.overview.setAttribute("aria-valuenow", (this.first / 60).toFixed(1));
    this.overview.setAttribute("aria-valuetext",
      `${(this.first / 60).toFixed(1)}–${((this.first + this.span) / 60).toFixed(1)} min`);
    this.paintCurve();
    this.paintOverview();
  }

  surface(canvas) {
    const box = canvas.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(box.width * ratio), Math.round(box.height * ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const pen = canvas.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, box.width, box.height);
    pen.font = "13px system-ui, sans-serif";
    return [pen, box.width, box.height];
  }

  trace(pen, x, y, from, to) {
    const position = (time) => (time - this.timeline.start) / this.step;
    const low = Math.max(0, Math.floor(position(from)));
    const high = Math.min(this.timeline.samples - 1, Math.ceil(position(to)));
    pen.beginPath();
    for (let i = low; i <= high; i += 1) {
      pen.lineTo(x(this.timeline.start + i * this.step), y(this.values[i]));
    }
    return [x(this.timeline.start + low * this.step), x(this.timeline.start + high * this.step)];
  }

  paintCurve() {
    const [pen, width, height] = this.surface(this.canvas);
    const pad = Drawing.PADDING;
    const x = (time) => pad.left + ((time - this.first) / this.span) * (width - pad.left - pad.right);
    const y = (value) => pad.top + (1 - value) * (height - pad.top - pad.bottom);
    pen.lineWidth = 1;
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    for (const value of [0, 0.25, 0.5, 0.75, 1]) {
      pen.strokeStyle = value % 1 ? "#e6e9ed" : "#aab1bb";
      pen.beginPath();
      pen.moveTo(pad.left, y(value));
      pen.lineTo(width - pad.right, y(value));
      pen.stroke();
      pen.fillStyle = "#59616b";
      pen.fillText(`${value * 100} %`, pad.left - 6, y(value));
    }
    const minutes = this.span / 60;
    const room = (width - pad.left - pad.right) / 54;
    const stride = [0.5, 1, 2, 5, 10, 15, 30, 60, 120, 240].find((size) => minutes / size <= room) ?? 480;
    pen.textAlign = "center";
    for (let minute = Math.ceil(this.first / 60 / stride) * stride;
      minute <= (this.first + this.span) / 60 + 1e-9; minute += stride) {
      pen.strokeStyle = "#e6e9ed";
      pen.beginPath();
      pen.moveTo(x(minute * 60), pad.top);
      pen.lineTo(x(minute * 60), height - pad.bottom);
      pen.stroke();
      pen.fillText(`${Math.round(minute * 10) / 10} min`, x(minute * 60), height - pad.bottom + 14);
    }
    pen.textAlign = "left";
    pen.fillStyle = "#7a828d";
    pen.fillText(this.texts.full, pad.left + 6, y(1) + 10);
    pen.fillText(this.texts.none, pad.left + 6, y(0) - 10);
    pen.save();
    pen.beginPath();
    pen.rect(pad.left - 2, 0, width - pad.left - pad.right + 4, height);
    pen.clip();
    const [from, to] = this.trace(pen, x, y, this.first, this.first + this.span);
    pen.strokeStyle = "#1d5fa8";
    pen.lineWidth = 2.5;
    pen.lineJoin = "round";
    pen.stroke();
    pen.lineTo(to, y(0));
    pen.lineTo(from, y(0));
    pen.fillStyle = "rgba(29, 95, 168, 0.13)";
    pen.fill();
    if (this.pen) {
      pen.strokeStyle = "#b3541e";
      pen.lineWidth = 2;
      pen.beginPath();
      pen.arc(x(this.pen.time), y(this.pen.value), 7, 0, 2 * Math.PI);
      pen.stroke();
    }
    pen.restore();
  }

  paintOverview() {
    const [pen, width, height] = this.surface(this.overview);
    const { start, end } = this.timeline;
    const x = (time) => ((time - start) / (end - start)) * width;
    const y = (value) => 6 + (1 - value) * (height - 24);
    pen.fillStyle = "#dbe8f6";
    pen.fillRect(x(this.first), 0, x(this.first + this.span) - x(this.first), height);
    this.trace(pen, x, y, start, end);
    pen.strokeStyle = "#1d5fa8";
    pen.lineWidth = 1.5;
    pen.stroke();
    pen.strokeStyle = "#1d5fa8";
    pen.lineWidth = 2;
    pen.strokeRect(x(this.first) + 1, 1, x(this.first + this.span) - x(this.first) - 2, height - 2);
    pen.fillStyle = "#59616b";
    pen.textBaseline = "alphabetic";
    const parts = width < 420 ? 2 : 4;
    const stride = (end - start) / parts;
    for (let i = 0; i <= parts; i += 1) {
      pen.textAlign = i === 0 ? "left" : i === parts ? "right" : "center";
      const inset = i === 0 ? 5 : i === parts ? -5 : 0;
      pen.fillText(`${Math.round((start + i * stride) / 6) / 10} min`, x(start + i * stride) + inset, height - 5);
    }
  }
}
