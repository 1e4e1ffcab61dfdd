/** A table of points, for those who would rather write a curve down than draw it. */
class PointTable {
  /** Calls `draw` with points ({time, value}, ascending) and `tell` with what is wrong with them. */
  constructor(timeline, texts, draw, tell) {
    this.timeline = timeline;
    this.texts = texts;
    this.draw = draw;
    this.tell = tell;
    /** Whether something was written since the points were drawn. */
    this.waiting = false;
    this.rows = element("div", {
      class: "points",
      oninput: () => { this.waiting = true; },
      onkeydown: (event) => {
        if (event.key !== "Enter" || event.target.tagName !== "INPUT") return;
        event.preventDefault();
        this.apply();
      },
    }, element("span", {}, texts.points_minutes), element("span", {}, texts.points_percent), element("span"));
    this.add();
    this.add();
    const button = (text, act) => element("button", { type: "button", onclick: act }, text);
    this.root = element("details", {}, element("summary", {}, texts.points_title),
      element("p", { class: "hint" }, texts.points), this.rows,
      element("div", { class: "tools" }, button(texts.points_add, () => this.add()),
        button(texts.points_apply, () => this.apply())));
  }

  add() {
    const number = (label, low, high) => element("input", {
      type: "number", min: String(low), max: String(high), step: "any", "aria-label": label,
    });
    const { start, end } = this.timeline;
    const row = [number(this.texts.points_minutes, start / 60, end / 60), number(this.texts.points_percent, 0, 100)];
    const gone = element("button", {
      type: "button",
      onclick: () => {
        this.waiting = true;
        for (const part of [...row, gone]) part.remove();
      },
    }, this.texts.points_remove);
    this.rows.append(...row, gone);
  }

  /** Draws what is written, and says whether it could. */
  apply() {
    const inputs = [...this.rows.querySelectorAll("input")];
    const points = [];
    for (let i = 0; i < inputs.length; i += 2) {
      const [minutes, percent] = inputs.slice(i, i + 2);
      const isEmpty = [minutes, percent].every((input) => input.value === "" && !input.validity.badInput);
      if (!isEmpty) points.push({ time: minutes.valueAsNumber * 60, value: percent.valueAsNumber / 100 });
    }
    const { start, end } = this.timeline;
    const fits = (p) => p.time >= start && p.time <= end && p.value >= 0 && p.value <= 1;
    if (!points.length || !points.every(fits)) {
      this.tell(filled(this.texts.points_wrong, { low: start / 60, high: end / 60 }));
      return false;
    }
    points.sort((one, other) => one.time - other.time);
    this.draw(points);
    this.waiting = false;
    return true;
  }
}
