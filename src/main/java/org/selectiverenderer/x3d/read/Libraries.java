package org.selectiverenderer.x3d.read;

import java.util.List;
import org.selectiverenderer.x3d.files.ContentBase;

/** Where a reader gets prototypes of other files. Thread-safe. */
public interface Libraries {
  /** What became of looking for a library. */
  sealed interface Answer {
    /**
     * @param fragment what stands behind the sign # of the url: the prototype's name there
     */
    record Found(PrototypeLibrary library, String fragment) implements Answer {}

    /**
     * @param reason a clause that reads after "the prototype cannot be had: "
     */
    record None(String reason) implements Answer {}
  }

  /**
   * The library that the first readable one of some urls names. May wait until it is read.
   *
   * @param base where relative urls start
   */
  Answer find(List<String> urls, ContentBase base);

  /** For who reads a file by itself. */
  static Libraries none() {
    return (urls, base) -> new Answer.None("it is in another file, which is not read here");
  }
}
