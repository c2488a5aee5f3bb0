package org.selectiverenderer.x3d.source;

import java.util.Optional;
import java.util.regex.Pattern;

/**
 * How a scene is written down. A file's first characters tell it, never the ending of its name:
 * scenes in the wild have any.
 */
public enum Encoding {
  /** X3D's XML encoding (ISO/IEC 19776-1). */
  XML("X3D XML"),
  /** ClassicVRML (ISO/IEC 19776-2). */
  CLASSIC("ClassicVRML"),
  /** VRML97 (ISO/IEC 14772-1), of which ClassicVRML is the heir. */
  VRML97("VRML97"),
  /** X3D's JSON encoding. */
  JSON("X3D JSON");

  private static final Pattern VRML2 = Pattern.compile("#VRML[ \\t]+V2\\.");

  private final String title;

  Encoding(String title) {
    this.title = title;
  }

  /** What users call it. */
  public String title() {
    return title;
  }

  /** Whether it is one of VRML's two. */
  public boolean vrml() {
    return this == CLASSIC || this == VRML97;
  }

  /** The encoding of a text that begins so; empty for one that is none of them. */
  public static Optional<Encoding> of(String head) {
    String start = head.stripLeading();
    if (head.isEmpty()) {
      return Optional.empty();
    }
    if (start.isEmpty() || start.startsWith("<")) {
      return Optional.of(XML);
    }
    if (start.startsWith("{")) {
      return Optional.of(JSON);
    }
    if (start.startsWith("#X3D")) {
      return Optional.of(CLASSIC);
    }
    return VRML2.matcher(start).lookingAt() ? Optional.of(VRML97) : Optional.empty();
  }
}
