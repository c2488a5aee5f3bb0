package org.selectiverenderer.study.web;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvErrorHandler;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * Finds the records of each session in files, without keeping them in the memory. A line of a file
 * is a record, or a part of several as the page sends it.
 */
final class WebRecordIndex {
  /** The receiver takes at most 16 MiB at once. */
  private static final int MOST_BYTES = 32 << 20;

  /** A session of two hours with all its head logs has less. */
  private static final long MOST_OF_SESSION = 1L << 28;

  private static final int MOST_LINES = 1_000_000;
  private static final int MOST_FILES = 100_000;
  private static final int MOST_SESSIONS = 100_000;
  private static final int MOST_PART = 1_000_000;
  private static final int DEEPEST = 4;
  private static final String SESSIONS = "sessions.csv";
  private static final Pattern UUID =
      Pattern.compile("[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}");

  private final String study;
  private final RecordFaults faults;
  private final Map<String, WebSessionLines> sessions = new TreeMap<>();

  /** A line of a file. */
  record Line(Path file, int number, long offset, int length) {
    SourceLocation place() {
      return new SourceLocation(file.toString(), number, 1);
    }

    /** Reads the line's JSON again. */
    JsonNode json() throws IOException {
      byte[] bytes = new byte[length];
      try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
        in.seek(offset);
        in.readFully(bytes);
      }
      return JsonTree.parse(new String(bytes, StandardCharsets.UTF_8));
    }
  }

  /**
   * Makes an index.
   *
   * @param study name of the study, whose records alone are taken
   */
  WebRecordIndex(String study, RecordFaults faults) {
    this.study = study;
    this.faults = faults;
  }

  /** Returns whether a text is the id of a session. */
  static boolean isSession(String text) {
    return UUID.matcher(text).matches();
  }

  /** Returns what was found, by the ids of the sessions. */
  Map<String, WebSessionLines> sessions() {
    return sessions;
  }

  /**
   * Adds a file, or the files of a folder that end with {@code .jsonl} or {@code .txt}.
   *
   * @throws IOException if it cannot be read
   */
  void add(Path path) throws IOException {
    if (!Files.isDirectory(path)) {
      InputFileReader.requireRegular(path);
      file(path);
      return;
    }
    List<Path> files;
    try (Stream<Path> found = Files.walk(path, DEEPEST)) {
      files = found.filter(WebRecordIndex::holdsRecords).limit(MOST_FILES + 1L).sorted().toList();
    }
    if (files.isEmpty() || files.size() > MOST_FILES) {
      throw new IOException(
          path
              + (files.isEmpty()
                  ? ": has no files of records, which end with .jsonl, or with .txt from JATOS;"
                      + " name the folder that receive.py --write has made"
                  : ": has more than " + MOST_FILES + " files"));
    }
    for (Path each : files) {
      file(each);
    }
    if (Files.isRegularFile(path.resolve(SESSIONS))) {
      receiverTable(path.resolve(SESSIONS));
    }
  }

  private static boolean holdsRecords(Path file) {
    String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    return (name.endsWith(".jsonl") || name.endsWith(".txt")) && Files.isRegularFile(file);
  }

  private void file(Path file) throws IOException {
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      long at = 0;
      long begin = 0;
      int number = 1;
      for (int next = in.read(); ; next = in.read()) {
        if (next == '\n' || next < 0) {
          line(file, number, begin, at - begin, bytes);
          if (next < 0) {
            return;
          }
          bytes.reset();
          begin = at + 1;
          if (++number > MOST_LINES) {
            faults.tell(
                new SourceLocation(file.toString(), number, 1),
                "the file has more than %d lines; the rest is left out".formatted(MOST_LINES));
            return;
          }
        } else if (at - begin < MOST_BYTES) {
          bytes.write(next);
        }
        at++;
      }
    }
  }

  private void line(Path file, int number, long begin, long length, ByteArrayOutputStream bytes) {
    SourceLocation place = new SourceLocation(file.toString(), number, 1);
    if (length > MOST_BYTES) {
      faults.tell(
          place, "the line has more than %d MiB; it is left out".formatted(MOST_BYTES >> 20));
      return;
    }
    String text = bytes.toString(StandardCharsets.UTF_8);
    if (text.isBlank()) {
      return;
    }
    JsonNode json;
    try {
      json = JsonTree.parse(text);
    } catch (JsonProcessingException e) {
      faults.tell(place, "the line is not valid JSON; it is left out");
      return;
    }
    String fault = fault(json);
    if (!fault.isEmpty()) {
      faults.tell(place, fault + "; the line is left out");
      return;
    }
    WebSessionLines own = lines(json.path("session").asText(), place);
    if (own != null && !own.fits(length, MOST_OF_SESSION)) {
      faults.tell(
          place,
          "the session %s has more than %d MiB; this line of it is left out"
              .formatted(own.session(), MOST_OF_SESSION >> 20));
    } else if (own != null) {
      own.add(new Line(file, number, begin, (int) length), json, faults);
    }
  }

  private @Nullable WebSessionLines lines(String session, SourceLocation place) {
    if (!sessions.containsKey(session) && sessions.size() >= MOST_SESSIONS) {
      faults.tell(
          place, "there are more than %d sessions; this one is left out".formatted(MOST_SESSIONS));
      return null;
    }
    return sessions.computeIfAbsent(session, WebSessionLines::new);
  }

  private String fault(JsonNode json) {
    boolean part = json.path("records").isArray() && json.path("part").isIntegralNumber();
    if (!json.isObject() || !part && !json.path("step").isTextual()) {
      return "this is neither a record of a study's page nor a part of several";
    }
    if (part
        && !(json.get("part").canConvertToInt()
            && json.get("part").asInt() >= 0
            && json.get("part").asInt() <= MOST_PART)) {
      return "\"part\" is not a number from 0 to " + MOST_PART;
    }
    if (!json.path("session").isTextual() || !isSession(json.get("session").asText())) {
      return "\"session\" is not an id that the page makes";
    }
    String name = json.path("study").asText();
    return name.equals(study)
        ? ""
        : "this is of the study %s, not of %s"
            .formatted(RecordFaults.quoted(name), RecordFaults.quoted(study));
  }

  /** Reads what the receiver tells of the parts of each session. */
  private void receiverTable(Path file) throws IOException {
    CsvErrorHandler misfit =
        new CsvErrorHandler() {
          @Override
          public void fault(SourceLocation at, String message) {
            faults.tell(at, message + "; the line is left out");
          }
        };
    Optional<CsvTable> table =
        CsvTable.read(file, CsvColumnSpec.of(List.of("session", "missing", "final")), misfit);
    if (table.isEmpty() || !Stream.of("session", "missing", "final").allMatch(table.get()::has)) {
      return;
    }
    table
        .get()
        .rows()
        .forEach(
            row -> {
              WebSessionLines own = sessions.get(row.cell("session"));
              if (own != null && row.cell("missing").matches("[0-9 ]{0,10000}")) {
                List<String> missing = new ArrayList<>(List.of(row.cell("missing").split(" ")));
                missing.removeIf(String::isEmpty);
                own.receiver(missing);
              }
            });
  }
}
