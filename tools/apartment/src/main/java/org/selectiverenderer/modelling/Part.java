package org.selectiverenderer.modelling;

import java.util.regex.Pattern;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * A piece of a model of one material: one X3D Shape.
 *
 * @param name letters, digits and underscores, unique within the model
 * @param creaseAngle edges whose faces meet at less than this angle look smooth, degrees
 * @param bothSides whether faces are seen from behind as well
 */
public record Part(
    String name, Look look, TriangleMesh mesh, double creaseAngle, boolean bothSides) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_]*");

  public Part {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException("\"" + name + "\" is no part's name");
    }
  }

  /**
   * With a crease angle of 35 degrees: roundings smooth, edges and chamfers sharp. A mesh with a
   * border is seen from both sides.
   */
  public static Part of(String name, Look look, TriangleMesh... meshes) {
    TriangleMesh mesh = TriangleMesh.of(meshes);
    return new Part(name, look, mesh, 35, !mesh.isClosed());
  }

  /** The same with another crease angle, degrees; 0 is facets, 180 smooth everywhere. */
  public Part crease(double degrees) {
    return new Part(name, look, mesh, degrees, bothSides);
  }

  /**
   * The same, not drawn where it is seen from behind: a ceiling that lets one look in from above.
   */
  public Part oneSided() {
    return new Part(name, look, mesh, creaseAngle, false);
  }

  /** The same with another mesh, seen from both sides if that one has a border. */
  public Part with(TriangleMesh other) {
    return new Part(
        name, look, other, creaseAngle, bothSides || mesh.isClosed() && !other.isClosed());
  }
}
