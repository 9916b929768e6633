// A dialog over the page: the browser keeps the focus inside and gives it back; Escape and a click beside it close it.
import { X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useId, useLayoutEffect, useRef } from "preact/hooks";
import { ToastList } from "./toasts";
import { UploadCard } from "./upload_card";

interface DialogProps {
  title: string;
  close: () => void;
  children: ComponentChildren;
  /** Buttons at the foot. */
  foot?: ComponentChildren;
  class?: string;
  /** The title is read out, not shown. */
  bare?: boolean;
}

export function Dialog(props: DialogProps) {
  const element = useRef<HTMLDialogElement>(null);
  const title = useId();
  useLayoutEffect(() => {  // at once: what is typed right after the key is the dialog's
    const dialog = element.current!;
    dialog.showModal();
    return () => dialog.close();
  }, []);
  const onPointerDown = (event: PointerEvent): void => {
    if (event.target === element.current) props.close();
  };
  return (
    <dialog
      ref={element}
      class={`dialog ${props.class ?? ""}`}
      aria-labelledby={title}
      onCancel={(event) => {
        event.preventDefault();
        props.close();
      }}
      onPointerDown={onPointerDown}
    >
      <div class="dialog-body">
        <header class={props.bare ? "unseen" : "dialog-head"}>
          <h2 id={title}>{props.title}</h2>
          {!props.bare && <button class="plain icon" aria-label="Close" onClick={props.close}><X /></button>}
        </header>
        <div class="dialog-content">{props.children}</div>
        <ToastList />
        <UploadCard />
        {props.foot && <footer class="dialog-foot">{props.foot}</footer>}
      </div>
    </dialog>
  );
}
