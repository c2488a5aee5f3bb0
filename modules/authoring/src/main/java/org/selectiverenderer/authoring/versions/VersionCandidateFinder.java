package org.selectiverenderer.authoring.versions;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.versions.VersionCandidate.Remark;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;

/**
 * Finds the objects of a scene that versions may be made of, as whole pieces: a chair, not its
 * legs. Not thread-safe; for one search.
 */
public final class VersionCandidateFinder {
  /** An object with fewer polygons is not worth versions. */
  public static final int FEW = 200;

  /** A box is flat if its least extent is at most this share of its largest. */
  private static final double FLAT = 0.06;

  private static final double WIDE = 0.4;
  private static final double AROUND = 0.9;

  private final ElementNodeMapping scene;
  private final VersionsEdit.Request request;
  private final ModelReader models;
  private final BatchProgress progress;
  private final ObjectNamer names;
  private final ProblemCollector unheard = new ProblemCollector();
  private final Map<NodeView, MeasuredElement> measured = new IdentityHashMap<>();
  private final List<VersionCandidate> found = new ArrayList<>();
  private final Map<DocumentElement, MeasuredElement> all = new HashMap<>();
  private BoundingBox extent = BoundingBox.EMPTY;
  private int shapes;
  private int done;

  private VersionCandidateFinder(
      ElementNodeMapping scene,
      VersionsEdit.Request request,
      NodeCatalogue catalogue,
      BatchProgress progress) {
    this.scene = scene;
    this.request = request;
    this.progress = progress;
    this.models = new ModelReader(catalogue, request.access());
    this.names = new ObjectNamer(scene.snapshot().text(), scene.elements());
  }

  /**
   * Finds the objects of a scene, in document order. This takes a while, so it must not run on the
   * event dispatch thread.
   *
   * @param request the scene and what it may read; its object and goals are not used
   * @param chosen offsets of the elements to look at; empty for the whole pieces of the scene
   * @throws SceneNotEditableException if the scene's text cannot be changed
   * @throws IOException if a file cannot be read, with a one-line message that names it
   * @throws CancellationException if the progress throws it
   */
  public static List<VersionCandidate> find(
      DocumentSnapshot snapshot,
      VersionsEdit.Request request,
      List<Integer> chosen,
      NodeCatalogue catalogue,
      BatchProgress progress)
      throws IOException {
    ProblemCollector unheard = new ProblemCollector(); // the scene's own problems are not asked for
    ElementNodeMapping scene = VersionsEdit.scene(snapshot, request, catalogue, unheard);
    return new VersionCandidateFinder(scene, request, catalogue, progress).find(chosen);
  }

  private List<VersionCandidate> find(List<Integer> chosen) {
    Optional<DocumentElement> root = scene.elements().scene();
    if (root.isEmpty()) {
      return List.of();
    }
    root.get()
        .visit(
            element -> {
              if (element.name().equals("Shape") || element.name().equals("Inline")) {
                shapes++;
              }
            });
    List<MeasuredElement> top = new ArrayList<>();
    for (DocumentElement child : root.get().children()) {
      measure(child).ifPresent(top::add);
    }
    for (MeasuredElement each : top) {
      extent = extent.union(each.box());
    }
    if (chosen.isEmpty()) {
      top.forEach(each -> propose(each, new Matrix4d()));
    } else {
      proposeChosen(chosen);
    }
    found.sort(Comparator.comparingInt(VersionCandidate::start));
    return List.copyOf(found);
  }

  private void proposeChosen(List<Integer> chosen) {
    List<DocumentElement> elements =
        chosen.stream().flatMap(start -> scene.elements().at(start).stream()).distinct().toList();
    Set<DocumentElement> objects = new HashSet<>();
    for (DocumentElement element : elements) {
      object(element)
          .filter(object -> elements.stream().noneMatch(other -> inside(object, other)))
          .ifPresent(objects::add);
    }
    for (DocumentElement object : objects) {
      add(all.get(object), BoundingBox.EMPTY);
    }
  }

  private static boolean inside(DocumentElement element, DocumentElement other) {
    return other != element && other.contains(element);
  }

  /** Returns the nearest element around one that draws faces; of a Switch's Inlines the Switch. */
  private Optional<DocumentElement> object(DocumentElement element) {
    DocumentElement at = element;
    while (at != null && !all.containsKey(at)) {
      at = at.parent().orElse(null);
    }
    return Optional.ofNullable(at);
  }

  private Optional<MeasuredElement> measure(DocumentElement element) {
    NodeView node = scene.node(element);
    if (node == null || proxy(element)) {
      return Optional.empty();
    }
    boolean group =
        element.use().isEmpty()
            && !element.name().equals("ProtoInstance") // whose nodes are no elements of the scene
            && GroupingNodeChildren.isGroup(node.type())
            && !Set.of("Switch", "LOD", "GeoLOD", "CADFace").contains(node.type().name());
    Optional<MeasuredElement> result = group ? group(element, node) : leaf(element, node);
    if (element.use().isEmpty()) {
      result.ifPresent(each -> all.put(element, each));
    }
    return result;
  }

