package org.selectiverenderer.runtime.nodes.sound;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The nodes of the Sound component that this program acts on. */
public final class Sounds {
  private Sounds() {}

  public static final Map<String, NodeMaker> MAKERS =
      Map.of("AudioClip", AudioClipNode::new, "Sound", SoundNode::new);
}
