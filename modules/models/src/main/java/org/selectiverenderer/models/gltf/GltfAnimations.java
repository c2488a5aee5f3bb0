package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes glTF's animations as TimeSensors and interpolators with routes. The first animation runs
 * in a loop, as viewers of glTF show it; the TimeSensors of others wait for {@code enabled}.
 */
final class GltfAnimations {
  /** The maximum number of coordinates of one CoordinateInterpolator. */
  private static final long MAX_MORPHED = 6_000_000;

  private final GltfFile file;
  private final GltfAccessors accessors;
  private final X3dWriter out;
  private final DefNames names;
  private final GltfProblems problems;
  private final Map<Integer, String> transforms;
  private final Map<Integer, List<GltfMeshes.Morph>> morphs;

  /**
   * @param transforms the DEF names of the Transforms of nodes
   * @param morphs the points that animations of weights change, by their node
   */
  GltfAnimations(
      GltfFile file,
      GltfAccessors accessors,
      X3dWriter out,
      DefNames names,
      GltfProblems problems,
      Map<Integer, String> transforms,
      Map<Integer, List<GltfMeshes.Morph>> morphs) {
    this.file = file;
    this.accessors = accessors;
    this.out = out;
    this.names = names;
    this.problems = problems;
    this.transforms = transforms;
    this.morphs = morphs;
  }

  /** A channel that can be written. */
  private record Channel(int node, String target, AnimationSampler sampler) {}

  void write() {
    JsonNode animations = file.root().path("animations");
    for (int i = 0; i < animations.size(); i++) {
      animation(animations.path(i), i);
    }
  }

  private void animation(JsonNode animation, int index) {
    String path = "animations[%d]".formatted(index);
    List<Channel> channels = new ArrayList<>();
    int i = 0;
    for (JsonNode channel : animation.path("channels")) {
      String at = "%s.channels[%d]".formatted(path, i++);
      try {
        read(animation, channel, at, channels);
      } catch (IOException e) {
        problems.tell(at, e.getMessage() + "; it is left out");
      }
    }
    double duration = channels.stream().mapToDouble(c -> c.sampler().end()).max().orElse(0);
    if (channels.isEmpty() || !(duration > 0)) {
      return;
    }
    String name = GltfFile.text(animation, "name");
    String clock = names.unique(name, "animation" + index);
    out.open("TimeSensor", "DEF", clock, "cycleInterval", Numbers.of(duration), "loop", "true");
    if (!name.isBlank()) {
      out.attribute("description", name);
    }
    if (index > 0) {
      out.attribute("enabled", "false");
    }
    out.close();
    for (Channel channel : channels) {
      if (channel.target().equals("weights")) {
        morphed(channel, clock, duration, path);
      } else {
        moved(channel, clock, duration);
      }
    }
  }

  private void read(JsonNode animation, JsonNode channel, String path, List<Channel> to)
      throws IOException {
    JsonNode target = channel.path("target");
    int node = GltfFile.index(target, "node");
    String what = target.path("path").asText("");
    int index = GltfFile.index(channel, "sampler");
    JsonNode sampler = animation.path("samplers").path(Math.max(0, index));
    int size =
        switch (what) {
          case "translation", "scale" -> 3;
          case "rotation" -> 4;
          case "weights" -> weights(node);
          default -> 0;
        };
    if (size == 0) {
      problems.tell(path, "it animates something that X3D or glTF does not have; it is left out");
    } else if (index >= 0 && transforms.containsKey(node)) {
      to.add(new Channel(node, what, AnimationSampler.of(sampler, accessors, size)));
    }
  }

  private int weights(int node) {
    List<GltfMeshes.Morph> moved = morphs.getOrDefault(node, List.of());
    return moved.isEmpty() ? 0 : moved.get(0).targets().size();
  }

  private void moved(Channel channel, String clock, double duration) {
    boolean turns = channel.target().equals("rotation");
    String type = turns ? "OrientationInterpolator" : "PositionInterpolator";
    AnimationSampler sampler = channel.sampler();
    float[] values = turns ? rotations(sampler) : sampler.values();
    String transform = transforms.getOrDefault(channel.node(), "");
    String def = interpolator(type, sampler, duration, values, transform + "_" + channel.target());
    out.route(clock, "fraction_changed", def, "set_fraction");
    out.route(def, "value_changed", transform, channel.target());
  }

  private String interpolator(
      String type, AnimationSampler sampler, double duration, float[] values, String name) {
    String def = names.unique("", name);
    out.open(type, "DEF", def);
    out.ownLine().numbers("key", Numbers.list(sampler.fractions(duration)));
    out.ownLine().numbers("keyValue", Numbers.list(values)).close();
    return def;
  }

  private static float[] rotations(AnimationSampler sampler) {
    float[] rotations = new float[sampler.values().length];
    for (int i = 0; i < sampler.times().length; i++) {
      float[] q = sampler.value(i);
      double[] turned =
          Numbers.axisAngle(NodeTransform.unit(new double[] {q[0], q[1], q[2], q[3]}));
      for (int k = 0; k < 4; k++) {
        rotations[4 * i + k] = (float) turned[k];
      }
    }
    return rotations;
  }

  private void morphed(Channel channel, String clock, double duration, String path) {
    AnimationSampler sampler = channel.sampler();
    for (GltfMeshes.Morph morph : morphs.getOrDefault(channel.node(), List.of())) {
      int keys = sampler.times().length;
      if ((long) keys * morph.points().length > MAX_MORPHED) {
        problems.tell(path, "its morph targets need too many coordinates; they do not move");
        continue;
      }
      float[] all = new float[keys * morph.points().length];
      for (int i = 0; i < keys; i++) {
        float[] value = sampler.value(i);
        double[] weights = new double[value.length];
        for (int k = 0; k < value.length; k++) {
          weights[k] = value[k];
        }
        float[] moved = GltfMeshes.moved(morph.points(), morph.targets(), weights);
        System.arraycopy(moved, 0, all, i * moved.length, moved.length);
      }
      String name = morph.coordinate() + "_weights";
      String def = interpolator("CoordinateInterpolator", sampler, duration, all, name);
      out.route(clock, "fraction_changed", def, "set_fraction");
      out.route(def, "value_changed", morph.coordinate(), "point");
    }
  }
}
