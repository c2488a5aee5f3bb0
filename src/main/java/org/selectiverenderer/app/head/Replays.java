package org.selectiverenderer.app.head;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.base.csv.CsvColumns;
import org.selectiverenderer.base.csv.CsvTable;

/** What kind of log a replay is of. */
public final class Replays {
  private static final String[] COLUMNS = {"t", "x", "y", "z", "yaw", "pitch", "roll"};

  private Replays() {}

  /**
   * Whether a log has positions: the head log of a session, which is played again frame by frame. A
   * tracker's log has orientations, and places in the tracker's room under other names.
   *
   * @throws IOException if it cannot be read
   */
  public static boolean hasPositions(Path log) throws IOException {
    try (BufferedReader reader = Files.newBufferedReader(log, StandardCharsets.UTF_8)) {
      String header = reader.readLine();
      return header != null
          && CsvTable.parse(
                  log.toString(), header, CsvColumns.of(List.of(COLUMNS)), (at, fault) -> {})
              .filter(table -> Stream.of(COLUMNS).allMatch(table::has))
              .isPresent();
    } catch (MalformedInputException e) {
      return false; // Whoever reads all of it says what is wrong.
    }
  }
}
