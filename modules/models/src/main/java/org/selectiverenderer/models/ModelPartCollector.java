package org.selectiverenderer.models;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshReplicator;
import org.selectiverenderer.geometry.mesh.MeshTransformer;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.PrototypeLibraryProvider;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.tessellate.GeoMeshOrigin;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;
import org.selectiverenderer.x3d.tessellate.InstancedShapeTransforms;
import org.selectiverenderer.x3d.tessellate.Tessellator;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Collects the surfaces of nodes and of what they inline. Of nodes that select one of their
 * children it takes the child that a browser shows initially: the choice of a Switch, the finest
 * level of an LOD.
 */
final class ModelPartCollector {
  private static final int DEEPEST = 500;

  /** The numbers of a vertex: position, normal and texture coordinates. */
  private static final int STRIDE = 8;

  /** As many as a running scene may have, since nested USEs multiply without bound. */
  private static final long MAX_INSTANCES =
      Math.min(8_000_000, Runtime.getRuntime().maxMemory() / 512);

  private final X3dReader reader;
  private final Tessellator tessellator;
  private final UrlResolver root;
  private final PrototypeLibraryProvider libraries;
  private final ProblemCollector problems;
  private final List<ModelPart> parts = new ArrayList<>();
  private final Set<String> open = new LinkedHashSet<>();
  private final long maxBytes;
  private long instances;
  private long bytes;

  /**
   * @param maxBytes the size of the arrays of all meshes
   */
  ModelPartCollector(
      X3dReader reader,
      Tessellator tessellator,
      UrlResolver root,
      long maxBytes,
      ProblemCollector problems) {
    this.reader = reader;
    this.tessellator = tessellator;
    this.root = root;
    libraries = new PrototypeLibraryLoader(reader, root);
    this.maxBytes = maxBytes;
    this.problems = problems;
  }

  List<ModelPart> parts() {
    return parts;
  }

  /** Returns the limit that the nodes exceed, as a clause; empty if they are within all limits. */
  Optional<String> beyond() {
    if (instances > MAX_INSTANCES) {
      return Optional.of("contains itself or has more than %d instances".formatted(MAX_INSTANCES));
    }
    return bytes > maxBytes
        ? Optional.of("has more than %d MiB of vertices".formatted(maxBytes >> 20))
        : Optional.empty();
  }

  /**
   * @param folder the folder against which relative urls are resolved
   * @param metres length of the file's unit of length in metres
   */
  void gather(List<? extends NodeView> nodes, Path folder, double metres) {
    nodes.forEach(node -> visit(node, new Matrix4d(), folder, metres, 0));
  }

  private void visit(NodeView node, Matrix4dc placement, Path folder, double metres, int depth) {
    if (++instances > MAX_INSTANCES || bytes > maxBytes) {
      return;
    }
    if (depth > DEEPEST || node.type().field("visible").isPresent() && !node.bool("visible")) {
      return;
    }
    switch (node.type().name()) {
      case "Inline" -> inline(node, placement, folder, metres, depth);
      case "Switch" -> {
        List<? extends NodeView> children = node.nodes("children");
        int choice = node.integer("whichChoice");
        if (choice >= 0 && choice < children.size()) {
          visit(children.get(choice), placement, folder, metres, depth + 1);
        }
      }
      case "LOD" ->
          node.nodes("children").stream()
              .limit(1)
              .forEach(child -> visit(child, placement, folder, metres, depth + 1));
      default -> {
        if (node.type().is("X3DShapeNode")) {
          shape(node, placement, folder);
        } else {
          Matrix4dc placed =
              GroupingNodeChildren.placement(node)
                  .map(local -> (Matrix4dc) placement.mul(local, local))
                  .orElse(placement);
          GroupingNodeChildren.of(node)
              .forEach(child -> visit(child, placed, folder, metres, depth + 1));
        }
      }
    }
  }

