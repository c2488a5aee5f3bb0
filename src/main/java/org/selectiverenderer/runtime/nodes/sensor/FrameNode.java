package org.selectiverenderer.runtime.nodes.sensor;

import org.selectiverenderer.runtime.scene.Cascade;

/**
 * A node that is updated in every frame: sensors and clocks. It sends its events through the
 * cascade, whose time stamp is the frame's time.
 */
public interface FrameNode {
  void frame(Frame frame, Cascade cascade);
}
