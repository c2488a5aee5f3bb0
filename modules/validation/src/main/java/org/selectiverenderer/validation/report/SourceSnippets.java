package org.selectiverenderer.validation.report;

import java.io.IOException;
import java.io.InputStream;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.x3d.source.SourceLineReader;

/**
 * Reads the source lines of findings. Files are read again, one at a time and only those with
 * findings, since keeping all of them would take too much memory.
 */
final class SourceSnippets {
  private static final int WIDTH = 100;
  private static final int LEFT = 60;

  /**
   * A snippet: a part of a line of a file.
   *
   * @param before white space as wide as the text before the location, tabs kept
   */
  public record Snippet(String text, String before) {}

  private final Map<String, SourceFile> files = new HashMap<>();
  private String open = "";
  private @Nullable SourceLineReader lines;

  public SourceSnippets(List<SourceFile> files) {
    files.forEach(file -> this.files.put(file.name(), file));
  }

  /**
   * Returns the line of a location, cut to the width of a terminal; empty for a file as a whole.
   */
  public Optional<Snippet> at(SourceLocation location) {
    if (location.line() == 0 || location.column() == 0) {
      return Optional.empty();
    }
    SourceLineReader source = lines(location.file());
    if (source == null) {
      return Optional.empty();
    }
    int from = location.column() <= WIDTH ? 0 : location.column() - LEFT;
    return source
        .line(location.line(), from, WIDTH)
        .map(SourceSnippets::printable)
        .map(
            text -> {
              String left =
                  text.substring(0, Math.min(text.length(), location.column() - 1 - from));
              return new Snippet(text.stripTrailing(), left.replaceAll("[^\\t]", " "));
            });
  }

  private @Nullable SourceLineReader lines(String name) {
    if (!name.equals(open)) {
      open = name;
      lines = null;
      SourceFile file = files.get(name);
      if (file != null) {
        try (InputStream in = file.open()) {
          lines = SourceLineReader.read(in, file.size());
        } catch (IOException e) {
          lines = null; // The file is gone: the finding is shown without its line.
        }
      }
    }
    return lines;
  }

  private static String printable(String text) {
    return text.codePoints()
        .map(c -> ControlCharacterEscaper.isControl(c) ? '?' : c)
        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
        .toString();
  }
}
