// Begins the page: shows what stands in the way, or the studio.
import { render } from "preact";
import type { JSX } from "preact";
import { ApiError } from "../../api/api";
import { lookOnReturn } from "../../document/files_looked";
import { openStudio } from "../../document/open_studio";
import { createClient, takeToken } from "../../api/client";
import type { Api } from "../../api/api";
import { App } from "./app";
import { followWindow } from "./layout";
import { Logo } from "./logo";
import { followTheme } from "./theme";

function Obstacle({ title, children }: { title: string; children: string }) {
  return (
    <div class="obstacle" role="alert">
      <Logo />
      <h1>{title}</h1>
      <p class="muted">{children}</p>
      <button class="primary" onClick={() => location.reload()}>Try again</button>
    </div>
  );
}

export async function start(root: HTMLElement, api: Api | null): Promise<void> {
  followTheme(document.documentElement);
  followWindow();
  const show = (page: JSX.Element): void => {
    root.replaceChildren();  // what the page says until then
    render(page, root);
  };
  if (!api) {
    const words = "Open the address that 'seamount studio' has printed: it carries the key to this studio.";
    return show(<Obstacle title="This window has no key">{words}</Obstacle>);
  }
  try {
    const studio = await openStudio(api);
    lookOnReturn(api, window);
    show(<App studio={studio} />);
  } catch (error) {
    const refused = error instanceof ApiError && error.status === 401;
    const words = refused
      ? "The studio was started anew since this window was opened. Open the address that it has printed."
      : "The studio's server does not answer. Is 'seamount studio' still running?";
    show(<Obstacle title={refused ? "This key is an old one" : "No answer"}>{words}</Obstacle>);
  }
}

export function startWithServer(root: HTMLElement): Promise<void> {
  const token = takeToken(location, history, sessionStorage);
  return start(root, token === null ? null : createClient(token));
}
