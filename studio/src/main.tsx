// The studio's page: a word at once, and the studio as soon as that is painted.
function painted(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve, 0));
    setTimeout(resolve, 250);  // a window that is not seen paints nothing
  });
}

void painted()
  .then(() => import("./panels/shell/start"))
  .then(({ startWithServer }) => startWithServer(document.getElementById("app")!));
