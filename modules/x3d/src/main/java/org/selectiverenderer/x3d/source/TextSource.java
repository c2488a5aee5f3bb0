package org.selectiverenderer.x3d.source;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldParser;

/** An unchanging text. Its lines are indexed when the first location is needed. */
public final class TextSource implements ElementSource {
  private final String file;
  private final CharSequence text;
  private final EntityTable declared;
  private final CharSequence original;
  private final @Nullable ExpansionMapping expansions;
  private final boolean located;
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
    this(file, text, EntityTable.NONE, text, null, true);
  }

  private TextSource(
      String file,
      CharSequence text,
      EntityTable declared,
      CharSequence original,
      @Nullable ExpansionMapping expansions,
      boolean located) {
    this.file = file;
    this.text = text;
    this.declared = declared;
    this.original = original;
    this.expansions = expansions;
    this.located = located;
  }

  /**
   * Returns this text with its entities expanded; locations are those of the references.
   *
   * @param declared the entities of the text
   */
  TextSource expanded(CharSequence expanded, EntityTable declared, ExpansionMapping mapping) {
    return new TextSource(file, expanded, declared, original, mapping, located);
  }

  /**
   * Returns the source of a text that the user has never seen, as it was translated from a model;
   * locations name the file only.
   */
  static TextSource translated(String file, CharSequence text) {
    return new TextSource(file, text, EntityTable.NONE, text, null, false);
  }

  /** Returns whether entities are expanded, so that offsets are not those of the file. */
  boolean isExpanded() {
    return expansions != null;
  }

  /** Returns the entities of the DOCTYPE, for messages; empty if none has been expanded. */
  EntityTable declared() {
    return declared;
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
    if (!located) {
      return SourceLocation.of(file);
    }
    LineIndex known = lines;
    if (known == null) {
      known = new LineIndex(original);
      lines = known;
    }
    int at = expansions == null ? offset : expansions.original(offset);
    int line = known.line(original, at);
    return new SourceLocation(file, line, at - known.start(original, line) + 1);
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
