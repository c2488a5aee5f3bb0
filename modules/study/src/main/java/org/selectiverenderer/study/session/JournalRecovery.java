package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * Recovers a journal after a crash, so that it ends with a whole line before the session is
 * resumed. A truncated last line is removed, once a copy of it is on the disk; a last event that
 * lacks only its line end gets one. Damaged lines in the middle are kept and reported.
 */
public final class JournalRecovery {
  private JournalRecovery() {}

  /**
   * Recovers a journal; the caller holds the lock of the session.
   *
   * @param problems receives the damage that was found
   * @return members of the event that records the recovery; empty if the journal was intact
   * @throws IOException if the journal cannot be read or written; nothing is lost then
   */
  public static Optional<Map<String, Object>> mend(Path journal, ProblemCollector problems)
      throws IOException {
    byte[] bytes = InputFileReader.bytes(journal);
    JournalContent text = JournalContent.of(bytes);
    Map<String, Object> found = new LinkedHashMap<>();
    if (!text.damaged().isEmpty()) {
      tellDamaged(journal, text, problems);
      found.put("damaged_lines", text.damaged());
    }
    if (text.tail() > 0) {
      Path copy = copy(journal, Arrays.copyOfRange(bytes, text.kept(), bytes.length));
      try (FileChannel channel = FileChannel.open(journal, StandardOpenOption.WRITE)) {
        channel.truncate(text.kept());
        channel.force(true);
      }
      int line = text.lines() + 1;
      problems.warning(
          new SourceLocation(journal.toString(), line, 1),
          "the last line was cut off by a crash; it was removed, and a copy is in %s"
              .formatted(copy.getFileName()));
      found.put("cut_off_line", line);
      found.put("bytes", text.tail());
      found.put("kept_as", copy.getFileName().toString());
    } else if (!text.ended()) {
      try (FileChannel channel = FileChannel.open(journal, StandardOpenOption.APPEND)) {
        DiskSync.write(channel, new byte[] {'\n'});
        channel.force(true);
      }
    }
    return found.isEmpty() ? Optional.empty() : Optional.of(found);
  }

  /** Reports the damaged lines of a journal, without changing it. */
  public static void tellDamaged(Path journal, JournalContent text, ProblemCollector problems) {
    for (int line : text.damaged()) {
      problems.warning(
          new SourceLocation(journal.toString(), line, 1),
          "this line is damaged and is ignored; the other lines are used, and nothing is deleted");
    }
  }

  private static Path copy(Path journal, byte[] tail) throws IOException {
    String name = journal.getFileName().toString();
    String stem = name.substring(0, name.lastIndexOf('.'));
    Path copy = journal;
    for (int number = 1; Files.exists(copy); number++) {
      copy =
          journal.resolveSibling(String.format(Locale.ROOT, "%s-cut-off-%02d.txt", stem, number));
    }
    FileOperations.PRIVATE.write(copy, tail);
    DiskSync.forceFolder(copy.getParent());
    return copy;
  }
}
