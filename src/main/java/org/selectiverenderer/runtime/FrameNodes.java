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
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.nodes.sensor.FrameNode;
import org.selectiverenderer.runtime.nodes.sensor.TouchSensorNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;

/**
 * The nodes of a scene that a frame is about, each once, in document order.
 *
 * @param frameNodes sensors and clocks, those that stand in no group last
 * @param inlines all Inlines, filled or not
 * @param scripts all Scripts, those that stand in no group last
 * @param touchable whether there is a TouchSensor or an Anchor
 */
record FrameNodes(
    List<FrameNode> frameNodes,
    List<InlineNode> inlines,
    List<ScriptNode> scripts,
    boolean touchable) {

  static FrameNodes of(Scene scene, InstanceTree instances) {
    Set<InlineNode> inlines = new LinkedHashSet<>();
    boolean anchors = collect(instances.root(), inlines);
    List<FrameNode> nodes = new ArrayList<>();
    List<ScriptNode> scripts = new ArrayList<>();
    add(instances.otherNodes(), nodes, scripts);
    add(scene.loose(), nodes, scripts);
    for (InlineNode inline : inlines) {
      inline.content().ifPresent(content -> add(content.loose(), nodes, scripts));
    }
    boolean touchable =
        anchors || instances.otherNodes().stream().anyMatch(TouchSensorNode.class::isInstance);
    return new FrameNodes(
        List.copyOf(nodes), List.copyOf(inlines), List.copyOf(scripts), touchable);
  }

  private static void add(
      Collection<Node> from, List<FrameNode> frameNodes, List<ScriptNode> scripts) {
    for (Node node : from) {
      if (node instanceof FrameNode frameNode) {
        frameNodes.add(frameNode);
      } else if (node instanceof ScriptNode script) {
        scripts.add(script);
      }
    }
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
