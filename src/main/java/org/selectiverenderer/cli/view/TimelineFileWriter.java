package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineJson;

/**
 * Writes a time line into a file, line by line as events happen. An existing file keeps its content
 * until it is opened.
 */
final class TimelineFileWriter implements Consumer<TimelineEvent>, AutoCloseable {
  private final Path file;
  private final TimelineJson json = new TimelineJson();
  private volatile @Nullable PrintWriter writer;

  TimelineFileWriter(Path file) {
    this.file = file;
  }

  /**
   * Opens the file and deletes its previous content.
   *
   * @throws IOException when it cannot be written
   */
  void open() throws IOException {
    writer = new PrintWriter(Files.newBufferedWriter(file, StandardCharsets.UTF_8));
  }

  @Override
  public void accept(TimelineEvent event) {
    PrintWriter to = writer;
    if (to == null) {
      throw new IllegalStateException("nothing happens before the time line's file is open");
    }
    to.print(json.line(event) + "\n");
    to.flush();
  }

  /**
   * @throws IOException when a line could not be written
   */
  @Override
  public void close() throws IOException {
    PrintWriter opened = writer;
    if (opened == null) {
      return;
    }
    opened.close();
    if (opened.checkError()) {
      throw new IOException(file + ": the time line could not be written");
    }
  }
}
