package org.selectiverenderer.runtime;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.instance.Instance;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.nodes.sensor.FrameNode;
import org.selectiverenderer.runtime.nodes.sensor.TouchSensorNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;

/**
 * The nodes of a scene that a frame is about, each once, in document order.
 *
 * @param frameNodes sensors and clocks, those that stand in no group last
 * @param inlines all Inlines, filled or not
 * @param touchable whether there is a TouchSensor or an Anchor
 */
record FrameNodes(List<FrameNode> frameNodes, List<InlineNode> inlines, boolean touchable) {

  static FrameNodes of(Scene scene, InstanceTree instances) {
    return of(Optional.of(scene), instances);
  }

  /**
   * The nodes of a part of a scene.
   *
   * @param scene whose nodes in no group count too
   */
  static FrameNodes of(Optional<Scene> scene, InstanceTree instances) {
    Set<InlineNode> inlines = new LinkedHashSet<>();
    boolean anchors = collect(instances.root(), inlines);
    List<FrameNode> nodes = new ArrayList<>();
    addFrameNodes(instances.otherNodes(), nodes);
    scene.ifPresent(of -> addFrameNodes(of.loose(), nodes));
    for (InlineNode inline : inlines) {
      inline.content().ifPresent(content -> addFrameNodes(content.loose(), nodes));
    }
    boolean touchable =
        anchors || instances.otherNodes().stream().anyMatch(TouchSensorNode.class::isInstance);
    return new FrameNodes(List.copyOf(nodes), List.copyOf(inlines), touchable);
  }

  private static void addFrameNodes(Collection<Node> from, List<FrameNode> to) {
    from.stream().filter(FrameNode.class::isInstance).forEach(node -> to.add((FrameNode) node));
  }

  /** Collects Inlines; says whether there is an Anchor. */
  private static boolean collect(GroupInstance group, Set<InlineNode> inlines) {
    if (group.node() instanceof InlineNode inline) {
      inlines.add(inline);
    }
    boolean anchors = group.node().type().name().equals("Anchor");
    for (Instance child : group.children()) {
      if (child instanceof GroupInstance inner) {
        anchors |= collect(inner, inlines);
      }
    }
    return anchors;
  }
}
