package org.selectiverenderer.x3d.shader;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.files.Content;

/**
 * The text of one stage of a shader's program.
 *
 * @param text in the shader's language
 * @param start where its first character stands: in a scene, or in a file of its own
 */
public record ShaderText(String text, Location start) {
  /** Far more than anybody writes. */
  public static final int MAX_BYTES = 1 << 20;

  /** Characters of a url up to the comma of its data: a media type and no more. */
  private static final int LONGEST_TYPE = 100;

  /**
   * The text that stands in a url itself: after {@code data:text/plain,} as it is written in
   * scenes, with blanks and new lines, or as text without any scheme. Empty for the name of a file,
   * and for {@code data:} urls that are written as the network has it (RFC 2397).
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
    // Written by hand a % is a %; who encodes it writes %25.
    return encoded ? Optional.empty() : Optional.of(url.substring(comma + 1).replace("%25", "%"));
  }

  /**
   * Reads a file.
   *
   * @throws IOException when it cannot be read or is larger than {@value #MAX_BYTES} bytes
   */
  public static ShaderText read(Content file) throws IOException {
    return new ShaderText(
        new String(file.bytes(MAX_BYTES), StandardCharsets.UTF_8), new Location(file.name(), 1, 1));
  }

  /**
   * Where a place of the text stands.
   *
   * @param line from 1
   * @param column from 1, or 0 when it is not known
   */
  public Location at(int line, int column) {
    if (start.line() == 0 || line < 1) {
      return start;
    }
    return new Location(start.file(), start.line() + line - 1, line == 1 ? 0 : column);
  }
}
