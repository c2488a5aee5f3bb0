package org.selectiverenderer.x3d.source;

import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The encodings of X3D and VRML scenes. The encoding of a file is detected by its first characters,
 * not by its file name, which is often wrong.
 */
public enum SceneEncoding {
  /** X3D's XML encoding (ISO/IEC 19776-1). */
  XML("X3D XML"),
  /** ClassicVRML (ISO/IEC 19776-2). */
  CLASSIC("ClassicVRML"),
  /** VRML97 (ISO/IEC 14772-1), the predecessor of ClassicVRML. */
  VRML97("VRML97"),
  /** VRML 1.0, whose nodes change a state, as in Open Inventor. */
  VRML1("VRML 1.0"),
  /** X3D's JSON encoding. */
  JSON("X3D JSON"),
  /** An X3D element within a page of HTML or XHTML. */
  PAGE("HTML page");

  /** The number of characters at the start of a text by which its encoding is detected. */
  static final int HEAD = 1024;

  /** The start of a page, after an XML declaration and comments; an X3D file's root is X3D. */
  private static final Pattern PAGE_HEAD =
      Pattern.compile(
          "(?:<\\?[^>]*>|<!--(?:[^-]|-(?!->))*+-->|\\s)*+"
              + "(?:(?i:<!DOCTYPE\\s+html|<html)\\b|<x3d\\b).*",
          Pattern.DOTALL);

  private static final Pattern VRML1_HEAD = Pattern.compile("#VRML[ \\t]+V1\\.");

  /** The header that some exporters write instead of {@code #X3D V4.0}. */
  private static final Pattern MISNAMED_CLASSIC = Pattern.compile("#VRML[ \\t]+V[34]\\.");

  private static final Pattern VRML2 = Pattern.compile("#VRML[ \\t]+V2\\.");

  private final String title;

  SceneEncoding(String title) {
    this.title = title;
  }

  /** Returns the name for users. */
  public String title() {
    return title;
  }

  /** Returns whether this is ClassicVRML or VRML97. */
  public boolean vrml() {
    return this == CLASSIC || this == VRML97;
  }

  /** Detects the encoding by the beginning of a text; empty if it is unknown. */
  public static Optional<SceneEncoding> of(String head) {
    String start = head.stripLeading();
    if (head.isEmpty()) {
      return Optional.empty();
    }
    if (start.isEmpty() || start.startsWith("<")) {
      return Optional.of(PAGE_HEAD.matcher(start).matches() ? PAGE : XML);
    }
    if (start.startsWith("{")) {
      return Optional.of(JSON);
    }
    if (start.startsWith("#X3D") || MISNAMED_CLASSIC.matcher(start).lookingAt()) {
      return Optional.of(CLASSIC);
    }
    if (VRML1_HEAD.matcher(start).lookingAt()) {
      return Optional.of(VRML1);
    }
    return VRML2.matcher(start).lookingAt() ? Optional.of(VRML97) : Optional.empty();
  }
}
