package org.selectiverenderer.x3d.source;

import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldParser;

/** The text that elements stand in, as it is now. Serves one thread. */
public interface ElementSource {
  /** The name that places call the file by. */
  String file();

  /** The characters; offsets of elements count these. */
  CharSequence characters();

  /** The place of a character. */
  Location location(int offset);

  /** What makes values of attributes. */
  FieldParser parser();

  /**
   * Where an attribute's name stands; where the element starts if there is no such attribute.
   *
   * @param element the offset at which its element starts
   * @param index from 0, namespace declarations not counted
   */
  default Location attribute(int element, int index) {
    WrittenAttribute found = tag(element).at(index);
    return location(found == null ? element : found.from());
  }

  /** Where a character of its value stands, counted from the first that is no white space. */
  default Location inAttribute(int element, int index, int character) {
    WrittenAttribute found = tag(element).at(index);
    return location(found == null ? element : found.at(character));
  }

  /** The value of that attribute as it is written, references and all. */
  default String attributeText(int element, int index) {
    WrittenAttribute found = tag(element).at(index);
    return found == null ? "" : found.written();
  }

  /** The value of that attribute with the ends of its lines, where its encoding loses them. */
  default String attributeLines(int element, int index) {
    WrittenAttribute found = tag(element).at(index);
    return found == null ? "" : found.lines();
  }

  /** The attributes of the tag that starts at an offset. */
  default StartTag tag(int start) {
    return StartTag.of(characters(), start, entities());
  }

  /** The entities that attributes may refer to; none where they are never expanded. */
  default Entities entities() {
    return Entities.NONE;
  }
}