  private static boolean proxy(DocumentElement element) {
    return element.text("containerField").orElse("children").equals("proxy");
  }

  private Optional<MeasuredElement> group(DocumentElement element, NodeView node) {
    Matrix4dc placement =
        GroupingNodeChildren.placement(node).map(Matrix4dc.class::cast).orElse(new Matrix4d());
    List<MeasuredElement> children = new ArrayList<>();
    for (DocumentElement child : element.children()) {
      measure(child).ifPresent(children::add);
    }
    if (children.isEmpty()) {
      return Optional.empty();
    }
    BoundingBox box = BoundingBox.EMPTY;
    long polygons = 0;
    int inside = 0;
    for (MeasuredElement child : children) {
      box = box.union(child.box().transformed(placement));
      polygons += child.polygons();
      inside += child.shapes();
    }
    return Optional.of(
        new MeasuredElement(element, box, placement, polygons, inside, List.copyOf(children)));
  }

  private Optional<MeasuredElement> leaf(DocumentElement element, NodeView node) {
    if (!node.type().is("X3DChildNode")) {
      return Optional.empty();
    }
    progress.done(shapes == 0 ? 0 : Math.min(1.0, (double) done++ / shapes), "");
    MeasuredElement known = measured.get(node);
    if (known == null) {
      known = size(element, node);
      measured.put(node, known);
    }
    return known.polygons() == 0
        ? Optional.empty()
        : Optional.of(
            new MeasuredElement(
                element, known.box(), known.placement(), known.polygons(), 1, List.of()));
  }

  private MeasuredElement size(DocumentElement element, NodeView node) {
    BoundingBox box = BoundingBox.EMPTY;
    Optional<Model> model =
        models.of(
            List.of(node),
            scene.file(),
            VersionFileNames.folder(request.scene()),
            element.location(),
            "it",
            unheard);
    if (model.isPresent()) {
      for (Mesh mesh : model.get().meshes()) {
        box = box.union(BoundingBox.around(mesh.positions()));
      }
    }
    return new MeasuredElement(
        element, box, new Matrix4d(), model.map(Model::polygons).orElse(0), 1, List.of());
  }

  private void propose(MeasuredElement each, Matrix4dc world) {
    BoundingBox box = each.box().transformed(world);
    if (!each.children().isEmpty() && each.holdsPieces(box.extent() / extent.extent())) {
      Matrix4d inner = world.mul(each.placement(), new Matrix4d());
      each.children().forEach(child -> propose(child, inner));
    } else if (each.element().use().isEmpty()) {
      add(each, box);
    }
  }

  /**
   * @param box bounding box in the scene; empty for an object that the author has chosen
   */
  private void add(MeasuredElement each, BoundingBox box) {
    DocumentElement element = each.element();
    String name = element.def().orElseGet(() -> names.name(element));
    ProblemCollector problems = new ProblemCollector();
    Optional<ObjectElements> object = new ObjectFinder(scene, problems).at(element, name);
    object
        .filter(ObjectElements.Whole.class::isInstance)
        .map(ObjectElements.Whole.class::cast)
        .ifPresent(whole -> new CrossFileReferences(scene, problems).free(name, whole.elements()));
    String obstacle = problems.list().stream().findFirst().map(Problem::message).orElse("");
    Remark remark =
        !obstacle.isEmpty()
            ? Remark.IMPOSSIBLE
            : object.orElseThrow() instanceof ObjectElements.Versioned
                ? Remark.VERSIONS
                : box.isEmpty() ? Remark.NONE : remark(each, box);
    int polygons = (int) Math.min(Integer.MAX_VALUE, each.polygons());
    found.add(
        new VersionCandidate(
            element.start(), element.name(), element.def(), name, polygons, remark, obstacle));
  }

  private static boolean shares(MeasuredElement each) {
    return each.element().use().isPresent()
        || each.children().stream().anyMatch(VersionCandidateFinder::shares);
  }

  private Remark remark(MeasuredElement each, BoundingBox box) {
    if (shares(each)) {
      return Remark.SHARED;
    }
    if (all.size() == 1) {
      return few(each); // the object is the scene
    }
    double least = Math.min(box.width(), Math.min(box.height(), box.depth()));
    if (box.extent() >= WIDE * extent.extent() && least <= FLAT * box.extent()) {
      return Remark.FLAT;
    }
    boolean around =
        box.width() >= AROUND * extent.width()
            && box.height() >= AROUND * extent.height()
            && box.depth() >= AROUND * extent.depth();
    return around && found.size() + shapes > 1 && each.shapes() < shapes
        ? Remark.AROUND
        : few(each);
  }

  private static Remark few(MeasuredElement each) {
    return each.polygons() < FEW ? Remark.FEW : Remark.NONE;
  }
}
