// What went wrong or should be known, at the window's foot: errors stay until they are read, notes go by themselves.
import { signal } from "@preact/signals";
import { CircleAlert, Info, TriangleAlert, X } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { Message } from "../../document/studio";
import { anyDialog, useStudio } from "./shell";

interface Toast extends Message {
  id: number;
}

const kMost = 4;
const kStay_ms = { error: 0, warning: 12_000, note: 5_000 };
const kIcons = { error: CircleAlert, warning: TriangleAlert, note: Info };

const toasts = signal<readonly Toast[]>([]);
let count = 0;

/** The same words again move to the end instead of standing there twice. */
export function showToast(message: Message): void {
  const others = toasts.value.filter((toast) => toast.text !== message.text);
  const id = ++count;
  toasts.value = [...others, { ...message, id }].slice(-kMost);
  if (kStay_ms[message.kind] > 0) setTimeout(() => dismiss(id), kStay_ms[message.kind]);
}

function dismiss(id: number): void {
  toasts.value = toasts.value.filter((toast) => toast.id !== id);
}

/** Under the page; while a dialog is open the list is in the dialog, as all else is out of reach. */
export function Toasts() {
  const studio = useStudio();
  const message = studio.message.value;
  useEffect(() => {
    if (message) showToast(message);
  }, [message]);
  return anyDialog.value ? null : <ToastList />;
}

export function ToastList() {
  const studio = useStudio();
  return (
    <div class="toasts" role="log" aria-live="polite" aria-label="Messages">
      {toasts.value.map((toast) => {
        const Icon = kIcons[toast.kind];
        return (
          <div key={toast.id} class={`toast ${toast.kind}`} role={toast.kind === "error" ? "alert" : undefined}>
            <Icon aria-hidden />
            <p>{toast.text}</p>
            {toast.step !== undefined && (
              <button class="plain" onClick={() => (studio.selected.value = toast.step!)}>Show {toast.step}</button>
            )}
            <button class="plain icon" aria-label="Dismiss" onClick={() => dismiss(toast.id)}><X /></button>
          </div>
        );
      })}
    </div>
  );
}
