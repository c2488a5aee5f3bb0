package org.selectiverenderer.experiment.threshold;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.Disk;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;

/**
 * What has happened to one participant of a threshold pilot: {@code trials.jsonl}, one JSON object
 * a line, each forced to the disk before the next trial is shown. A person answers once in some
 * seconds, so the caller waits for the disk. The lock is on a file of its own: a lock on the log
 * would go as soon as anybody in this program had read the log.
 */
final class TrialLog implements AutoCloseable {
  private static final String LOG = "trials.jsonl";

  private final Path file;
  private final FileChannel lock;
  private final FileChannel channel;

  private TrialLog(Path file, FileChannel lock, FileChannel channel) {
    this.file = file;
    this.lock = lock;
    this.channel = channel;
  }

  /** The log of a participant's folder. */
  static Path of(Path folder) {
    return folder.resolve(LOG);
  }

  /**
   * Opens a participant's log for adding to it, and makes it.
   *
   * @throws IOException if another program has it, or the disk fails
   */
  static TrialLog open(Path folder) throws IOException {
    Files.createDirectories(folder);
    Path file = of(folder);
    FileChannel lock =
        FileChannel.open(
            folder.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    try {
      FileLock held = lock.tryLock(); // Closing the channel lets go of it.
      if (held == null) {
        throw new IOException(folder + ": another program runs this participant; wait for its end");
      }
      boolean torn = Files.isRegularFile(file) && torn(Files.readAllBytes(file));
      FileChannel channel =
          FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      if (torn) {
        Disk.write(channel, new byte[] {'\n'}); // What a crash cut off stays what it is: no event.
      }
      Disk.forceFolder(folder);
      return new TrialLog(file, lock, channel);
    } catch (OverlappingFileLockException e) {
      lock.close();
      throw new IOException(folder + ": this participant is running already", e);
    } catch (IOException e) {
      lock.close();
      throw e;
    }
  }

  private static boolean torn(byte[] bytes) {
    return bytes.length > 0 && bytes[bytes.length - 1] != '\n';
  }

  /** Adds an event; it is on the disk when this returns. */
  void keep(String event, Map<String, ?> more) throws IOException {
    ObjectNode line = JsonTree.object();
    line.put("time", OffsetDateTime.now().truncatedTo(ChronoUnit.MILLIS).toString());
    line.put("event", event);
    more.forEach((key, value) -> line.set(key, JsonTree.of(value)));
    try {
      Disk.write(channel, (line + "\n").getBytes(StandardCharsets.UTF_8));
      channel.force(false);
    } catch (IOException e) {
      throw new IOException(file + ": an answer could not be written: " + e.getMessage(), e);
    }
  }

  /**
   * The events of a log, in order.
   *
   * @param problems hears of lines that are damaged, which are passed over
   * @throws IOException if it cannot be read
   */
  static List<JsonNode> read(Path folder, Problems problems) throws IOException {
    Path file = of(folder);
    List<JsonNode> events = new ArrayList<>();
    if (!Files.isRegularFile(file)) {
      return events;
    }
    int number = 0;
    for (String line : new String(Files.readAllBytes(file), StandardCharsets.UTF_8).split("\n")) {
      number++;
      JsonNode event = whole(line);
      if (event != null && event.isObject()) {
        events.add(event);
      } else if (!line.isBlank()) {
        problems.warning(
            new Location(file.toString(), number, 1),
            "the line is damaged or was cut off; it is passed over");
      }
    }
    return events;
  }

  private static @Nullable JsonNode whole(String line) {
    try {
      return JsonTree.parse(line);
    } catch (JsonProcessingException e) {
      return null;
    }
  }

  @Override
  public void close() throws IOException {
    try (lock) {
      channel.close();
    }
  }
}
