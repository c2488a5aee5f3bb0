package org.selectiverenderer.x3d.source;

import org.codehaus.stax2.XMLStreamLocation2;
import org.codehaus.stax2.XMLStreamReader2;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * The location of an element in its file. Locations within its start tag are found by parsing the
 * tag again, which is needed only for error messages. Thread-safe.
 *
 * @param offset the offset of the tag's {@code <}
 * @param location the location of the tag's {@code <}
 */
public record ElementLocation(ElementSource source, int offset, SourceLocation location) {
  /** Returns the start of the parser's current event, after the white space before the root. */
  static ElementLocation of(TextSource source, XMLStreamReader2 xml) {
    CharSequence text = source.characters();
    XMLStreamLocation2 at = xml.getLocationInfo().getStartLocation();
    int behind = offset(source, at);
    int offset = at.getCharacterOffset();
    int line = at.getLineNumber();
    int column = at.getColumnNumber();
    if (source.isExpanded()) {
      return new ElementLocation(source, behind, source.location(behind));
    }
    for (; offset < behind; offset++) {
      char c = text.charAt(offset);
      boolean first = c == '\r' && offset + 1 < text.length() && text.charAt(offset + 1) == '\n';
      column = c == '\n' || c == '\r' ? 1 : column + 1;
      line += (c == '\n' || c == '\r') && !first ? 1 : 0;
    }
    return new ElementLocation(source, offset, new SourceLocation(source.file(), line, column));
  }

  /** Returns the offset of an event, after the white space before the root. */
  static int offset(TextSource source, XMLStreamLocation2 at) {
    CharSequence text = source.characters();
    int offset = at.getCharacterOffset();
    while (offset < text.length() && text.charAt(offset) <= ' ') {
      offset++;
    }
    return offset;
  }

  /** Returns the location of an attribute, not counting namespace declarations. */
  public SourceLocation attribute(int index) {
    synchronized (source) {
      return source.attribute(offset, index);
    }
  }

  /** Returns the location of a character of its value, counted from the first non-blank one. */
  public SourceLocation inAttribute(int index, int character) {
    synchronized (source) {
      return source.inAttribute(offset, index, character);
    }
  }

  /** Returns an attribute's value with its line ends, which XML normalizes to blanks. */
  public String attributeLines(int index) {
    synchronized (source) {
      return source.attributeLines(offset, index);
    }
  }

  /** Returns an attribute's value as it is written, with references. */
  String attributeText(int index) {
    synchronized (source) {
      return source.attributeText(offset, index);
    }
  }
}
