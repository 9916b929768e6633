// Files on their way to the server: how much of them is there, and what calls them back.
import { signal } from "@preact/signals";
import type { Api, Uploaded } from "../api/api";

export interface Upload {
  name: string;
  bytes: number;
  /** 0 to 1. */
  share: number;
  cancel(): void;
}

/** The file that is being sent; null: none. */
export const uploading = signal<Upload | null>(null);

/** The person called it back: nothing need be said. */
export class UploadCancelled extends Error {
  constructor() {
    super("The file was called back");
  }
}

/** One after another; rejects with an UploadCancelled where it is called back. */
export async function uploadFile(api: Pick<Api, "upload">, file: File): Promise<Uploaded> {
  const abort = new AbortController();
  const upload: Upload = { name: file.name, bytes: file.size, share: 0, cancel: () => abort.abort() };
  uploading.value = upload;
  try {
    return await api.upload(file.name, file, {
      signal: abort.signal,
      progress: (share) => (uploading.value = { ...upload, share }),
    });
  } catch (error) {
    throw abort.signal.aborted ? new UploadCancelled() : error;
  } finally {
    uploading.value = null;
  }
}
