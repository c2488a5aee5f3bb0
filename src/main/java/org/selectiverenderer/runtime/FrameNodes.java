package org.selectiverenderer.runtime;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.instance.Instance;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.nodes.key.KeyDeviceSensorNode;
import org.selectiverenderer.runtime.nodes.sensor.FrameNode;
import org.selectiverenderer.runtime.nodes.sensor.PointingSensorNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;

/**
 * The nodes of a scene that a frame is about, each once, in document order.
 *
 * @param frameNodes sensors and clocks, those that stand in no group last
 * @param inlines all Inlines, filled or not
 * @param keySensors sensors of the keyboard
 * @param touchable whether there is a sensor of the pointing device or an Anchor
 * @param draggable whether there is a drag sensor
 */
record FrameNodes(
    List<FrameNode> frameNodes,
    List<InlineNode> inlines,
    List<KeyDeviceSensorNode> keySensors,
    boolean touchable,
    boolean draggable) {

  static FrameNodes of(Scene scene, InstanceTree instances) {
    Set<InlineNode> inlines = new LinkedHashSet<>();
    boolean anchors = collect(instances.root(), inlines);
    List<FrameNode> nodes = new ArrayList<>();
    List<KeyDeviceSensorNode> keySensors = new ArrayList<>();
    List<Node> placed = instances.otherNodes();
    add(placed, FrameNode.class, nodes);
    add(placed, KeyDeviceSensorNode.class, keySensors);
    add(scene.loose(), FrameNode.class, nodes);
    for (InlineNode inline : inlines) {
      inline.content().ifPresent(content -> add(content.loose(), FrameNode.class, nodes));
    }
    boolean touchable = anchors || placed.stream().anyMatch(PointingSensorNode.class::isInstance);
    boolean draggable =
        placed.stream().anyMatch(node -> node instanceof PointingSensorNode on && on.drags());
    return new FrameNodes(
        List.copyOf(nodes), List.copyOf(inlines), List.copyOf(keySensors), touchable, draggable);
  }

  private static <T> void add(Collection<Node> from, Class<T> kind, List<T> to) {
    from.stream().filter(kind::isInstance).forEach(node -> to.add(kind.cast(node)));
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
