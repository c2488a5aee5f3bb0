package org.selectiverenderer.models;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.catalogue.Profile;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.write.X3dNodeWriter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes models as X3D: a Shape per part, with an IndexedFaceSet of triangles, in the Interchange
 * profile of X3D 3.3 unless a material needs more. The same model gives the same bytes on every
 * machine; lines end in LF.
 */
public final class ModelWriter {
  /** The nodes of an appearance that the Interchange profile has. */
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
   * Returns the X3D text of a model.
   *
   * @param target the folder that the file will be in
   * @param title title of the file
   * @param description one sentence that describes the file
   */
  public String text(Model model, Path target, String title, String description) {
    X3dWriter out = new X3dWriter(80 * model.polygons() + 1000);
    boolean plain = model.parts().stream().allMatch(part -> allOf(INTERCHANGE, part.appearance()));
    boolean recent = !model.parts().stream().allMatch(part -> noneOf(NEW_IN_4, part.appearance()));
    out.file(plain ? "Interchange" : "Full", recent ? "4.0" : "3.3");
    head(out, Map.of(), model.units(), title, description);
    X3dNodeWriter nodes = new X3dNodeWriter(out, X3dNodeWriter.Written.GIVEN);
    int decimals = decimals(model.meshes());
    for (ModelPart part : model.parts()) {
      out.open("Shape");
      if (part.appearance() != null) {
        nodes.append(part.appearance(), "appearance", urls(part.folder(), target));
      }
      new MeshWriter(out, part.mesh(), decimals).append();
      out.close();
    }
    return out.finish();
  }

  /**
   * Returns the X3D text of nodes copied from another file, with the ROUTEs among them. Instances
   * of prototypes are written as the nodes of their bodies.
   *
   * @param folder the folder against which their relative urls are resolved
   * @param scene the file that they come from
   */
  public String text(
      List<? extends NodeView> nodes,
      X3dFile scene,
      Path folder,
      Path target,
      String title,
      String description) {
    X3dWriter out = new X3dWriter();
    String profile = scene.profile().isEmpty() ? "Immersive" : scene.profile();
    out.file(profile, scene.version().isEmpty() ? "3.3" : scene.version());
    RouteCopier routes = new RouteCopier(nodes, scene);
    Set<NodeType> types = new LinkedHashSet<>();
    nodes.forEach(node -> gather(types, node));
    routes.beside().forEach(node -> gather(types, node));
    head(
        out,
        Profile.of(profile).map(known -> known.missing(types.stream())).orElse(Map.of()),
        scene.units(),
        title,
        description);
    X3dNodeWriter writer = new X3dNodeWriter(out, X3dNodeWriter.Written.GIVEN);
    routes.name(writer);
    nodes.forEach(node -> writer.append(node, "", urls(folder, target)));
    routes.beside().forEach(node -> writer.append(node, "", urls(folder, target)));
    routes.append(out, writer);
    return out.finish();
  }

  private static X3dNodeWriter.UrlRule urls(Path folder, Path target) {
    return (node, url) ->
        node instanceof ParsedNode parsed
            ? turned(url, parsed.base(BaseUrl.folder(folder)), target)
            : UrlRelativizer.turned(url, folder, target);
  }

  /** Returns a url of a node that may be of a prototype from another folder, or from a host. */
  private static String turned(String url, BaseUrl base, Path target) {
    if (base instanceof BaseUrl.Folder folder) {
      return UrlRelativizer.turned(url, folder.path(), target);
    }
    if (base instanceof BaseUrl.FirstOf both) {
      boolean beside =
          !(both.first() instanceof BaseUrl.Folder folder) || found(url, folder.path());
      return turned(url, beside ? both.first() : both.second(), target);
    }
    try {
      return ((BaseUrl.Web) base).uri().resolve(url.strip()).toString();
    } catch (IllegalArgumentException e) {
      return url;
    }
  }

  private static boolean found(String url, Path folder) {
    try {
      return Files.exists(folder.resolve(url.strip().replaceFirst("#.*", "").replace('\\', '/')));
    } catch (InvalidPathException e) {
      return false;
    }
  }

  private static void head(
      X3dWriter out,
      Map<String, Integer> components,
      List<X3dFile.Unit> units,
      String title,
      String description) {
    out.open("head");
    components.forEach(out::component);
    units.forEach(unit -> out.unit(unit.category(), unit.name(), unit.conversionFactor()));
    out.meta("title", title).meta("description", description);
    out.meta("generator", "Selective Renderer").close().open("Scene");
  }

  /**
   * Returns the number of decimals: one more significant digit than the five of reduced models, for
   * models that are not reduced.
   */
  static int decimals(List<Mesh> meshes) {
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

  private static void gather(Set<NodeType> types, NodeView node) {
    if (node instanceof ParsedNode parsed) {
      NodeTraversal.visit(List.of(parsed), each -> types.add(each.type()));
    } else {
      types.add(node.type());
      children(node).forEach(child -> gather(types, child));
    }
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
