package org.selectiverenderer.runtime.nodes.sensor;

import org.selectiverenderer.runtime.scene.Cascade;

/**
 * A node that looks at every frame: sensors and clocks. It sends its events through the cascade,
 * whose time stamp is the frame's.
 */
public interface FrameNode {
  void frame(Frame frame, Cascade cascade);
}
