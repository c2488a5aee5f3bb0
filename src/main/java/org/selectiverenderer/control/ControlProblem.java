package org.selectiverenderer.control;

import org.web3d.x3d.sai.X3DNode;

/**
 * Something about the scene that its author should know.
 *
 * @param nodeName the name of the Switch or ProximitySensor
 * @param node the node that is at fault: often a metadata node of the former
 * @param severity whether something is wrong, or only worth knowing
 * @param message one sentence: what is wrong and what is done about it
 */
public record ControlProblem(String nodeName, X3DNode node, Severity severity, String message) {
  /** How much it matters. */
  public enum Severity {
    /** Something is probably not as the author wants it. */
    WARNING,
    /** Often as it should be, yet the author may want to know. */
    INFO
  }

  /** Something that is wrong. */
  static ControlProblem warning(String nodeName, X3DNode node, String message) {
    return new ControlProblem(nodeName, node, Severity.WARNING, message);
  }

  /** For people, when the place in the file is not known. */
  @Override
  public String toString() {
    return nodeName + ": " + message;
  }
}
