package org.selectiverenderer.x3d.source;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/** Reads single lines of a scene file in any encoding or compression, for showing to a user. */
public final class SourceLineReader {
  private final SourceText text;
  private final LineIndex lines;

  private SourceLineReader(SourceText text) {
    this.text = text;
    this.lines = new LineIndex(text);
  }

  /**
   * Reads a stream to its end; the caller closes it.
   *
   * @param size the approximate size in bytes
   */
  public static SourceLineReader read(InputStream in, long size) throws IOException {
    SceneBytes bytes = SceneBytes.read(in, size, ReadLimits.standard());
    return new SourceLineReader(SourceText.of(bytes.bytes(), bytes.length()));
  }

  /** Returns the first characters, for detecting the encoding. */
  public String head() {
    return text.head(SceneEncoding.HEAD);
  }

  /**
   * Returns a part of a line.
   *
   * @param number the line number, from 1
   * @param from the index of the first character, from 0
   * @param length the maximum number of characters
   * @return empty if the file has no such line
   */
  public Optional<String> line(int number, int from, int length) {
    int start = lines.start(text, number);
    if (lines.line(text, start) != number) {
      return Optional.empty();
    }
    StringBuilder found = new StringBuilder();
    for (int i = start; i < text.length() && i < start + from + length; i++) {
      char c = text.charAt(i);
      if (c == '\n' || c == '\r') {
        break;
      }
      if (i >= start + from) {
        found.append(c);
      }
    }
    return Optional.of(found.toString());
  }
}
