package org.selectiverenderer.modelling;

import java.util.regex.Pattern;

/**
 * A piece of a model of one material: one X3D Shape.
 *
 * @param name letters, digits and underscores, unique within the model
 * @param creaseAngle edges whose faces meet at less than this angle look smooth, degrees
 */
public record Part(String name, Look look, TriangleMesh mesh, double creaseAngle) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_]*");

  public Part {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException("\"" + name + "\" is no part's name");
    }
  }

  /** With a crease angle of 35 degrees: roundings smooth, edges and chamfers sharp. */
  public static Part of(String name, Look look, TriangleMesh... meshes) {
    return new Part(name, look, TriangleMesh.of(meshes), 35);
  }

  /** The same with another crease angle, degrees; 0 is facets, 180 smooth everywhere. */
  public Part crease(double degrees) {
    return new Part(name, look, mesh, degrees);
  }

  public Part with(TriangleMesh other) {
    return new Part(name, look, other, creaseAngle);
  }
}
