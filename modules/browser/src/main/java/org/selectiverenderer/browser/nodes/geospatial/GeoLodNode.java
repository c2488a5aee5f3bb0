package org.selectiverenderer.browser.nodes.geospatial;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.group.ViewerDependentNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.geodesy.GeoCoordinateTransform;

/**
 * GeoLOD (X3D 4.0, 25.3.6): shows its root from afar and its four children from near. Files are
 * read in the background when they are first needed; for this, the loader gives the node an Inline
 * for each of its urls. Files that have been read stay loaded.
 */
public final class GeoLodNode extends GroupingNode implements ViewerDependentNode {
  private final int rootNode;
  private final int center;
  private final int range;
  private final int levelChanged;
  private final int childrenField;
  private List<InlineNode> rootFiles = List.of();
  private List<InlineNode> childFiles = List.of();
  private boolean near;
  private boolean viewed;

  public GeoLodNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    rootNode = type.indexOf("rootNode");
    center = type.indexOf("center");
    range = type.indexOf("range");
    levelChanged = type.indexOf("level_changed");
    childrenField = type.indexOf("children");
  }

  /**
   * Sets the Inlines that stand for the node's urls.
   *
   * @param root the Inline of {@code rootUrl}; empty if there is a {@code rootNode}
   * @param children the Inlines of {@code child1Url} to {@code child4Url} that are not empty
   */
  public void files(List<InlineNode> root, List<InlineNode> children) {
    rootFiles = List.copyOf(root);
    childFiles = List.copyOf(children);
  }

  @SuppressWarnings("unchecked")
  private List<Node> root() {
    List<Node> given = (List<Node>) value(rootNode);
    return given.isEmpty() ? List.copyOf(rootFiles) : given;
  }

  @Override
  public List<Node> children() {
    List<Node> all = new ArrayList<>(root());
    all.addAll(childFiles);
    return all;
  }

  @Override
  public boolean shows(int child) {
    return visible() && child >= root().size() == near;
  }

  @Override
  public Effect effectOf(int field) {
    return field == rootNode
        ? Effect.STRUCTURE
        : field == childrenField ? Effect.NONE : super.effectOf(field);
  }

  @Override
  public Effect view(Vector3dc viewer, Vector3dc up, EventCascade cascade) {
    double[] c = (double[]) value(center);
    Vector3d at = GeoCoordinateTransform.of(this).scene(c[0], c[1], c[2]);
    boolean now = !childFiles.isEmpty() && at.distance(viewer) < (Float) value(range);
    if (viewed && now == near) {
      return Effect.NONE;
    }
    boolean first = !viewed;
    viewed = true;
    near = now;
    for (InlineNode file : now ? childFiles : rootFiles) {
      if (!file.bool("load")) {
        cascade.send(file, file.type().indexOf("load"), true);
      }
    }
    if (!first || now) {
      cascade.emit(this, levelChanged, now ? 1 : 0);
    }
    cascade.emit(this, childrenField, now ? List.<Node>copyOf(childFiles) : root());
    return Effect.CHOICE;
  }
}
