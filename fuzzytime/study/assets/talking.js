/** What this browser remembers of a study; where it may not store anything, until the page is left. */
class Memory {
  constructor(name) {
    this.name = name;
    this.all = {};
    try { this.all = JSON.parse(localStorage.getItem(name)) ?? {}; } catch { /* Without it, a reload begins anew. */ }
  }

  recall(key) { return this.all[key] ?? null; }

  keep(key, value) {
    this.all[key] = value;
    try { localStorage.setItem(this.name, JSON.stringify(this.all)); } catch { /* as above */ }
  }

  forget() {
    this.all = {};
    try { localStorage.removeItem(this.name); } catch { /* nothing was kept */ }
  }
}

/** What the study did not accept, and why. */
class Refused extends Error {}

/** The study's server, for those who know its token. */
class Server {
  constructor(token) { this.token = token; }

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

  /** Posts, and tries again for as long as the server cannot be reached; `waiting` is called before each pause. */
  async save(path, body, waiting) {
    for (let wait = 1; ; wait = Math.min(wait * 2, 15)) {
      try {
        return await this.ask("POST", path, body);
      } catch (error) {
        if (error instanceof Refused) throw error;
        waiting();
        await new Promise((resolve) => { setTimeout(resolve, wait * 1000); });
      }
    }
  }
}
