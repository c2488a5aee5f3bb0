package org.selectiverenderer.app;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/** What kind of log a replay is of. */
public final class Replays {
  private Replays() {}

  /**
   * Whether a log has positions: the head log of a session, which is played again frame by frame. A
   * tracker's log has orientations only.
   *
   * @throws IOException if it cannot be read
   */
  public static boolean hasPositions(Path log) throws IOException {
    try (BufferedReader reader = Files.newBufferedReader(log, StandardCharsets.UTF_8)) {
      String header = reader.readLine();
      if (header == null) {
        return false;
      }
      Set<String> names =
          Arrays.stream(header.toLowerCase(Locale.ROOT).split(","))
              .map(name -> name.replace("\"", "").replace("\uFEFF", "").strip())
              .collect(Collectors.toSet());
      return names.containsAll(Set.of("t", "x", "y", "z", "yaw", "pitch", "roll"));
    } catch (MalformedInputException e) {
      return false; // Whoever reads all of it says what is wrong.
    }
  }
}
