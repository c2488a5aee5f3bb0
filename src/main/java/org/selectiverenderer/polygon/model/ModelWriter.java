package org.selectiverenderer.polygon.model;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.X3dFile;
import org.selectiverenderer.x3d.geometry.Mesh;

/**
 * Writes models as X3D: a Shape per part, with an IndexedFaceSet of triangles, in the Interchange
 * profile of X3D 3.3 unless a material needs more. The same model gives the same bytes on every
 * machine; lines end in LF.
 */
public final class ModelWriter {
  /** What the Interchange profile has of the nodes that an appearance is made of. */
  private static final Set<String> INTERCHANGE =
      Set.of(
          "Appearance",
          "Material",
          "ImageTexture",
          "PixelTexture",
          "MultiTexture",
          "TextureTransform",
          "MultiTextureTransform",
          "TextureProperties");

  private static final Set<String> NEW_IN_4 = Set.of("PhysicalMaterial", "UnlitMaterial");

  /**
   * The file of a model.
   *
   * @param target the folder that it will lie in
   * @param title its name
   * @param description one sentence
   */
  public String text(Model model, Path target, String title, String description) {
    StringBuilder text = new StringBuilder(80 * model.polygons() + 1000);
    boolean plain = model.parts().stream().allMatch(part -> allOf(INTERCHANGE, part.appearance()));
    boolean recent = !model.parts().stream().allMatch(part -> noneOf(NEW_IN_4, part.appearance()));
    head(
        text,
        plain ? "Interchange" : "Full",
        recent ? "4.0" : "3.3",
        model.units(),
        title,
        description);
    NodeText nodes = new NodeText(text, target);
    int decimals = decimals(model.meshes());
    for (ModelPart part : model.parts()) {
      text.append("    <Shape>\n");
      if (part.appearance() != null) {
        nodes.append(part.appearance(), "appearance", part.folder(), 6);
      }
      new FaceSetText(text, part.mesh(), decimals).append();
      text.append("    </Shape>\n");
    }
    return end(text);
  }

  /**
   * A file of nodes as they are in another file.
   *
   * @param folder that their relative urls start from
   * @param scene the file that they come from
   */
  public String text(
      List<? extends NodeView> nodes,
      X3dFile scene,
      Path folder,
      Path target,
      String title,
      String description) {
    StringBuilder text = new StringBuilder();
    String profile = scene.profile().isEmpty() ? "Immersive" : scene.profile();
    String version = scene.version().isEmpty() ? "3.3" : scene.version();
    head(text, profile, version, scene.units(), title, description);
    NodeText writer = new NodeText(text, target);
    nodes.forEach(node -> writer.append(node, "", folder, 4));
    return end(text);
  }

  private static void head(
      StringBuilder text,
      String profile,
      String version,
      List<X3dFile.Unit> units,
      String title,
      String description) {
    text.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile='")
        .append(ValueText.escape(profile))
        .append("' version='")
        .append(ValueText.escape(version))
        .append("'>\n  <head>\n");
    for (X3dFile.Unit unit : units) {
      text.append("    <unit category='")
          .append(ValueText.escape(unit.category()))
          .append("' name='")
          .append(ValueText.escape(unit.name()))
          .append("' conversionFactor='")
          .append(NumberText.shortest(unit.conversionFactor()))
          .append("'/>\n");
    }
    meta(text, "title", title);
    meta(text, "description", description);
    meta(text, "generator", "Selective Renderer");
    text.append("  </head>\n  <Scene>\n");
  }

  private static void meta(StringBuilder text, String name, String content) {
    text.append("    <meta name='").append(name).append("' content='");
    text.append(ValueText.escape(content)).append("'/>\n");
  }

  private static String end(StringBuilder text) {
    return text.append("  </Scene>\n</X3D>\n").toString();
  }

  /** One digit more than the five that reduced models have, for those that are not reduced. */
  private static int decimals(List<Mesh> meshes) {
    double extent = 0;
    for (int axis = 0; axis < 3; axis++) {
      float least = Float.POSITIVE_INFINITY;
      float most = Float.NEGATIVE_INFINITY;
      for (Mesh mesh : meshes) {
        least = Math.min(least, mesh.bounds()[axis]);
        most = Math.max(most, mesh.bounds()[axis + 3]);
      }
      extent = Math.max(extent, (double) most - least);
    }
    int digits = extent > 0 ? 5 - (int) Math.floor(Math.log10(extent)) : 5;
    return Math.max(0, Math.min(9, digits));
  }

  private static boolean allOf(Set<String> types, @Nullable NodeView node) {
    return node == null
        || types.contains(node.type().name())
            && children(node).stream().allMatch(child -> allOf(types, child));
  }

  private static boolean noneOf(Set<String> types, @Nullable NodeView node) {
    return node == null
        || !types.contains(node.type().name())
            && children(node).stream().allMatch(child -> noneOf(types, child));
  }

  private static List<NodeView> children(NodeView node) {
    List<NodeView> children = new ArrayList<>();
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.value(field.index());
      if (value instanceof NodeView child) {
        children.add(child);
      } else if (field.type().isNode() && value instanceof List<?> list) {
        list.forEach(child -> children.add((NodeView) child));
      }
    }
    return children;
  }
}
