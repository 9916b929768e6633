// The studio's page.
import { startWithServer } from "./panels/shell/start";

void startWithServer(document.getElementById("app")!);
