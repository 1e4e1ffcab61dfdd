/** The study's road: consent, questions, tutorial, instructions, control question; saved at every step. */
class Study {
  constructor() {
    this.main = document.getElementById("main");
    this.status = document.getElementById("status");
    this.progress = document.getElementById("progress");
    this.token = new URLSearchParams(location.search).get("token") ?? "";
    this.memory = `fuzzytime-study-${this.token}`;
    this.person = null;
    this.curves = {};
  }

  async begin() {
    this.design = await this.ask("GET", "design");
    this.texts = this.design.texts;
    const known = this.recall("participant");
    if (known) {
      try {
        this.arrive(await this.ask("POST", "resume", { participant: known }));
        this.tell(this.texts.resumed);
        return;
      } catch (error) {
        if (!(error instanceof Refused)) throw error;
        this.forget();
      }
    }
    this.consent();
  }

  // -- memory of this browser, which may be switched off ------------------------------------------------------

  recall(key) {
    try { return JSON.parse(localStorage.getItem(this.memory) ?? "{}")[key] ?? null; } catch { return null; }
  }

  keep(key, value) {
    try {
      const all = JSON.parse(localStorage.getItem(this.memory) ?? "{}");
      all[key] = value;
      localStorage.setItem(this.memory, JSON.stringify(all));
    } catch { /* Without it, a reload begins anew. */ }
  }

  forget() {
    try { localStorage.removeItem(this.memory); } catch { /* nothing was kept */ }
  }

  // -- talking to the server ----------------------------------------------------------------------------------

  async ask(method, path, body) {
    const answer = await fetch(`/${path}`, {
      method,
      headers: { "X-Study-Token": this.token, ...(body ? { "Content-Type": "application/json" } : {}) },
      body: body ? JSON.stringify(body) : undefined,
      cache: "no-store",
    });
    const content = await answer.json();
    if (answer.ok) return content;
    if (answer.status >= 500 || answer.status === 429) throw new Error(content.error);
    throw new Refused(content.error);
  }

  /** Saves, and tries again for as long as the server cannot be reached. */
  async save(path, body) {
    const button = this.main.querySelector("button.primary");
    if (button) button.disabled = true;
    for (let wait = 1; ; wait = Math.min(wait * 2, 15)) {
      try {
        this.tell(this.texts.saving);
        const answer = await this.ask("POST", path, body);
        this.tell(this.texts.saved);
        return answer;
      } catch (error) {
        if (error instanceof Refused) {
          if (button) button.disabled = false;
          this.tell(filled(this.texts.refused, { reason: error.message }), true);
          throw error;
        }
        this.tell(this.texts.not_saved, true);
        await new Promise((resolve) => { setTimeout(resolve, wait * 1000); });
      }
    }
  }

  tell(text, warn = false) {
    this.status.textContent = text;
    this.status.className = warn ? "warn" : "";
  }

  say(key, more = {}) {
    return filled(this.texts[key], { actor: this.person ? this.person.actor : "", ...more });
  }

  // -- screens ------------------------------------------------------------------------------------------------

  /** Shows a screen; its form's submission goes to `next`. */
  screen(title, children, label, next, back = null) {
    this.tell("");
    const actions = [
      back ? element("button", { type: "button", onclick: back }, this.texts.back) : element("span"),
      label ? element("button", { class: "primary", type: "submit" }, label) : null,
    ];
    const form = element("form", {
      novalidate: true,
      onsubmit: (event) => {
        event.preventDefault();
        Promise.resolve(next(form)).catch((error) => {
          if (!(error instanceof Refused)) this.tell(String(error.message ?? error), true);
        });
      },
    }, element("h2", {}, title), ...children, element("div", { class: "actions" }, ...actions));
    this.main.replaceChildren(form);
    this.main.focus({ preventScroll: true });
    window.scrollTo(0, 0);
    return form;
  }

  arrive(person) {
    this.person = person;
    this.curves = person.curves;
    this.keep("participant", person.participant);
    if (person.finished) this.thanks();
    else if (!person.begun && !Object.keys(person.curves).length) this.demographics();
    else this.proceed();
  }

  proceed() {
    const open = this.person.order.findIndex((key) => !(key in this.curves));
    if (open >= 0) this.task(open);
    else this.control();
  }

  consent() {
    const agree = element("input", { type: "checkbox", required: true });
    const form = this.screen(this.texts.consent_title, [
      element("p", {}, this.texts.consent),
      element("label", { class: "choice" }, agree, this.texts.consent_agree),
    ], this.texts.begin, async () => {
      if (!agree.checked) return;
      this.arrive(await this.save("join", { consent: true }));
    });
    const button = form.querySelector("button.primary");
    button.disabled = true;
    agree.addEventListener("change", () => { button.disabled = !agree.checked; });
  }

