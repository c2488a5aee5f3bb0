package org.selectiverenderer.runtime.loading;

import java.util.regex.Pattern;

/**
 * Texts of scenes as applications write them: createVrmlFromString takes nodes without the header
 * that a file begins with (VRML97, 4.12.10.7), and many leave it out of XML, too.
 */
final class SceneText {
  private static final Pattern WHOLE =
      Pattern.compile("\\A\\s*(?:#|\\{|<\\?|<!|<X3D\\b)", Pattern.CASE_INSENSITIVE);
  private static final Pattern ELEMENT = Pattern.compile("\\A\\s*<");

  private SceneText() {}

  /** The text with a header, if it has none. */
  static String whole(String text) {
    if (WHOLE.matcher(text).lookingAt()) {
      return text;
    }
    return ELEMENT.matcher(text).lookingAt()
        ? "<X3D version='4.0' profile='Full'><Scene>" + text + "</Scene></X3D>"
        : "#VRML V2.0 utf8\n" + text;
  }
}
