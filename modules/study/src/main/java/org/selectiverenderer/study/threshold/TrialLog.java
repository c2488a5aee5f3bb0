package org.selectiverenderer.study.threshold;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.session.JournalContent;
import org.selectiverenderer.study.session.JournalRecovery;
import org.selectiverenderer.study.session.SessionLock;

/**
 * The log of one participant of a threshold pilot: {@code trials.jsonl} (JSON Lines), each event
 * forced to the disk before the next trial is shown. As a person answers once in some seconds, the
 * caller waits for the disk. The log is locked, and recovered after a crash, like the journal of a
 * session.
 */
final class TrialLog implements AutoCloseable {
  private static final String LOG = "trials.jsonl";

  private final Path file;
  private final SessionLock lock;
  private final FileChannel channel;

  private TrialLog(Path file, SessionLock lock, FileChannel channel) {
    this.file = file;
    this.lock = lock;
    this.channel = channel;
  }

  /** Returns the log's file in a participant's folder. */
  static Path of(Path folder) {
    return folder.resolve(LOG);
  }

  /**
   * Opens a participant's log for appending, and creates it if it does not exist.
   *
   * @param software name and version of the program, for others' messages
   * @param problems receives damaged lines; a truncated last line is moved to a separate file
   * @throws IOException if another program has the lock, or a file cannot be written
   */
  static TrialLog open(Path folder, String software, ProblemCollector problems) throws IOException {
    PrivateFiles.requireNoLink(folder);
    PrivateFiles.createFolders(folder);
    PrivateFiles.requireNoLink(of(folder));
    Path file = of(folder);
    SessionLock lock = SessionLock.take(folder, software);
    try {
      Optional<Map<String, Object>> mended =
          Files.isRegularFile(file) ? JournalRecovery.mend(file, problems) : Optional.empty();
      TrialLog log =
          new TrialLog(
              file,
              lock,
              PrivateFiles.open(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND));
      DiskSync.forceFolder(folder);
      if (mended.isPresent()) {
        log.keep("journal-mended", mended.get());
      }
      return log;
    } catch (IOException e) {
      lock.close();
      throw e;
    }
  }

  /** Logs an event, which is on the disk when this method returns. */
  void keep(String event, Map<String, ?> more) throws IOException {
    ObjectNode line = JsonTree.object();
    line.put("time", OffsetDateTime.now().truncatedTo(ChronoUnit.MILLIS).toString());
    line.put("event", event);
    more.forEach((key, value) -> line.set(key, JsonTree.of(value)));
    try {
      DiskSync.write(channel, (line + "\n").getBytes(StandardCharsets.UTF_8));
      channel.force(false);
    } catch (IOException e) {
      throw new IOException(file + ": an answer could not be written: " + e.getMessage(), e);
    }
  }

  /** Returns the events so far, in order. */
  List<JsonNode> events() throws IOException {
    return List.copyOf(JournalContent.read(file).events());
  }

  /**
   * Reads the events of a log that another program may be writing, in order.
   *
   * @param problems receives damaged lines, which are skipped
   * @throws IOException if the log cannot be read
   */
  static List<JsonNode> read(Path folder, ProblemCollector problems) throws IOException {
    Path file = of(folder);
    JournalContent text = JournalContent.read(file);
    JournalRecovery.tellDamaged(file, text, problems);
    if (text.tail() > 0) {
      problems.warning(
          new SourceLocation(file.toString(), text.lines() + 1, 1),
          "the last line is cut off and is ignored; --resume repairs the file");
    }
    return List.copyOf(text.events());
  }

  @Override
  public void close() throws IOException {
    try (lock) {
      channel.close();
    }
  }
}
