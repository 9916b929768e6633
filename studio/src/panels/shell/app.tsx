// The whole page: bars around the views, panels at their side and foot, dialogs over them.
import { useEffect } from "preact/hooks";
import { listenToKeys, registerActions } from "../../actions/registry";
import type { OpenedStudio } from "../../document/open_studio";
import { toolKey } from "../../tools/actions";
import { ConnectionBar } from "./connection";
import { Dock } from "./dock";
import { DropZone } from "./drop_zone";
import { ExportDialog } from "./export_dialog";
import { BlankDialog, OpenDialog, SaveAsDialog, UnsavedDialog } from "./file_dialogs";
import { FirstScreen } from "./first_screen";
import { followLabels } from "./label_under";
import { viewsAlone } from "./layout";
import { Palette } from "./palette";
import { ToolOptions, ToolRail } from "./parts";
import { dialog, openDialog, StudioContext, anyDialog } from "./shell";
import { shellActions } from "./shell_actions";
import { toolEntries } from "./tool_entries";
import { ShortcutsSheet } from "./shortcuts_sheet";
import { SidePanel } from "./side_panel";
import { StatusLine } from "./status_line";
import { Toasts } from "./toasts";
import { TopBar } from "./top_bar";
import { Views } from "./views";
import { baseName } from "./words";

const kStarted = "seamount.started";

/** Nothing was begun yet: a document without a file and without a history, and not asked before in this window. */
function isFirst(studio: OpenedStudio): boolean {
  const { file, history } = studio.document.value;
  return file === "" && history.length === 0 && sessionStorage.getItem(kStarted) === null;
}

/** The browser asks before a window is closed whose latest change is not on disk yet. */
function guardUnsent(studio: OpenedStudio): () => void {
  const ask = (event: BeforeUnloadEvent): void => {
    if (studio.busy.peek()) event.preventDefault();
  };
  addEventListener("beforeunload", ask);
  return () => removeEventListener("beforeunload", ask);
}

export function App({ studio }: { studio: OpenedStudio }) {
  useEffect(() => {
    const ends = [
      registerActions(shellActions(studio)),
      registerActions(() => toolEntries(studio)),
      listenToKeys(document, (event) => toolKey(studio, event)),
      followLabels(studio),
      guardUnsent(studio),
    ];
    if (isFirst(studio)) openDialog("examples");
    sessionStorage.setItem(kStarted, "yes");
    return () => ends.forEach((end) => end());
  }, [studio]);
  const { file } = studio.document.value;
  useEffect(() => {
    document.title = `${file === "" ? "Untitled" : baseName(file)} · Seamount`;
  }, [file]);
  return (
    <StudioContext.Provider value={studio}>
      <div class={`app ${viewsAlone.value ? "alone" : ""}`} inert={anyDialog.value}>
        <TopBar />
        <div class="rail-place"><ToolRail studio={studio} /></div>
        <main class="main">
          <ConnectionBar />
          <div class="options-place"><ToolOptions studio={studio} /></div>
          <Views />
          <Dock />
        </main>
        <SidePanel />
        <StatusLine />
      </div>
      <DropZone />
      <Dialogs />
      <UnsavedDialog />
      <Toasts />
    </StudioContext.Provider>
  );
}

function Dialogs() {
  switch (dialog.value) {
    case "palette": return <Palette />;
    case "shortcuts": return <ShortcutsSheet />;
    case "export": return <ExportDialog />;
    case "open": return <OpenDialog />;
    case "save_as": return <SaveAsDialog />;
    case "blank": return <BlankDialog />;
    case "examples": return <FirstScreen />;
    case null: return null;
  }
}
