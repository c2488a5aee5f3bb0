package org.selectiverenderer.cli.start;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.app.examples.ExampleFiles;
import org.selectiverenderer.app.examples.ExampleFolder;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

@Command(
    name = "examples",
    description = {
      "Copies the examples that the program brings into a folder, 31 MB of scenes and studies, and"
          + " lists what it has written.",
      "Files that are there already stay; where one of them has another content nothing is written."
    },
    footer = {
      "  ./selective-renderer examples my-examples",
      "  ./selective-renderer run my-examples/scenes/trashcan.x3d"
    })
public final class ExamplesCommand extends CliCommand {
  @Parameters(paramLabel = "DIR", description = "folder; created if it does not exist")
  private Path folder = Path.of("");

  /** Creates the command. */
  public ExamplesCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw CommandException.usage(folder + " is a file; name a folder for the examples");
    }
    Map<String, byte[]> examples = ExampleFiles.read();
    ExampleFolder copies = new ExampleFolder(folder);
    List<Path> changed = copies.changed(examples);
    if (!changed.isEmpty()) {
      throw CommandException.environment(
          "%s is there already with another content%s; name another folder: nothing is written"
              .formatted(
                  changed.get(0),
                  changed.size() == 1 ? "" : ", and " + (changed.size() - 1) + " more"));
    }
    List<Path> written = copies.complete(examples).written();
    written.forEach(file -> console().line(file.toString()));
    remember();
    long bytes = examples.values().stream().mapToLong(content -> content.length).sum();
    console()
        .message(
            written.isEmpty()
                ? folder + ": has all examples already; nothing is written"
                : String.format(
                    Locale.ROOT,
                    "%s: %d files written; the examples are %d files, %.0f MB",
                    folder,
                    written.size(),
                    examples.size(),
                    bytes / 1e6));
    return ExitStatus.DONE;
  }

  /** Has the start window and {@code experiment new} find the copies. */
  private void remember() {
    try {
      RecentPaths.exampleFolders(SettingsFolder.ofUser()).add(folder);
    } catch (IOException e) {
      console().message("the start window will not know of this folder: " + e.getMessage());
    }
  }
}
