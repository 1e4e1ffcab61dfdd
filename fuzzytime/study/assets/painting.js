/** Paints a drawing: the curve within its window, and the whole timeline below it. */
class Painter {
  static PADDING = { left: 52, right: 28, top: 18, bottom: 52 };

  constructor(timeline, texts) {
    this.timeline = timeline;
    this.texts = texts;
  }

  minutes(time) {
    return filled(this.texts.minutes, { minutes: Math.round(time / 6) / 10 });
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
    const style = getComputedStyle(canvas);
    return [pen, box.width, box.height, (name) => style.getPropertyValue(`--${name}`)];
  }

  trace(pen, drawing, x, y, from, to) {
    const { start } = this.timeline;
    const low = Math.max(0, Math.floor((from - start) / drawing.step));
    const high = Math.min(this.timeline.samples - 1, Math.ceil((to - start) / drawing.step));
    pen.beginPath();
    for (let i = low; i <= high; i += 1) pen.lineTo(x(start + i * drawing.step), y(drawing.values[i]));
    return [x(start + low * drawing.step), x(start + high * drawing.step)];
  }

  line(pen, colour, from, to) {
    pen.strokeStyle = colour;
    pen.beginPath();
    pen.moveTo(...from);
    pen.lineTo(...to);
    pen.stroke();
  }

  paintCurve(drawing, canvas) {
    const [pen, width, height, colour] = this.surface(canvas);
    const { first, span } = drawing;
    const pad = Painter.PADDING;
    const [right, bottom] = [width - pad.right, height - pad.bottom];
    const x = (time) => pad.left + ((time - first) / span) * (right - pad.left);
    const y = (value) => pad.top + (1 - value) * (bottom - pad.top);
    pen.lineWidth = 1;
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    pen.fillStyle = colour("soft");
    for (const value of [0, 0.25, 0.5, 0.75, 1]) {
      this.line(pen, colour(value % 1 ? "grid" : "axis"), [pad.left, y(value)], [right, y(value)]);
      pen.fillText(`${value * 100} %`, pad.left - 6, y(value));
    }
    const room = (right - pad.left) / 40;
    const stride = [0.5, 1, 2, 5, 10, 15, 30, 60, 120, 240].find((size) => span / 60 / size <= room) ?? 480;
    pen.textAlign = "center";
    const last = (first + span) / 60 + 1e-9;
    for (let minute = Math.ceil(first / 60 / stride) * stride; minute <= last; minute += stride) {
      this.line(pen, colour("grid"), [x(minute * 60), pad.top], [x(minute * 60), bottom]);
      pen.fillText(String(Math.round(minute * 10) / 10), x(minute * 60), bottom + 14);
    }
    pen.fillText(this.texts.axis_time, (pad.left + right) / 2, bottom + 36, right - pad.left);
    pen.textAlign = "left";
    pen.fillStyle = colour("faint");
    pen.fillText(this.texts.full, pad.left + 6, y(1) + 10);
    pen.fillText(this.texts.none, pad.left + 6, y(0) - 10);
    pen.save();
    pen.beginPath();
    pen.rect(pad.left - 2, 0, right - pad.left + 4, height);
    pen.clip();
    const [from, to] = this.trace(pen, drawing, x, y, first, first + span);
    pen.strokeStyle = colour("accent");
    pen.lineWidth = 2.5;
    pen.lineJoin = "round";
    pen.stroke();
    pen.lineTo(to, y(0));
    pen.lineTo(from, y(0));
    pen.fillStyle = colour("area");
    pen.fill();
    if (drawing.pen) {
      pen.strokeStyle = colour("pen");
      pen.lineWidth = 2;
      pen.beginPath();
      pen.arc(x(drawing.pen.time), y(drawing.pen.value), 7, 0, 2 * Math.PI);
      pen.stroke();
    }
    pen.restore();
  }

  paintOverview(drawing, canvas) {
    const [pen, width, height, colour] = this.surface(canvas);
    const { start, end } = this.timeline;
    const x = (time) => ((time - start) / (end - start)) * width;
    const y = (value) => 6 + (1 - value) * (height - 24);
    const [left, right] = [x(drawing.first), x(drawing.first + drawing.span)];
    pen.fillStyle = colour("window");
    pen.fillRect(left, 0, right - left, height);
    this.trace(pen, drawing, x, y, start, end);
    pen.strokeStyle = colour("accent");
    pen.lineWidth = 1.5;
    pen.stroke();
    pen.lineWidth = 2;
    pen.strokeRect(left + 1, 1, right - left - 2, height - 2);
    pen.fillStyle = colour("soft");
    pen.textBaseline = "alphabetic";
    const parts = width < 420 ? 2 : 4;
    const stride = (end - start) / parts;
    for (let i = 0; i <= parts; i += 1) {
      pen.textAlign = i === 0 ? "left" : i === parts ? "right" : "center";
      const inset = i === 0 ? 5 : i === parts ? -5 : 0;
      pen.fillText(this.minutes(start + i * stride), x(start + i * stride) + inset, height - 5);
    }
  }
}
