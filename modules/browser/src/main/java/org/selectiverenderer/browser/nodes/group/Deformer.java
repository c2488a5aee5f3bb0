package org.selectiverenderer.browser.nodes.group;

/**
 * A group that deforms geometry in it when other nodes in it move or change, such as a humanoid's
 * skin. {@link #deform} is called once when the group enters a scene, and then after each {@link
 * GroupingNode.Effect#FORM}.
 */
public interface Deformer {
  /** Deforms the geometry; costs little if nothing has changed. */
  void deform();
}
