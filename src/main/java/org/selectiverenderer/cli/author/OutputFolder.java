package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.command.output.CommandException;

/** The output folder of the command {@code simplify}: each result is named like its model. */
final class OutputFolder {
  private final Path folder;

  private OutputFolder(Path folder) {
    this.folder = folder;
  }

  /**
   * Creates the folder if it is missing, and checks that each result gets a file of its own that is
   * not one of the models.
   *
   * @throws IOException when the folder cannot be created
   */
  static OutputFolder open(Path folder, List<Path> models) throws IOException {
    OutputFolder opened = new OutputFolder(folder);
    Map<Path, Path> takenBy = new HashMap<>();
    Set<Path> read = new HashSet<>();
    for (Path model : models) {
      if (Files.exists(model)) {
        read.add(model.toRealPath());
      }
      Path other = takenBy.put(opened.of(model), model);
      if (other != null) {
        throw CommandException.usage(
            "--output-dir: %s and %s would both be written to %s; reduce them one after the other"
                .formatted(other, model, opened.of(model)));
      }
    }
    for (Path target : takenBy.keySet()) {
      if (Files.exists(target) && read.contains(target.toRealPath())) {
        throw CommandException.usage(
            "--output-dir: " + target + " is one of the models, which would be lost");
      }
    }
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw CommandException.environment("--output-dir " + folder + ": is not a folder");
    }
    Files.createDirectories(folder);
    return opened;
  }

  /** Returns the output file of a model. */
  Path of(Path model) {
    String name = String.valueOf(model.getFileName());
    int ending = name.lastIndexOf('.');
    return folder.resolve((ending > 0 ? name.substring(0, ending) : name) + ".x3d");
  }
}
