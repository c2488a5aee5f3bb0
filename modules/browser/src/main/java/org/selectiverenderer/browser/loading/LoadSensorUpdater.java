package org.selectiverenderer.browser.loading;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.network.LoadSensorNode;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.nodes.sound.SoundSourceNode;
import org.selectiverenderer.browser.scene.Node;

/**
 * Tells LoadSensors the loading states of the files that nodes name. The files named in the scene's
 * own file have been read before its first frame.
 */
final class LoadSensorUpdater {
  private final AssetProvider assets;

  /** The number of files that are being read for each node. */
  private final Map<Node, Integer> open = new HashMap<>();

  private List<LoadSensorNode> sensors = List.of();

  /**
   * @param assets the assets of the running scene
   */
  LoadSensorUpdater(AssetProvider assets) {
    this.assets = assets;
  }

  void watch(List<LoadSensorNode> present) {
    sensors = present;
    sensors.forEach(sensor -> sensor.asks(this::state));
  }

  void begins(Node node) {
    open.merge(node, 1, Integer::sum);
    sensors.forEach(sensor -> sensor.begins(node));
  }

  void ends(Node node) {
    open.computeIfPresent(node, (of, count) -> count == 1 ? null : count - 1);
    sensors.forEach(sensor -> sensor.ends(node));
  }

  private LoadSensorNode.State state(Node node) {
    boolean texture = node.type().is("X3DTextureNode");
    boolean shown = texture && assets.image(node).isPresent(); // Starts a new texture.
    if (open.containsKey(node)) {
      return LoadSensorNode.State.LOADING;
    }
    boolean wanted =
        node.type().field("load").isEmpty() || node.type().is("X3DScriptNode") || node.bool("load");
    if (!wanted || node.strings("url").length == 0) {
      return LoadSensorNode.State.NONE;
    }
    boolean loaded;
    if (node instanceof InlineNode inline) {
      loaded = inline.content().isPresent();
    } else if (node instanceof SoundSourceNode played && !texture) {
      loaded = played.loaded();
    } else if (node instanceof ScriptNode script) {
      loaded = script.program() != null;
    } else if (texture) {
      loaded = shown;
    } else {
      return LoadSensorNode.State.NONE;
    }
    return loaded ? LoadSensorNode.State.LOADED : LoadSensorNode.State.FAILED;
  }
}
