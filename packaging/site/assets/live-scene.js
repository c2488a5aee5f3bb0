// A picture of a scene becomes the scene itself, in a frame, for who asks for it: it takes megabytes.
for (const place of document.querySelectorAll(".live-scene")) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "md-button md-button--primary";
  button.textContent = `Walk here (${place.dataset.megabytes} MB)`;
  button.addEventListener("click", () => {
    const lacking = missing();
    if (lacking) {
      const sentence = document.createElement("p");
      sentence.setAttribute("role", "status");
      sentence.textContent = lacking;
      button.replaceWith(sentence);
      return;
    }
    const frame = document.createElement("iframe");
    frame.title = place.dataset.title;
    frame.allow = "fullscreen; xr-spatial-tracking";
    frame.src = place.dataset.scene;
    frame.addEventListener("load", () => frame.contentWindow.focus()); // keys walk at once
    place.replaceChildren(frame);
  });
  place.append(button);
}

/** Returns what the scene needs and this page lacks, as a sentence; nothing where it can be shown. */
function missing() {
  if (location.protocol === "file:") {
    return "A web browser loads no scene for a page that was opened as a file: open the site from a web server.";
  }
  return document.createElement("canvas").getContext("webgl2")
    ? ""
    : "This web browser has no WebGL 2, which would draw the scene. The picture shows its beginning; " +
      "the program itself draws it without.";
}
