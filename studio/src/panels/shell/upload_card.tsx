// The file that is on its way to the server, with how much of it is there.
import { FileUp, X } from "lucide-preact";
import { uploading } from "../../document/uploads";
import { bytesText } from "./words";

export function UploadCard() {
  const upload = uploading.value;
  if (upload === null) return null;
  const percent = Math.round(100 * upload.share);
  return (
    <div class="drop-zone quiet" role="status">
      <div class="drop-card upload-card">
        <FileUp aria-hidden />
        <div class="upload-what">
          <span class="ellipsis">Taking in {upload.name}</span>
          <progress max={100} value={percent} aria-label={`Sending ${upload.name}`} />
        </div>
        <span class="muted">{percent} % of {bytesText(upload.bytes)}</span>
        <button type="button" class="plain icon" aria-label="Cancel the upload" title="Cancel the upload" onClick={upload.cancel}><X /></button>
      </div>
    </div>
  );
}
