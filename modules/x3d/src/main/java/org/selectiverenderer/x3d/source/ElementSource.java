package org.selectiverenderer.x3d.source;

import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldParser;

/** The current text of a document, in which its elements are located. Not thread-safe. */
public interface ElementSource {
  /** Returns the name of the file in locations. */
  String file();

  /** Returns the characters, to which the offsets of elements refer. */
  CharSequence characters();

  /** Returns the location of a character. */
  SourceLocation location(int offset);

  /** Returns the parser of attribute values. */
  FieldParser parser();

  /**
   * Returns the location of an attribute, or of the element if there is no such attribute.
   *
   * @param element the offset of the element
   * @param index the index from 0, not counting namespace declarations
   */
  default SourceLocation attribute(int element, int index) {
    SourceAttribute found = tag(element).at(index);
    return location(found == null ? element : found.from());
  }

  /** Returns the location of a character of its value, counted from the first non-blank one. */
  default SourceLocation inAttribute(int element, int index, int character) {
    SourceAttribute found = tag(element).at(index);
    return location(found == null ? element : found.at(character));
  }

  /** Returns an attribute's value as it is written, with references. */
  default String attributeText(int element, int index) {
    SourceAttribute found = tag(element).at(index);
    return found == null ? "" : found.written();
  }

  /** Returns an attribute's value with its line ends, which XML normalizes to blanks. */
  default String attributeLines(int element, int index) {
    SourceAttribute found = tag(element).at(index);
    return found == null ? "" : found.lines();
  }

  /** Returns the start tag at an offset. */
  default StartTag tag(int start) {
    return StartTag.of(characters(), start, entities());
  }

  /** Returns the entities for references in attributes; none if they are expanded before. */
  default EntityTable entities() {
    return EntityTable.NONE;
  }
}
