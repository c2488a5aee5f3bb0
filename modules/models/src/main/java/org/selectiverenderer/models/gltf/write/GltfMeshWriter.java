package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.formats.image.Srgb;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshReplicator;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.tessellate.GeoMeshOrigin;
import org.selectiverenderer.x3d.tessellate.InstancedShapeTransforms;
import org.selectiverenderer.x3d.tessellate.Tessellator;

/** Writes shapes as meshes. A shape or a geometry that is used again is written once. */
final class GltfMeshWriter {
  /**
   * A mesh of the document.
   *
   * @param index its index
   * @param origin where its local origin is, for geospatial geometry
   */
  record Written(int index, Optional<Vector3d> origin) {}

  /** The data of a geometry, which shapes with different materials share. */
  private record Attributes(ObjectNode primitive, GltfMaterialWriter.Use use) {}

  private record Key(NodeView geometry, boolean physical, boolean multiply) {}

  private final GltfDocument out;
  private final GltfMaterialWriter materials;
  private final GltfLosses losses;
  private final Tessellator tessellator = new Tessellator();
  private final Map<NodeView, Optional<Written>> shapes = new HashMap<>();
  private final Map<Key, Optional<Attributes>> geometries = new HashMap<>();

  GltfMeshWriter(GltfDocument out, GltfMaterialWriter materials, GltfLosses losses) {
    this.out = out;
    this.materials = materials;
    this.losses = losses;
  }

  /** Returns the mesh of a shape; empty if it draws nothing. */
  Optional<Written> mesh(NodeView shape, GltfPlace place) throws IOException {
    Optional<Written> known = shapes.get(shape);
    if (known == null) {
      known = write(shape, place);
      shapes.put(shape, known);
    }
    return known;
  }

  private Optional<Written> write(NodeView shape, GltfPlace place) throws IOException {
    NodeView geometry = shape.type().field("geometry").isPresent() ? shape.node("geometry") : null;
    if (geometry == null) {
      if (shape.type().field("geometry").isEmpty()) {
        losses.node(shape);
      }
      return Optional.empty();
    }
    NodeView appearance = shape.node("appearance");
    Key key = new Key(geometry, GltfMaterialWriter.physical(appearance), place.imagesMultiply());
    boolean instanced = shape.type().name().equals("InstancedShape");
    Optional<Attributes> data = instanced ? null : geometries.get(key);
    if (data == null) {
      data = attributes(shape, key);
      if (!instanced) {
        geometries.put(key, data);
      }
    }
    if (data.isEmpty()) {
      return Optional.empty();
    }
    ObjectNode primitive = data.get().primitive().deepCopy();
    primitive.put("material", materials.material(appearance, data.get().use(), place));
    ObjectNode mesh = out.object();
    String name = geometry.name() != null ? geometry.name() : shape.name();
    if (name != null) {
      mesh.put("name", name);
    }
    mesh.putArray("primitives").add(primitive);
    return Optional.of(new Written(out.add("meshes", mesh), GeoMeshOrigin.of(geometry)));
  }

  private Optional<Attributes> attributes(NodeView shape, Key key) throws IOException {
    Mesh mesh = tessellator.tessellate(key.geometry(), losses.problems()).orElse(null);
    if (mesh == null) {
      losses.node(key.geometry());
      return Optional.empty();
    }
    if (shape.type().name().equals("InstancedShape") && !mesh.isEmpty()) {
      mesh = MeshReplicator.of(mesh, InstancedShapeTransforms.of(shape, MeshReplicator.most(mesh)));
    }
    return mesh.isEmpty() ? Optional.empty() : Optional.of(attributes(mesh, key));
  }

  private Attributes attributes(Mesh mesh, Key key) throws IOException {
    GltfDocument.Target vertices = GltfDocument.Target.VERTICES;
    ObjectNode primitive = out.object();
    ObjectNode attributes = primitive.putObject("attributes");
    attributes.put("POSITION", out.floats(mesh.positions(), "VEC3", true, vertices));
    boolean lit = mesh.normals() != null;
    if (mesh.normals() != null) {
      attributes.put("NORMAL", out.floats(units(mesh.normals()), "VEC3", false, vertices));
    }
    boolean translucent = false;
    if (mesh.colors() != null) {
      float[] colors = colors(mesh.colors(), key.physical());
      for (int i = 3; i < colors.length; i += 4) {
        translucent |= colors[i] < 1;
      }
      attributes.put("COLOR_0", out.floats(colors, "VEC4", false, vertices));
    }
    GltfTexCoordSets sets = GltfTexCoordSets.of(key.geometry(), mesh);
    for (GltfTexCoordSets.Channel channel : sets.channels()) {
      float[] values =
          channel.source() == 0
              ? mesh.texCoords()
              : channel.number() < 0
                  ? null
                  : mesh.moreTexCoords().get(channel.source() - 1).values();
      if (channel.number() >= 0 && values != null) {
        attributes.put(
            "TEXCOORD_" + channel.number(), out.floats(down(values), "VEC2", false, vertices));
      }
    }
    primitive.put("indices", out.indices(mesh.indices()));
    primitive.put(
        "mode",
        switch (mesh.primitive()) {
          case POINTS -> 0;
          case LINES -> 1;
          case TRIANGLES -> 4;
        });
    GltfMaterialWriter.Use use =
        new GltfMaterialWriter.Use(
            sets,
            mesh.colors() != null,
            translucent,
            lit,
            mesh.solid() && mesh.primitive() == Mesh.Primitive.TRIANGLES,
            key.multiply());
    return new Attributes(primitive, use);
  }

  /** Returns unit vectors: glTF allows no others. */
  private static float[] units(float[] normals) {
    float[] units = normals.clone();
    for (int i = 0; i < units.length; i += 3) {
      double length =
          Math.sqrt(
              units[i] * (double) units[i]
                  + units[i + 1] * (double) units[i + 1]
                  + units[i + 2] * (double) units[i + 2]);
      boolean usable = length > 0 && Double.isFinite(length);
      for (int axis = 0; axis < 3; axis++) {
        units[i + axis] = usable ? (float) (units[i + axis] / length) : axis == 1 ? 1 : 0;
      }
    }
    return units;
  }

  /** Returns texture coordinates from the top: t of X3D goes up, v of glTF down. */
  private static float[] down(float[] texCoords) {
    float[] down = new float[texCoords.length];
    for (int i = 0; i + 1 < down.length; i += 2) {
      down[i] = Float.isFinite(texCoords[i]) ? texCoords[i] : 0;
      down[i + 1] = Float.isFinite(texCoords[i + 1]) ? 1 - texCoords[i + 1] : 0;
    }
    return down;
  }

  private static float[] colors(float[] rgba, boolean linear) {
    float[] colors = new float[rgba.length];
    for (int i = 0; i < colors.length; i++) {
      float value = rgba[i] >= 0 ? Math.min(rgba[i], 1) : 0;
      colors[i] = linear || i % 4 == 3 ? value : (float) Srgb.light(value);
    }
    return colors;
  }
}
