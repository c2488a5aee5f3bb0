package org.selectiverenderer.study.gaze;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Finds head logs: files as they are named, and in folders all tables with the first columns of a
 * head log, those of practice left out. Links in folders are not followed, since they may lead to
 * data of another study.
 */
final class HeadLogFinder {
  private static final int MOST_LOGS = 2000;
  private static final int MOST_FILES = 100_000;
  private static final int DEPTH = 8;
  private static final String FIRST_COLUMNS = "t,x,y,z,yaw,pitch,roll,motion,object,";
  private static final Pattern PRACTICE = Pattern.compile("practice_run-\\d+\\.csv");
  private static final Pattern PARTICIPANT = Pattern.compile("sub-[0-9A-Za-z]+");

  /**
   * A head log.
   *
   * @param participant tells participants apart: the folder {@code sub-ID} that holds the log, else
   *     the file itself
   * @param named whether the user named the file, rather than a folder that holds it
   */
  record Found(Path file, String participant, boolean named) {}

  private HeadLogFinder() {}

  /**
   * Finds the logs of files and folders, in their order.
   *
   * @throws IOException if a file or folder does not exist or cannot be read, if a folder holds no
   *     log, or if there are too many
   */
  static List<Found> find(List<Path> paths) throws IOException {
    Map<Path, Found> all = new LinkedHashMap<>();
    for (Path path : paths) {
      if (Files.isDirectory(path)) {
        List<Path> logs = inFolder(path);
        if (logs.isEmpty()) {
          throw new IOException(
              path + ": no head logs in this folder; run --head-log and studies write them");
        }
        logs.forEach(log -> all.putIfAbsent(key(log), found(log, false)));
      } else if (Files.exists(path)) {
        all.put(key(path), found(path, true));
      } else {
        throw new IOException(path + ": the file does not exist");
      }
      if (all.size() > MOST_LOGS) {
        throw new IOException(
            "%s: more than %d head logs; name fewer at once".formatted(path, MOST_LOGS));
      }
    }
    return List.copyOf(all.values());
  }

  private static Path key(Path log) {
    return log.toAbsolutePath().normalize();
  }

  private static Found found(Path log, boolean named) {
    Path at = key(log);
    for (Path folder = at.getParent(); folder != null; folder = folder.getParent()) {
      Path name = folder.getFileName();
      if (name != null && PARTICIPANT.matcher(name.toString()).matches()) {
        return new Found(log, folder.toString(), named);
      }
    }
    return new Found(log, at.toString(), named);
  }

  private static List<Path> inFolder(Path folder) throws IOException {
    List<Path> tables = new ArrayList<>();
    try (Stream<Path> files = Files.walk(folder, DEPTH)) {
      List<Path> all = files.limit(MOST_FILES + 1L).toList();
      if (all.size() > MOST_FILES) {
        throw new IOException(
            "%s: more than %d files; name a smaller folder".formatted(folder, MOST_FILES));
      }
      all.stream()
          .filter(file -> String.valueOf(file.getFileName()).endsWith(".csv"))
          .filter(file -> !PRACTICE.matcher(String.valueOf(file.getFileName())).matches())
          .filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS))
          .sorted()
          .forEach(tables::add);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    List<Path> logs = new ArrayList<>();
    for (Path table : tables) {
      if (isHeadLog(table)) {
        logs.add(table);
      }
    }
    return logs;
  }

  private static boolean isHeadLog(Path table) throws IOException {
    char[] first = new char[FIRST_COLUMNS.length()];
    try (BufferedReader text =
        new BufferedReader(
            new InputStreamReader(Files.newInputStream(table), StandardCharsets.ISO_8859_1))) {
      int read = text.read(first);
      return read == first.length && new String(first).equals(FIRST_COLUMNS);
    }
  }
}
