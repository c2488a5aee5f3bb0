package org.selectiverenderer.authoring.placement;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.area.LocalCoordinateSystem;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/**
 * Tells where a node stands in the scene, and which Transform places it: itself; the one around it
 * that holds nothing else; else a new one that has to be put around it. A Transform whose pose a
 * ROUTE changes, as an animation does, places nothing: what is written in it would be overwritten.
 *
 * @param node the node to be placed
 * @param transform the Transform that is changed; empty if a new one is put around the node
 * @param parent the matrix from the coordinates around the Transform to those of the scene
 * @param pose the present pose of the Transform
 */
public record Placement(
    DocumentElement node,
    Optional<DocumentElement> transform,
    Matrix4dc parent,
    TransformPose pose) {
  private static final Set<String> TRANSFORMS =
      Set.of("Transform", "CADPart", "HAnimJoint", "HAnimSite", "HAnimHumanoid");

  /** The fields of a pose, which a ROUTE may change. */
  private static final Set<String> POSE =
      Set.of("translation", "rotation", "scale", "center", "scaleOrientation");

  /**
   * Returns the placement of a node.
   *
   * @return empty for an element that does not stand in the scene by itself, or whose place the
   *     text does not determine: in the body of a prototype, under a Billboard or a scale of 0; and
   *     for one that needs a new Transform where none may stand, as among the joints of a humanoid
   */
  public static Optional<Placement> of(
      SceneDocument document, NodeCatalogue catalogue, DocumentElement node) {
    if (!node.attached() || !movable(catalogue, node)) {
      return Optional.empty();
    }
    Optional<DocumentElement> transform =
        transforms(document, node)
            ? Optional.of(node)
            : node.parent().filter(at -> alone(document, at));
    if (transform.isEmpty() && !wrappable(catalogue, node)) {
      return Optional.empty();
    }
    return LocalCoordinateSystem.of(transform.orElse(node))
        .map(
            around ->
                new Placement(
                    node,
                    transform,
                    new Matrix4d(around.world()),
                    transform.map(TransformPose::of).orElse(TransformPose.IDENTITY)));
  }

  /** Returns whether a node stands in the scene as a child of a group. */
  public static boolean movable(NodeCatalogue catalogue, DocumentElement node) {
    boolean shown =
        node.name().equals("ProtoInstance")
            || catalogue.find(node.name()).filter(type -> type.is("X3DBoundedObject")).isPresent();
    boolean place =
        node.parent()
            .filter(
                at ->
                    at.name().equals("Scene")
                        || catalogue
                            .find(at.name())
                            .filter(type -> type.field("children").isPresent())
                            .isPresent())
            .isPresent();
    boolean child = node.text("containerField").filter(at -> !at.equals("children")).isEmpty();
    return shown && place && child;
  }

  /** Returns whether a Transform may stand in the place of a node. */
  private static boolean wrappable(NodeCatalogue catalogue, DocumentElement node) {
    DocumentElement parent = node.parent().orElseThrow();
    return parent.name().equals("Scene")
        || catalogue
            .find(parent.name())
            .flatMap(type -> type.field("children"))
            .filter(
                field ->
                    ContainerFieldRules.accepts(field, catalogue.find("Transform").orElseThrow()))
            .isPresent();
  }

  /**
   * Returns whether a node is a Transform or one like it, whose pose can be changed: it is no USE,
   * and no ROUTE changes its pose.
   */
  public static boolean transforms(SceneDocument document, DocumentElement node) {
    return TRANSFORMS.contains(node.name()) && node.use().isEmpty() && !driven(document, node);
  }

  private static boolean driven(SceneDocument document, DocumentElement node) {
    return node.def()
        .flatMap(
            def ->
                document
                    .tree()
                    .map(
                        tree ->
                            tree.routes().stream()
                                .filter(route -> says(route, "toNode").equals(def))
                                .filter(route -> POSE.contains(field(says(route, "toField"))))
                                .anyMatch(route -> ElementScope.shared(route, node))))
        .orElse(false);
  }

  private static String says(DocumentElement route, String attribute) {
    return route.text(attribute).orElse("").strip();
  }

  private static String field(String written) {
    return written.startsWith("set_") ? written.substring("set_".length()) : written;
  }

  /** Returns whether an element is a Transform around one node, which is used nowhere else. */
  private static boolean alone(SceneDocument document, DocumentElement around) {
    List<DocumentElement> children =
        around.children().stream()
            .filter(child -> !child.name().startsWith("Metadata"))
            .filter(child -> !child.name().equals("ROUTE"))
            .toList();
    boolean used =
        around.def().isPresent()
            && document.tree().filter(tree -> tree.used(around.def().get(), around)).isPresent();
    return around.name().equals("Transform")
        && transforms(document, around)
        && children.size() == 1
        && !used;
  }

  /** Returns the same node with another pose. */
  public Placement with(TransformPose now) {
    return new Placement(node, transform, parent, now);
  }

  /** Returns the matrix from the coordinates in the Transform to those of the scene. */
  public Matrix4d own() {
    return parent.mul(pose.matrix(), new Matrix4d());
  }
}
