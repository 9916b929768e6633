// The bar at the top: the document and whether it is safe, undo and redo, what is being computed, what leads elsewhere.
import { Search } from "lucide-preact";
import { runAction } from "../../actions/registry";
import { ActionButton, Keys } from "./keys";
import { Logo } from "./logo";
import { Menu } from "./menu";
import { Progress } from "./progress";
import { useStudio } from "./shell";
import { baseName } from "./words";

const kMenu = [
  "file.new", "file.examples", "file.open", "file.import", "-", "file.save", "file.save_as", "file.export", "-",
  "view.theme", "help.shortcuts",
];

export function TopBar() {
  return (
    <header class="top-bar">
      <Menu label="Menu" entries={kMenu}><Logo /></Menu>
      <DocumentName />
      <div class="bar-group">
        <ActionButton id="edit.undo" />
        <ActionButton id="edit.redo" />
      </div>
      <div class="bar-space" />
      <Progress />
      <button class="find" onClick={() => runAction("help.palette")} aria-keyshortcuts="Control+K">
        <Search aria-hidden />
        <span class="find-text">Find anything</span>
        <Keys keys="Ctrl+K" />
      </button>
      <div class="bar-group">
        <ActionButton id="view.inset" />
        <ActionButton id="view.split" />
        <ActionButton id="view.single" />
      </div>
      <div class="bar-group">
        <ActionButton id="view.theme" />
        <ActionButton id="help.shortcuts" />
      </div>
      <ActionButton id="file.export" text="Export" class="primary" />
    </header>
  );
}

function DocumentName() {
  const studio = useStudio();
  const { file, saved } = studio.document.value;
  const connected = studio.connected.value;
  const standing = !connected ? "offline" : studio.busy.value ? "busy" : saved ? "saved" : "kept";
  const words = { offline: "Not connected", busy: "Keeping…", saved: "Saved", kept: "Changes kept" }[standing];
  const name = file === "" ? "Untitled" : baseName(file);
  const hints = {
    offline: "The studio's server does not answer. What you do now waits in this window.",
    busy: "The last change is on its way to the disk.",
    saved: `${name} has every change.`,
    kept: "Every change is on disk at once and comes back after a crash. "
      + `Save (Ctrl+S) writes them into ${file === "" ? "a file" : name}.`,
  };
  return (
    <div class="document-name">
      <span class="document-file" title={file}>{name}</span>
      <span class={`document-standing ${standing}`} title={hints[standing]}>{words}</span>
    </div>
  );
}
