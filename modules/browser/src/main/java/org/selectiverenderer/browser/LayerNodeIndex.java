package org.selectiverenderer.browser;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.keyboard.KeyDeviceSensorNode;
import org.selectiverenderer.browser.nodes.picking.PickSensorNode;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.nodes.sensor.PointingDeviceSensorNode;
import org.selectiverenderer.browser.nodes.sound.MovieTextureNode;
import org.selectiverenderer.browser.nodes.sound.SoundNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.scene.Scene;

/**
 * The nodes of a layer that the frame step visits, sorted by role; each node once, in document
 * order.
 *
 * @param frameNodes sensors and clocks; those outside all groups come last
 * @param inlines all Inlines, whether or not they have content
 * @param scripts all Scripts; those outside all groups come last
 * @param keySensors key device sensors
 * @param sounds all Sound nodes
 * @param picks pick sensors
 * @param touchable whether there is a pointing device sensor or an Anchor
 * @param draggable whether there is a drag sensor
 */
record LayerNodeIndex(
    List<FrameDrivenNode> frameNodes,
    List<InlineNode> inlines,
    List<ScriptNode> scripts,
    List<KeyDeviceSensorNode> keySensors,
    List<SoundNode> sounds,
    List<PickSensorNode> picks,
    boolean touchable,
    boolean draggable) {

  /**
   * Collects the nodes of a layer of a scene.
   *
   * @param base whether the layer is the scene's base layer, which also has the nodes outside all
   *     groups
   */
  static LayerNodeIndex of(Scene scene, boolean base, InstanceTree instances) {
    Set<InlineNode> inlines = new LinkedHashSet<>();
    Set<Node> beside = new LinkedHashSet<>();
    boolean anchors = collect(instances.root(), inlines, beside);
    List<FrameDrivenNode> nodes = new ArrayList<>();
    List<ScriptNode> scripts = new ArrayList<>();
    List<KeyDeviceSensorNode> keySensors = new ArrayList<>();
    List<Node> placed = instances.otherNodes();
    Set<Node> loose = new LinkedHashSet<>(base ? scene.loose() : Set.of());
    for (InlineNode inline : inlines) {
      inline.shown().ifPresent(content -> loose.addAll(content.loose()));
    }
    // Other nodes came with a scene of which a script or an application has taken nodes over.
    placed.forEach(node -> PrototypeInstance.beside(node, beside));
    instances.shapes().forEach(shape -> PrototypeInstance.beside(shape.node(), beside));
    beside.removeAll(scene.loose());
    loose.addAll(beside);
    add(placed, FrameDrivenNode.class, nodes);
    add(formed(instances), FrameDrivenNode.class, nodes);
    add(films(instances, placed), FrameDrivenNode.class, nodes);
    add(loose, FrameDrivenNode.class, nodes);
    add(placed, ScriptNode.class, scripts);
    add(loose, ScriptNode.class, scripts);
    add(placed, KeyDeviceSensorNode.class, keySensors);
    add(loose, KeyDeviceSensorNode.class, keySensors);
    List<SoundNode> sounds = new ArrayList<>();
    add(placed, SoundNode.class, sounds);
    List<PickSensorNode> picks = new ArrayList<>();
    add(placed, PickSensorNode.class, picks);
    boolean touchable =
        anchors || placed.stream().anyMatch(node -> node instanceof PointingDeviceSensorNode);
    boolean draggable =
        placed.stream().anyMatch(node -> node instanceof PointingDeviceSensorNode on && on.drags());
    return new LayerNodeIndex(
        List.copyOf(nodes),
        List.copyOf(inlines),
        List.copyOf(scripts),
        List.copyOf(keySensors),
        List.copyOf(sounds),
        List.copyOf(picks),
        touchable,
        draggable);
  }

  private static <T> void add(Collection<? extends Node> from, Class<T> kind, List<T> to) {
    from.stream().filter(kind::isInstance).forEach(node -> to.add(kind.cast(node)));
  }

  /** Returns the nodes that make their own mesh and change by themselves, each once. */
  private static Set<Node> formed(InstanceTree instances) {
    Set<Node> formed = new LinkedHashSet<>();
    for (ShapeInstance shape : instances.shapes()) {
      if (shape.node() instanceof FrameDrivenNode) {
        formed.add(shape.node());
      }
    }
    return formed;
  }

  /**
   * Returns the movie textures on shapes and in backgrounds, and the generated cube maps on shapes,
   * each once.
   */
  private static Set<Node> films(InstanceTree instances, List<Node> placed) {
    Set<Node> films = new LinkedHashSet<>();
    instances.shapes().forEach(shape -> films.addAll(shape.films()));
    instances.shapes().forEach(shape -> films.addAll(shape.cubes()));
    for (Node node : placed) {
      if (node.type().name().equals("TextureBackground")) {
        for (Background.Side side : Background.Side.values()) {
          if (node.node(side.textureField()) instanceof MovieTextureNode film) {
            films.add(film);
          }
        }
      }
    }
    return films;
  }

  /**
   * Collects Inlines and the nodes that stand beside instances of prototypes; returns whether the
   * group or one below it is an Anchor.
   */
  private static boolean collect(GroupInstance group, Set<InlineNode> inlines, Set<Node> beside) {
    PrototypeInstance.beside(group.node(), beside);
    if (group.node() instanceof InlineNode inline) {
      inlines.add(inline);
    }
    boolean anchors = group.node().type().name().equals("Anchor");
    for (Instance child : group.children()) {
      if (child instanceof GroupInstance inner) {
        anchors |= collect(inner, inlines, beside);
      }
    }
    return anchors;
  }
}