  demographics() {
    if (!this.design.demographics.length) { this.tutorial(); return; }
    const fields = this.design.demographics.map((question) => this.question(question));
    this.screen(this.texts.demographics_title,
      [element("p", { class: "hint" }, this.texts.demographics), ...fields], this.texts.next, async (form) => {
        const answers = {};
        for (const question of this.design.demographics) {
          const field = form.elements.namedItem(question.key);
          answers[question.key] = field ? field.value : "";
        }
        await this.save("demographics", { participant: this.person.participant, answers });
        this.tutorial();
      });
  }

  question(question) {
    if (question.choices.length) {
      const choice = (value, text) => element("label", { class: "choice" },
        element("input", { type: "radio", name: question.key, value, checked: value === "" }), text);
      return element("fieldset", {}, element("legend", {}, question.ask),
        ...question.choices.map((text) => choice(text, text)), choice("", this.texts.no_answer));
    }
    const input = question.whole
      ? { type: "number", min: String(question.whole[0]), max: String(question.whole[1]), inputmode: "numeric" }
      : { type: "text", maxlength: String(question.length) };
    return element("label", {}, question.ask,
      element("input", { ...input, name: question.key, autocomplete: "off" }));
  }

  drawing(changed) {
    return new Drawing(this.design.timeline, this.design.default, this.texts, changed);
  }

  tutorial() {
    const drawing = this.drawing(() => {});
    const steps = this.texts.tutorial_steps.map((text) => element("li", {}, filled(text, this.person)));
    this.screen(this.texts.scenario_title, [
      element("p", {}, this.say("scenario")),
      element("h2", {}, this.texts.tutorial_title),
      element("p", {}, this.say("tutorial")),
      element("ol", {}, ...steps),
      element("p", { class: "instruction" }, this.say("tutorial_example")),
      drawing.root,
    ], this.texts.next, () => this.proceed());
  }

  task(position) {
    const key = this.person.order[position];
    const words = { done: position + 1, all: this.person.order.length };
    const drafts = this.recall("drafts") ?? {};
    const drawing = this.drawing(() => this.keep("drafts", { [key]: drawing.rounded() }));
    const before = this.curves[key] ?? drafts[key];
    if (before && before.length === this.design.timeline.samples) drawing.load(before);
    this.progress.hidden = false;
    this.progress.max = this.person.order.length + 1;
    this.progress.value = position;
    let warned = false;
    this.screen(this.say("task_title", words), [
      element("p", { class: "instruction" }, filled(this.design.instructions[key], this.person)),
      element("p", {}, this.say("task")),
      drawing.root,
    ], this.texts.next, async () => {
      if (!drawing.values.some((value) => value > 0) && !warned) {
        warned = true;
        this.tell(this.texts.nothing_drawn, true);
        return;
      }
      const values = drawing.rounded();
      await this.save("curve", { participant: this.person.participant, instruction: key, values });
      this.curves[key] = values;
      this.keep("drafts", {});
      if (position + 1 < this.person.order.length) this.task(position + 1);
      else this.proceed();
    }, position > 0 ? () => this.task(position - 1) : null);
  }

  control() {
    const control = this.design.control;
    if (!control) { this.finish(); return; }
    this.progress.hidden = false;
    this.progress.max = this.person.order.length + 1;
    this.progress.value = this.person.order.length;
    const points = Array.from({ length: control.points }, (_, i) => String(i + 1));
    const scale = points.map((point) => element("label", {},
      element("input", { type: "radio", name: "control", value: point, required: true }), point));
    const form = this.screen(this.texts.control_title, [
      element("fieldset", {}, element("legend", { class: "instruction" }, filled(control.text, this.person)),
        element("div", { class: "scale" }, element("span", { class: "hint" }, control.lowest), ...scale,
          element("span", { class: "hint" }, control.highest))),
    ], this.texts.next, async () => {
      const chosen = form.elements.namedItem("control").value;
      if (!chosen) return;
      await this.save("control", { participant: this.person.participant, answer: Number(chosen) });
      await this.finish();
    }, this.person.order.length ? () => this.task(this.person.order.length - 1) : null);
  }

  async finish() {
    await this.save("finish", { participant: this.person.participant });
    this.thanks();
  }

  thanks() {
    this.progress.hidden = true;
    this.screen(this.texts.thanks_title, [element("p", {}, this.texts.thanks)], this.texts.another, () => {
      this.forget();
      this.person = null;
      this.curves = {};
      this.consent();
    });
  }
}

class Refused extends Error {}

{
  const study = new Study();
  study.begin().catch((error) => study.tell(String(error.message ?? error), true));
}
