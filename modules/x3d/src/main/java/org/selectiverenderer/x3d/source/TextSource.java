package org.selectiverenderer.x3d.source;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldParser;

/** An unchanging text. Its lines are indexed when the first location is needed. */
public final class TextSource implements ElementSource {
  private final String file;
  private final CharSequence text;
  private final FieldParser parser = new FieldParser();
  private @Nullable LineIndex lines;
  private @Nullable StartTag tag;
  private int tagStart;

  /**
   * Creates a source.
   *
   * @param file the name of the file in locations
   */
  public TextSource(String file, CharSequence text) {
    this.file = file;
    this.text = text;
  }

  @Override
  public String file() {
    return file;
  }

  @Override
  public CharSequence characters() {
    return text;
  }

  @Override
  public SourceLocation location(int offset) {
    LineIndex known = lines;
    if (known == null) {
      known = new LineIndex(text);
      lines = known;
    }
    int line = known.line(text, offset);
    return new SourceLocation(file, line, offset - known.start(text, line) + 1);
  }

  @Override
  public FieldParser parser() {
    return parser;
  }

  /** Caches the last tag, as its attributes are often read one after the other. */
  @Override
  public StartTag tag(int start) {
    StartTag known = tag;
    if (known == null || tagStart != start) {
      known = StartTag.of(text, start, entities());
      tag = known;
      tagStart = start;
    }
    return known;
  }
}
