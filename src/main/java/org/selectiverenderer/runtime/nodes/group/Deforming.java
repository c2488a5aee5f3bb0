package org.selectiverenderer.runtime.nodes.group;

/**
 * A group that gives geometry in it another form when other nodes in it move or change. It is asked
 * to once when it comes into a scene, and then after each {@link GroupingNode.Effect#FORM}.
 */
public interface Deforming {
  /** Brings the geometry up to date; costs little when nothing has changed. */
  void deform();
}
