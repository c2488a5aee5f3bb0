package org.selectiverenderer.app.head;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvTable;

/** Tells head logs and tracker logs apart when a log is replayed. */
public final class ReplayLogFormat {
  private static final String[] COLUMNS = {"t", "x", "y", "z", "yaw", "pitch", "roll"};

  private ReplayLogFormat() {}

  /**
   * Returns whether a log has the viewer's positions: then it is the head log of a session, which
   * is replayed frame by frame. A tracker log has orientations only, and positions in tracker
   * coordinates in other columns.
   *
   * @throws IOException if it cannot be read
   */
  public static boolean hasPositions(Path log) throws IOException {
    InputFileReader.requireRegular(log);
    try (BufferedReader reader = Files.newBufferedReader(log, StandardCharsets.UTF_8)) {
      String header = reader.readLine();
      return header != null
          && CsvTable.parse(
                  log.toString(), header, CsvColumnSpec.of(List.of(COLUMNS)), (at, fault) -> {})
              .filter(table -> Stream.of(COLUMNS).allMatch(table::has))
              .isPresent();
    } catch (MalformedInputException e) {
      return false; // The reader of the whole log reports what is wrong.
    }
  }
}
