package org.selectiverenderer.models.importer;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What a model file holds, all meshes in one coordinate frame. The arrays must not be modified.
 *
 * @param materials the materials, to which meshes refer by index
 * @param meshes the meshes of triangles
 */
public record ImportedModel(List<ImportedMaterial> materials, List<ImportedMesh> meshes) {
  /** Makes defensive copies of the lists. */
  public ImportedModel {
    materials = List.copyOf(materials);
    meshes = List.copyOf(meshes);
  }

  /**
   * A material. A value that the file does not state is null; numbers may be of any size, or not
   * finite.
   *
   * @param diffuse red, green, blue
   * @param specular red, green, blue
   * @param emissive red, green, blue
   * @param specularExponent the exponent of the Phong model
   * @param opacity 0 for transparent, 1 for opaque
   * @param texture the url of a picture, or {@code *N} for one inside the file
   */
  public record ImportedMaterial(
      float @Nullable [] diffuse,
      float @Nullable [] specular,
      float @Nullable [] emissive,
      @Nullable Float specularExponent,
      @Nullable Float opacity,
      @Nullable String texture) {}

  /**
   * A mesh. Numbers may be of any size, or not finite; indices are in range.
   *
   * @param name the name, or ""
   * @param material index of the material
   * @param positions x, y, z per vertex
   * @param normals x, y, z per vertex, or null
   * @param texCoords s, t per vertex, or null
   * @param colors r, g, b, a per vertex, or null
   * @param triangles three vertex indices per triangle
   */
  public record ImportedMesh(
      String name,
      int material,
      float[] positions,
      float @Nullable [] normals,
      float @Nullable [] texCoords,
      float @Nullable [] colors,
      int[] triangles) {}
}
