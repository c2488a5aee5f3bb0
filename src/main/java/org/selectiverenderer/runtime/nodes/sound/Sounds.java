package org.selectiverenderer.runtime.nodes.sound;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/**
 * The constructors of the nodes of the Sound component that this program supports, and of
 * MovieTexture, by node type name.
 */
public final class Sounds {
  private Sounds() {}

  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "AudioClip", AudioClipNode::new,
          "MovieTexture", MovieTextureNode::new,
          "Sound", SoundNode::new);
}
