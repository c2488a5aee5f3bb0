package org.selectiverenderer.models.importer;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Holds the content of a model file, in metres and with y upwards. The arrays must not be modified;
 * numbers may be of any size, or not finite, indices are in range.
 *
 * @param materials the materials, to which meshes refer by index
 * @param meshes the meshes of triangles, or of points, each in the coordinates of the nodes that
 *     have it
 * @param textures pictures inside of the file
 * @param nodes the tree of nodes, parents before their children; the first is the root
 * @param cameras the cameras
 * @param lights the lights
 * @param animations the animations of nodes
 */
public record ImportedModel(
    List<ImportedMaterial> materials,
    List<ImportedMesh> meshes,
    List<ImportedTexture> textures,
    List<ImportedNode> nodes,
    List<ImportedCamera> cameras,
    List<ImportedLight> lights,
    List<ImportedAnimation> animations) {
  /** Makes defensive copies of the lists. */
  public ImportedModel {
    materials = List.copyOf(materials);
    meshes = List.copyOf(meshes);
    textures = List.copyOf(textures);
    nodes = List.copyOf(nodes);
    cameras = List.copyOf(cameras);
    lights = List.copyOf(lights);
    animations = List.copyOf(animations);
  }

  /**
   * A picture inside of the file.
   *
   * @param bytes a PNG or JPEG file or another, as its first bytes tell; empty for a picture that
   *     is not in the form of a file
   */
  public record ImportedTexture(byte[] bytes) {}

  /**
   * A node.
   *
   * @param name the name, or ""
   * @param parent the index of its parent, less than its own; -1 for the root
   * @param matrix its place in its parent, 16 numbers in column-major order
   * @param meshes the indices of its meshes
   */
  public record ImportedNode(String name, int parent, float[] matrix, int[] meshes) {}

  /**
   * A camera.
   *
   * @param node the index of its node
   * @param position x, y, z in the node's coordinates
   * @param direction in which it looks
   * @param up the direction that is above in the picture
   * @param fieldOfView the horizontal angle in radians
   * @param aspect the width of the picture divided by its height; 0 if unknown
   * @param orthographicWidth half the width of an orthographic camera; 0 for a perspective one
   */
  public record ImportedCamera(
      int node,
      float[] position,
      float[] direction,
      float[] up,
      float fieldOfView,
      float aspect,
      float orthographicWidth) {}

  /** The kinds of lights; {@code OTHER} is none of X3D's. */
  public enum LightKind {
    DIRECTIONAL,
    POINT,
    SPOT,
    OTHER
  }

  /**
   * A light.
   *
   * @param node the index of its node
   * @param position x, y, z in the node's coordinates
   * @param direction to which it shines
   * @param color red, green, blue, also more than 1
   * @param attenuation constant, linear and quadratic
   * @param cone the inner and the outer angle of a spot light, full angles in radians
   */
  public record ImportedLight(
      int node,
      LightKind kind,
      float[] position,
      float[] direction,
      float[] color,
      float[] attenuation,
      float[] cone) {}

  /**
   * An animation.
   *
   * @param name the name, or ""
   * @param channels what it moves
   * @param morphs whether it also changes shapes, which is not read
   */
  public record ImportedAnimation(String name, List<ImportedChannel> channels, boolean morphs) {
    /** Makes a defensive copy of the list. */
    public ImportedAnimation {
      channels = List.copyOf(channels);
    }
  }

  /**
   * Describes how a node moves; each property has times in seconds and a value for each of them.
   *
   * @param node the index of the node
   * @param rotations quaternions x, y, z, w
   */
  public record ImportedChannel(
      int node,
      float[] translationTimes,
      float[] translations,
      float[] rotationTimes,
      float[] rotations,
      float[] scaleTimes,
      float[] scales) {}

  /**
   * A joint of a mesh.
   *
   * @param node the index of its node
   * @param inverse the matrix from the mesh's coordinates to the joint's when it was bound, 16
   *     numbers in column-major order
   * @param vertices the indices of the vertices that follow it
   * @param weights how much each of them does
   */
  public record ImportedBone(int node, float[] inverse, int[] vertices, float[] weights) {}

  /**
   * A material. A value that the file does not state is null.
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
   * A mesh.
   *
   * @param name the name, or ""
   * @param material index of the material
   * @param positions x, y, z per vertex
   * @param normals x, y, z per vertex, or null
   * @param texCoords s, t per vertex, or null
   * @param colors r, g, b, a per vertex, or null
   * @param triangles three vertex indices per triangle; none in a cloud of points
   * @param bones the joints that move it; empty for none
   */
  public record ImportedMesh(
      String name,
      int material,
      float[] positions,
      float @Nullable [] normals,
      float @Nullable [] texCoords,
      float @Nullable [] colors,
      int[] triangles,
      List<ImportedBone> bones) {
    /** Makes a defensive copy of the list. */
    public ImportedMesh {
      bones = List.copyOf(bones);
    }
  }
}
