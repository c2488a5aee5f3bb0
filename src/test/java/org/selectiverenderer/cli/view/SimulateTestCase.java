package org.selectiverenderer.cli.view;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.cli.CommandTestCase;

/**
 * Scenes in a folder of the test's own, and what {@code simulate} says of them. The viewer stands
 * still at (0, 0, 10) for two frames.
 */
final class SimulateTestCase {
  /** A shape of 12 polygons, to see what of a scene is still shown. */
  static final String BOX = "<Shape><Box/></Shape>";

  private static final Pattern POLYGONS = Pattern.compile("\"polygons\":\\{\"start\":(\\d+)");

  /**
   * How a command ended.
   *
   * @param messages the lines of standard error, files named relative to the folder
   */
  record Result(int status, String out, List<String> messages) {
    /** Polygons shown in the first frame. */
    long polygons() {
      Matcher matcher = POLYGONS.matcher(out);
      if (!matcher.find()) {
        throw new AssertionError("no polygons are told: " + out);
      }
      return Long.parseLong(matcher.group(1));
    }
  }

  private final Path folder;

  SimulateTestCase(Path folder) {
    this.folder = folder;
    write("still.csv", "t,x,y,z\n0,0,0,10\n0.01,0,0,10\n0.02,0,0,10\n");
  }

  Path path(String name) {
    return folder.resolve(name);
  }

  /** Writes a file, making its folder. */
  SimulateTestCase write(String name, String text) {
    return write(name, text.getBytes(StandardCharsets.UTF_8));
  }

  SimulateTestCase write(String name, byte[] bytes) {
    try {
      Files.createDirectories(path(name).getParent());
      Files.write(path(name), bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return this;
  }

  /** Writes a scene; its nodes begin in line 2. */
  SimulateTestCase scene(String name, String nodes) {
    return write(
        name, "<X3D version='4.0' profile='Immersive'><Scene>\n" + nodes + "</Scene></X3D>");
  }

  /** Walks through a scene of the folder. */
  Result simulate(String name) {
    return run(
        "simulate",
        path(name).toString(),
        "--path",
        path("still.csv").toString(),
        "--rate",
        "50",
        "--format",
        "json");
  }

  /** Runs a command in this process. */
  Result run(String... args) {
    CommandTestCase command = new CommandTestCase();
    int status = command.execute(args);
    String messages = command.messages().replace(folder + File.separator, "").replace('\\', '/');
    return new Result(status, command.printed(), messages.lines().toList());
  }
}
