package org.selectiverenderer.browser.nodes.sensor;

import org.selectiverenderer.browser.scene.EventCascade;

/**
 * A node that is updated in every frame: sensors and clocks. It sends its events through the
 * cascade, whose time stamp is the frame's time.
 */
public interface FrameDrivenNode {
  void frame(FrameContext frame, EventCascade cascade);
}
