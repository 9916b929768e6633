// The real server and a real browser for tests: starts the program on a recipe in a folder of its own and opens its page
// in Chromium, whose errors are the test's.
import { spawn, type ChildProcess } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { createInterface } from "node:readline";
import { chromium, type Browser, type Page } from "playwright-core";
import type { DocumentAnswer, Recipe } from "../src/api/types";

const root = resolve(process.cwd(), "..");
const program = process.env["SEAMOUNT"] ?? join(root, "build/dev/apps/seamount/seamount");
const browserProgram = process.env["CHROMIUM"] ?? "/usr/bin/chromium";

function freePort(): Promise<number> {
  return new Promise((done, fail) => {
    const probe = createServer();
    probe.once("error", fail);
    probe.listen(0, "127.0.0.1", () => {
      const address = probe.address();
      probe.close(() => (address && typeof address === "object" ? done(address.port) : fail(new Error("no port"))));
    });
  });
}

/** A server on a document in a folder that goes when it ends. */
export class Server {
  readonly folder = mkdtempSync(join(tmpdir(), "seamount-studio-"));
  address = "";
  private process: ChildProcess | null = null;

  /** `files`: what lies beside the document, by name: copies of files of the repository. */
  static async start(recipe: Recipe | null, files: { [name: string]: string } = {}): Promise<Server> {
    const server = new Server();
    mkdirSync(join(server.folder, "work"));
    for (const [name, of] of Object.entries(files)) copyFileSync(join(root, of), join(server.folder, "work", name));
    if (recipe) writeFileSync(join(server.folder, "work/test.json"), JSON.stringify(recipe, null, 2));
    await server.run(recipe !== null);
    return server;
  }

  async run(withRecipe = true): Promise<void> {
    const work = join(this.folder, "work");
    const rest = ["--no-browser", "--no-cache", "--state", join(this.folder, "state"), "--port", String(await freePort())];
    const document = withRecipe ? [join(work, "test.json")] : ["--folder", work];
    this.process = spawn(program, ["studio", ...document, ...rest], { stdio: ["ignore", "pipe", "ignore"] });
    const child = this.process, lines = createInterface({ input: child.stdout! });
    process.once("exit", () => child.kill("SIGKILL"));
    this.address = await new Promise<string>((done, fail) => {
      lines.once("line", done);
      child.once("exit", (code) => fail(new Error(`the server ended with ${code}`)));
    });
    // A test that failed before it ended its server ends all the same.
    lines.close();
    child.stdout!.destroy();
    child.unref();
  }

  kill(): Promise<void> {
    return new Promise((done) => {
      this.process!.once("exit", () => done());
      this.process!.kill("SIGKILL");
    });
  }

  async end(): Promise<void> {
    if (this.process && this.process.exitCode === null) await this.kill();
    rmSync(this.folder, { recursive: true, force: true });
  }

  async request(method: string, path: string, body?: unknown): Promise<Response> {
    const [base, token] = this.address.split("/#") as [string, string];
    return fetch(base + path, {
      method,
      headers: { Authorization: `Bearer ${token}`, "Content-Type": "application/json" },
      ...(body === undefined ? {} : { body: JSON.stringify(body) }),
    });
  }

  async document(): Promise<DocumentAnswer> {
    return (await this.request("GET", "/api/document")).json() as Promise<DocumentAnswer>;
  }
}

/** A recipe of the repository, and the files that it names, to be put beside it. */
export function repositoryRecipe(name: string): { recipe: Recipe; files: { [name: string]: string } } {
  const files: { [name: string]: string } = {};
  const text = readFileSync(join(root, "recipes", name), "utf8").replace(/"[./]*(data\/(?:[^"]*\/)?)([^"/]+)"/g, (_all, folder, file) => {
    files[file] = `${folder}${file}`;
    return `"${file}"`;
  });
  return { recipe: JSON.parse(text) as Recipe, files };
}

/** Without a graphics processor: the terrain is drawn by SwiftShader, the page around it by the browser's own painter. */
export function openBrowser(): Promise<Browser> {
  return chromium.launch({
    executablePath: browserProgram,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing", "--force-color-profile=srgb"],
  });
}

export interface OpenedPage {
  page: Page;
  /** Errors of scripts and of the console, and what the content security policy refused. */
  errors: string[];
}

export async function openPage(
  browser: Browser,
  address: string,
  options: { width?: number; height?: number; dark?: boolean; touch?: boolean } = {},
): Promise<OpenedPage> {
  const context = await browser.newContext({
    viewport: { width: options.width ?? 1280, height: options.height ?? 800 },
    colorScheme: options.dark === false ? "light" : "dark",
    hasTouch: options.touch ?? false,
    reducedMotion: "reduce",
  });
  const page = await context.newPage();
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" && !message.text().startsWith("Failed to load resource")) errors.push(message.text());
  });
  page.on("response", (response) => {
    // A result that was overtaken is gone when it is asked for; text that is being typed is refused.
    const expected = (response.status() === 404 && response.url().includes("/api/values/")) || response.status() === 422;
    if (response.status() >= 400 && !expected) errors.push(`${response.status()} ${response.request().method()} ${response.url()}`);
  });
  await page.goto(address);
  return { page, errors };
}

/** Waits until a question has a true answer; throws after `seconds`. */
export async function until<T>(what: string, ask: () => Promise<T | null | undefined | false>, seconds = 20): Promise<T> {
  const end = Date.now() + 1000 * seconds;
  for (;;) {
    const answer = await ask();
    if (answer) return answer;
    if (Date.now() > end) throw new Error(`not within ${seconds} s: ${what}`);
    await new Promise((done) => setTimeout(done, 20));
  }
}
