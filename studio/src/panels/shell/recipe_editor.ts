// The editor of the recipe's text. It lives in a shadow tree, where CodeMirror puts its styles into constructed sheets:
// the page's content security policy allows no inline ones.
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { json } from "@codemirror/lang-json";
import {
  bracketMatching, foldGutter, foldKeymap, HighlightStyle, indentOnInput, syntaxHighlighting,
} from "@codemirror/language";
import { lintKeymap, setDiagnostics } from "@codemirror/lint";
import type { Diagnostic as Mark } from "@codemirror/lint";
import { ChangeSet, EditorState, Transaction } from "@codemirror/state";
import type { Text } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { Diagnostic } from "../../api/types";
import { differences } from "./text_diff";

const kLook = EditorView.theme({
  "&": { height: "100%", color: "var(--text)", backgroundColor: "var(--bg)", fontSize: "12.5px" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "ui-monospace, 'DejaVu Sans Mono', monospace", lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--accent)", padding: "6px 0" },
  ".cm-cursor": { borderLeftColor: "var(--accent)", borderLeftWidth: "2px" },
  ".cm-gutters": { backgroundColor: "var(--bg)", color: "var(--muted)", border: "none" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--hover) 45%, transparent)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground":
    { backgroundColor: "var(--accent-soft)" },
  "&.cm-focused .cm-matchingBracket": { backgroundColor: "var(--hover)", outline: "1px solid var(--edge)" },
  ".cm-foldPlaceholder": { backgroundColor: "var(--raised)", border: "1px solid var(--line)", color: "var(--muted)" },
  // CodeMirror draws these with pictures in data: addresses, which the policy forbids.
  ".cm-lintRange": { backgroundImage: "none", paddingBottom: "0" },
  ".cm-lintRange-error": { textDecoration: "underline wavy var(--error)", textUnderlineOffset: "3px" },
  ".cm-tooltip": {
    backgroundColor: "var(--raised)", color: "var(--text)", border: "1px solid var(--line)", borderRadius: "6px",
    font: "13px system-ui, sans-serif",
  },
  ".cm-diagnostic": { padding: "6px 10px" },
  ".cm-diagnostic-error": { borderLeft: "3px solid var(--error)" },
});

const kColours = HighlightStyle.define([
  { tag: tags.propertyName, color: "var(--accent)" },
  { tag: tags.string, color: "var(--ok)" },
  { tag: [tags.number, tags.bool, tags.null], color: "var(--warn)" },
  { tag: [tags.separator, tags.squareBracket, tags.brace], color: "var(--muted)" },
]);

/** A change of the window's other parts, of another window, or of the server's writing. */
const kOutside = Transaction.userEvent.of("outside");

export interface EditorTold {
  /** Something was typed. */
  changed: () => void;
  blurred: () => void;
}

/** Places of the server's messages in the text, from 1; without one they stand at the beginning. */
export function marksOf(text: Text, diagnostics: readonly Diagnostic[]): Mark[] {
  return diagnostics.map(({ line: number, column, message }) => {
    const line = text.line(Math.min(Math.max(1, number), text.lines));
    const from = Math.min(line.from + Math.max(0, column - 1), line.to);
    const word = /^("[^"]*"?|[^\s,:\]}]+)/.exec(line.text.slice(from - line.from));
    const to = Math.min(line.to, from + Math.max(1, word?.[0].length ?? 1));
    return { from: Math.min(from, Math.max(line.from, to - 1)), to, severity: "error" as const, message };
  });
}

export class RecipeEditor {
  private view: EditorView;

  constructor(parent: HTMLElement, text: string, told: EditorTold) {
    const root = parent.shadowRoot ?? parent.attachShadow({ mode: "open" });
    const frame = document.createElement("div");
    frame.style.height = "100%";
    root.replaceChildren(frame);
    const state = EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), foldGutter(), history(), drawSelection(), indentOnInput(), bracketMatching(),
        highlightActiveLine(),
        json(), syntaxHighlighting(kColours), kLook,
        EditorView.contentAttributes.of({ "aria-label": "Recipe", spellcheck: "false" }),
        keymap.of([...defaultKeymap, ...historyKeymap, ...foldKeymap, ...lintKeymap, indentWithTab]),
        EditorView.updateListener.of((update) => {
          const typed = update.docChanged && !update.transactions.every((one) => one.isUserEvent("outside"));
          if (typed) told.changed();
          if (update.focusChanged && !update.view.hasFocus) told.blurred();
        }),
      ],
    });
    this.view = new EditorView({ state, parent: frame, root });
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  get focused(): boolean {
    return this.view.hasFocus;
  }

  /** What changed from `before` to `after` elsewhere is changed here too; what was typed since `before` stays. */
  merge(before: string, after: string): void {
    const here = this.view.state.doc;
    const outside = ChangeSet.of(differences(before, after), before.length);
    const typed = ChangeSet.of(differences(before, here.toString()), before.length);
    const changes = outside.map(typed);
    if (changes.empty) return;
    this.view.dispatch({ changes, annotations: [kOutside, Transaction.addToHistory.of(false)] });
  }

  mark(diagnostics: readonly Diagnostic[]): void {
    this.view.dispatch(setDiagnostics(this.view.state, marksOf(this.view.state.doc, diagnostics)));
  }

  /** Brings the step into sight. */
  showStep(id: string): void {
    const at = this.text.indexOf(`"id": ${JSON.stringify(id)}`);
    if (at >= 0) this.view.dispatch({ effects: EditorView.scrollIntoView(at, { y: "start", yMargin: 24 }) });
  }

  goTo(line: number, column: number): void {
    const at = this.view.state.doc.line(Math.min(Math.max(1, line), this.view.state.doc.lines));
    const anchor = Math.min(at.to, at.from + Math.max(0, column - 1));
    this.view.dispatch({ selection: { anchor }, scrollIntoView: true });
    this.view.focus();
  }

  close(): void {
    this.view.destroy();
  }
}
