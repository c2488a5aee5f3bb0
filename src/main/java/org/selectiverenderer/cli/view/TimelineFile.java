package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.selectiverenderer.app.timeline.TimelineEvent;
import org.selectiverenderer.app.timeline.TimelineJson;

/** A time line on its way into a file, line by line as it happens. */
final class TimelineFile implements Consumer<TimelineEvent>, AutoCloseable {
  private final Path file;
  private final PrintWriter writer;
  private final TimelineJson json = new TimelineJson();

  /**
   * @throws IOException when the file cannot be written
   */
  TimelineFile(Path file) throws IOException {
    this.file = file;
    writer = new PrintWriter(Files.newBufferedWriter(file, StandardCharsets.UTF_8));
  }

  @Override
  public void accept(TimelineEvent event) {
    writer.print(json.line(event) + "\n");
    writer.flush();
  }

  /**
   * @throws IOException when a line could not be written
   */
  @Override
  public void close() throws IOException {
    writer.close();
    if (writer.checkError()) {
      throw new IOException(file + ": the time line could not be written");
    }
  }
}
