package org.selectiverenderer.browser.nodes.hanim;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.group.Deformer;
import org.selectiverenderer.browser.nodes.group.TransformNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.tessellate.GroupingNodeChildren;

/**
 * HAnimHumanoid (X3D 4.0, 26.3.2): a skeleton of joints and a skin that follows them. The skin is
 * deformed, at most once per frame, when a joint, a displacer or the skin itself has changed.
 */
public final class HAnimHumanoidNode extends TransformNode implements Deformer {
  private final int skeleton;
  private final int skin;
  private final int viewpoints;
  private final int motions;
  private final int motionsEnabled;
  private final int skinCoord;
  private final int skinNormal;
  private final NodeObserver watch = this::watched;
  private final Set<Node> observed = Collections.newSetFromMap(new IdentityHashMap<>());
  private @Nullable Skeleton joints;
  private @Nullable RestPoseVertices points;
  private @Nullable RestPoseVertices normals;

  public HAnimHumanoidNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    skeleton = type.indexOf("skeleton");
    skin = type.indexOf("skin");
    viewpoints = type.indexOf("viewpoints");
    motions = type.indexOf("motions");
    motionsEnabled = type.indexOf("motionsEnabled");
    skinCoord = type.indexOf("skinCoord");
    skinNormal = type.indexOf("skinNormal");
    addObserver(watch);
  }

  @Override
  @SuppressWarnings("unchecked")
  public List<Node> children() {
    return (List<Node>) GroupingNodeChildren.of(this);
  }

  @Override
  public Effect effectOf(int field) {
    if (field == skeleton || field == skin || field == viewpoints || field == motions) {
      return Effect.STRUCTURE;
    }
    return field == skinCoord || field == skinNormal ? Effect.FORM : super.effectOf(field);
  }

  private void watched(Node node, int field) {
    if (node == this) {
      if (field != skeleton && field != motions && field != motionsEnabled) {
        return;
      }
      joints = null;
    }
    if (points != null && node == points.node() && !points.others(field)
        || normals != null && node == normals.node() && !normals.others(field)) {
      return; // The change is this node's own.
    }
    if (node.type().name().equals("HAnimJoint")) {
      String changed = node.type().fields().get(field).name();
      if (changed.equals("children") || changed.equals("displacers")) {
        joints = null;
      }
    }
    tellObservers(skinCoord);
  }

  @Override
  public void deform() {
    points = rest(node("skinCoord"), "Coordinate", "point", points);
    normals = rest(node("skinNormal"), "Normal", "vector", normals);
    Skeleton known = joints;
    if (known == null) {
      known = Skeleton.of(nodes("skeleton"));
      joints = known;
      observe(known);
      motions(known);
    }
    if (points == null) {
      return;
    }
    Matrix4dc[] placements = known.placements();
    float[] rest = points.rest().clone();
    known.joints().forEach(joint -> Displacers.apply(Displacers.of(joint), rest));
    points.show(Skinning.of(known.joints(), placements, rest, false));
    if (normals != null && normals.rest().length == rest.length) {
      normals.show(Skinning.of(known.joints(), placements, normals.rest(), true));
    }
  }

  private void motions(Skeleton known) {
    boolean[] enabled = (boolean[]) value("motionsEnabled");
    List<Node> all = nodes("motions");
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i) instanceof HAnimMotionNode motion) {
        motion.joints(known.joints(), i >= enabled.length || enabled[i]);
      }
    }
  }

  private @Nullable RestPoseVertices rest(
      @Nullable Node node, String kind, String field, @Nullable RestPoseVertices before) {
    if (node == null || !node.type().name().equals(kind)) {
      return null;
    }
    if (before != null && before.node() == node) {
      return before;
    }
    joints = null; // Forces observation of the new nodes, too.
    return new RestPoseVertices(node, field);
  }

  private void observe(Skeleton known) {
    observed.forEach(node -> node.removeObserver(watch));
    observed.clear();
    List<Node> all = new ArrayList<>(known.joints());
    known.joints().forEach(joint -> all.addAll(Displacers.of(joint)));
    if (points != null) {
      all.add(points.node());
    }
    if (normals != null) {
      all.add(normals.node());
    }
    for (Node node : all) {
      if (observed.add(node)) {
        node.addObserver(watch);
      }
    }
  }
}
