package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.models.scene.AnimatedNodes;
import org.selectiverenderer.models.scene.AnimationWriter;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.Keyframes;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes glTF's animations of nodes and of the weights of morph targets. */
final class GltfAnimations {
  /** The maximum number of coordinates of all interpolators of morph targets together. */
  private static final long MAX_MORPHED = 6_000_000;

  private final GltfFile file;
  private final GltfAccessors accessors;
  private final AnimationWriter writer;
  private final GltfProblems problems;
  private final AnimatedNodes nodes;
  private final Map<Integer, List<GltfMeshes.Morph>> morphs;
  private long left = MAX_MORPHED;

  /**
   * @param nodes the nodes that have been written
   * @param morphs the points and normals that animations of weights change, by their node
   */
  GltfAnimations(
      GltfFile file,
      GltfAccessors accessors,
      X3dWriter out,
      DefNames names,
      GltfProblems problems,
      AnimatedNodes nodes,
      Map<Integer, List<GltfMeshes.Morph>> morphs) {
    this.file = file;
    this.accessors = accessors;
    writer = new AnimationWriter(out, names, nodes);
    this.problems = problems;
    this.nodes = nodes;
    this.morphs = morphs;
  }

  /** A channel that can be written. */
  private record Channel(int node, String target, Keyframes keys) {}

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
    double duration = channels.stream().mapToDouble(c -> c.keys().end()).max().orElse(0);
    if (channels.isEmpty() || !(duration > 0)) {
      return;
    }
    writer.begin(GltfFile.text(animation, "name"), "animation" + index, duration);
    for (Channel channel : channels) {
      if (channel.target().equals("weights")) {
        morphed(channel, path);
      } else {
        writer.move(channel.node(), channel.target(), channel.keys());
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
    } else if (index >= 0 && nodes.has(node)) {
      to.add(new Channel(node, what, AnimationSamplerReader.read(sampler, accessors, size)));
    }
  }

  private int weights(int node) {
    List<GltfMeshes.Morph> moved = morphs.getOrDefault(node, List.of());
    return moved.isEmpty() ? 0 : moved.get(0).targets().size();
  }

  private void morphed(Channel channel, String path) {
    Keyframes keys = channel.keys();
    for (GltfMeshes.Morph morph : morphs.getOrDefault(channel.node(), List.of())) {
      int count = keys.times().length;
      long coordinates = (long) count * morph.values().length;
      if (coordinates > left) {
        problems.tell(
            path,
            "its morph targets need too many coordinates, more than %d for all of the model; some do not move"
                .formatted(MAX_MORPHED));
        continue;
      }
      left -= coordinates;
      float[] all = new float[count * morph.values().length];
      for (int i = 0; i < count; i++) {
        float[] value = keys.value(i);
        double[] weights = new double[value.length];
        for (int k = 0; k < value.length; k++) {
          weights[k] = value[k];
        }
        float[] moved =
            morph.normals()
                ? GltfPrimitive.turned(morph.values(), morph.targets(), weights)
                : GltfPrimitive.moved(morph.values(), morph.targets(), weights);
        System.arraycopy(moved, 0, all, i * moved.length, moved.length);
      }
      if (morph.normals()) {
        writer.change("NormalInterpolator", keys, all, morph.def(), "vector");
      } else {
        writer.change("CoordinateInterpolator", keys, all, morph.def(), "point");
      }
    }
  }
}
