/** The study's road: consent, questions, tutorial, instructions, control question; saved at every step. */
class Study {
  constructor() {
    this.main = document.getElementById("main");
    this.status = document.getElementById("status");
    this.progress = document.getElementById("progress");
    const token = new URLSearchParams(location.search).get("token") ?? "";
    this.server = new Server(token);
    this.memory = new Memory(`fuzzytime-study-${token}`);
    this.person = null;
    this.curves = {};
    this.shown = null;
    this.goBack = null;
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { if (this.shown) this.shown.paint(); });
    window.addEventListener("popstate", (event) => this.wentBack(event));
    // The second click of a double click was not meant for what the first one brought.
    this.moved = this.clicked = 0;
    this.main.addEventListener("click", (event) => {
      if (event.detail < 2) this.clicked = event.timeStamp;
      else if (this.clicked < this.moved) {
        event.preventDefault();
        event.stopPropagation();
      }
    }, true);
  }

  async begin() {
    this.design = await this.server.ask("GET", "design");
    this.texts = this.design.texts;
    const known = this.memory.recall("participant");
    if (known) {
      try {
        this.arrive(await this.server.ask("POST", "resume", { participant: known }));
        if (!this.person.finished) this.tell(this.texts.resumed, { offer: this.anewButton() });
        return;
      } catch (error) {
        if (!(error instanceof Refused)) throw error;
        this.memory.forget();
      }
    }
    this.consent();
  }

  /** Saves; until that is done nothing on the page moves. */
  async save(path, body) {
    this.main.inert = true;
    this.tell(this.texts.saving);
    try {
      const answer = await this.server.save(path, body, () => this.tell(this.texts.not_saved, { warn: true }));
      this.tell(this.texts.saved);
      return answer;
    } catch (error) {
      if (error instanceof Refused) {
        this.tell(filled(this.texts.refused, { reason: error.message }), { warn: true });
      }
      throw error;
    } finally {
      this.main.inert = false;
      const button = this.main.querySelector("button.primary");
      if (button) button.focus({ preventScroll: true });
    }
  }

  tell(text, { warn = false, offer = null } = {}) {
    this.status.replaceChildren(...(text ? [text] : []), ...(offer ? [" ", offer] : []));
    this.status.className = warn ? "warn" : "";
    if (!warn) return;
    this.moved = performance.now();
    window.scrollTo(0, document.body.scrollHeight);
  }

  say(key, more = {}) {
    return filled(this.texts[key], { actor: this.person ? this.person.actor : "", ...more });
  }

  // -- screens ------------------------------------------------------------------------------------------------

  /** Shows a screen; its form's submission goes to `next`, Back on it and of the browser to `back`. */
  screen(title, children, label, next, back = null) {
    this.tell("");
    this.moved = performance.now();
    this.goBack = back;
    if (back) this.holdBack();
    const actions = [
      back ? element("button", { type: "button", onclick: back }, this.texts.back) : element("span"),
      element("button", { class: "primary", type: "submit" }, label),
    ];
    const form = element("form", {
      novalidate: true,
      onsubmit: (event) => {
        event.preventDefault();
        Promise.resolve(next(form)).catch((error) => {
          if (!(error instanceof Refused)) this.tell(String(error.message ?? error), { warn: true });
        });
      },
    }, element("h2", {}, title), ...children, element("div", { class: "actions" }, ...actions));
    this.main.replaceChildren(form);
    this.main.focus({ preventScroll: true });
    window.scrollTo(0, 0);
    return form;
  }

  /** Puts an entry of the page's own into the browser's history, which its Back takes away first. */
  holdBack() {
    if (!history.state) history.pushState({ inside: true }, "");
  }

  wentBack(event) {
    if (event.state || !this.goBack) return;
    if (this.main.inert) this.holdBack();
    else this.goBack();
  }

  arrive(person) {
    this.person = person;
    this.curves = person.curves;
    this.memory.keep("participant", person.participant);
    const seen = this.memory.recall("seen") ?? [];
    if (person.finished) this.thanks();
    else if (Object.keys(person.curves).length || seen.includes("tutorial")) this.proceed();
    else if (person.begun || seen.includes("demographics")) this.tutorial();
    else this.demographics();
  }

  hasSeen(screen) {
    this.memory.keep("seen", [...(this.memory.recall("seen") ?? []), screen]);
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
          if (question.whole && !field.validity.valid) {
            const [low, high] = question.whole;
            this.tell(filled(this.texts.whole_wrong, { low, high }), { warn: true });
            field.focus();
            return;
          }
          answers[question.key] = field ? field.value : "";
        }
        await this.save("demographics", { participant: this.person.participant, answers });
        this.hasSeen("demographics");
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
    this.shown = new Drawing(this.design.timeline, this.design.default, this.texts, changed);
    return this.shown;
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
    ], this.texts.next, () => {
      this.hasSeen("tutorial");
      this.proceed();
    });
  }

  task(position) {
    const key = this.person.order[position];
    const words = { done: position + 1, all: this.person.order.length };
    const drafts = () => this.memory.recall("drafts") ?? {};
    const drawing = this.drawing(() => {
      this.tell("");
      this.memory.keep("drafts", { ...drafts(), [key]: drawing.rounded() });
    });
    const before = drafts()[key] ?? this.curves[key];
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
      if (drawing.points.waiting && !drawing.points.apply()) return;
      if (!drawing.values.some((value) => value > 0) && !warned) {
        warned = true;
        this.tell(this.texts.nothing_drawn, { warn: true });
        return;
      }
      const values = drawing.rounded();
      await this.save("curve", { participant: this.person.participant, instruction: key, values });
      this.curves[key] = values;
      this.memory.keep("drafts", { ...drafts(), [key]: undefined });
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
        element("div", { class: "scale" }, ...scale),
        element("div", { class: "ends hint" }, element("span", {}, control.lowest),
          element("span", {}, control.highest))),
    ], this.texts.next, async () => {
      const chosen = form.elements.namedItem("control").value;
      if (!chosen) {
        this.tell(this.texts.choose, { warn: true });
        return;
      }
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
    this.screen(this.texts.thanks_title, [element("p", {}, this.texts.thanks)], this.texts.another, () => this.anew());
  }

  anew() {
    this.memory.forget();
    this.person = null;
    this.curves = {};
    this.progress.hidden = true;
    this.consent();
  }

  anewButton() {
    return element("button", { type: "button", onclick: () => this.anew() }, this.texts.another);
  }
}

{
  const study = new Study();
  study.begin().catch((error) => study.tell(String(error.message ?? error), { warn: true }));
}
