package org.selectiverenderer.x3d.shader;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * The source text of one stage of a shader program.
 *
 * @param text the text in the shading language
 * @param start the location of its first character, in a scene or in a file of its own
 */
public record ShaderSource(String text, SourceLocation start) {
  /** The maximum size of a shader file in bytes. */
  public static final int MAX_BYTES = 1 << 20;

  /** The maximum length of the part of a data: url before the comma. */
  private static final int LONGEST_TYPE = 100;

  /**
   * Returns the inline text of a url: unencoded after {@code data:text/plain,}, as is usual in
   * scenes, or without any scheme. Empty for the name of a file, and for properly encoded {@code
   * data:} urls (RFC 2397).
   */
  static Optional<String> in(String url) {
    boolean plain = url.contains("\n") || url.contains("{") || url.contains(";\t");
    if (!plain) {
      return Optional.empty();
    }
    String head = url.stripLeading();
    if (!head.regionMatches(true, 0, "data:", 0, 5)) {
      return head.contains("{") ? Optional.of(url) : Optional.empty();
    }
    int comma = url.indexOf(',');
    boolean encoded =
        comma < 0
            || comma > LONGEST_TYPE
            || url.substring(0, comma).toLowerCase(Locale.ROOT).contains("base64");
    // a hand-written % stands for itself; encoded text has %25
    return encoded ? Optional.empty() : Optional.of(url.substring(comma + 1).replace("%25", "%"));
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it cannot be read or is larger than {@value #MAX_BYTES} bytes
   */
  public static ShaderSource read(UrlContent file) throws IOException {
    return new ShaderSource(
        new String(file.bytes(MAX_BYTES), StandardCharsets.UTF_8),
        new SourceLocation(file.name(), 1, 1));
  }

  /**
   * Returns the location of a position in the text.
   *
   * @param line the line, from 1
   * @param column the column, from 1, or 0 if unknown
   */
  public SourceLocation at(int line, int column) {
    if (start.line() == 0 || line < 1) {
      return start;
    }
    return new SourceLocation(start.file(), start.line() + line - 1, line == 1 ? 0 : column);
  }
}