  private void shape(NodeView shape, Matrix4dc placement, Path folder) {
    NodeView geometry = shape.type().field("geometry").isPresent() ? shape.node("geometry") : null;
    if (geometry == null) {
      return;
    }
    Mesh mesh = tessellator.tessellate(geometry, problems).orElse(null);
    if (mesh == null || mesh.primitive() != Mesh.Primitive.TRIANGLES) {
      problems.info(geometry.location(), geometry.type().name() + " has no faces; it is left out");
      return;
    }
    if (mesh.isEmpty()) {
      return;
    }
    if (shape.type().name().equals("InstancedShape")) {
      mesh = MeshReplicator.of(mesh, InstancedShapeTransforms.of(shape, MeshReplicator.most(mesh)));
    }
    NodeView appearance = shape.node("appearance");
    Matrix4dc place =
        GeoMeshOrigin.of(geometry)
            .map(anchor -> (Matrix4dc) placement.translate(anchor, new Matrix4d()))
            .orElse(placement);
    bytes += Float.BYTES * (STRIDE * (long) mesh.vertexCount() + mesh.indices().length);
    if (bytes > maxBytes) {
      return;
    }
    Mesh placed = MeshTransformer.place(mesh, place);
    if (!finite(placed.positions())) {
      problems.error(
          geometry.location(),
          geometry.type().name() + " has a position that is not finite; it is left out");
      return;
    }
    parts.add(
        new ModelPart(appearance, TextureUsage.used(appearance) ? placed : bare(placed), folder));
  }

  private static boolean finite(float[] positions) {
    for (float value : positions) {
      if (!(Math.abs(value) < Float.POSITIVE_INFINITY)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the mesh without texture coordinates, so that seams of a texture that is not there do
   * not constrain the simplification.
   */
  private static Mesh bare(Mesh mesh) {
    return new Mesh(
        mesh.primitive(),
        mesh.positions(),
        mesh.normals(),
        mesh.colors(),
        null,
        mesh.indices(),
        mesh.solid(),
        mesh.bounds());
  }

  private void inline(NodeView inline, Matrix4dc placement, Path folder, double metres, int depth) {
    if (!inline.bool("load")) {
      return;
    }
    ResolvedUrlContent choice =
        ResolvedUrlContent.of(inline, root, base(inline, folder), "the Inline is left out");
    if (!(choice instanceof ResolvedUrlContent.Found found)) {
      problems.add(((ResolvedUrlContent.None) choice).problem());
      return;
    }
    UrlContent file = found.content();
    if (!open.add(file.key())) {
      problems.error(inline.location(), "the Inline names a file that contains it; it is left out");
      return;
    }
    try (InputStream in = file.open()) {
      ProblemCollector heard = new ProblemCollector();
      X3dFile content =
          reader.with(libraries, file.base()).read(file.name(), in, file.size(), heard);
      Problem.withReference(heard.list(), "Inline", inline.location()).forEach(problems::add);
      double own = metres(content);
      Matrix4d scaled = new Matrix4d(placement).scale(own / metres);
      Path folderOfFile = file.base() instanceof BaseUrl.Folder at ? at.path() : folder;
      for (NodeView node : content.nodes()) {
        visit(node, scaled, folderOfFile, own, depth + 1);
      }
    } catch (IOException e) {
      problems.error(
          inline.location(),
          "%s cannot be read (%s); the Inline is left out".formatted(file.name(), e.getMessage()));
    } finally {
      open.remove(file.key());
    }
  }

  private static BaseUrl base(NodeView node, Path folder) {
    BaseUrl ofFile = BaseUrl.folder(folder);
    return node instanceof ParsedNode parsed ? parsed.base(ofFile) : ofFile;
  }

  /** Returns a file's unit of length in metres. */
  static double metres(X3dFile file) {
    return file.units().stream()
        .filter(unit -> unit.category().equals("length"))
        .mapToDouble(X3dFile.Unit::conversionFactor)
        .filter(factor -> factor > 0 && factor < Double.POSITIVE_INFINITY)
        .findFirst()
        .orElse(1);
  }
}
