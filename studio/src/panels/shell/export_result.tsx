// An export while it runs and after: how far, the files to take along, and the numbers to type in.
import { useSignal } from "@preact/signals";
import { Check, CircleAlert, Copy, Download } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { JobEvent, Json } from "../../api/types";
import { Estimate } from "./estimate";
import { importNumbers, numbersText, sidecarsOf } from "./import_numbers";
import type { ImportNumbers } from "./import_numbers";
import { closeDialog, useStudio } from "./shell";
import { showToast } from "./toasts";
import { baseName, bytesText, durationText } from "./words";

export function ExportResult({ job: id, back }: { job: string; back: () => void }) {
  const studio = useStudio();
  const job = studio.jobs.value.find((one) => one.job === id);
  if (!job || job.state === "running")
    return <Running id={id} fraction={job?.fraction ?? 0} message={job?.message ?? ""} />;
  if (job.state === "done") return <Written job={job} back={back} />;
  return (
    <div class="export-result">
      <p class={job.state === "failed" ? "failure" : "muted"} role="alert">
        {job.state === "failed" && <CircleAlert aria-hidden />}
        {job.state === "failed" ? job.message || "It could not be written." : "Stopped. No file was written."}
      </p>
      <div class="bar-group"><button onClick={back}>Back to the settings</button></div>
    </div>
  );
}

function Running({ id, fraction, message }: { id: string; fraction: number; message: string }) {
  const studio = useStudio();
  const estimate = useRef(new Estimate());
  const left = estimate.current.left_s(fraction, performance.now());
  return (
    <div class="export-result">
      <p>
        {message || "Computing and writing"}
        {left !== null && <span class="muted">, {durationText(left)} left</span>}
      </p>
      <progress max={1} value={fraction} aria-label="Export" />
      <div class="bar-group">
        <button onClick={() => void studio.api.cancel(id).catch(() => undefined)}>Stop</button>
      </div>
    </div>
  );
}

function Written({ job, back }: { job: JobEvent; back: () => void }) {
  const studio = useStudio();
  const numbers = useNumbers(job);
  const download = async (path: string): Promise<void> => {
    try {
      takeAlong(await studio.api.download(path), baseName(path));
    } catch (error) {
      showToast({ kind: "error", text: `${baseName(path)} could not be fetched: ${(error as Error).message}` });
    }
  };
  return (
    <div class="export-result">
      <p class="good">
        <Check aria-hidden />
        {job.files.length === 1 ? "1 file was written" : `${job.files.length} files were written`}
      </p>
      <ul class="file-list">
        {job.files.map(({ path, bytes }) => (
          <li key={path}>
            <span class="file-path">{path}</span>
            <span class="muted">{bytesText(bytes)}</span>
            <button onClick={() => void download(path)}>
              <Download aria-hidden />
              Download
            </button>
          </li>
        ))}
      </ul>
      <Numbers numbers={numbers} notes={job.notes} />
      <div class="bar-group">
        <button onClick={back}>Export more</button>
        <button class="primary" onClick={closeDialog}>
          Done
        </button>
      </div>
    </div>
  );
}

/** Read from the side-cars that were written. */
function useNumbers(job: JobEvent): readonly ImportNumbers[] {
  const studio = useStudio();
  const found = useSignal<readonly ImportNumbers[]>([]);
  useEffect(() => {
    const read = async (path: string): Promise<ImportNumbers | null> => {
      try {
        return importNumbers(JSON.parse(await (await studio.api.download(path)).text()) as Json);
      } catch {
        return null;  // the file can still be taken along and looked into
      }
    };
    void Promise.all(sidecarsOf(job.files.map(({ path }) => path)).map(read)).then((all) => {
      found.value = all.filter((one): one is ImportNumbers => one !== null);
    });
  }, [job]);
  return found.value;
}

function Numbers({ numbers, notes }: { numbers: readonly ImportNumbers[]; notes: readonly string[] }) {
  const copied = useSignal(false);
  if (numbers.length === 0 && notes.length === 0) return null;
  const copy = async (): Promise<void> => {
    await navigator.clipboard.writeText(numbersText(numbers, notes));
    copied.value = true;
  };
  return (
    <section class="notes" aria-label="What to type in">
      <header>
        <h3>{numbers.length > 0 ? "What to type in" : "Notes"}</h3>
        <button class="plain" onClick={() => void copy()}>
          <Copy aria-hidden />
          {copied.value ? "Copied" : "Copy"}
        </button>
      </header>
      {numbers.map(({ file, rows, note }) => (
        <div key={file} class="import-numbers">
          <h4>{file}</h4>
          <dl>
            {rows.map(([name, value]) => (
              <div key={name}>
                <dt>{name}</dt>
                <dd>{value}</dd>
              </div>
            ))}
          </dl>
          {note && <p class="muted">{note}</p>}
        </div>
      ))}
      {notes.length > 0 && (
        <ul>
          {notes.map((note) => (
            <li key={note}>{note}</li>
          ))}
        </ul>
      )}
    </section>
  );
}

/** Files are fetched with the token, so that a plain link would not do. */
function takeAlong(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
