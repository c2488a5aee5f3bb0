package org.selectiverenderer.models;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * Diagnoses a model file that Assimp cannot read, since Assimp's own messages are about its code
 * rather than the file.
 */
final class ModelFileDiagnostics {
  /** The maximum number of characters of a line that are looked at. */
  private static final int MAX_LINE = 1 << 16;

  private final ModelSource file;
  private final String ending;
  private final ProblemCollector problems;

  ModelFileDiagnostics(ModelSource file, ProblemCollector problems) {
    this.file = file;
    this.problems = problems;
    this.ending = file.ending();
  }

  /** Reports why the file cannot be read at all. */
  void report() throws IOException {
    if (ending.equals("obj") && obj()) {
      return;
    }
    String kind = ending.startsWith("gl") ? "glTF" : ending.toUpperCase(Locale.ROOT);
    problems.error(
        SourceLocation.of(file.name()),
        "this is not a %s model, or it is damaged or cut off; nothing is read".formatted(kind));
  }

  /**
   * Reports why no face was read although the file should have some.
   *
   * @return whether a problem was reported
   */
  boolean reportMissingFaces() throws IOException {
    long announced = ending.equals("ply") ? announcedFaces() : 0;
    if (announced > 0) {
      problems.error(
          SourceLocation.of(file.name()),
          "the file announces %s, but none can be read; it is damaged or cut off"
              .formatted(Pluralizer.of(announced, "face")));
    }
    return announced > 0;
  }

  private BufferedReader lines() throws IOException {
    return new BufferedReader(new InputStreamReader(file.open(), StandardCharsets.ISO_8859_1));
  }

  /** Returns the number of faces that the header of a PLY file announces. */
  private long announcedFaces() throws IOException {
    try (BufferedReader lines = lines()) {
      String line = next(lines);
      while (line != null && !line.strip().equals("end_header")) {
        String[] words = line.strip().split("\\s+");
        if (words.length == 3 && words[0].equals("element") && words[1].equals("face")) {
          return number(words[2]);
        }
        line = next(lines);
      }
    }
    return 0;
  }

  private boolean obj() throws IOException {
    long vertices = 0;
    boolean faces = false;
    int number = 0;
    try (BufferedReader lines = lines()) {
      for (String line = next(lines); line != null; line = next(lines)) {
        number++;
        String[] words = line.strip().split("\\s+");
        if (words[0].equals("v")) {
          vertices++;
        } else if (words[0].equals("f")) {
          faces = true;
          for (int i = 1; i < words.length; i++) {
            long vertex = number(words[i].split("/", -1)[0]);
            if (vertex == 0 || Math.abs(vertex) > vertices) {
              problems.error(
                  new SourceLocation(file.name(), number, 1),
                  ("the face refers to vertex %d, but only %d come before it; the "
                          + "model is not read")
                      .formatted(vertex, vertices));
              return true;
            }
          }
        }
      }
    }
    if (!faces) {
      problems.error(
          SourceLocation.of(file.name()), "the file has no faces, so there is nothing to reduce");
    }
    return !faces;
  }

  /** Returns the next line, without what is beyond {@link #MAX_LINE}; null at the end. */
  private static @Nullable String next(BufferedReader lines) throws IOException {
    StringBuilder line = new StringBuilder();
    int c = lines.read();
    if (c < 0) {
      return null;
    }
    for (; c >= 0 && c != '\n'; c = lines.read()) {
      if (line.length() < MAX_LINE) {
        line.append((char) c);
      }
    }
    return line.toString();
  }

  /** Returns the number in a text; 0 if there is none. */
  private static long number(String text) {
    return text.matches("-?\\d{1,18}") ? Long.parseLong(text) : 0;
  }
}
