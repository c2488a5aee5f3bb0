package org.selectiverenderer.runtime.loading;

import java.util.regex.Pattern;

/**
 * Completes scene texts that lack a file header: createVrmlFromString takes nodes without the
 * header (VRML97, 4.12.10.7), and many applications leave it out of XML, too.
 */
final class SceneText {
  private static final Pattern WHOLE =
      Pattern.compile("\\A\\s*(?:#|\\{|<\\?|<!|<X3D\\b)", Pattern.CASE_INSENSITIVE);
  private static final Pattern ELEMENT = Pattern.compile("\\A\\s*<");

  private SceneText() {}

  /** Returns the text, with a header added if it has none. */
  static String whole(String text) {
    if (WHOLE.matcher(text).lookingAt()) {
      return text;
    }
    return ELEMENT.matcher(text).lookingAt()
        ? "<X3D version='4.0' profile='Full'><Scene>" + text + "</Scene></X3D>"
        : "#VRML V2.0 utf8\n" + text;
  }
}
