package org.selectiverenderer.x3d.source;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldParser;

/** A text that does not change. Its lines are found when the first place is asked for. */
public final class TextSource implements ElementSource {
  private final String file;
  private final CharSequence text;
  private final FieldParser parser = new FieldParser();
  private @Nullable LineIndex lines;
  private @Nullable StartTag tag;
  private int tagStart;

  /**
   * @param file the name that places call it by
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
  public Location location(int offset) {
    LineIndex known = lines;
    if (known == null) {
      known = new LineIndex(text);
      lines = known;
    }
    int line = known.line(text, offset);
    return new Location(file, line, offset - known.start(text, line) + 1);
  }

  @Override
  public FieldParser parser() {
    return parser;
  }

  /** Keeps the last tag, so that who asks for one attribute after the other has it read once. */
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
