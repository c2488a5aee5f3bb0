package org.selectiverenderer.x3d.model;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The formats of models that are read as scenes. Most are recognised by their first bytes, whatever
 * the file is called; OBJ and STL have no such mark and are recognised by the ending of the name.
 */
public enum ModelFormat {
  /** The JSON form of glTF, with its numbers in other files or in data urls. */
  GLTF("glTF"),
  /** The binary form of glTF. */
  GLB("glTF"),
  /** Wavefront OBJ. */
  OBJ("OBJ"),
  /** STL, in text or binary. */
  STL("STL"),
  /** PLY, in text or binary. */
  PLY("PLY"),
  /** COLLADA. */
  DAE("COLLADA"),
  /** Autodesk FBX. */
  FBX("FBX");

  /** The members of glTF with which its text may begin; X3D in JSON begins with {@code X3D}. */
  private static final Pattern GLTF_START =
      Pattern.compile(
          "\\s*\\{\\s*\"(asset|accessors|animations|buffers|bufferViews|cameras|images|materials"
              + "|meshes|nodes|samplers|scene|scenes|skins|textures|extensionsUsed"
              + "|extensionsRequired)\"");

  private static final int HEAD = 512;
  private static final String COLLADA_ROOT = "<COLLADA";

  private final String title;

  ModelFormat(String title) {
    this.title = title;
  }

  /** Returns the name for users. */
  public String title() {
    return title;
  }

  /** Returns the ending by which other programs know the format, without a dot. */
  public String ending() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Detects the format of a file; empty for a scene, and for what is unknown.
   *
   * @param name the name of the file, or its url
   * @param length the number of bytes that count
   */
  public static Optional<ModelFormat> of(String name, byte[] bytes, int length) {
    String head = new String(bytes, 0, Math.min(length, HEAD), StandardCharsets.ISO_8859_1);
    if (head.startsWith("glTF")) {
      return Optional.of(GLB);
    }
    if (head.startsWith("ply\n") || head.startsWith("ply\r")) {
      return Optional.of(PLY);
    }
    if (head.startsWith("Kaydara FBX Binary")) {
      return Optional.of(FBX);
    }
    if (head.contains(COLLADA_ROOT) || GLTF_START.matcher(head).lookingAt()) {
      return Optional.of(head.contains(COLLADA_ROOT) ? DAE : GLTF);
    }
    return isScene(head) ? Optional.empty() : byName(name);
  }

  private static boolean isScene(String head) {
    String start = head.stripLeading();
    return start.startsWith("<")
        || start.startsWith("#X3D")
        || start.startsWith("#VRML")
        || start.startsWith("#Inventor")
        || start.startsWith("{") && start.contains("\"X3D\"");
  }

  /** Returns the format that the ending of a name means; empty for others. */
  public static Optional<ModelFormat> byName(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    String ending = lower.substring(lower.lastIndexOf('.') + 1);
    for (ModelFormat format : values()) {
      if (format.ending().equals(ending)) {
        return Optional.of(format);
      }
    }
    return Optional.empty();
  }
}
