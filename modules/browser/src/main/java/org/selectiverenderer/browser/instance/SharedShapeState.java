package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.nodes.shader.ShaderNode;
import org.selectiverenderer.browser.nodes.shape.GeneratedCubeMapTextureNode;
import org.selectiverenderer.browser.nodes.sound.SoundSourceNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.scene.NodeSubgraphCollector;
import org.selectiverenderer.browser.scene.ProceduralShape;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.tessellate.GeoMeshOrigin;

/**
 * The mesh, material and drawing properties of one Shape node, shared by its instances. It observes
 * the Shape and every node in it, and rebuilds at the next update what a change has affected.
 */
final class SharedShapeState implements NodeObserver {
  private final Node shape;
  private final AssetProvider assets;
  private final InstanceTree tree;
  final List<ShapeInstance> instances = new ArrayList<>(1);
  private List<Node> inAppearance = List.of();
  private List<Node> inGeometry = List.of();
  private @Nullable Mesh mesh;
  private @Nullable Vector3dc anchor;
  private SurfaceMaterial surface = SurfaceMaterial.UNLIT_WHITE;
  private DrawProperties stroke = DrawProperties.PLAIN;
  private List<ShaderProgramSource> programs = List.of();
  private boolean pending;
  private boolean disposed;
  private boolean onScreen;
  private @Nullable Node geometry;
  private List<SoundSourceNode> films = List.of();
  private List<GeneratedCubeMapTextureNode> cubes = List.of();

  SharedShapeState(Node shape, AssetProvider assets, InstanceTree tree) {
    this.shape = shape;
    this.assets = assets;
    this.tree = tree;
    if (shape instanceof ProceduralShape formed) {
      formed.meshes(assets::mesh);
    }
    observe();
    read();
  }

  Optional<Mesh> mesh() {
    return Optional.ofNullable(mesh);
  }

  /**
   * Returns the origin of the mesh's coordinates in the Shape's coordinates; null if they are the
   * same.
   */
  @Nullable Vector3dc anchor() {
    return anchor;
  }

  SurfaceMaterial surface() {
    return surface;
  }

  DrawProperties stroke() {
    return stroke;
  }

  List<ShaderProgramSource> programs() {
    return programs;
  }

  /** Tells a shader node whether its program compiled and is used. */
  void judged(ShaderNode shader, boolean valid, boolean selected, List<Problem> problems) {
    shader.judged(valid, selected);
    tree.judged(shader);
    problems.forEach(assets::told);
  }

  int polygons() {
    return mesh == null ? 0 : mesh.polygons();
  }

  /** Returns whether the geometry is text measured in pixels (X3D 4.0, 36.4.4). */
  boolean onScreen() {
    return onScreen;
  }

  boolean visible() {
    return shape.type().field("visible").map(f -> (Boolean) shape.value(f.index())).orElse(true);
  }

  private void read() {
    stroke = DrawPropertiesReader.read(shape.node("appearance"));
    Mesh formed;
    if (shape instanceof ProceduralShape own) {
      formed = own.form().orElse(null);
    } else {
      formed = geometry == null ? null : assets.mesh(geometry).orElse(null);
      anchor = geometry == null ? null : GeoMeshOrigin.of(geometry).orElse(null);
    }
    mesh = LineTextureCoordinates.of(formed, stroke);
    onScreen = isOnScreen(geometry);
    surface = AppearanceReader.read(shape.node("appearance"), geometry, assets);
    programs = ShaderProgramReader.read(shape.node("appearance"), geometry, assets);
    cubes = GeneratedCubeTexture.in(surface, programs);
  }

  private static boolean isOnScreen(@Nullable Node geometry) {
    if (geometry == null || !geometry.type().name().equals("Text")) {
      return false;
    }
    Node style = geometry.node("fontStyle");
    return style != null && style.type().name().equals("ScreenFontStyle");
  }

  /** Returns the movie textures in the appearance. */
  List<SoundSourceNode> films() {
    return films;
  }

  /** Returns the generated cube maps on the shape. */
  List<GeneratedCubeMapTextureNode> cubes() {
    return cubes;
  }

  private void observe() {
    shape.addObserver(this);
    geometry = shape.node("geometry");
    if (geometry != null) {
      inGeometry = observed(geometry);
      int changes = 0;
      for (int i = 0; i < inGeometry.size(); i++) {
        changes += inGeometry.get(i).changes();
      }
      if (changes > 0) {
        assets.asOf(geometry, changes);
      }
    }
    Node appearance = shape.node("appearance");
    if (appearance != null) {
      inAppearance = observed(appearance);
    }
  }

  private List<Node> observed(Node top) {
    List<Node> parts = List.copyOf(NodeSubgraphCollector.of(top)); // compact
    for (int i = 0; i < parts.size(); i++) {
      Node part = parts.get(i);
      part.addObserver(this);
      if (part.changes() > 0 && hasAsset(part)) {
        assets.asOf(part, part.changes());
      }
      if (part instanceof SoundSourceNode film) {
        films = films.isEmpty() ? new ArrayList<>(1) : films;
        films.add(film);
      }
    }
    return parts;
  }

  /** Returns whether a node of an appearance has an asset of its own. */
  private static boolean hasAsset(Node node) {
    return node.type().is("X3DTextureNode")
        || node.type().name().equals("ShaderPart")
        || node.type().name().equals("ShaderProgram");
  }

  @Override
  public void changed(Node node, int field) {
    if (node instanceof SoundSourceNode film
        && field != film.urlField()
        && field != film.loadField()) {
      return; // The movie advanced; the material stays the same.
    }
    if (node instanceof ShaderNode shader && shader.onlyNumbers(field)) {
      return;
    }
    if (node instanceof GeneratedCubeMapTextureNode cube && field == cube.updateField()) {
      return;
    }
    if (inGeometry.contains(node) && geometry != null) {
      assets.changed(geometry);
    } else if (hasAsset(node)) {
      assets.changed(node);
    }
    if (!pending) {
      pending = true;
      tree.pending(this);
    }
  }

  /** Rebuilds mesh and material after a change. */
  void update() {
    pending = false;
    if (disposed) {
      return; // The last instance left the scene between the change and this update.
    }
    List<SoundSourceNode> filmsBefore = films;
    List<GeneratedCubeMapTextureNode> cubesBefore = cubes;
    boolean onScreenBefore = onScreen;
    forget();
    observe();
    for (ShapeInstance instance : instances) {
      boolean wanted = instance.wanted;
      instance.show(false, tree);
      instance.wanted = wanted;
    }
    read();
    if (onScreen != onScreenBefore || !films.equals(filmsBefore) || !cubes.equals(cubesBefore)) {
      tree.structureChanged();
    }
    for (ShapeInstance instance : instances) {
      instance.see(tree.sight());
      instance.forgetBounds();
      tree.changes().add(instance);
      instance.show(instance.wanted, tree);
    }
  }

  /** Stops observing; called when the last instance is removed. */
  void dispose() {
    disposed = true;
    forget();
  }

  private void forget() {
    films = List.of();
    shape.removeObserver(this);
    inAppearance.forEach(node -> node.removeObserver(this));
    inAppearance = List.of();
    inGeometry.forEach(node -> node.removeObserver(this));
    inGeometry = List.of();
  }
}
