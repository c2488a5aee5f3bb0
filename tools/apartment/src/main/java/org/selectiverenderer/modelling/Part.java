package org.selectiverenderer.modelling;

import java.util.regex.Pattern;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * A part of a model with one material: one X3D Shape.
 *
 * @param name letters, digits and underscores, unique within the model
 * @param creaseAngle edges whose faces meet at less than this angle look smooth, degrees
 * @param bothSides whether faces are visible from behind as well
 */
public record Part(
    String name, ModelMaterial look, TriangleMesh mesh, double creaseAngle, boolean bothSides) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_]*");

  public Part {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException(
          "part name \"" + name + "\": use a letter, then letters, digits and _");
    }
  }

  /**
   * Returns a part with a crease angle of 35 degrees: roundings are shaded smooth, edges and
   * chamfers sharp. A mesh with a border is two-sided.
   */
  public static Part of(String name, ModelMaterial look, TriangleMesh... meshes) {
    TriangleMesh mesh = TriangleMesh.of(meshes);
    return new Part(name, look, mesh, 35, !mesh.isClosed());
  }

  /**
   * Returns the part with another crease angle, degrees; 0 gives flat facets, 180 smooth shading
   * everywhere.
   */
  public Part crease(double degrees) {
    return new Part(name, look, mesh, degrees, bothSides);
  }

  /**
   * Returns the part with back faces culled, as for a ceiling through which one can look in from
   * above.
   */
  public Part oneSided() {
    return new Part(name, look, mesh, creaseAngle, false);
  }

  /** Returns the part with another mesh, two-sided if that mesh has a border. */
  public Part with(TriangleMesh other) {
    return new Part(
        name, look, other, creaseAngle, bothSides || mesh.isClosed() && !other.isClosed());
  }
}
