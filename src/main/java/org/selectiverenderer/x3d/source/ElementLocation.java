package org.selectiverenderer.x3d.source;

import org.codehaus.stax2.XMLStreamLocation2;
import org.codehaus.stax2.XMLStreamReader2;
import org.selectiverenderer.base.problem.Location;

/**
 * Where an element starts in its file. Places within its start tag are found by reading the tag
 * once more, which costs nothing as long as nothing is wrong. Several threads may ask at a time.
 *
 * @param offset of the tag's {@code <}
 * @param location of the same
 */
public record ElementLocation(ElementSource source, int offset, Location location) {
  /** Where the parser's current event starts: in front of the root it counts white space to it. */
  static ElementLocation of(TextSource source, XMLStreamReader2 xml) {
    CharSequence text = source.characters();
    XMLStreamLocation2 at = xml.getLocationInfo().getStartLocation();
    int behind = offset(source, at);
    int offset = at.getCharacterOffset();
    int line = at.getLineNumber();
    int column = at.getColumnNumber();
    for (; offset < behind; offset++) {
      char c = text.charAt(offset);
      boolean first = c == '\r' && offset + 1 < text.length() && text.charAt(offset + 1) == '\n';
      column = c == '\n' || c == '\r' ? 1 : column + 1;
      line += (c == '\n' || c == '\r') && !first ? 1 : 0;
    }
    return new ElementLocation(source, offset, new Location(source.file(), line, column));
  }

  /** The offset of an event that starts there or, in front of the root, behind white space. */
  static int offset(TextSource source, XMLStreamLocation2 at) {
    CharSequence text = source.characters();
    int offset = at.getCharacterOffset();
    while (offset < text.length() && text.charAt(offset) <= ' ') {
      offset++;
    }
    return offset;
  }

  /** The name of the attribute of that index, namespace declarations not counted. */
  public Location attribute(int index) {
    synchronized (source) {
      return source.attribute(offset, index);
    }
  }

  /** A character of its value, counted from the first that is no white space. */
  public Location inAttribute(int index, int character) {
    synchronized (source) {
      return source.inAttribute(offset, index, character);
    }
  }

  /** The value of that attribute with the ends of its lines, which XML takes for blanks. */
  public String attributeLines(int index) {
    synchronized (source) {
      return source.attributeLines(offset, index);
    }
  }

  /** The value of that attribute as it is written, references and all. */
  String attributeText(int index) {
    synchronized (source) {
      return source.attributeText(offset, index);
    }
  }
}
