package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Quaterniond;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * Writes each TimeSensor with the interpolators that move Transforms as an animation. glTF has no
 * equal times in a channel, so the second of two equal keys, where X3D jumps, becomes the next
 * number.
 */
final class GltfAnimationWriter {
  /** An interpolator, and the property of a Transform that it sets. */
  private record Channel(ParsedNode interpolator, ParsedNode transform, String property) {}

  private final GltfDocument out;
  private final GltfLosses losses;
  private final Map<ParsedNode, List<Channel>> channels = new LinkedHashMap<>();
  private final Set<ParsedNode> moved = new HashSet<>();
  private final Set<ParsedNode> moving = new HashSet<>();
  private final Map<ParsedNode, List<GltfTransform>> placed = new HashMap<>();

  GltfAnimationWriter(GltfDocument out, GltfLosses losses) {
    this.out = out;
    this.losses = losses;
  }

  /** Finds the animations among the routes of a file. */
  void find(X3dFile file) {
    Map<ParsedNode, List<ParsedNode>> timers = new HashMap<>();
    Set<X3dFile.ParsedRoute> used = new HashSet<>();
    for (X3dFile.ParsedRoute route : file.routes()) {
      if (is(route.from(), "TimeSensor", route.fromField(), "fraction_changed")
          && is(route.to(), "", route.toField(), "set_fraction")) {
        timers.computeIfAbsent(route.to(), unused -> new ArrayList<>()).add(route.from());
        used.add(route);
      }
    }
    for (X3dFile.ParsedRoute route : file.routes()) {
      String property = property(route);
      if (property.isEmpty() || !timers.containsKey(route.from())) {
        continue;
      }
      used.add(route);
      moved.add(route.to());
      moving.add(route.from());
      for (ParsedNode timer : timers.get(route.from())) {
        moving.add(timer);
        channels
            .computeIfAbsent(timer, unused -> new ArrayList<>())
            .add(new Channel(route.from(), route.to(), property));
      }
    }
    file.routes().stream()
        .filter(route -> !used.contains(route))
        .findFirst()
        .ifPresent(
            route ->
                losses.tell(
                    "ROUTE",
                    route.from().location(),
                    "glTF has no ROUTEs but those of animations, from a TimeSensor by an"
                        + " interpolator to a Transform; the route from "
                        + route.from()
                        + " and all others are left out"));
  }

  /** Returns what a route animates; "" for nothing that glTF can hold. */
  private static String property(X3dFile.ParsedRoute route) {
    if (!route.to().type().name().equals("Transform")) {
      return "";
    }
    return switch (route.from().type().name()) {
      case "PositionInterpolator" ->
          is(route.to(), "", route.toField(), "translation")
              ? "translation"
              : is(route.to(), "", route.toField(), "scale") ? "scale" : "";
      case "OrientationInterpolator" ->
          is(route.to(), "", route.toField(), "rotation") ? "rotation" : "";
      default -> "";
    };
  }

  private static boolean is(ParsedNode node, String type, int field, String name) {
    NodeType actual = node.type();
    return (type.isEmpty() || actual.name().equals(type))
        && actual.fields().get(field).name().equals(name);
  }

  /** Returns whether an animation moves a node. */
  boolean moves(Object transform) {
    return transform instanceof ParsedNode node && moved.contains(node);
  }

  /** Returns whether a TimeSensor or interpolator is part of an animation. */
  boolean takes(Object node) {
    return node instanceof ParsedNode parsed && moving.contains(parsed);
  }

  /** Notes the nodes of the document for a Transform, one each time that it is used. */
  void place(Object transform, GltfTransform nodes) {
    if (transform instanceof ParsedNode node) {
      placed.computeIfAbsent(node, unused -> new ArrayList<>()).add(nodes);
    }
  }

  /** Writes the animations of the nodes that have been placed. */
  void write() throws IOException {
    for (Map.Entry<ParsedNode, List<Channel>> timed : channels.entrySet()) {
      ParsedNode timer = timed.getKey();
      ObjectNode animation = out.object();
      if (timer.name() != null) {
        animation.put("name", timer.name());
      }
      double seconds = (Double) timer.value(timer.type().indexOf("cycleInterval"));
      Set<String> targets = new HashSet<>();
      for (Channel channel : timed.getValue()) {
        write(channel, seconds > 0 && Double.isFinite(seconds) ? seconds : 1, animation, targets);
      }
      if (!targets.isEmpty()) {
        out.add("animations", animation);
      }
    }
  }

  private void write(Channel channel, double seconds, ObjectNode animation, Set<String> targets)
      throws IOException {
    List<GltfTransform> nodes = placed.getOrDefault(channel.transform(), List.of());
    float[] keys = channel.interpolator().floats("key");
    float[] values = channel.interpolator().floats("keyValue");
    boolean turns = channel.property().equals("rotation");
    int tuple = turns ? 4 : 3;
    int count = Math.min(keys.length, values.length / tuple);
    if (nodes.isEmpty() || count == 0) {
      return;
    }
    float[] times = new float[count];
    for (int i = 0; i < count; i++) {
      float time = (float) GltfDocument.finite(Math.max(0, keys[i] * seconds));
      times[i] = i > 0 && time <= times[i - 1] ? Math.nextUp(times[i - 1]) : time;
    }
    float[] output = new float[tuple * count];
    for (int i = 0; i < count; i++) {
      for (int k = 0; k < tuple; k++) {
        float centre = channel.property().equals("translation") ? nodes.get(0).centre()[k] : 0;
        output[tuple * i + k] = (float) GltfDocument.finite(values[tuple * i + k] + centre);
      }
      if (turns) {
        Quaterniond q =
            GltfTransform.rotation(
                new float[] {
                  values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]
                });
        output[4 * i] = (float) q.x;
        output[4 * i + 1] = (float) q.y;
        output[4 * i + 2] = (float) q.z;
        output[4 * i + 3] = (float) q.w;
      }
    }
    int sampler = animation.withArray("/samplers").size();
    boolean added = false;
    for (GltfTransform transform : nodes) {
      int node = channel.property().equals("scale") ? transform.scaled() : transform.outer();
      if (targets.add(node + channel.property())) {
        ObjectNode entry = animation.withArray("/channels").addObject().put("sampler", sampler);
        entry.putObject("target").put("node", node).put("path", channel.property());
        added = true;
      }
    }
    if (added) {
      animation
          .withArray("/samplers")
          .addObject()
          .put("input", out.floats(times, "SCALAR", true, GltfDocument.Target.OTHER))
          .put(
              "output",
              out.floats(output, turns ? "VEC4" : "VEC3", false, GltfDocument.Target.OTHER))
          .put("interpolation", "LINEAR");
    }
  }
}
