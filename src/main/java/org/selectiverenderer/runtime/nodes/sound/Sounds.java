package org.selectiverenderer.runtime.nodes.sound;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The nodes of the Sound component that this program acts on, and what may be heard besides. */
public final class Sounds {
  private Sounds() {}

  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "AudioClip", AudioClipNode::new,
          "MovieTexture", MovieTextureNode::new,
          "Sound", SoundNode::new);
}
