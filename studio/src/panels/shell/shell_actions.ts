// What the shell can do, for menus, palette and keys.
import {
  ArrowLeftRight, CircleQuestionMark, CircleStop, ClockArrowUp, Columns2, Expand, FileBraces, FileOutput, FilePlus,
  FileUp, FolderOpen,
  Images, ListVideo, Maximize, PictureInPicture2, Redo2, Scan, Save, SaveAll, Search, Square, SunMoon, Undo2, Workflow,
} from "lucide-preact";
import type { Action } from "../../actions/registry";
import type { OpenedStudio } from "../../document/open_studio";
import { importFiles, pickFiles, save, unlessUnsaved } from "./files";
import { arrangement, chooseArrangement, dockOpen, dockTab, swapViews, toggleDock, viewsAlone } from "./layout";
import type { Arrangement, DockTab } from "./layout";
import { viewport } from "./parts";
import { goToRegion } from "./regions";
import { openDialog } from "./shell";
import { theme, themeChoice } from "./theme";

function moveActions(studio: OpenedStudio): Action[] {
  const group = "Steps";
  const selectBy = (by: number) => (): void => {
    const { steps } = studio.document.value.recipe;
    const at = steps.findIndex((step) => step.id === studio.selected.value);
    const next = steps[at < 0 ? (by > 0 ? 0 : steps.length - 1) : at + by];
    if (next) studio.selected.value = next.id;
  };
  return [
    { id: "step.next", title: "Step below", group, keys: ["Alt+Down"], run: selectBy(1) },
    { id: "step.previous", title: "Step above", group, keys: ["Alt+Up"], run: selectBy(-1) },
    {
      id: "engine.stop", title: "Stop computing", group, icon: CircleStop, keys: ["P"], words: "cancel suspend pause",
      when: () => !studio.engine.value.settled, run: () => void studio.api.cancel().catch(() => undefined),
    },
  ];
}

function fileActions(studio: OpenedStudio): Action[] {
  const group = "File";
  const open = (name: "blank" | "open") => () => unlessUnsaved(studio, () => openDialog(name));
  return [
    { id: "file.new", title: "New…", group, icon: FilePlus, words: "blank create", run: open("blank") },
    {
      id: "file.examples", title: "Examples…", group, icon: Images, words: "gallery begin start",
      run: () => openDialog("examples"),
    },
    {
      id: "file.open", title: "Open…", group, icon: FolderOpen, keys: ["Ctrl+O"], words: "load recipe",
      run: () => openDialog("open"),
    },
    {
      id: "file.import", title: "Import…", group, icon: FileUp, keys: ["Ctrl+I"],
      words: "elevation dem coast picture heightmap",
      run: () => void pickFiles("", true).then((files) => importFiles(studio, files)),
    },
    { id: "file.save", title: "Save", group, icon: Save, keys: ["Ctrl+S"], run: () => void save(studio) },
    {
      id: "file.save_as", title: "Save as…", group, icon: SaveAll, keys: ["Ctrl+Shift+S"],
      run: () => openDialog("save_as"),
    },
    {
      id: "file.export", title: "Export…", group, icon: FileOutput, keys: ["Ctrl+E"],
      words: "unreal unity godot blender geotiff gltf mesh",
      when: () => studio.document.value.recipe.steps.length > 0, run: () => openDialog("export"),
    },
  ];
}

function editActions(studio: OpenedStudio): Action[] {
  const group = "Edit";
  return [
    {
      id: "edit.undo", title: "Undo", group, icon: Undo2, keys: ["Ctrl+Z"],
      when: () => studio.document.value.done > 0 || studio.busy.value, run: () => void studio.undo(),
    },
    {
      id: "edit.redo", title: "Redo", group, icon: Redo2, keys: ["Ctrl+Shift+Z", "Ctrl+Y"],
      when: () => studio.document.value.done < studio.document.value.history.length || studio.busy.value,
      run: () => void studio.redo(),
    },
  ];
}

function arrange(to: Arrangement, title: string, icon: Action["icon"], words: string): Action {
  return {
    id: `view.${to}`, title, group: "View", words, ...(icon ? { icon } : {}),
    checked: () => arrangement.value === to, run: () => chooseArrangement(to),
  };
}

function viewActions(): Action[] {
  const group = "View";
  return [
    {
      id: "view.swap", title: "Swap the views", group, icon: ArrowLeftRight, keys: ["V"], words: "map 3d",
      run: swapViews,
    },
    arrange("inset", "One view in the other's corner", PictureInPicture2, "layout inset"),
    arrange("split", "Views side by side", Columns2, "layout split"),
    arrange("single", "One view alone", Square, "layout single"),
    {
      id: "view.alone", title: "Views only", group, icon: Expand, keys: ["Ctrl+."], words: "full hide panels zen",
      checked: () => viewsAlone.value, run: () => (viewsAlone.value = !viewsAlone.value),
    },
    {
      id: "view.theme", title: "Light or dark", group, icon: SunMoon, words: "theme",
      run: () => (themeChoice.value = theme.value === "dark" ? "light" : "dark"),
    },
    {
      id: "view.theme_system", title: "Light or dark as the system", group, icon: SunMoon, words: "theme",
      run: () => (themeChoice.value = "system"),
    },
    {
      id: "view.frame", title: "Frame what is drawn, or all", group, icon: Scan, keys: ["F"], words: "zoom fit",
      when: () => viewport.value !== null,
      run: () => viewport.value?.frameSelection(),
    },
    {
      id: "view.frame_all", title: "Frame all", group, icon: Maximize, keys: ["Home"], words: "zoom fit reset",
      when: () => viewport.value !== null,
      run: () => viewport.value?.frameAll(),
    },
    {
      id: "view.next_region", title: "Next part of the window", group, keys: ["F6"], typing: true,
      run: () => goToRegion(1),
    },
    {
      id: "view.previous_region", title: "Part before", group, keys: ["Shift+F6"], typing: true,
      run: () => goToRegion(-1),
    },
  ];
}

function dockAction(tab: DockTab, title: string, icon: Action["icon"], key: string, words: string): Action {
  return {
    id: `panel.${tab}`, title, group: "Panels", keys: [key], words, ...(icon ? { icon } : {}),
    checked: () => dockOpen.value && dockTab.value === tab, run: () => toggleDock(tab),
  };
}

/** In the order of menus and of the sheet. */
export function shellActions(studio: OpenedStudio): Action[] {
  return [
    ...fileActions(studio),
    ...editActions(studio),
    ...moveActions(studio),
    ...viewActions(),
    dockAction("graph", "Graph", Workflow, "Alt+1", "nodes"),
    dockAction("text", "Recipe text", FileBraces, "Alt+2", "json code"),
    dockAction("history", "History", ClockArrowUp, "Alt+3", "undo list"),
    dockAction("timeline", "Timeline", ListVideo, "Alt+4", "events play"),
    {
      id: "help.palette", title: "Find anything", group: "Help", icon: Search, keys: ["Ctrl+K"], typing: true,
      run: () => openDialog("palette"),
    },
    {
      id: "help.shortcuts", title: "Keyboard and mouse", group: "Help", icon: CircleQuestionMark, keys: ["?"],
      run: () => openDialog("shortcuts"),
    },
  ];
}
