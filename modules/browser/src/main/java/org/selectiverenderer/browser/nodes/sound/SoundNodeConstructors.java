package org.selectiverenderer.browser.nodes.sound;

import java.util.Map;
import org.selectiverenderer.browser.scene.NodeConstructor;

/**
 * The constructors of the nodes of the Sound component that this program supports, and of
 * MovieTexture, by node type name.
 */
public final class SoundNodeConstructors {
  private SoundNodeConstructors() {}

  public static final Map<String, NodeConstructor> MAKERS =
      Map.of(
          "AudioClip", AudioClipNode::new,
          "MovieTexture", MovieTextureNode::new,
          "Sound", SoundNode::new);
}
