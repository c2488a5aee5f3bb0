package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.nodes.shader.ShaderNode;
import org.selectiverenderer.browser.nodes.shape.GeneratedCubeMapTextureNode;
import org.selectiverenderer.browser.nodes.sound.SoundSourceNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.scene.NodeSubgraphCollector;
import org.selectiverenderer.browser.scene.NodeTemplate;
import org.selectiverenderer.browser.scene.ProceduralShape;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * The mesh, material and drawing properties of one Shape node, shared by its instances. It observes
 * the Shape and every node in it, and rebuilds at the next update what a change has affected.
 */
final class SharedShapeState implements NodeObserver {
  private final Node shape;
  private final InstanceTree tree;

  /** The instance or, of a Shape that is USEd, the first of several; null without any. */
  private @Nullable ShapeInstance first;

  /** The further instances of a Shape that is USEd. */
  private List<ShapeInstance> others = List.of();

  private List<Node> inAppearance = List.of();
  private List<Node> inGeometry = List.of();
  private ShapeReading reading;
  private int polygons;
  private boolean visible;
  private boolean pending;
  private boolean disposed;

  /** Whether the nodes in the Shape are not observed, since nobody has asked for one yet. */
  private boolean deferred;

  private @Nullable Node geometry;
  private List<SoundSourceNode> films = List.of();

  /**
   * Reads a Shape.
   *
   * @param readings the readings of Shapes that are like their templates; a new one is added
   */
  SharedShapeState(Node shape, InstanceTree tree, Map<NodeTemplate, ShapeReading> readings) {
    this.shape = shape;
    this.tree = tree;
    AssetProvider assets = tree.assets();
    if (shape instanceof ProceduralShape formed) {
      formed.meshes(assets::mesh);
    }
    NodeTemplate template = shape.template();
    ShapeReading known = template != null && shape.partsDeferred() ? readings.get(template) : null;
    if (known != null) {
      deferred = true;
      shape.addObserver(this);
    } else {
      observe();
      known =
          template != null && isLikeTemplate()
              ? readings.computeIfAbsent(template, any -> ShapeReading.of(shape, geometry, assets))
              : ShapeReading.of(shape, geometry, assets);
    }
    reading = known;
    lookAtShape();
  }

  /** Returns what the instances of a Shape in a tree share; null without any. */
  static @Nullable SharedShapeState of(Node shape, InstanceTree tree) {
    return shape.observer(
        SharedShapeState.class, known -> known.shape == shape && known.tree == tree);
  }

  /** Notes what is asked for whenever the Shape is shown or hidden. */
  private void lookAtShape() {
    Mesh mesh = reading.mesh();
    polygons = mesh == null ? 0 : mesh.polygons();
    int field = shape.type().field("visible").map(FieldDefinition::index).orElse(-1);
    visible = field < 0 || (Boolean) shape.value(field);
  }

  /**
   * Returns whether a copy of the Shape with the same template is read alike: no node in it has
   * changed, and none has an image or program of its own, which may arrive later.
   */
  private boolean isLikeTemplate() {
    for (Node part : inGeometry) {
      if (part.changes() > 0) {
        return false;
      }
    }
    for (Node part : inAppearance) {
      if (part.changes() > 0 || hasAsset(part) || part instanceof ShaderNode) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether the Shape is in no part of the scene. */
  boolean unused() {
    return first == null;
  }

  void add(ShapeInstance instance) {
    if (first == null) {
      first = instance;
      return;
    }
    if (others.isEmpty()) {
      others = new ArrayList<>();
    }
    others.add(instance);
  }

  void remove(ShapeInstance instance) {
    if (instance != first) {
      others.remove(instance);
    } else {
      first = others.isEmpty() ? null : others.remove(0);
    }
  }

  private void forEach(Consumer<ShapeInstance> action) {
    if (first != null) {
      action.accept(first);
      others.forEach(action);
    }
  }

  Optional<Mesh> mesh() {
    return Optional.ofNullable(reading.mesh());
  }

  /**
   * Returns the origin of the mesh's coordinates in the Shape's coordinates; null if they are the
   * same.
   */
  @Nullable Vector3dc anchor() {
    return reading.anchor();
  }

  SurfaceMaterial surface() {
    return reading.surface();
  }

  DrawProperties stroke() {
    return reading.stroke();
  }

  List<ShaderProgramSource> programs() {
    return reading.programs();
  }

  /** Tells a shader node whether its program compiled and is used. */
  void judged(ShaderNode shader, boolean valid, boolean selected, List<Problem> problems) {
    shader.judged(valid, selected);
    tree.judged(shader);
    problems.forEach(tree.assets()::told);
  }

  int polygons() {
    return polygons;
  }

  /** Returns whether the geometry is text measured in pixels (X3D 4.0, 36.4.4). */
  boolean onScreen() {
    return reading.onScreen();
  }

  boolean visible() {
    return visible;
  }

  /** Returns the movie textures in the appearance. */
  List<SoundSourceNode> films() {
    return films;
  }

  /** Returns the generated cube maps on the shape. */
  List<GeneratedCubeMapTextureNode> cubes() {
    return reading.cubes();
  }

  private void observe() {
    shape.addObserver(this);
    observeParts();
  }

  /** Begins to observe the nodes in the Shape, of which one is changing. */
  @Override
  public void partChanges(Node node) {
    if (deferred) {
      observeParts();
    }
  }

  private void observeParts() {
    deferred = false;
    geometry = shape.node("geometry");
    if (geometry != null) {
      inGeometry = observed(geometry);
      int changes = 0;
      for (int i = 0; i < inGeometry.size(); i++) {
        changes += inGeometry.get(i).changes();
      }
      if (changes > 0) {
        tree.assets().asOf(geometry, changes);
      }
    }
    Node appearance = shape.node("appearance");
    if (appearance != null) {
      inAppearance = observed(appearance);
      Node metadata = appearance.node("metadata");
      if (metadata != null) { // may say how it is shaded
        List<Node> all = new ArrayList<>(inAppearance);
        all.addAll(observed(metadata));
        inAppearance = List.copyOf(all);
      }
    }
  }

  private List<Node> observed(Node top) {
    List<Node> parts = List.copyOf(NodeSubgraphCollector.of(top)); // compact
    for (int i = 0; i < parts.size(); i++) {
      Node part = parts.get(i);
      part.addObserver(this);
      if (part.changes() > 0 && hasAsset(part)) {
        tree.assets().asOf(part, part.changes());
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
      tree.assets().changed(geometry);
    } else if (hasAsset(node)) {
      tree.assets().changed(node);
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
    ShapeReading before = reading;
    int polygonsBefore = polygons;
    forget();
    observe();
    forEach(
        instance -> {
          boolean wanted = instance.wanted;
          instance.show(false, tree);
          instance.wanted = wanted;
        });
    reading = ShapeReading.of(shape, geometry, tree.assets());
    lookAtShape();
    if (polygons != polygonsBefore) {
      forEach(instance -> tree.markRestructured(instance.parent()));
    }
    if (reading.onScreen() != before.onScreen()
        || !films.equals(filmsBefore)
        || !reading.cubes().equals(before.cubes())) {
      tree.structureChanged();
    }
    forEach(
        instance -> {
          instance.see(tree.sight());
          instance.forgetBounds();
          tree.changes().add(instance);
          instance.show(instance.wanted, tree);
        });
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
