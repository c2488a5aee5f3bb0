package org.selectiverenderer.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.RunListener;
import org.selectiverenderer.app.TimelineEvent;
import org.selectiverenderer.app.TimelineJson;
import org.selectiverenderer.x3d.Problem;

/** Where a run's words go: problems to the messages, the time line to a file if one is wanted. */
final class RunOutput implements RunListener, AutoCloseable {
  private final Console console;
  private final @Nullable PrintWriter timeline;
  private final @Nullable Path file;
  private final TimelineJson json = new TimelineJson();

  private RunOutput(Console console, @Nullable PrintWriter timeline, @Nullable Path file) {
    this.console = console;
    this.timeline = timeline;
    this.file = file;
  }

  /**
   * @throws IOException when the file cannot be written
   */
  static RunOutput open(Console console, @Nullable Path file) throws IOException {
    PrintWriter writer =
        file == null
            ? null
            : new PrintWriter(Files.newBufferedWriter(file, StandardCharsets.UTF_8));
    return new RunOutput(console, writer, file);
  }

  @Override
  public void problem(Problem problem) {
    console.problem(problem);
  }

  @Override
  public void happened(TimelineEvent event) {
    if (timeline != null) {
      timeline.print(json.line(event) + "\n");
      timeline.flush();
    }
  }

  @Override
  public void printed(String text) {
    console.message(text);
  }

  /**
   * @throws IOException when a line could not be written
   */
  @Override
  public void close() throws IOException {
    if (timeline != null) {
      timeline.close();
      if (timeline.checkError()) {
        throw new IOException(file + ": the time line could not be written");
      }
    }
  }
}
