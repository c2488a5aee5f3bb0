package org.selectiverenderer.x3d;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/** The lines of a scene's file, whatever its encoding or compression, for showing one to a user. */
public final class SourceLines {
  private final SourceText text;
  private int line = 1;
  private int start;

  private SourceLines(SourceText text) {
    this.text = text;
  }

  /**
   * Reads a stream to its end; the caller closes it.
   *
   * @param size in bytes, about
   */
  public static SourceLines read(InputStream in, long size) throws IOException {
    SceneBytes bytes = SceneBytes.read(in, size, ReadLimits.standard());
    return new SourceLines(SourceText.of(bytes.bytes(), bytes.length()));
  }

  /**
   * A part of a line. Cheap when lines are asked for from first to last.
   *
   * @param number from 1
   * @param from the first character wanted, from 0
   * @param length characters at most
   * @return empty if the file has no such line
   */
  public Optional<String> line(int number, int from, int length) {
    if (number < line) {
      line = 1;
      start = 0;
    }
    while (line < number && start < text.length()) {
      char c = text.charAt(start++);
      boolean first = c == '\r' && start < text.length() && text.charAt(start) == '\n';
      line += (c == '\n' || c == '\r') && !first ? 1 : 0;
    }
    if (line != number) {
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
