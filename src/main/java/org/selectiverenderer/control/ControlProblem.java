package org.selectiverenderer.control;

import org.web3d.x3d.sai.X3DNode;

/**
 * Something about the scene that its author should know.
 *
 * @param nodeName the name of the Switch or ProximitySensor
 * @param node the node that is at fault: often a metadata node of the former
 * @param message one sentence: what is wrong and what is done about it
 */
public record ControlProblem(String nodeName, X3DNode node, String message) {
  /** For people, when the place in the file is not known. */
  @Override
  public String toString() {
    return nodeName + ": " + message;
  }
}
