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

  /** The attributes of the tag that starts at an offset. */
  default StartTag tag(int start) {
    return StartTag.of(characters(), start);
  }
}
