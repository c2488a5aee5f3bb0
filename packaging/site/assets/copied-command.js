// Pages show commands with what they print. The button that copies a block takes the commands alone.
document.addEventListener("click", (event) => {
  const button = event.target.closest?.("button.md-clipboard, button.md-code__button");
  const code = button?.closest("pre")?.querySelector("code");
  const lines = code?.textContent.split("\n") ?? [];
  if (!lines[0]?.startsWith("$ ")) {
    return;
  }
  const commands = [];
  lines.forEach((line, i) => {
    if (line.startsWith("$ ")) {
      commands.push(line.slice(2));
    } else if (lines[i - 1]?.endsWith("\\")) {
      commands.push(line);
    }
  });
  button.setAttribute("data-clipboard-text", commands.join("\n"));
}, true);
